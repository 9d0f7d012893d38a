#!/usr/bin/env python3
"""Answers the cases of `beamgap export` with the residual and the tangent of a contact element with a penalty.

    beamgap adapter python > adapter.py
    beamgap adapter python --contact > contact.py
    beamgap export --family segment -o vectors.jsonl
    beamgap verify vectors.jsonl --run "python3 contact.py"

The energy is STIFFNESS g_N^2 / 2 if the gap g_N = d - r - r_bar is negative, and zero otherwise. For your element, change
1. STIFFNESS, and HEAD: conventions that differ are stated there, such as "residual_sign": "-" (beamgap schema answers),
2. `contact`, and `element` and FAMILY of adapter.py.
"""
import json
import sys

from adapter import FAMILY, element

STIFFNESS = 250.0
HEAD = {
    "schema": "beamgap-answers/1",
    "program": "contact.py",
    "penalty_stiffness": STIFFNESS,
    "only": ["residual", "tangent"],
}


def contact(gap, gradient, hessian):
    """YOUR ELEMENT: residual and tangent, the gradient and the Hessian of the energy."""
    dofs = range(len(gradient))
    if gap >= 0:
        return {"residual": [0.0 for _ in dofs], "tangent": [0.0 for _ in dofs for _ in dofs]}
    residual = [STIFFNESS * gap * g for g in gradient]
    tangent = [
        STIFFNESS * (gradient[i] * gradient[j] + gap * hessian[i * len(gradient) + j]) for i in dofs for j in dofs
    ]
    return {"residual": residual, "tangent": tangent}


def main():
    sys.stdin.readline()  # the head of the cases
    print(json.dumps(HEAD))
    for line in sys.stdin:
        case = json.loads(line)
        answer = {"result": "degenerate"}
        for family in (case["beam"]["family"], case["bar"]["family"]):
            if family != FAMILY:
                sys.exit(f"contact.py is for the family {FAMILY}; a case is of the family {family}.")
        if case["result"] == "valid":
            point, radii = case["point"], case["contact"]
            d = element(case["beam"]["q"], case["bar"]["q"], point["xi"], point["xi_bar"], case["held"])["d"]
            gap = d["value"] - radii["radius"] - radii["radius_bar"]
            answer = contact(gap, d["gradient"], d["hessian"])
        print(json.dumps({"id": case["id"], **answer}), flush=True)


if __name__ == "__main__":
    main()
