"""Answers pairs of cubic Hermite beams by CasADi: its rootfinder differentiates the condition of the closest point.

    beamgap export --family hermite -o vectors.jsonl
    beamgap verify vectors.jsonl --run "python3 casadi_gap.py"
"""
import casadi
import numpy
from stream import answer, rows

q, start, free, at = (casadi.MX.sym(*of) for of in [("q", 24), ("start", 2), ("free", 2), ("at", 2)])


def point(q, xi):
    """A cubic Hermite curve: q is point, tangent, point, tangent, and tangents are dx/dxi."""
    shapes = [2 - 3 * xi + xi**3, 1 - xi - xi**2 + xi**3, 2 + 3 * xi - xi**3, -1 - xi + xi**2 + xi**3]
    return sum(shape / 4 * q[3 * i : 3 * i + 3] for i, shape in enumerate(shapes))


def difference(at):
    return point(q[:12], at[0]) - point(q[12:], at[1])


# Dimensionless and zero at the closest point. A parameter that is held at an end is constant.
slope = casadi.gradient(0.5 * casadi.sumsqr(difference(at)), at)
tangents = casadi.jacobian(difference(at), at)
squares = casadi.vertcat(casadi.sumsqr(tangents[:, 0]), casadi.sumsqr(tangents[:, 1]))
condition = free * slope / casadi.substitute(squares, at, start) + (1 - free) * (at - start)
parameters = casadi.vertcat(q, start, free)
problem = {"x": at, "p": parameters, "g": condition}
options = {"abstol": 1e-15, "abstolStep": 1e-15, "max_iter": 20}
solve = casadi.rootfinder("closest_point", "newton", problem, options)
# The start differs from the closest point, so that the iterations are needed.
found = solve(x0=start + 1e-5 * free, p=parameters)["x"]
quantities = {"xi": found[0], "xi_bar": found[1], "d": casadi.norm_2(difference(found))}
outputs = [part for of in quantities.values() for part in (of, casadi.gradient(of, q), casadi.hessian(of, q)[0])]
linearized = casadi.Function("linearized", [q, start, free], outputs)


def element(case):
    held = case["held"]
    start = [case["point"]["xi"], case["point"]["xi_bar"]]
    try:
        of = linearized(
            case["beam"]["q"] + case["bar"]["q"],
            start,
            [held not in ("xi", "both"), held not in ("xi_bar", "both")],
        )
    except RuntimeError:
        return None  # the rootfinder does not converge
    found = {}
    for i, name in enumerate(quantities):
        value, gradient, hessian = (numpy.array(part) for part in of[3 * i : 3 * i + 3])
        found[name] = {"value": float(value[0, 0]), "gradient": gradient[:, 0].tolist(), "hessian": rows(hessian)}
    return found


answer(element, ["hermite"] * 2, program="CasADi", version=casadi.__version__, only=["xi", "xi_bar", "d"])
