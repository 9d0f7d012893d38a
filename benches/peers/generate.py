"""Generates C code for the two tasks by CasADi and by SymPy: one file with one function for each task."""

import pathlib
import sys

UPPER = [(i, j) for i in range(24) for j in range(i, 24)]


def curve(q, xi):
    """The cubic Hermite curve of 12 dofs, component by component."""
    shapes = [(2 - 3 * xi + xi**3) / 4, (1 - xi - xi**2 + xi**3) / 4, (2 + 3 * xi - xi**3) / 4, (-1 - xi + xi**2 + xi**3) / 4]
    return [sum(shapes[a] * q[3 * a + i] for a in range(4)) for i in range(3)]


def casadi(to, implicit):
    """By the envelope theorem, d's Hessian needs first derivatives of xi only; `implicit` treats d like any other quantity.

    xi and xi_bar: y(q) with R(q, y) = 0, R = (d.t, d.t_bar). All derivatives of explicit functions are from CasADi. Here
    they are combined. Symmetric matrices are computed above the diagonal.
    """
    import casadi as ca

    q, xi, xib = ca.SX.sym("q", 24), ca.SX.sym("xi"), ca.SX.sym("xib")
    y = ca.vertcat(xi, xib)
    x, x_bar = ca.vertcat(*curve(ca.vertsplit(q[:12]), xi)), ca.vertcat(*curve(ca.vertsplit(q[12:]), xib))
    t, t_bar, d = ca.jacobian(x, xi), ca.jacobian(x_bar, xib), x - x_bar
    norm = lambda v: ca.sqrt(ca.dot(v, v))
    symmetric = lambda h: ca.triu2symm(ca.triu(h))

    def parts(f):
        """f's gradient and Hessian in (q, y), in blocks."""
        hessian, gradient = ca.hessian(f, ca.vertcat(q, y))
        return gradient[:24], gradient[24:], hessian[:24, :24], hessian[:24, 24:], hessian[24:, 24:]

    residuals = [ca.dot(d, t), ca.dot(d, t_bar)]
    inverse = ca.inv(ca.jacobian(ca.vertcat(*residuals), y))
    Y = -inverse @ ca.jacobian(ca.vertcat(*residuals), q)

    def second(f, fixed):
        """The second derivative of f(q, y(q)), without the term of the second derivative of y."""
        _, _, qq, qy, yy = fixed
        with_y = (qy + Y.T @ yy / 2) @ Y
        return qq + with_y + with_y.T

    def total(f):
        fixed = parts(f)
        h = second(f, fixed) + fixed[1][0] * H_y[0] + fixed[1][1] * H_y[1]
        return [f, fixed[0] + Y.T @ fixed[1], symmetric(h)]

    S = [symmetric(second(r, parts(r))) for r in residuals]
    H_y = [symmetric(-(inverse[k, 0] * S[0] + inverse[k, 1] * S[1])) for k in range(2)]
    if implicit:
        of_d = total(norm(d))
    else:
        g, _, qq, qy, _ = parts(norm(d))
        of_d = [norm(d), g, symmetric(qq + qy @ Y)]
    of_all = of_d + [xi, Y[0, :].T, H_y[0], xib, Y[1, :].T, H_y[1]] + total(norm(t)) + total(norm(t_bar))
    for task, results in [("d", of_d), ("all", of_all)]:
        results = ca.cse([ca.densify(result) for result in results])
        name = f"casadi_{'implicit_' if implicit else ''}{task}"
        function = ca.Function(name, [q, xi, xib], results)
        here = pathlib.Path.cwd()
        function.generate(f"{name}.c", {"casadi_int": "int"})
        (here / f"{name}.c").replace(to / f"{name}.c")
        print(f"{name}: {function.n_instructions()} instructions")


