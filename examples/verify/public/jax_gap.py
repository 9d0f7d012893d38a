"""Answers pairs of cubic Hermite beams by automatic differentiation in JAX.

    beamgap export --family hermite -o vectors.jsonl
    beamgap verify vectors.jsonl --time-out 300 --run "python3 jax_gap.py unrolled"

unrolled   jax.hessian of the gap through the iterations of Newton's method for the closest point
implicit   the same through jax.lax.custom_root, which differentiates the equation of the solution
"""
import sys

import jax
import jax.numpy as jnp
from stream import answer, rows

jax.config.update("jax_enable_x64", True)
STEPS = 4
AWAY = 1e-5


def point(q, xi):
    """A cubic Hermite curve: q is point, tangent, point, tangent, and tangents are dx/dxi."""
    shapes = jnp.stack([2 - 3 * xi + xi**3, 1 - xi - xi**2 + xi**3, 2 + 3 * xi - xi**3, -1 - xi + xi**2 + xi**3]) / 4
    return shapes @ q.reshape(4, 3)


def difference(q, at):
    return point(q[:12], at[0]) - point(q[12:], at[1])


def half_squared(at, q):
    return 0.5 * jnp.sum(difference(q, at) ** 2)


def condition(at, q, start, free):
    """Zero at the closest point. A parameter that is held at an end is constant."""
    return jnp.where(free, jax.grad(half_squared)(at, q), at - start)


def solved(matrix, b):
    """Solves two equations by Cramer's rule."""
    (m00, m01), (m10, m11) = matrix
    return jnp.stack([m11 * b[0] - m01 * b[1], m00 * b[1] - m10 * b[0]]) / (m00 * m11 - m01 * m10)


def newton(residual, at):
    for _ in range(STEPS):
        at = at - solved(jax.jacfwd(residual)(at), residual(at))
    return at


def unrolled(q, start, free):
    # The start differs from the closest point, so that the iterations are needed.
    return newton(lambda at: condition(at, q, start, free), start + jnp.where(free, AWAY, 0.0))


def implicit(q, start, free):
    tangent_solve = lambda linear, b: solved(jax.jacfwd(linear)(b), b)
    residual = lambda at: condition(at, q, start, free)
    return jax.lax.custom_root(residual, start + jnp.where(free, AWAY, 0.0), newton, tangent_solve)


METHODS = {"unrolled": unrolled, "implicit": implicit}
closest = METHODS[sys.argv[1]]


def quantities(q, start, free):
    at = closest(q, start, free)
    return jnp.append(at, jnp.linalg.norm(difference(q, at)))


@jax.jit
def linearized(q, start, free):
    of = lambda q: quantities(q, start, free)
    return of(q), jax.jacfwd(of)(q), jax.hessian(of)(q)


def element(case):
    q = jnp.array(case["beam"]["q"] + case["bar"]["q"])
    start = jnp.array([case["point"]["xi"], case["point"]["xi_bar"]])
    held = case["held"]
    free = jnp.array([held not in ("xi", "both"), held not in ("xi_bar", "both")])
    values, gradients, hessians = linearized(q, start, free)
    of = zip(("xi", "xi_bar", "d"), values.tolist(), gradients.tolist(), hessians.tolist())
    return {name: {"value": value, "gradient": gradient, "hessian": rows(hessian)} for name, value, gradient, hessian in of}


answer(element, ["hermite"] * 2, program=f"JAX {sys.argv[1]}", version=jax.__version__, only=["xi", "xi_bar", "d"])
