// The closed form by hand for four pairs at once, one in each lane. Numbers replace the columns of reference.cpp. Of every
// Hessian the half above the diagonal is computed and stored.
//
// A block, in numbers of four lanes, PEER_HALF of them: 0 value, 8 gradient[24], 32 hessian, row i from column i on.

#include "peer.h"
#include <immintrin.h>

namespace {

constexpr int PEER_HALF = 332;

/// Four numbers, one for each pair.
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

/// Common terms of all quantities.
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

/// The Hessian X P + Y P_bar: of xi with X = p and Y = q, of xi_bar with X = -q and Y = r. As in reference.cpp.
struct Parameter {
    V X, Y;
    Vector w0, w0_bar, w1, w1_bar, w2, w2_bar;
    V with[24], with_bar[24], along[24], along_bar[12];
    V hat[24], row[24], bar_row[12]; // K_i, and L_i of either beam's rows

    Parameter(const First &o, V X, V Y) : X(X), Y(Y) {
        const Curve &x = o.x, &y = o.y;
        const V b1 = dot(y.t, x.t1), b2 = dot(x.t, y.t1);
        const V in_g = -X * (1.5 * dot(x.t, x.t1) + .5 * dot(o.d, x.t2)) - .5 * Y * b1, in_h = X * b1;
        const V bar_in_g = -Y * b2, bar_in_h = .5 * X * b2 - Y * (.5 * dot(o.d, y.t2) - 1.5 * dot(y.t, y.t1));
        w0 = in_g * o.u - X * x.t1 - in_h * o.v;
        w0_bar = bar_in_g * o.u - Y * y.t1 - bar_in_h * o.v;
        w1 = (in_h * o.q - in_g * o.p) * o.d - 2 * X * x.t - Y * y.t;
        w1_bar = (bar_in_h * o.q - bar_in_g * o.p) * o.d + X * y.t;
        w2 = (-in_g * o.q - in_h * o.r) * o.d - Y * x.t;
        w2_bar = (-bar_in_g * o.q - bar_in_h * o.r) * o.d + 2 * Y * y.t + X * x.t;
        spread(with, x, y, w0, w1, w2);
        spread(with_bar, x, y, w0_bar, w1_bar, w2_bar);
        const Vector x_d = X * o.d, y_d = Y * o.d;
        for (int a = 0; a < 4; a++)
            for (int i = 0; i < 3; i++) {
                with[3 * a + i] -= x.s[2][a] * x_d[i];
                with_bar[12 + 3 * a + i] -= y.s[2][a] * y_d[i];
            }
#pragma GCC unroll 1
        for (int c = 0; c < 24; c++) along[c] = o.q * with_bar[c] - o.p * with[c];
#pragma GCC unroll 1
        for (int c = 0; c < 12; c++) along_bar[c] = -o.q * with[12 + c] - o.r * with_bar[12 + c];
    }

    /// Sets K_i and L_i.
    void set_rows(const First &o, int i) {
        const Curve &x = o.x, &y = o.y;
#pragma GCC unroll 1
        for (int c = 0; c < 24; c++) {
            hat[c] = o.u[i] * with[c] - o.v[i] * with_bar[c] + w0[i] * o.g[c] + w0_bar[i] * o.h[c];
            row[c] = o.d[i] * along[c] + w1[i] * o.g[c] + w1_bar[i] * o.h[c];
        }
#pragma GCC unroll 1
        for (int c = 0; c < 12; c++)
            bar_row[c] = o.d[i] * along_bar[c] + w2[i] * o.g[12 + c] + w2_bar[i] * o.h[12 + c];
        for (int a = 0; a < 4; a++) {
            hat[3 * a + i] -= X * x.s[1][a], hat[12 + 3 * a + i] -= Y * y.s[1][a];
            row[3 * a + i] -= X * x.s[0][a], row[12 + 3 * a + i] -= X * y.s[0][a];
            bar_row[3 * a + i] -= Y * y.s[0][a];
        }
    }
};

/// The length of a tangent, as in reference.cpp: own and other columns of g follow each other.
struct Length {
    V length, inverse, kappa, turn[12], own[12], other[12], q[12];
    Vector w;

    Length(const Curve &x, const V *g_own, const V *g_other) {
        length = _mm256_sqrt_pd(dot(x.t, x.t)), inverse = 1 / length, w = inverse * x.t, kappa = dot(w, x.t1);
        const V twice_mu = dot(w, x.t2) + (dot(x.t1, x.t1) - kappa * kappa) * inverse;
        const Vector change = inverse * (x.t1 - kappa * w);
        for (int a = 0; a < 4; a++)
            for (int i = 0; i < 3; i++) turn[3 * a + i] = x.s[2][a] * w[i] + x.s[1][a] * change[i];
        for (int c = 0; c < 12; c++) own[c] = turn[c] + twice_mu * g_own[c], other[c] = twice_mu * g_other[c];
    }

    void write_gradient(double *to, double *to_other, const Curve &x, const V *g_own, const V *g_other) const {
        for (int c = 0; c < 12; c++) {
            store(to + 4 * c, x.s[1][c / 3] * w[c % 3] + kappa * g_own[c]);
            store(to_other + 4 * c, kappa * g_other[c]);
        }
    }