def sympy(to):
    """The same by SymPy: partial derivatives by diff, then their combinations, each with common subexpressions."""
    import sympy as sp

    q, (xi, xib) = sp.symbols("q:24"), sp.symbols("xi xib")
    z = list(q) + [xi, xib]
    x, x_bar = curve(q[:12], xi), curve(q[12:], xib)
    dot = lambda u, v: sum(a * b for a, b in zip(u, v))
    d, t, t_bar = [a - b for a, b in zip(x, x_bar)], [sp.diff(a, xi) for a in x], [sp.diff(a, xib) for a in x_bar]
    code, named = [], {}

    def name(prefix, expression):
        """A symbol for a partial derivative, or its number if it is constant."""
        if expression.is_number:
            return expression
        symbol = sp.Symbol(f"{prefix}_{len(named)}")
        named[symbol] = expression
        return symbol

    def parts(f, prefix):
        first = [sp.diff(f, v) for v in z]
        gradient = [name(prefix, e) for e in first]
        hessian = [[None] * 26 for _ in range(26)]
        for i in range(26):
            for j in range(i, 26):
                hessian[i][j] = hessian[j][i] = name(prefix, sp.diff(first[i], z[j]))
        return f, gradient, hessian

    def write(assignments, prefix):
        symbols = sp.numbered_symbols(prefix)
        shared, reduced = sp.cse([e for _, e in assignments], symbols=symbols)
        print_c = lambda e: sp.ccode(sp.sympify(e).xreplace({}), standard="c99")
        body = [f"    const double {s} = {print_c(e)};" for s, e in shared]
        return body + [f"    {target} = {print_c(e)};" for (target, _), e in zip(assignments, reduced)]

    # Half the squares have polynomial derivatives. The derivatives of the lengths follow from them.
    half_squared = [parts(dot(v, v) / 2, n) for v, n in [(d, "d"), (t, "t"), (t_bar, "u")]]
    residuals = [parts(dot(d, t), "r"), parts(dot(d, t_bar), "s")]
    inverse, length = sp.symbols("i:4"), sp.symbols("l:3")
    Y = [sp.symbols("Y:24"), sp.symbols("Z:24")]
    W = [sp.symbols("W:24"), sp.symbols("V:24")]  # qy + Y' yy / 2, one column a parameter
    P = {(i, j): sp.Symbol(f"P{i}_{j}") for i, j in UPPER}
    H = [{(i, j): sp.Symbol(f"{n}{i}_{j}") for i, j in UPPER} for n in ["X", "B"]]

    def with_y(of):
        """Assignments of W for a quantity."""
        h = of[2]
        return [(f"const double {W[k][i]}", h[i][24 + k] + (Y[0][i] * h[24][24 + k] + Y[1][i] * h[25][24 + k]) / 2)
                for k in range(2) for i in range(24)]

    def second(of, i, j):
        return of[2][i][j] + W[0][i] * Y[0][j] + W[1][i] * Y[1][j] + W[0][j] * Y[0][i] + W[1][j] * Y[1][i]

    r_y = [[r[1][24 + k] for k in range(2)] for r in residuals]
    det = r_y[0][0] * r_y[1][1] - r_y[0][1] * r_y[1][0]
    adjugate = [r_y[1][1], -r_y[0][1], -r_y[1][0], r_y[0][0]]

    def block(k, value, gradient, hessian):
        lines = [(f"out[{608 * k}]", value)] + [(f"out[{608 * k + 8 + i}]", g) for i, g in enumerate(gradient)]
        for i, j in UPPER:
            at = f"out[{608 * k + 32 + 24 * i + j}]"
            lines.append((at if i == j else f"out[{608 * k + 32 + 24 * j + i}] = {at}", hessian(i, j)))
        return lines

    def scope(lines):
        return ["    {"] + ["    " + line for line in lines] + ["    }"]

    common = write([(f"const double {inverse[k]}", adjugate[k] / det) for k in range(4)]
                   + [(f"const double {length[0]}", sp.sqrt(dot(d, d)))], "c")
    common += write([(f"const double {Y[k][i]}", -(inverse[2 * k] * residuals[0][1][i] + inverse[2 * k + 1] * residuals[1][1][i]))
                     for k in range(2) for i in range(24)], "y")
    n = sp.symbols("n:24")
    common += write([(f"const double {n[i]}", half_squared[0][1][i] / length[0]) for i in range(24)], "g")
    h = half_squared[0][2]
    of_d = write(block(0, length[0], n, lambda i, j: (h[i][j] + h[i][24] * Y[0][j] + h[i][25] * Y[1][j] - n[i] * n[j]) / length[0]), "a")
    task_d = common + of_d
    task_all = task_d[:]
    # R's second derivatives are stored in P, then combined to those of both parameters.
    declared = []
    for k, r in enumerate(residuals):
        names = {(i, j): sp.Symbol(f"{'PS'[k]}{i}_{j}") for i, j in UPPER}
        declared.append(names)
        task_all += ["    double " + ", ".join(str(s) for s in names.values()) + ";"]
        task_all += scope(write(with_y(r), "w") + write([(str(names[ij]), second(r, *ij)) for ij in UPPER], "v"))
    task_all += write([(f"const double {H[k][ij]}", -(inverse[2 * k] * declared[0][ij] + inverse[2 * k + 1] * declared[1][ij]))
                       for k in range(2) for ij in UPPER], "h")
    for k, parameter in enumerate([xi, xib]):
        task_all += write(block(1 + k, parameter, Y[k], lambda i, j: H[k][i, j]), f"b{k}_")
    for k in range(2):
        of = half_squared[1 + k]
        value, slope = sp.Symbol(f"l{k + 1}"), of[1][24:]
        g = sp.symbols(f"m{k}_:24")
        lines = write([(f"const double {value}", sp.sqrt(2 * of[0]))], "e")
        lines += write([(f"const double {g[i]}", (of[1][i] + Y[0][i] * slope[0] + Y[1][i] * slope[1]) / value) for i in range(24)], "k")
        lines += write(with_y(of), "w")
        lines += write(block(3 + k, value, g, lambda i, j: (second(of, i, j) + slope[0] * H[0][i, j] + slope[1] * H[1][i, j] - g[i] * g[j]) / value), "f")
        task_all += scope(lines)

    def function(task, body):
        text = "\n".join(body)
        import re
        used = set(re.findall(r"[A-Za-z_]\w*", text))
        partials = write([(f"const double {s}", e) for s, e in named.items() if str(s) in used], "x")
        return (f"#include <math.h>\nvoid sympy_{task}_full(const double *dofs, double xi, double xib, double *out) {{\n"
                + "\n".join(f"    const double q{i} = dofs[{i}];" for i in range(24)) + "\n"
                + "\n".join(partials) + "\n" + text + "\n}\n")

    for task, body in [("d", task_d), ("all", task_all)]:
        (to / f"sympy_{task}.c").write_text(function(task, body))


if __name__ == "__main__":
    to = pathlib.Path(sys.argv[2])
    if sys.argv[1] == "casadi":
        casadi(to, implicit=False)
        casadi(to, implicit=True)
    else:
        sympy(to)
