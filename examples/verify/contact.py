#!/usr/bin/env python3
"""Answers the cases of `beamgap export --element` with your own contact element with friction.

    beamgap export --element --family segment -o vectors.jsonl
    beamgap verify vectors.jsonl --run "python3 contact.py"

This program is for two straight beams, the family `segment`. For yours, change
1. FAMILY and BEAM_DOFS, the name of the family and its dofs a beam,
2. `element`: it returns what is answered,
3. HEAD: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).

Equation numbers are those of Zavarise (2007). The other formulas are in docs/contact-element.md.
"""
import json
import sys

FAMILY, BEAM_DOFS = "segment", 6
DOFS = range(2 * BEAM_DOFS)
HEAD = {"schema": "beamgap-answers/1", "program": "contact.py", "only": ["residual", "tangent"]}


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def normal_law(law, gap):
    """Laws: F_N, and k = -dF_N/dg_N."""
    eps = law["eps_N"]
    if law["law"] == "lpqp" and gap > 0:
        rest = max(law["g_0"] - gap, 0.0)
        return eps * rest * rest / (2 * law["g_0"]), eps * rest / law["g_0"]
    force = law.get("lambda", 0.0) + eps * law.get("g_0", 0.0) / 2 - eps * gap
    return (force, eps) if force > 0 else (0.0, 0.0)


