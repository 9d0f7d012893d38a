#!/usr/bin/env python3
"""Answers the cases of `beamgap export` with your own element.

    beamgap export --family segment -o vectors.jsonl
    beamgap verify vectors.jsonl --run "python3 adapter.py"

This program is for two straight beams, the family `segment`. For yours, change
1. FAMILY, the name of the family,
2. `element`: it returns what is answered,
3. HEAD: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
"""
import json
import sys

FAMILY = "segment"
HEAD = {
    "schema": "beamgap-answers/1",
    "program": "adapter.py",
    "only": ["d", "xi:value", "xi:first", "xi_bar:value", "xi_bar:first"],
}


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def element(q, q_bar, xi, xi_bar, held):
    """YOUR ELEMENT. Here: two straight beams, 12 dofs, by the equations of Zavarise (2007).

    q, q_bar: both ends of beam and bar beam. xi, xi_bar: the closest point, in [-1, 1].
    held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
    """
    dofs = range(12)
    # Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
    shapes = [(1 - xi) / 2, (1 + xi) / 2, -(1 - xi_bar) / 2, -(1 + xi_bar) / 2]
    slopes = [-0.5, 0.5, 0.0, 0.0]
    slopes_bar = [0.0, 0.0, -0.5, 0.5]
    points = [q[0:3], q[3:6], q_bar[0:3], q_bar[3:6]]
    sums = lambda of: [sum(s * p[c] for s, p in zip(of, points)) for c in range(3)]
    d, t, t_bar = sums(shapes), sums(slopes), sums(slopes_bar)
    length = dot(d, d) ** 0.5
    n = [c / length for c in d]
    # The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1.
    along = lambda of, w: [of[i // 3] * w[i % 3] for i in dofs]
    A1d, B1d = along(slopes, d), along(slopes_bar, d)
    # Eq. (50): the right-hand sides and the matrix.
    r = [-x - y for x, y in zip(along(shapes, t), A1d)]
    r_bar = [-x - y for x, y in zip(along(shapes, t_bar), B1d)]
    a, b, a_bar = dot(t, t), dot(t, t_bar), -dot(t_bar, t_bar)
    # Eq. (52), reduced to one equation or none if parameters are held at an end.
    det = a * a_bar + b * b
    g, g_bar = [0.0] * 12, [0.0] * 12
    if held == "none":
        g = [(a_bar * r[i] + b * r_bar[i]) / det for i in dofs]
        g_bar = [(-b * r[i] + a * r_bar[i]) / det for i in dofs]
    elif held == "xi":
        g_bar = [r_bar[i] / a_bar for i in dofs]
    elif held == "xi_bar":
        g = [r[i] / a for i in dofs]
    # Eq. (37) and (40).
    gradient, Gt, Gt_bar = along(shapes, n), along(shapes, t), along(shapes, t_bar)
    hessian = []
    for i in dofs:
        for j in dofs:
            GG = shapes[i // 3] * shapes[j // 3] if i % 3 == j % 3 else 0.0
            moved = Gt[i] * g[j] - Gt_bar[i] * g_bar[j]
            turned = A1d[i] * g[j] - B1d[i] * g_bar[j]
            hessian.append((GG + moved + turned - gradient[i] * gradient[j]) / length)
    return {
        "d": {"value": length, "gradient": gradient, "hessian": hessian},
        "xi": {"value": xi, "gradient": g},
        "xi_bar": {"value": xi_bar, "gradient": g_bar},
    }


def main():
    sys.stdin.readline()  # the head of the cases
    print(json.dumps(HEAD))
    for line in sys.stdin:
        case = json.loads(line)
        answer = {"id": case["id"], "result": "degenerate"}
        beam, bar = case["beam"], case["bar"]
        for family in (beam["family"], bar["family"]):
            if family != FAMILY:
                sys.exit(f"adapter.py is for the family {FAMILY}; a case is of the family {family}. Change FAMILY and element.")
        if case["result"] == "valid":
            point = case["point"]
            answer = element(beam["q"], bar["q"], point["xi"], point["xi_bar"], case["held"])
            answer["id"] = case["id"]
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
