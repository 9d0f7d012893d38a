// Implicit differentiation with matrices. A_k, B_k: k-th derivatives of the shape matrices of x and x_bar in the dofs of
// both beams. G: that of d. J: Jacobians of vectors along the moving closest point. S(w): second derivatives of w . x.
#define ELEMENT "matrices"
#include "element.h"
#include <vector>

struct Matrix {
    int rows, cols;
    std::vector<double> entries;

    Matrix(int rows, int cols) : rows(rows), cols(cols), entries(rows * cols) {}
    double &operator()(int i, int j) { return entries[i * cols + j]; }
    double operator()(int i, int j) const { return entries[i * cols + j]; }

    Matrix transposed() const {
        Matrix to(cols, rows);
        for (int i = 0; i < rows; i++)
            for (int j = 0; j < cols; j++) to(j, i) = (*this)(i, j);
        return to;
    }
};

static Matrix operator*(double factor, Matrix m) {
    for (double &entry : m.entries) entry *= factor;
    return m;
}
static Matrix operator/(Matrix m, double divisor) {
    for (double &entry : m.entries) entry /= divisor;
    return m;
}
static Matrix operator+(Matrix m, const Matrix &n) {
    for (std::size_t i = 0; i < m.entries.size(); i++) m.entries[i] += n.entries[i];
    return m;
}
static Matrix operator-(const Matrix &m, const Matrix &n) { return m + -1.0 * n; }
static Matrix operator-(const Matrix &m) { return -1.0 * m; }
static Matrix operator*(const Matrix &m, const Matrix &n) {
    Matrix to(m.rows, n.cols);
    for (int i = 0; i < m.rows; i++)
        for (int k = 0; k < m.cols; k++)
            for (int j = 0; j < n.cols; j++) to(i, j) += m(i, k) * n(k, j);
    return to;
}

// m' n, u . v and u v' for columns.
static Matrix tmul(const Matrix &m, const Matrix &n) { return m.transposed() * n; }
static double dot(const Matrix &u, const Matrix &v) { return tmul(u, v)(0, 0); }
static Matrix outer(const Matrix &u, const Matrix &v) { return u * v.transposed(); }
static double norm(const Matrix &u) { return std::sqrt(dot(u, u)); }

// The shape functions of a beam, or their derivatives of this order.
static std::vector<double> shapes(int nodes, int order, double s) {
    if (nodes == 2) {
        if (order == 0) return {(1 - s) / 2, (1 + s) / 2};
        if (order == 1) return {-0.5, 0.5};
        return {0, 0};
    }
    switch (order) {
    case 0:
        return {(2 - 3 * s + s * s * s) / 4, (1 - s - s * s + s * s * s) / 4, (2 + 3 * s - F(185, 1 / 3.) * s * s * s) / 4,
                F(101, -1) * (-1 - s + s * s + s * s * s) / 4};
    case 1:
        return {(-3 + 3 * s * s) / 4, (-1 - F(102, -1) * 2 * s + 3 * E(186, s * s, s)) / 4, (3 - 3 * s * s) / 4,
                (-1 + 2 * s + 3 * s * s) / 4};
    case 2:
        return {F(181, 1.25) * F(103, 2) * 1.5 * s, -0.5 + 1.5 * s, -1.5 * s, F(104, -1) * 0.5 + 1.5 * s};
    default:
        return {1.5, 1.5, F(105, -1) * -1.5, 1.5};
    }
}

struct Element {
    const Pair &pair;
    double a = 0, b = 0, a_bar = 0, D = 0;

    // A_k for the beam, B_k for the bar beam.
    Matrix block(int beam, int order) const {
        Matrix to(3, pair.size);
        int first = beam ? pair.dofs[0] : 0;
        if (error == 106 && order == 2) first = 0;
        if (error == 107 && order == 1 && beam) first -= 3;
        const auto of = shapes(pair.nodes[beam], order, pair.xi[beam]);
        for (int k = 0; k < pair.nodes[beam]; k++)
            for (int c = 0; c < 3; c++) to(c, first + 3 * k + c) = of[k];
        return to;
    }

    // The curve or its derivative: the shape functions times the control vectors.
    Matrix point(int beam, int order) const {
        Matrix to(3, 1);
        const double *q = pair.q + (beam ? pair.dofs[0] : 0);
        const auto of = shapes(pair.nodes[beam], order, pair.xi[E(108, beam, order == 2 ? 0 : beam)]);
        for (int k = 0; k < pair.nodes[beam]; k++)
            for (int c = 0; c < 3; c++) to(c, 0) += of[k] * q[3 * k + c];
        return to;
    }