    void set_rows(const Curve &x, int i) {
        Vector k = (-inverse * w[i]) * w;
        k.c[i] += inverse;
        for (int c = 0; c < 12; c++) q[c] = x.s[1][c / 3] * k[c % 3];
    }
};

void write_all(const double *const q[4], double *out) {
    constexpr int BLOCK = 4 * PEER_HALF;
    const First o(q);
    const Curve &x = o.x, &y = o.y;
    write_d(o, out);
    Parameter f(o, o.p, o.q), f_bar(o, -o.q, o.r);
    Length t(x, o.g, o.g + 12), t_bar(y, o.h + 12, o.h);
    const V values[4] = {V{q[0][24], q[1][24], q[2][24], q[3][24]}, V{q[0][25], q[1][25], q[2][25], q[3][25]}, t.length,
                         t_bar.length};
    for (int k = 0; k < 4; k++) store(out + (1 + k) * BLOCK, values[k]);
    double *const gradient = out + 4 * 8;
    for (int c = 0; c < 24; c++) store(gradient + BLOCK + 4 * c, o.g[c]), store(gradient + 2 * BLOCK + 4 * c, o.h[c]);
    t.write_gradient(gradient + 3 * BLOCK, gradient + 3 * BLOCK + 48, x, o.g, o.g + 12);
    t_bar.write_gradient(gradient + 4 * BLOCK + 48, gradient + 4 * BLOCK, y, o.h + 12, o.h);
#pragma GCC unroll 1
    for (int i = 0; i < 3; i++) {
        f.set_rows(o, i), f_bar.set_rows(o, i), t.set_rows(x, i), t_bar.set_rows(y, i);
        const V x_d = f.X * o.d[i], y_d = f.Y * o.d[i], x_d_bar = f_bar.X * o.d[i], y_d_bar = f_bar.Y * o.d[i];
#pragma GCC unroll 1
        for (int a = 0; a < 4; a++) {
            const int r = 3 * a + i;
            {
                double *const to = row(out + BLOCK, r);
                const V s = x.s[0][a], s1 = x.s[1][a], s2 = x_d * x.s[2][a], s2_bar = x_d_bar * x.s[2][a];
                const V g_r = o.g[r], h_r = o.h[r], own_r = t.own[r];
#pragma GCC unroll 1
                for (int c = r; c < 12; c++) {
                    const V of_xi = s * f.hat[c] + s1 * f.row[c] - s2 * o.g[c];
                    const V of_bar = s * f_bar.hat[c] + s1 * f_bar.row[c] - s2_bar * o.g[c];
                    store(to + 4 * c, of_xi);
                    store(to + 4 * c + BLOCK, of_bar);
                    store(to + 4 * c + 2 * BLOCK, t.kappa * of_xi + g_r * t.turn[c] + own_r * o.g[c] + s1 * t.q[c]);
                    store(to + 4 * c + 3 * BLOCK, t_bar.kappa * of_bar + h_r * t_bar.other[c]);
                }
#pragma GCC unroll 1
                for (int c = 12; c < 24; c++) {
                    const V of_xi = s * f.hat[c] + s1 * f.row[c] - s2 * o.g[c];
                    const V of_bar = s * f_bar.hat[c] + s1 * f_bar.row[c] - s2_bar * o.g[c];
                    store(to + 4 * c, of_xi);
                    store(to + 4 * c + BLOCK, of_bar);
                    store(to + 4 * c + 2 * BLOCK, t.kappa * of_xi + own_r * o.g[c]);
                    store(to + 4 * c + 3 * BLOCK, t_bar.kappa * of_bar + h_r * t_bar.own[c - 12]);
                }
            }
            double *const to = row(out + BLOCK, 12 + r) + 48;
            const V *const g = o.g + 12, *const h = o.h + 12, *const hat = f.hat + 12, *const hat_bar = f_bar.hat + 12;
            const V s = y.s[0][a], s1 = y.s[1][a], s2 = y_d * y.s[2][a], s2_bar = y_d_bar * y.s[2][a];
            const V g_r = g[r], h_r = h[r], own_r = t_bar.own[r];
#pragma GCC unroll 1
            for (int c = r; c < 12; c++) {
                const V of_xi = s * hat[c] + s1 * f.bar_row[c] - s2 * h[c];
                const V of_bar = s * hat_bar[c] + s1 * f_bar.bar_row[c] - s2_bar * h[c];
                store(to + 4 * c, of_xi);
                store(to + 4 * c + BLOCK, of_bar);
                store(to + 4 * c + 2 * BLOCK, t.kappa * of_xi + g_r * t.other[c]);
                store(to + 4 * c + 3 * BLOCK, t_bar.kappa * of_bar + h_r * t_bar.turn[c] + own_r * h[c] + s1 * t_bar.q[c]);
            }
        }
    }
}
} // namespace

extern "C" void lanes_d_half(const double *const q[4], double *out) { write_d(First(q), out); }
extern "C" void lanes_all_half(const double *const q[4], double *out) { write_all(q, out); }
