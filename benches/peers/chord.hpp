// The two tasks in any scalar of automatic differentiation: positions and tangents from their definitions, the closest point
// by chord steps: Newton's method with the matrix of the real numbers. Each step makes one order of derivatives
// exact; d is stationary in the closest point and needs one step less.
#pragma once
#include <cmath>

template <class T> struct Curve {
    T x[3], t[3];

    Curve(const T *q, const T &z) {
        const T s[4] = {(2. - 3. * z + z * z * z) * .25, (1. - z - z * z + z * z * z) * .25,
                        (2. + 3. * z - z * z * z) * .25, (z * z * z + z * z - z - 1.) * .25};
        const T s1[4] = {.75 * (z * z - 1.), .25 * (3. * z * z - 2. * z - 1.), .75 * (1. - z * z),
                         .25 * (3. * z * z + 2. * z - 1.)};
        for (int i = 0; i < 3; i++) {
            x[i] = s[0] * q[i] + s[1] * q[3 + i] + s[2] * q[6 + i] + s[3] * q[9 + i];
            t[i] = s1[0] * q[i] + s1[1] * q[3 + i] + s1[2] * q[6 + i] + s1[3] * q[9 + i];
        }
    }
};

template <class T> T dot(const T *a, const T *b) { return T(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); }

/// The inverse of the matrix of d.t and d.t_bar in xi and xi_bar.
struct Chord {
    double p, q, r, s;

    Chord(const double *dofs, double xi, double xib) {
        const Curve<double> x(dofs, xi), y(dofs + 12, xib);
        double d[3], t1[3], u1[3];
        for (int i = 0; i < 3; i++) {
            d[i] = x.x[i] - y.x[i];
            t1[i] = second(dofs + i, xi), u1[i] = second(dofs + 12 + i, xib);
        }
        const double a = dot(x.t, x.t) + dot(d, t1), b = dot(x.t, y.t), c = dot(d, u1) - dot(y.t, y.t), det = a * c + b * b;
        p = c / det, q = b / det, r = -b / det, s = a / det;
    }

    static double second(const double *q, double z) {
        return 1.5 * z * (q[0] - q[6]) + .5 * (3 * z - 1) * q[3] + .5 * (3 * z + 1) * q[9];
    }
};

/// d, xi, xi_bar, t, t_bar.
template <class T> void quantities(const T *q, const Chord &chord, double at, double at_bar, int steps, bool all, T *to) {
    using std::sqrt;
    T xi(at), xib(at_bar);
    for (int k = 0; k < steps; k++) {
        const Curve<T> x(q, xi), y(q + 12, xib);
        T d[3];
        for (int i = 0; i < 3; i++) d[i] = x.x[i] - y.x[i];
        const T f = dot(d, x.t), g = dot(d, y.t);
        xi = xi - (chord.p * f + chord.q * g);
        xib = xib - (chord.r * f + chord.s * g);
    }
    const Curve<T> x(q, xi), y(q + 12, xib);
    T d[3];
    for (int i = 0; i < 3; i++) d[i] = x.x[i] - y.x[i];
    to[0] = sqrt(dot(d, d));
    if (all) to[1] = xi, to[2] = xib, to[3] = sqrt(dot(x.t, x.t)), to[4] = sqrt(dot(y.t, y.t));
}
