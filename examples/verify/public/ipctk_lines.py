"""Answers pairs of straight beams with functions of the IPC Toolkit.

    beamgap export --family segment -o vectors.jsonl
    beamgap verify vectors.jsonl --run "python3 ipctk_lines.py line-line"

line-line       line_line_distance, the squared distance of two lines, with gradient and Hessian
signed          line_line_signed_distance, times its sign, with gradient and Hessian
edge-edge       edge_edge_distance, the squared distance of two edges, with gradient and Hessian
closest-point   edge_edge_closest_point with edge_edge_closest_point_jacobian

The lines are infinite, so only edge-edge answers if a parameter is held at an end.
"""
import sys

import ipctk
import numpy
from stream import answer, rows


def ends(case):
    return [numpy.array(case[beam]["q"][at : at + 3]) for beam in ("beam", "bar") for at in (0, 3)]


def is_inside(case):
    return case["held"] == "none"


def line_line(case):
    if not is_inside(case):
        return None
    of = ends(case)
    gradient, hessian = ipctk.line_line_distance_gradient(*of), ipctk.line_line_distance_hessian(*of)
    return {"d": {"value": ipctk.line_line_distance(*of), "gradient": list(gradient), "hessian": rows(hessian)}}


def signed(case):
    if not is_inside(case):
        return None
    of = ends(case)
    value = ipctk.line_line_signed_distance(*of)
    sign = -1.0 if value < 0.0 else 1.0
    gradient = sign * ipctk.line_line_signed_distance_gradient(*of)
    hessian = sign * ipctk.line_line_signed_distance_hessian(*of)
    return {"d": {"value": sign * value, "gradient": list(gradient), "hessian": rows(hessian)}}


def edge_edge(case):
    of = ends(case)
    gradient, hessian = ipctk.edge_edge_distance_gradient(*of), ipctk.edge_edge_distance_hessian(*of)
    return {"d": {"value": ipctk.edge_edge_distance(*of), "gradient": list(gradient), "hessian": rows(hessian)}}


def closest_point(case):
    if not is_inside(case):
        return None
    of = ends(case)
    at, jacobian = ipctk.edge_edge_closest_point(*of), ipctk.edge_edge_closest_point_jacobian(*of)
    return {name: {"value": at[i], "gradient": list(jacobian[i])} for i, name in enumerate(("xi", "xi_bar"))}


FUNCTIONS = {
    "line-line": (line_line, {"distance": "d^2", "only": ["d"], "only_held": "none"}),
    "signed": (signed, {"only": ["d"], "only_held": "none"}),
    "edge-edge": (edge_edge, {"distance": "d^2", "only": ["d"]}),
    "closest-point": (
        closest_point,
        {"parameter": "[0,1]", "only": ["xi:value", "xi:first", "xi_bar:value", "xi_bar:first"], "only_held": "none"},
    ),
}

element, conventions = FUNCTIONS[sys.argv[1]]
answer(element, ["segment"] * 2, program=f"ipctk {sys.argv[1]}", version=ipctk.__version__, **conventions)