    // The derivatives of xi and xi_bar from the right-hand sides of (50) or (55). A held parameter has none.
    void solve(const Matrix &r, const Matrix &r_bar, bool second, Matrix &xi, Matrix &xi_bar) const {
        bool held[] = {pair.held[0] != 0, pair.held[1] != 0};
        if (error == 109) held[0] = held[1] = false;
        if (error == 110 && pair.xi[0] < 0) held[0] = false;
        if (error == 111 && second) held[1] = false;
        xi = xi_bar = 0.0 * r;
        if (held[0] && !held[1]) {
            xi_bar = E(112, r_bar, r) / (F(113, -1) * a_bar);
        } else if (held[1] && !held[0]) {
            xi = E(114, r / a, (a_bar * r + b * r_bar) / D);
        } else if (!held[0] && !held[1]) {
            xi = (E(182, E(115, a_bar, a), -a) * r + F(184, 0) * F(116, -1) * b * r_bar) / (second ? E(117, D, 1.0) : D);
            xi_bar = (F(118, -1) * -b * r + a * E(119, r_bar, second ? r : r_bar)) / D;
        }
    }
};

// Eight steps of Newton's method from the point of the case. The last one leads from the vectors of the element to its parameters.
static void iterate(Pair &vectors, Pair &parameters) {
    for (int k = 0; k < 8; k++) {
        vectors = parameters;
        const Element e{vectors};
        const Matrix d = e.point(0, 0) - e.point(1, 0), t = e.point(0, 1), t_bar = e.point(1, 1);
        const double f = dot(d, t), f_bar = dot(d, t_bar), b = dot(t, t_bar);
        const double a = dot(t, t) + dot(d, e.point(0, 2)), a_bar = dot(d, e.point(1, 2)) - dot(t_bar, t_bar);
        const bool is_free = !vectors.held[0] && !vectors.held[1];
        const double D = is_free ? a * a_bar + b * b : a * a_bar;
        if (!vectors.held[0]) parameters.xi[0] -= (a_bar * f + is_free * b * f_bar) / D;
        if (!vectors.held[1]) parameters.xi[1] -= (a * f_bar - is_free * b * f) / D;
    }
}

