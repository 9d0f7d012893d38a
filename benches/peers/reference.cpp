// The reference: the closed form for two cubic Hermite curves by hand, for AVX2 and FMA. See peer.h for the interface.
//
// Every derivative of a curve in its dofs is a shape value times a unit vector, so a row of a Hessian is
//     row(a, i) = s_a K_i + s'_a L_i + s''_a M_i,
// where a counts shape functions and i coordinates. K_i, L_i, M_i are 24 columns, six vectors of four. Common terms
// are computed once. The block of bar rows and beam columns is the transpose of its mirror image.
//
// With [[p, q], [-q, r]] the inverse matrix of the orthogonality conditions:
//     g = grad xi = (s; -s_bar) u - s' p d - s_bar' q d             u     = -(p t + q t_bar)
//     h = grad xi_bar = -(s; -s_bar) v + s' q d - s_bar' r d        v     = r t_bar - q t

#include "peer.h"
#include <cmath>
#include <immintrin.h>

namespace {

using V = __m256d;

inline V load(const double *p) { return _mm256_loadu_pd(p); }
inline void store(double *p, V v) { _mm256_storeu_pd(p, v); }
inline V all(double x) { return _mm256_set1_pd(x); }
inline V at(const double *p) { return _mm256_broadcast_sd(p); }
template <int I> inline V lane(V v) { return _mm256_permute4x64_pd(v, 0x55 * I); }

/// Twelve columns, those of one beam: dof (a, i) is column 3a + i.
struct Columns {
    V v[3];
};

/// s_a in column (a, i).
inline Columns by_shape(V s) {
    return {{_mm256_permute4x64_pd(s, 0x40), _mm256_permute4x64_pd(s, 0xA5), _mm256_permute4x64_pd(s, 0xFE)}};
}

/// w_i in column (a, i).
inline Columns by_axis(V w) {
    return {{_mm256_permute4x64_pd(w, 0x24), _mm256_permute4x64_pd(w, 0x49), _mm256_permute4x64_pd(w, 0x92)}};
}

inline Columns operator*(const Columns &x, const Columns &y) {
    return {{x.v[0] * y.v[0], x.v[1] * y.v[1], x.v[2] * y.v[2]}};
}
inline Columns operator*(V x, const Columns &y) { return {{x * y.v[0], x * y.v[1], x * y.v[2]}}; }
inline Columns operator+(const Columns &x, const Columns &y) {
    return {{x.v[0] + y.v[0], x.v[1] + y.v[1], x.v[2] + y.v[2]}};
}
inline Columns operator-(const Columns &x, const Columns &y) {
    return {{x.v[0] - y.v[0], x.v[1] - y.v[1], x.v[2] - y.v[2]}};
}
inline void store(double *p, const Columns &x) {
    for (int k = 0; k < 3; k++) store(p + 4 * k, x.v[k]);
}

/// The columns of both beams.
struct Both {
    Columns beam, bar;
};

/// One curve at its parameter. Vectors of space have a zero in their last lane.
struct Curve {
    V s[3][4];    // derivative k of shape function a, in all lanes
    Columns e[3]; // the same by columns
    V x, t, t1, t2;
};

inline V in_space(V v) { return _mm256_blend_pd(v, _mm256_setzero_pd(), 8); }

/// Shapes of order zero, and x with them, are multiplied by SIGN: d and its derivatives are sums over both beams then.
template <int SIGN> inline Curve curve(const double *q, double xi) {
    const V c0 = {.5, .25, .5, -.25}, c1 = {-.75, -.25, .75, -.25}, c2 = {0, -.25, 0, .25}, c3 = {.25, .25, -.25, .25};
    const V z = all(xi), square = z * z;
    const V shapes[3] = {(SIGN * c3 * z + SIGN * c2) * square + (SIGN * c1 * z + SIGN * c0),
                         3 * c3 * square + (2 * c2 * z + c1), 6 * c3 * z + 2 * c2};
    Curve c;
    for (int k = 0; k < 3; k++) {
        c.s[k][0] = lane<0>(shapes[k]), c.s[k][1] = lane<1>(shapes[k]);
        c.s[k][2] = lane<2>(shapes[k]), c.s[k][3] = lane<3>(shapes[k]);
        c.e[k] = by_shape(shapes[k]);
    }
    // The curve as a polynomial: t depends on q by fewer operations than with the shapes.
    const V x1 = in_space(load(q)), t1 = in_space(load(q + 3)), x2 = in_space(load(q + 6));
    const V t2 = in_space(_mm256_permute4x64_pd(load(q + 8), 0xF9));
    const V x = x1 - x2, sum = t1 + t2, difference = t1 - t2;
    const V q0 = .5 * (x1 + x2) + .25 * difference, q1 = -.75 * x - .25 * sum, q2 = -.25 * difference, q3 = .25 * (x + sum);
    c.x = SIGN * ((q3 * z + q2) * square + (q1 * z + q0));
    c.t = 3 * q3 * square + (2 * q2 * z + q1);
    c.t1 = 6 * q3 * z + 2 * q2;
    c.t2 = 6 * q3;
    return c;
}

/// The sums of the lanes of four vectors.
inline V sums(V a, V b, V c, V d) {
    const V ab = _mm256_hadd_pd(a, b), cd = _mm256_hadd_pd(c, d);
    return _mm256_permute2f128_pd(ab, cd, 0x21) + _mm256_blend_pd(ab, cd, 12);
}

/// Rows of twelve numbers become columns: bar rows of a full Hessian from its beam rows.
inline void mirror(double *hessian) {
#pragma GCC unroll 1
    for (int i = 0; i < 12; i += 4) {
#pragma GCC unroll 3
        for (int j = 12; j < 24; j += 4) {
            const double *from = hessian + 24 * i + j;
            double *to = hessian + 24 * j + i;
            const auto halves = [&](int row, int column) {
                const V low = _mm256_castpd128_pd256(_mm_loadu_pd(from + 24 * row + column));
                return _mm256_insertf128_pd(low, _mm_loadu_pd(from + 24 * (row + 2) + column), 1);
            };
            const V a = halves(0, 0), b = halves(1, 0), c = halves(0, 2), d = halves(1, 2);
            store(to, _mm256_unpacklo_pd(a, b));
            store(to + 24, _mm256_unpackhi_pd(a, b));
            store(to + 48, _mm256_unpacklo_pd(c, d));
            store(to + 72, _mm256_unpackhi_pd(c, d));
        }
    }
}

/// The place of a row of the beam in a block, and that of a row of the bar beam.
template <bool FULL> struct Layout {
    static constexpr int BLOCK = FULL ? PEER_FULL : PEER_UPPER;
    static double *beam(double *to, int row) { return to + (FULL ? PEER_HESSIAN + 24 * row : PEER_BEAM + 12 * row); }
    static double *mixed(double *to, int row) { return FULL ? beam(to, row) + 12 : to + PEER_MIXED + 12 * row; }
    static double *bar(double *to, int row) {
        return to + (FULL ? PEER_HESSIAN + 24 * (12 + row) + 12 : PEER_BAR + 12 * row);
    }
};

// The time of one pair is mostly the latency of the chain from the dofs to u and v. Instructions are scheduled for it before
// registers are allocated. write_all has enough independent instructions, so there this costs more than it gains.
template <bool FULL>
__attribute__((optimize("schedule-insns,sched-pressure"))) inline void write_d(const double *dofs, double xi, double xib, double *out) {
    using To = Layout<FULL>;
    const Curve x = curve<1>(dofs, xi), y = curve<-1>(dofs + 12, xib);
    const V d = x.x + y.x;
    // a = t.t + d.t', b = t.t_bar, c = a_bar = d.t_bar' - t_bar.t_bar
    const V dots = sums(x.t * x.t + d * x.t1, x.t * y.t, d * y.t1 - y.t * y.t, d * d);
    const V a = lane<0>(dots), b = lane<1>(dots), c = lane<2>(dots), square = lane<3>(dots);
    // u and v without the factor of the determinant, n without normalization
    const V of_det = b * b + a * c, u_det = V{} - c * x.t - b * y.t, v_det = a * y.t - b * x.t;
    const V over_det = 1 / of_det, over_square = 1 / square, length = _mm256_sqrt_pd(square), inverse = length * over_square;
    const V u = u_det * over_det, v = v_det * over_det, n = d * inverse;
    const V d_over_det = length * over_det, pd = c * d_over_det, qd = b * d_over_det, rd = a * d_over_det;
    const V over_both = inverse * over_det, over_cube = inverse * over_square;

    const Columns of_n = by_axis(n), of_u = by_axis(u), of_v = by_axis(v);
    const Columns slope = x.e[1] * of_n, slope_bar = y.e[1] * of_n;
    const Both g = {x.e[0] * of_u - pd * slope, y.e[0] * of_u - qd * slope_bar};
    const Both h = {qd * slope - x.e[0] * of_v, (V{} - rd) * slope_bar - y.e[0] * of_v};
    out[PEER_VALUE] = length[0];
    store(out + PEER_GRADIENT, x.e[0] * of_n);
    store(out + PEER_GRADIENT + 12, y.e[0] * of_n);

    const V unit[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    const V n_i[3] = {lane<0>(n), lane<1>(n), lane<2>(n)}, u_i[3] = {lane<0>(u), lane<1>(u), lane<2>(u)};
    const V v_i[3] = {lane<0>(v), lane<1>(v), lane<2>(v)}, d_i[3] = {lane<0>(d), lane<1>(d), lane<2>(d)};
    const V t_i[3] = {lane<0>(x.t), lane<1>(x.t), lane<2>(x.t)}, t_bar_i[3] = {lane<0>(y.t), lane<1>(y.t), lane<2>(y.t)};
#pragma GCC unroll 3
    for (int i = 0; i < 3; i++) {
        // (I - nn' + tu' + t_bar v')/d, row i
        const V k = (t_i[i] * u_det + t_bar_i[i] * v_det) * over_both + (unit[i] * inverse - (d_i[i] * d) * over_cube);
        const Columns of_k = by_axis(k);
        const Columns row = x.e[0] * of_k + u_i[i] * slope, row_bar = y.e[0] * of_k + v_i[i] * slope_bar;
        const Columns n_g = n_i[i] * g.beam, n_g_bar = n_i[i] * g.bar, n_h_bar = n_i[i] * h.bar;
#pragma GCC unroll 4
        for (int j = 0; j < 4; j++) {
            store(To::beam(out, 3 * j + i), x.s[0][j] * row + x.s[1][j] * n_g);
            store(To::mixed(out, 3 * j + i), x.s[0][j] * row_bar + x.s[1][j] * n_g_bar);
            store(To::bar(out, 3 * j + i), y.s[0][j] * row_bar - y.s[1][j] * n_h_bar);
        }
    }
    if (FULL) mirror(out + PEER_HESSIAN);
}

/// 1 in the columns (a, i).
alignas(32) const double AXIS[3][12] = {{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0},
                                        {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0},
                                        {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}};

/// A vector of space; each component is needed separately, in all lanes.
struct Components {
    alignas(32) double c[4];
    Components(V v) { store(c, v); }
    V operator[](int i) const { return at(c + i); }
};

/// Common first-order terms of xi and xi_bar.
struct First {
    V d, u, v, p, q, r;
    Both g, h;
};

/// The Hessian X P + Y P_bar: of xi with X = p and Y = q, of xi_bar with X = -q and Y = r.
struct Parameter {
    V X, Y;
    Both with, with_bar, along, along_bar;
    Components w0, w0_bar, w1, w1_bar, w2, w2_bar;

    Parameter(const Curve &x, const Curve &y, const First &o, V X, V Y, const V *dots)
        : Parameter(x, y, o, X, Y, V{} - X * dots[0] - .5 * Y * dots[1], X * dots[1], V{} - Y * dots[2],
                    .5 * X * dots[2] - Y * dots[3]) {}

    Parameter(const Curve &x, const Curve &y, const First &o, V X, V Y, V in_g, V in_h, V bar_in_g, V bar_in_h)
        : X(X), Y(Y), w0(in_g * o.u - X * x.t1 - in_h * o.v), w0_bar(bar_in_g * o.u - Y * y.t1 - bar_in_h * o.v),
          w1((in_h * o.q - in_g * o.p) * o.d - 2 * X * x.t - Y * y.t),
          w1_bar((bar_in_h * o.q - bar_in_g * o.p) * o.d + X * y.t),
          w2((V{} - in_g * o.q - in_h * o.r) * o.d - Y * x.t),
          w2_bar((V{} - bar_in_g * o.q - bar_in_h * o.r) * o.d + 2 * Y * y.t + X * x.t) {
        const Columns c = by_axis(load(w0.c)), c_bar = by_axis(load(w0_bar.c)), of_d = by_axis(o.d);
        with = {x.e[0] * c + x.e[1] * by_axis(load(w1.c)) - X * (x.e[2] * of_d),
                y.e[0] * c + y.e[1] * by_axis(load(w2.c))};
        with_bar = {x.e[0] * c_bar + x.e[1] * by_axis(load(w1_bar.c)),
                    y.e[0] * c_bar + y.e[1] * by_axis(load(w2_bar.c)) - Y * (y.e[2] * of_d)};
        along = {o.q * with_bar.beam - o.p * with.beam, o.q * with_bar.bar - o.p * with.bar};
        along_bar.bar = (V{} - o.q) * with.bar - o.r * with_bar.bar;
    }
};

/// The length of a tangent: H = kappa H_xi + g M' + M g' + s'_a Q_i with M = turn on its own beam plus mu g.
struct Length {
    V length, inverse, kappa;
    Components w;
    Columns slope, turn;
    Columns own, other; // turn + 2 mu g, 2 mu g
};

inline Length length(const Curve &x, V square, V t_t1, V t_t2, V t1_t1, const Columns &g_own, const Columns &g_other) {
    const V length = _mm256_sqrt_pd(square), inverse = length / square, w = x.t * inverse, kappa = t_t1 * inverse;
    const V twice_mu = (t_t2 + t1_t1 - kappa * kappa) * inverse;
    const Columns of_w = by_axis(w), slope = x.e[1] * of_w;
    const Columns turn = x.e[2] * of_w + x.e[1] * by_axis((x.t1 - kappa * w) * inverse);
    return {length, inverse, kappa, w, slope, turn, turn + twice_mu * g_own, twice_mu * g_other};
}

template <bool FULL> inline void write_all(const double *dofs, double xi, double xib, double *out) {
    using To = Layout<FULL>;
    double *const to_d = out, *const to_xi = out + To::BLOCK, *const to_xi_bar = out + 2 * To::BLOCK;
    double *const to_t = out + 3 * To::BLOCK, *const to_t_bar = out + 4 * To::BLOCK;
    const Curve x = curve<1>(dofs, xi), y = curve<-1>(dofs + 12, xib);
    const V d = x.x + y.x;
    alignas(32) double dots[16];
    store(dots, sums(x.t * x.t, x.t * y.t, y.t * y.t, d * d));
    store(dots + 4, sums(d * x.t1, d * y.t1, 1.5 * x.t * x.t1 + .5 * d * x.t2, y.t * x.t1));
    store(dots + 8, sums(x.t * y.t1, .5 * d * y.t2 - 1.5 * y.t * y.t1, x.t * x.t1, x.t * x.t2));
    store(dots + 12, sums(x.t1 * x.t1, y.t * y.t1, y.t * y.t2, y.t1 * y.t1));
    const auto dot = [&](int k) { return at(dots + k); };
    const V a = dot(0) + dot(4), b = dot(1), c = dot(5) - dot(2), square = dot(3);
    const V over_det = 1 / (b * b + a * c), over_square = 1 / square, distance = _mm256_sqrt_pd(square);
    const V inverse = distance * over_square, n = d * inverse;

    First o;
    o.d = d, o.p = c * over_det, o.q = b * over_det, o.r = a * over_det;
    o.u = V{} - o.p * x.t - o.q * y.t, o.v = o.r * y.t - o.q * x.t;
    const Columns of_n = by_axis(n), of_d = by_axis(d), of_u = by_axis(o.u), of_v = by_axis(o.v);
    const Columns slope = x.e[1] * of_n, slope_bar = y.e[1] * of_n, slope_d = x.e[1] * of_d, slope_d_bar = y.e[1] * of_d;
    o.g = {x.e[0] * of_u - o.p * slope_d, y.e[0] * of_u - o.q * slope_d_bar};
    o.h = {o.q * slope_d - x.e[0] * of_v, (V{} - o.r) * slope_d_bar - y.e[0] * of_v};
    const V parts[4] = {dot(6), dot(7), dot(8), dot(9)};
    const Parameter xi_(x, y, o, o.p, o.q, parts), xi_bar(x, y, o, V{} - o.q, o.r, parts);
    const Length t = length(x, dot(0), dot(10), dot(11), dot(12), o.g.beam, o.g.bar);
    const Length t_bar = length(y, dot(2), dot(13), dot(14), dot(15), o.h.bar, o.h.beam);

    to_d[PEER_VALUE] = distance[0], to_xi[PEER_VALUE] = xi, to_xi_bar[PEER_VALUE] = xib;
    to_t[PEER_VALUE] = t.length[0], to_t_bar[PEER_VALUE] = t_bar.length[0];
    const auto gradient = [](double *to, const Columns &beam, const Columns &bar) {
        store(to + PEER_GRADIENT, beam);
        store(to + PEER_GRADIENT + 12, bar);
    };
    gradient(to_d, x.e[0] * of_n, y.e[0] * of_n);
    gradient(to_xi, o.g.beam, o.g.bar);
    gradient(to_xi_bar, o.h.beam, o.h.bar);
    gradient(to_t, t.slope + t.kappa * o.g.beam, t.kappa * o.g.bar);
    gradient(to_t_bar, t_bar.kappa * o.h.beam, t_bar.slope + t_bar.kappa * o.h.bar);
    // Single entries, by row: of g, of h, of turn + 2 mu g and its twin.
    V g[24], h[24], own[12], own_bar[12];
    {
        alignas(32) double number[24];
        const auto spread = [&](V *to, const Columns &from) {
            store(number, from);
            for (int r = 0; r < 12; r++) to[r] = at(number + r);
        };
        spread(g, o.g.beam), spread(g + 12, o.g.bar), spread(h, o.h.beam), spread(h + 12, o.h.bar);
        spread(own, t.own), spread(own_bar, t_bar.own);
    }
    static const double unit[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    const Components d_(d), n_(n), u_(o.u), v_(o.v), x_t(x.t), y_t(y.t);
    const V u_over_d = o.u * inverse, v_over_d = o.v * inverse, n_over_d = n * inverse;
    const V w_over_t = load(t.w.c) * t.inverse, w_over_t_bar = load(t_bar.w.c) * t_bar.inverse;
#pragma GCC unroll 1
    for (int i = 0; i < 3; i++) {
        const V n_i = n_[i], d_i = d_[i], u = u_[i], v = v_[i];
        const Columns of_k = by_axis(load(unit[i]) * inverse - n_i * n_over_d + x_t[i] * u_over_d + y_t[i] * v_over_d);
        const Columns of_q = by_axis(load(unit[i]) * t.inverse - t.w[i] * w_over_t);
        const Columns of_q_bar = by_axis(load(unit[i]) * t_bar.inverse - t_bar.w[i] * w_over_t_bar);
#pragma GCC unroll 3
        for (int c = 0; c < 3; c++) {
            const V axis = load(AXIS[i] + 4 * c);
            {
                const V row = x.e[0].v[c] * of_k.v[c] + u * slope.v[c], n_g = n_i * o.g.beam.v[c];
                const V g_c = o.g.beam.v[c], h_c = o.h.beam.v[c], q = x.e[1].v[c] * of_q.v[c];
                const V s0 = axis * x.e[0].v[c], s1 = axis * x.e[1].v[c];
                const auto hat = [&](const Parameter &k) {
                    return u * k.with.beam.v[c] - v * k.with_bar.beam.v[c] + k.w0[i] * g_c + k.w0_bar[i] * h_c - k.X * s1;
                };
                const auto along = [&](const Parameter &k) {
                    return d_i * k.along.beam.v[c] + k.w1[i] * g_c + k.w1_bar[i] * h_c - k.X * s0;
                };
                const V hat_xi = hat(xi_), along_xi = along(xi_), along2_xi = xi_.X * d_i * g_c;
                const V hat_bar = hat(xi_bar), along_bar = along(xi_bar), along2_bar = xi_bar.X * d_i * g_c;
#pragma GCC unroll 4
                for (int j = 0; j < 4; j++) {
                    const V s = x.s[0][j], s1 = x.s[1][j], s2 = x.s[2][j];
                    const int r = 3 * j + i;
                    store(To::beam(to_d, r) + 4 * c, s * row + s1 * n_g);
                    const V of_xi = s * hat_xi + s1 * along_xi - s2 * along2_xi;
                    const V of_bar = s * hat_bar + s1 * along_bar - s2 * along2_bar;
                    store(To::beam(to_xi, r) + 4 * c, of_xi);
                    store(To::beam(to_xi_bar, r) + 4 * c, of_bar);
                    store(To::beam(to_t, r) + 4 * c, t.kappa * of_xi + g[r] * t.turn.v[c] + own[r] * g_c + s1 * q);
                    store(To::beam(to_t_bar, r) + 4 * c, t_bar.kappa * of_bar + h[r] * t_bar.other.v[c]);
                }
            }
            {
                const V row = y.e[0].v[c] * of_k.v[c] + v * slope_bar.v[c];
                const V g_c = o.g.bar.v[c], h_c = o.h.bar.v[c], n_g = n_i * g_c, n_h = n_i * h_c;
                const V s0 = axis * y.e[0].v[c], s1 = axis * y.e[1].v[c], q = y.e[1].v[c] * of_q_bar.v[c];
                const auto hat = [&](const Parameter &k) {
                    return u * k.with.bar.v[c] - v * k.with_bar.bar.v[c] + k.w0[i] * g_c + k.w0_bar[i] * h_c - k.Y * s1;
                };
                const auto along = [&](const Parameter &k) {
                    return d_i * k.along.bar.v[c] + k.w1[i] * g_c + k.w1_bar[i] * h_c - k.X * s0;
                };
                const auto across = [&](const Parameter &k) {
                    return d_i * k.along_bar.bar.v[c] + k.w2[i] * g_c + k.w2_bar[i] * h_c - k.Y * s0;
                };
                const V hat_xi = hat(xi_), hat_bar = hat(xi_bar);
                {
                    const V along_xi = along(xi_), along2_xi = xi_.X * d_i * g_c;
                    const V along_bar = along(xi_bar), along2_bar = xi_bar.X * d_i * g_c;
#pragma GCC unroll 4
                    for (int j = 0; j < 4; j++) {
                        const V s = x.s[0][j], s1 = x.s[1][j], s2 = x.s[2][j];
                        const int r = 3 * j + i;
                        store(To::mixed(to_d, r) + 4 * c, s * row + s1 * n_g);
                        const V of_xi = s * hat_xi + s1 * along_xi - s2 * along2_xi;
                        const V of_bar = s * hat_bar + s1 * along_bar - s2 * along2_bar;
                        store(To::mixed(to_xi, r) + 4 * c, of_xi);
                        store(To::mixed(to_xi_bar, r) + 4 * c, of_bar);
                        store(To::mixed(to_t, r) + 4 * c, t.kappa * of_xi + own[r] * g_c);
                        store(To::mixed(to_t_bar, r) + 4 * c, t_bar.kappa * of_bar + h[r] * t_bar.own.v[c]);
                    }
                }
                {
                    const V across_xi = across(xi_), across2_xi = xi_.Y * d_i * h_c;
                    const V across_bar = across(xi_bar), across2_bar = xi_bar.Y * d_i * h_c;
#pragma GCC unroll 4
                    for (int j = 0; j < 4; j++) {
                        const V s = y.s[0][j], s1 = y.s[1][j], s2 = y.s[2][j];
                        const int r = 3 * j + i;
                        store(To::bar(to_d, r) + 4 * c, s * row - s1 * n_h);
                        const V of_xi = s * hat_xi + s1 * across_xi - s2 * across2_xi;
                        const V of_bar = s * hat_bar + s1 * across_bar - s2 * across2_bar;
                        store(To::bar(to_xi, r) + 4 * c, of_xi);
                        store(To::bar(to_xi_bar, r) + 4 * c, of_bar);
                        store(To::bar(to_t, r) + 4 * c, t.kappa * of_xi + g[12 + r] * t.other.v[c]);
                        store(To::bar(to_t_bar, r) + 4 * c,
                              t_bar.kappa * of_bar + h[12 + r] * t_bar.turn.v[c] + own_bar[r] * h_c + s1 * q);
                    }
                }
            }
        }
    }
    if (FULL) {
#pragma GCC unroll 1
        for (int k = 0; k < 5; k++) mirror(out + To::BLOCK * k + PEER_HESSIAN);
    }
}
} // namespace

extern "C" {
void ref_d_full(const double *q, double xi, double xib, double *out) { write_d<true>(q, xi, xib, out); }
void ref_d_upper(const double *q, double xi, double xib, double *out) { write_d<false>(q, xi, xib, out); }
void ref_all_full(const double *q, double xi, double xib, double *out) { write_all<true>(q, xi, xib, out); }
void ref_all_upper(const double *q, double xi, double xib, double *out) { write_all<false>(q, xi, xib, out); }
}