def element(q, xi, xi_bar, held, radii, case):
    """YOUR ELEMENT. Here: two straight beams, 12 dofs; t,xi and all that has it is zero.

    q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
    held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
    radii: r + r_bar. case: law, eps_T, mu, work and history.
    """
    # Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
    shapes = [(1 - xi) / 2, (1 + xi) / 2, -(1 - xi_bar) / 2, -(1 + xi_bar) / 2]
    slopes, slopes_bar = [-0.5, 0.5, 0.0, 0.0], [0.0, 0.0, -0.5, 0.5]
    d, t, t_bar = ([dot(of, q[c::3]) for c in range(3)] for of in (shapes, slopes, slopes_bar))
    # The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1.
    along = lambda of, w: [of[i // 3] * w[i % 3] for i in DOFS]
    A1 = lambda w: along(slopes, w)
    B1 = lambda w: along(slopes_bar, w)

    # Geometry. Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
    a, b, a_bar = dot(t, t), dot(t, t_bar), -dot(t_bar, t_bar)
    inverse = [[0.0, 0.0], [0.0, 0.0]]
    if held == "none":
        det = a * a_bar + b * b
        inverse = [[a_bar / det, b / det], [-b / det, a / det]]
    elif held == "xi":
        inverse[1][1] = 1 / a_bar
    elif held == "xi_bar":
        inverse[0][0] = 1 / a
    solve = lambda r, r_bar: [row[0] * r + row[1] * r_bar for row in inverse]
    Gt, Gt_bar, A1d, B1d = along(shapes, t), along(shapes, t_bar), A1(d), B1(d)
    g, g_bar = zip(*(solve(-Gt[i] - A1d[i], -Gt_bar[i] - B1d[i]) for i in DOFS))
    # n = d/|d|; t x t_bar has the same direction, also where the beams cross. It keeps the side of the last step.
    side = cross(t, t_bar) if held == "none" else d
    length = dot(side, side) ** 0.5
    if dot(side, case["history"]["normal"] or d) < 0:
        length = -length
    n = [w / length for w in side]
    d_s = dot(n, d)
    grad_gap, A1n, B1n = along(shapes, n), A1(n), B1(n)  # eq. (37)

    # Normal.
    F_N, k = normal_law(case, d_s - radii)
    grad_F_N = [-k * w for w in grad_gap]

    # Slip, eq. (15) and (20), and trial.
    slips = case["history"]["slips"]
    has_friction = F_N > 0 and case["mu"] > 0 and slips and held != "both"
    abs_t, abs_t_bar = a**0.5, (-a_bar) ** 0.5  # |t|, |t_bar|
    tau, tau_bar = [w / abs_t for w in t], [w / abs_t_bar for w in t_bar]
    c = dot(tau, tau_bar)
    grad_t, grad_t_bar = A1(tau), B1(tau_bar)
    u = u_bar = F = F_bar = 0.0
    grad_F = grad_F_bar = [0.0 for _ in DOFS]
    state = "open" if F_N == 0 else "frictionless"
    if has_friction:
        u = 0.0 if held == "xi" else xi - slips["xi"]
        u_bar = 0.0 if held == "xi_bar" else xi_bar - slips["xi_bar"]
        e, e_bar, c_n = slips["e"], slips["e_bar"], slips["cosine"]
        if held not in ("none", slips["held"]):  # a parameter that becomes held loses its part
            was_free = slips["held"] == "none"
            e, e_bar = (
                e - c_n * e_bar if was_free and held == "xi_bar" else 0.0,
                e_bar - c_n * e if was_free and held == "xi" else 0.0,
            )
        e, e_bar = e + abs_t * u, e_bar + abs_t_bar * u_bar
        s = [e * v - e_bar * w for v, w in zip(tau, tau_bar)]
        gamma = dot(s, s) ** 0.5
        l = 0.0 if held == "xi" else dot(s, tau)  # e - c e_bar
        l_bar = 0.0 if held == "xi_bar" else -dot(s, tau_bar)  # e_bar - c e
        grad_e = [abs_t * g[i] + u * grad_t[i] for i in DOFS]
        grad_e_bar = [abs_t_bar * g_bar[i] + u_bar * grad_t_bar[i] for i in DOFS]
        turned = A1([(v - c * w) / abs_t for v, w in zip(tau_bar, tau)])
        turned_bar = B1([(v - c * w) / abs_t_bar for v, w in zip(tau, tau_bar)])
        grad_c = [turned[i] + turned_bar[i] for i in DOFS]
        grad_l = [grad_e[i] - c * grad_e_bar[i] - e_bar * grad_c[i] for i in DOFS]
        grad_l_bar = [grad_e_bar[i] - c * grad_e[i] - e * grad_c[i] for i in DOFS]

        # Return to the cone.
        state, rho, grad_rho = "stick", 1.0, [0.0 for _ in DOFS]
        if case["eps_T"] * gamma > case["mu"] * F_N:
            state, rho = "slip", case["mu"] * F_N / (case["eps_T"] * gamma)
            grad_gamma = [(l * grad_e[i] + l_bar * grad_e_bar[i] - e * e_bar * grad_c[i]) / gamma for i in DOFS]
            grad_rho = [
                case["mu"] / (case["eps_T"] * gamma) * grad_F_N[i] - rho / gamma * grad_gamma[i] for i in DOFS
            ]
        F, F_bar = case["eps_T"] * rho * l, case["eps_T"] * rho * l_bar
        grad_F = [case["eps_T"] * (rho * grad_l[i] + l * grad_rho[i]) for i in DOFS]
        grad_F_bar = [case["eps_T"] * (rho * grad_l_bar[i] + l_bar * grad_rho[i]) for i in DOFS]

    # Work: with "paper", A = grad g_T.
    paper = 1.0 if case["work"] == "paper" else 0.0
    A = [abs_t * g[i] + paper * u * grad_t[i] for i in DOFS]
    A_bar = [abs_t_bar * g_bar[i] + paper * u_bar * grad_t_bar[i] for i in DOFS]
    residual = [-F_N * grad_gap[i] + F * A[i] + F_bar * A_bar[i] for i in DOFS]

    # Tangent.
    grad_a, grad_a_bar = [2 * w for w in A1(t)], [-2 * w for w in B1(t_bar)]
    grad_b = [v + w for v, w in zip(A1(t_bar), B1(t))]
    tangent = []
    for i in DOFS:
        for j in DOFS:
            both = lambda v, w: v[i] * w[j] + w[i] * v[j]
            product = lambda v, w: v[i // 3] * w[j // 3] if i % 3 == j % 3 else 0.0
            # The Hessian of the gap: eq. (40), or if both parameters are free a form that also holds at d = 0.
            if held == "none":
                turned = inverse[0][0] * A1n[i] * A1n[j] + inverse[0][1] * both(A1n, B1n) - inverse[1][1] * B1n[i] * B1n[j]
                H_gap = both(A1n, g) - both(B1n, g_bar) + d_s * turned
            else:
                moved = Gt[i] * g[j] - Gt_bar[i] * g_bar[j] - grad_gap[i] * grad_gap[j]
                H_gap = (product(shapes, shapes) + moved) / d_s + A1n[i] * g[j] - B1n[i] * g_bar[j]
            # The derivatives of eq. (50), solved as eq. (52).
            GA, GB = (product(shapes, of) + product(of, shapes) for of in (slopes, slopes_bar))
            H_xi, H_xi_bar = solve(
                -GA - both(grad_a, g) + both(grad_b, g_bar), -GB - both(grad_b, g) - both(grad_a_bar, g_bar)
            )
            H_t = (product(slopes, slopes) - grad_t[i] * grad_t[j]) / abs_t
            H_t_bar = (product(slopes_bar, slopes_bar) - grad_t_bar[i] * grad_t_bar[j]) / abs_t_bar
            H_A = g[i] * grad_t[j] + abs_t * H_xi + paper * (grad_t[i] * g[j] + u * H_t)
            H_A_bar = g_bar[i] * grad_t_bar[j] + abs_t_bar * H_xi_bar + paper * (grad_t_bar[i] * g_bar[j] + u_bar * H_t_bar)
            K_N = k * grad_gap[i] * grad_gap[j] - F_N * H_gap
            K_T = A[i] * grad_F[j] + A_bar[i] * grad_F_bar[j] + F * H_A + F_bar * H_A_bar
            tangent.append(K_N + K_T)
    return {"state": state, "F_N": F_N, "F": F, "F_bar": F_bar, "residual": residual, "tangent": tangent}


def main():
    sys.stdin.readline()  # the head of the cases
    print(json.dumps(HEAD))
    for line in sys.stdin:
        case = json.loads(line)
        beam, bar, answer = case["beam"], case["bar"], {"result": "degenerate"}
        for family in (beam["family"], bar["family"]):
            if family != FAMILY:
                sys.exit(f"contact.py is for the family {FAMILY}; a case is of the family {family}. Change FAMILY and element.")
        if case["result"] == "valid":
            if "element" not in case:
                sys.exit("contact.py: a case has no element. Write the cases with `beamgap export --element`.")
            point, radii = case["point"], case["contact"]["radius"] + case["contact"]["radius_bar"]
            answer = element(beam["q"] + bar["q"], point["xi"], point["xi_bar"], case["held"], radii, case["element"])
        print(json.dumps({"id": case["id"], **answer}), flush=True)


if __name__ == "__main__":
    main()