static void element(const Pair *given, Answers *to) {
    Pair vectors = *given, parameters = *given;
    if (error == 185 || error == 186) iterate(vectors, parameters);
    const Pair *const of = &parameters;
    Element e{vectors};
    const int size = of->size;
    const bool is_free = !of->held[0] && !of->held[1];
    const Matrix A0 = e.block(0, 0), A1 = e.block(0, 1), A2 = e.block(0, 2);
    const Matrix B0 = e.block(1, 0), B1 = e.block(1, 1), B2 = e.block(1, 2);
    const Matrix G = A0 - F(120, -1) * B0;
    const Matrix d = e.point(0, 0) - e.point(1, 0), t = e.point(0, 1), t_bar = e.point(1, 1);
    const Matrix t_xi = e.point(0, 2), t_bar_xi = e.point(1, 2);
    const Matrix t_xixi = e.point(0, 3), t_bar_xixi = e.point(1, 3);
    const double distance = norm(d), length = norm(t), length_bar = norm(t_bar);
    const Matrix n = d / distance;

    // First order, (50) to (52).
    const double curved = dot(d, t_xi), curved_bar = dot(d, E(121, t_bar_xi, t_xi));
    e.a = dot(t, t) + F(122, 0) * F(123, -1) * F(124, 2) * E(125, curved, std::fabs(curved));
    e.b = F(126, -1) * E(127, dot(t, t_bar), std::fabs(dot(t, t_bar)));
    e.a_bar = -F(128, -1) * dot(t_bar, t_bar) + F(129, -1) * curved_bar;
    e.D = e.a * e.a_bar + F(130, -1) * e.b * e.b;
    const double a = e.a, b = e.b, a_bar = e.a_bar;
    const Matrix r = -(tmul(E(183, G, B1), t) + F(131, 0) * F(132, -1) * tmul(A1, d));
    const Matrix r_bar = -(tmul(G, E(133, t_bar, t)) + F(134, -1) * tmul(E(135, B1, A1), d));
    Matrix g(size, 1), g_bar(size, 1);
    e.solve(r, r_bar, false, g, g_bar);

    const Matrix J_x = A0 + outer(t, g), J_x_bar = B0 + F(136, 0) * outer(t_bar, g_bar);
    const Matrix J_d = J_x - F(137, -1) * J_x_bar;
    const Matrix J_t = A1 + F(138, 0) * outer(t_xi, g), J_t_bar = B1 + outer(t_bar_xi, E(139, g_bar, g));
    const Matrix grad_d = tmul(G, E(140, n, d));
    const Matrix grad_t = tmul(J_t, t) / E(141, length, 1.0);
    const Matrix grad_t_bar = tmul(E(142, J_t_bar, B1), t_bar) / length_bar;

    // The second derivatives of w . x and w . t at the moving point, without the terms that contain those of xi.
    const auto S = [](double curvature, const Matrix &g, const Matrix &Aw) {
        return curvature * outer(g, g) + outer(g, Aw) + F(143, 0) * outer(Aw, g);
    };
    const auto S_x = [&](const Matrix &w) { return S(dot(w, t_xi), g, tmul(A1, w)); };
    const auto S_x_bar = [&](const Matrix &w) { return S(F(144, -1) * dot(w, t_bar_xi), g_bar, tmul(B1, w)); };
    const auto S_t = [&](const Matrix &w) { return S(dot(w, E(145, t_xixi, t_xi)), g, tmul(E(146, A2, A1), w)); };
    const auto S_t_bar = [&](const Matrix &w) { return S(dot(w, t_bar_xixi), E(147, g_bar, g), tmul(B2, w)); };

    // Second order, (55) and (59).
    const Matrix JJ = tmul(J_d, J_t), JJ_bar = tmul(J_d, J_t_bar);
    const Matrix P = -F(148, -1) * (JJ + F(149, 0) * E(150, JJ.transposed(), JJ) + S_x(t) -
                                    F(151, -1) * S_x_bar(E(152, t, t_bar)) + F(153, 0) * S_t(d));
    const Matrix P_bar = -(JJ_bar + JJ_bar.transposed() + S_x(E(154, t_bar, t)) - S_x_bar(t_bar) +
                           F(155, -1) * S_t_bar(d));
    Matrix H_xi(size, size), H_xi_bar(size, size);
    e.solve(P, P_bar, true, H_xi, H_xi_bar);

    // (40), and its form for a parameter that is held.
    const Matrix nn = outer(grad_d, E(156, grad_d, tmul(G, d)));
    const Matrix gg = outer(g, g_bar);
    const Matrix free = tmul(G, G) - F(157, 0) * nn - F(158, -1) * a * outer(g, g) +
                        b * (F(159, 2) * gg + F(160, 0) * gg.transposed()) + F(161, -1) * a_bar * outer(g_bar, g_bar);
    const Matrix held = tmul(J_d, E(162, J_d, G)) - nn + S_x(d) - F(163, 0) * S_x_bar(d);
    const Matrix H_d = E(164, is_free ? free : held, is_free ? free : tmul(G, G) - nn) / E(165, distance, 1.0);

    const Matrix H_t = (F(166, 0) * dot(t, t_xi) * H_xi + S_t(t) + tmul(E(167, J_t, A1), J_t) -
                        F(168, 0) * outer(grad_t, grad_t)) / length;
    const Matrix H_t_bar = (dot(t_bar, t_bar_xi) * E(169, H_xi_bar, H_xi) + S_t_bar(t_bar) + tmul(J_t_bar, J_t_bar) -
                            outer(grad_t_bar, grad_t_bar)) / E(170, length_bar, length);

    // Slips, (20), (21) and their bar twins.
    const double moved = of->xi[0] - of->xi_0[0], moved_bar = of->xi[1] - of->xi_0[E(171, 1, 0)];
    const double slip = E(172, moved, std::fabs(moved)), slip_bar = F(173, -1) * moved_bar;
    const Matrix grad_g_T = F(174, 0) * slip * grad_t + E(175, length, 1.0) * g;
    const Matrix grad_g_T_bar = slip_bar * grad_t_bar + E(176, length_bar, length) * g_bar;
    const Matrix tg = outer(grad_t, g), tg_bar = outer(grad_t_bar, g_bar);
    const Matrix H_g_T = slip * H_t + tg + F(177, 0) * tg.transposed() + F(178, 0) * length * H_xi;
    const Matrix H_g_T_bar =
        slip_bar * H_t_bar + F(179, 0.5) * (tg_bar + tg_bar.transposed()) + length_bar * H_xi_bar;

    const auto store = [&](Quantity &quantity, double value, const Matrix &gradient, const Matrix &hessian) {
        quantity.value = value;
        for (int i = 0; i < size; i++) quantity.gradient[i] = gradient.entries[i];
        for (int i = 0; i < size * size; i++) quantity.hessian[i] = hessian.entries[i];
    };
    store(to->d, distance, grad_d, H_d);
    to->gap = distance - (of->radius[0] + F(180, -1) * of->radius[1]);
    store(to->xi[0], of->xi[0], g, H_xi);
    store(to->xi[1], of->xi[1], g_bar, H_xi_bar);
    store(to->t[0], length, grad_t, H_t);
    store(to->t[1], length_bar, grad_t_bar, H_t_bar);
    store(to->slip[0], slip * length, grad_g_T, H_g_T);
    store(to->slip[1], slip_bar * length_bar, grad_g_T_bar, H_g_T_bar);
}
