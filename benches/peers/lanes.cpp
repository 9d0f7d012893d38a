// The closed form by hand for four pairs at once, one in each lane: numbers where reference.cpp has columns. Of every
// Hessian the half above the diagonal is computed and stored.
//
// A block, in numbers of four lanes, PEER_HALF of them: 0 value, 8 gradient[24], 32 hessian, row i from column i on.

#include "peer.h"
#include <immintrin.h>

namespace {

constexpr int PEER_HALF = 332;

/// Four numbers, one a pair.
using V = __m256d;

inline V all(double x) { return _mm256_set1_pd(x); }
inline void store(double *p, V v) { _mm256_storeu_pd(p, v); }

struct Vector {
    V c[3];
    V operator[](int i) const { return c[i]; }
};
inline Vector operator+(Vector a, Vector b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
inline Vector operator-(Vector a, Vector b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
inline Vector operator*(V x, Vector a) { return {{x * a[0], x * a[1], x * a[2]}}; }
inline V dot(Vector a, Vector b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// A curve, with derivative k of shape function a; those of order zero are multiplied by SIGN.
struct Curve {
    V s[3][4];
    Vector x, t, t1, t2;
};

template <int SIGN> inline Curve curve(const V *q, V z) {
    const V square = z * z, half = all(.5), quarter = all(.25);
    Curve c;
    const V odd = quarter * z * (square - 3.), bent = quarter * (square - 1.);
    const V s0[4] = {half + odd, bent * (z - 1.), half - odd, bent * (z + 1.)};
    for (int a = 0; a < 4; a++) c.s[0][a] = SIGN * s0[a];
    const V slope = .75 * (square - 1.);
    c.s[1][0] = slope, c.s[1][2] = -slope;
    c.s[1][1] = .75 * square - .5 * z - .25, c.s[1][3] = .75 * square + .5 * z - .25;
    c.s[2][0] = 1.5 * z, c.s[2][1] = 1.5 * z - .5, c.s[2][2] = -1.5 * z, c.s[2][3] = 1.5 * z + .5;
    const auto node = [&](int a) { return Vector{{q[3 * a], q[3 * a + 1], q[3 * a + 2]}}; };
    const Vector x1 = node(0), t1 = node(1), x2 = node(2), t2 = node(3);
    c.x = s0[0] * x1 + s0[1] * t1 + s0[2] * x2 + s0[3] * t2;
    c.t = slope * (x1 - x2) + c.s[1][1] * t1 + c.s[1][3] * t2;
    c.t1 = c.s[2][0] * (x1 - x2) + c.s[2][1] * t1 + c.s[2][3] * t2;
    c.t2 = all(1.5) * (x1 - x2 + t1 + t2);
    return c;
}

/// (s; s_bar) w + s' w_beam + s_bar' w_bar, all 24 columns.
inline void spread(V *to, const Curve &x, const Curve &y, Vector w, Vector w_beam, Vector w_bar) {
#pragma GCC unroll 4
    for (int a = 0; a < 4; a++)
        for (int i = 0; i < 3; i++) {
            to[3 * a + i] = x.s[0][a] * w[i] + x.s[1][a] * w_beam[i];
            to[12 + 3 * a + i] = y.s[0][a] * w[i] + y.s[1][a] * w_bar[i];
        }
}

/// What all quantities share.
struct First {
    Curve x, y;
    Vector d, n, u, v;
    V distance, inverse, p, q, r, g[24], h[24];

    First(const double *const dofs[4]) {
        V q_[26];
        for (int i = 0; i < 26; i++) q_[i] = V{dofs[0][i], dofs[1][i], dofs[2][i], dofs[3][i]};
        x = curve<1>(q_, q_[24]), y = curve<-1>(q_ + 12, q_[25]);
        d = x.x - y.x;
        const V square = dot(d, d), a = dot(x.t, x.t) + dot(d, x.t1), b = dot(x.t, y.t), c = dot(d, y.t1) - dot(y.t, y.t);
        const V over_det = 1 / (a * c + b * b);
        distance = _mm256_sqrt_pd(square), inverse = 1 / distance;
        p = c * over_det, q = b * over_det, r = a * over_det;
        n = inverse * d, u = (-p) * x.t - q * y.t, v = r * y.t - q * x.t;
        spread(g, x, y, u, (-p) * d, (-q) * d);
        spread(h, x, y, all(-1) * v, q * d, (-r) * d);
    }
};

inline double *row(double *block, int r) { return block + 4 * (32 + 24 * r - r * (r - 1) / 2 - r); }

inline void write_d(const First &o, double *out) {
    const Curve &x = o.x, &y = o.y;
    V gradient[24];
    spread(gradient, x, y, o.n, Vector{}, Vector{});
    store(out, o.distance);
    for (int c = 0; c < 24; c++) store(out + 4 * (8 + c), gradient[c]);
    const Vector u = o.inverse * o.u, v = o.inverse * o.v;
#pragma GCC unroll 3
    for (int i = 0; i < 3; i++) {
        Vector k = x.t[i] * u + y.t[i] * v - (o.inverse * o.n[i]) * o.n;
        k.c[i] += o.inverse;
        V rows[24];
        spread(rows, x, y, k, o.u[i] * o.n, o.v[i] * o.n);
#pragma GCC unroll 4
        for (int a = 0; a < 4; a++) {
            const int r = 3 * a + i;
            const V s = x.s[0][a], s1 = x.s[1][a] * o.n[i], z = y.s[0][a], z1 = y.s[1][a] * o.n[i];
            double *to = row(out, r), *to_bar = row(out, 12 + r);
#pragma GCC unroll 24
            for (int c = r; c < 24; c++) store(to + 4 * c, s * rows[c] + s1 * o.g[c]);
#pragma GCC unroll 12
            for (int c = 12 + r; c < 24; c++) store(to_bar + 4 * c, z * rows[c] - z1 * o.h[c]);
        }
    }
}
} // namespace

extern "C" void lanes_d_half(const double *const q[4], double *out) { write_d(First(q), out); }
