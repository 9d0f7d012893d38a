#!/usr/bin/env python3
"""Derives the element `sympy` and writes it as C: python3 generate.py > generated.h. Needs SymPy 1.14.

Both curves are their Taylor series about the closest point. A direction of the dofs moves a point by u, its tangent by u1
and the next derivative by u2. Two directions have the amplitudes a and b. The parameters z and y follow from d.t = 0 and
d.t_bar = 0. All else is differentiation.
"""
from sympy import (Matrix, Rational, Symbol, ccode, cse, diff, hessian, horner, numbered_symbols, solve, sqrt, symbols)

z, y, a, b, s = symbols("z y a b s")
p, q, pq = symbols("p q pq")  # derivatives of xi: along a, along b, along both
r, t, rt = symbols("r t rt")  # those of xi_bar
moved, moved_bar = symbols("moved moved_bar")  # xi - xi_0 and its twin


def F(number, wrong):
    """The factor of a term: 1, or `wrong` if this error is put in. It is printed as the macro of element.h."""
    return Symbol(f"F({number}, {wrong})")


def E(number, right, wrong):
    return F(number, 0) * right + (1 - F(number, 0)) * wrong


def vector(name, first):
    return Matrix([Symbol(f"{name}[{first + c}]") for c in range(3)])


D, T, C, K, S, Q, L = (vector("g", 3 * i) for i in range(7))
u, u1, u2, v, v1, v2 = (vector("u", 3 * i) for i in range(6))
w, w1, w2, o, o1, o2 = (vector("w", 3 * i) for i in range(6))


def series(of, at):
    return of[0] + of[1] * at + of[2] * at**2 / 2


x = T * z + F(301, 2) * C * z**2 / 2 + F(302, 0) * K * z**3 / 6
x += a * series([u, u1, F(303, 0) * u2], z) + b * series([w, w1, F(303, 0) * w2], z)
x_bar = S * y + F(304, 0) * Q * y**2 / 2 + F(305, -1) * L * y**3 / 6
x_bar += a * series([v, F(306, 0) * v1, v2], y) + b * series([o, F(306, 0) * o1, o2], y)
d = D + x - F(307, -1) * x_bar
tangent, tangent_bar = x.diff(z), x_bar.diff(y)
half = d.dot(d) / 2
equations = [diff(half, z), E(308, diff(half, y), -d.dot(tangent_bar.subs(y, 0)))]

origin = {z: 0, y: 0, a: 0, b: 0}
at_origin = lambda expression: expression.subs({a: 0, b: 0}).subs({z: 0, y: 0})
path = {z: p * a + q * b + pq * a * b, y: r * a + t * b + rt * a * b}
path_at_rest = {z: p * a + F(309, 0) * q * b, y: r * a + t * b}
length = sqrt(tangent.subs(z, F(310, 0) * z).dot(tangent.subs(z, F(310, 0) * z)))
length_bar = sqrt(tangent_bar.dot(tangent_bar))
slip = (moved + F(311, 0) * z) * length
slip_bar = (moved_bar + y) * E(312, length_bar, length)
distance = sqrt(d[0] ** 2 + d[1] ** 2 + F(313, 0) * d[2] ** 2)
quantities = [distance, length, length_bar, slip, slip_bar]


def along_path(expression, path, *amplitudes):
    expression = expression.subs(path, simultaneous=True)
    for amplitude in amplitudes:
        expression = diff(expression, amplitude)
    return expression.subs({a: 0, b: 0})


def shapes():
    """The cubic Hermite functions from their values and slopes at -1 and 1, with three derivatives."""
    c = symbols("c0:4")
    cubic = sum(c[i] * s**i for i in range(4))
    rows = [cubic.subs(s, -1), F(314, 2) * diff(cubic, s).subs(s, -1), cubic.subs(s, 1), diff(cubic, s).subs(s, 1)]
    of = [cubic.subs(solve([row - int(i == j) for j, row in enumerate(rows)], c)) for i in range(4)]
    return [horner(diff(f, s, k), s) if k < 2 else diff(f, s, k) for k in range(4) for f in of]


functions = {
    "shapes": ("double s", shapes()),
    "matrix": ("const double *g", [at_origin(entry) for entry in hessian(half, (z, y))]),
    "first_right": ("const double *g, const double *u", [-at_origin(diff(f, a)) for f in equations]),
    "first": (
        "const double *g, const double *u, double p, double r, double moved, double moved_bar",
        [along_path(f.subs(b, 0), {z: p * a, y: r * a}, a) for f in quantities],
    ),
    "second_right": (
        "const double *g, const double *u, const double *w, double p, double q, double r, double t",
        [-along_path(f, path_at_rest, a, b) for f in equations],
    ),
    "second": (
        "const double *g, const double *u, const double *w, double p, double q, double pq, double r, double t, "
        "double rt, double moved, double moved_bar",
        [along_path(f, path, a, b) for f in quantities],
    ),
}

# Errors of someone who edits the generated code: number, function, text, wrong text.
EDITS = [
    (315, "shapes", "s*(x0 - 3)", "s*(x0 + 3)"),
    (316, "matrix", "F(301, 2)*g[1]*g[7]", "F(301, 2)*g[1]*g[6]"),
    (317, "matrix", "g[14]*g[5]", "g[14]*g[4]"),
    (318, "first_right", "g[1]*u[4]", "g[1]*u[3]"),
    (319, "first_right", "g[14]*x2", "g[13]*x2"),
    (320, "first", "g[7]*x1 + u[4]", "g[7]*x1 - u[4]"),
    (321, "first", "moved*x2", "moved*x0"),
    (322, "second_right", "p*w[4] + u[4]*x1", "p*w[4]"),
    (323, "second_right", "g[18]*x29", "g[19]*x29"),
    (324, "second_right", "g[11]*x3", "g[10]*x3"),
    (325, "second_right", "x12*(g[6]*x11 + w[3])", "x6*(g[6]*x11 + w[3])"),
    (326, "second", "x31*x36", "x31*x31"),
    (327, "second", "x57 - x54/x43", "x57 + x54/x43"),
    (328, "second", "x42 - x37/x22", "x42 - x37"),
    (329, "second", "x46*x50", "x46*x46"),
    (330, "second", "p*x36*x58", "q*x36*x58"),
]

print("/* Written by generate.py with SymPy. */")
for name, (arguments, results) in functions.items():
    steps, results = cse(results, symbols=numbered_symbols("x"), optimizations="basic")
    body = "".join(f"    const double {symbol} = {ccode(step)};\n" for symbol, step in steps)
    body += "".join(f"    to[{i}] = {ccode(result)};\n" for i, result in enumerate(results))
    for number, function, text, wrong in EDITS:
        if function == name:
            assert text in body, f"error {number}: {text} is not in {name}; another version of SymPy?"
            body = body.replace(text, f"E({number}, {text}, {wrong})", 1)
    print(f"\nstatic void {name}({arguments}, double *to) {{\n{body}}}")
