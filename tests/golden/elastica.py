"""Contact forces of the crossed beams from the differential equations of both beams, without finite elements.

Both beams are extensible elasticas without shear and torsion: EA times the strain is the axial force, and EI times the turning of the
tangent over the length of the reference is the bending moment. The beam is clamped at both ends and loaded at its middle, so it bends
in the plane of the force. The bar beam is free up to the contact point. There it has the contact force, and the couple of friction,
which acts at the distance d. Each beam is integrated from one end; Newton's method finds what makes the other end fit.

Prints F_N for mu = 0 and mu = 0.3 with slip, in steps 3 to 6. Takes half a minute.
"""
from math import cos, hypot, sin

EA, EI, EPS, RADII = 1e8 * 4e-2, 1e8 * 2e-4, 1e4, 0.4
INTERVALS = 200


def end(force, start, length):
    """Position, angle and moment at the end of a beam with a constant inner force, by the method of Runge and Kutta."""
    def slope(state):
        _, _, angle, moment = state
        c, s = cos(angle), sin(angle)
        stretch = 1 + (force[0] * c + force[1] * s) / EA
        return [stretch * c, stretch * s, moment / EI, stretch * (s * force[0] - c * force[1])]

    def moved(state, by, along):
        return [x + by * v for x, v in zip(state, along)]

    h, state = length / INTERVALS, start
    for _ in range(INTERVALS):
        a = slope(state)
        b = slope(moved(state, h / 2, a))
        c = slope(moved(state, h / 2, b))
        d = slope(moved(state, h, c))
        state = [x + h / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(state, a, b, c, d)]
    return state


def newton(residual, x):
    """A zero of residual, with a Jacobian of differences."""
    for _ in range(50):
        rows = [[-r] for r in residual(x)]
        for j in range(len(x)):
            h = 1e-6 * max(1, abs(x[j]))
            ahead, behind = ([v + s * h * (i == j) for i, v in enumerate(x)] for s in (1, -1))
            for row, p, m in zip(rows, residual(ahead), residual(behind)):
                row.insert(j, (p - m) / (2 * h))
        for i in range(len(x)):
            rows[i:] = sorted(rows[i:], key=lambda row: -abs(row[i]))
            rows[i] = [v / rows[i][i] for v in rows[i]]
            rows = [row if k == i else [v - row[i] * w for v, w in zip(row, rows[i])] for k, row in enumerate(rows)]
        x = [v + row[-1] for v, row in zip(x, rows)]
        if max(abs(row[-1]) for row in rows) < 1e-11 * max(map(abs, x)):
            return x
    raise ArithmeticError("Newton's method does not converge")


def deflection(force):
    """Of the middle of the beam, which is clamped at both ends of its length 10."""
    def half(x):
        axial, moment = 1e3 * x[0], x[1]
        return end((axial, force / 2), [0, 0, 0, moment], 5)

    def misfit(x):
        along, _, angle, _ = half(x)
        return [along - 5, angle]

    return half(newton(misfit, [0, 1.25 * force]))[1]


def normal_force(step, mu, guess):
    """F_N, and the place on the bar beam, its angle there, and the distance d."""
    def residual(x):
        place, angle, distance = x
        tangent, normal = (cos(angle), sin(angle)), (-sin(angle), cos(angle))
        f_n = EPS * (RADII - distance)
        # The couple bends the bar beam on one side of the contact point: half of its curvature is in the slip's derivative.
        friction = mu * f_n / (1 + mu * f_n * distance**2 / (2 * EI))
        force = [f_n * n + friction * t for n, t in zip(normal, tangent)]
        x_end, z_end, angle_end, _ = end(force, [0, 0, angle, -friction * distance], 14 - place)
        size = hypot(*force)
        away = deflection(size) / size
        d = (4 + away * force[0] - 14 - 0.03 * step + x_end, 1 + away * force[1] - 0.3 * step + z_end)
        return [angle_end, d[0] * tangent[0] + d[1] * tangent[1], d[0] * normal[0] + d[1] * normal[1] - distance]

    found = newton(residual, guess)
    return EPS * (RADII - found[2]), found


for mu, first in ((0.0, 3), (0.3, 4)):
    guess, forces = [4.0, 0.04 * (first - 2), RADII - 1.7e-3 * (first - 2)], []
    for step in range(first, 7):
        f_n, guess = normal_force(step, mu, guess)
        guess = [guess[0], guess[1] + 0.04, guess[2] - 1.6e-3]
        forces.append(f"{f_n:.5f}")
    print("mu =", mu, *forces)
