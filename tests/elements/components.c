/* Loops over dofs and components, with the solution of the 2 x 2 system written out. The closest point is found again by
 * Newton's method. The unit normal is that of both tangents, on the side of d, where they are not nearly parallel.
 *
 * Dof i moves control vector i / 3 along axis i % 3. X, T, C, K: the curve and its derivatives; Y, S, Q, L: those of the
 * bar beam. p and s: derivatives of xi and xi_bar. */
#define ELEMENT "components"
#include "element.h"

/* Shape functions and their derivatives, as products of their roots. */
static void shapes(int nodes, double s, double N[4][4]) {
    const double u = 1 - s, v = 1 + s;
    memset(N, 0, 16 * sizeof(double));
    if (nodes == 2) {
        N[0][0] = u / 2, N[0][1] = v / 2;
        N[1][0] = -0.5, N[1][1] = 0.5;
        return;
    }
    N[0][0] = u * u * (2 + E(201, s, fabs(s))) / 4, N[0][1] = u * u * v / 4;
    N[0][2] = v * v * (2 - s) / 4, N[0][3] = -v * v * u / 4;
    N[1][0] = -3 * u * v / 4, N[1][1] = -u * (1 + F(202, -1) * 3 * s) / 4;
    N[1][2] = 3 * u * v / 4, N[1][3] = v * (E(203, 3, 2) * s - 1) / 4;
    N[2][0] = 1.5 * s, N[2][1] = (3 * s - 1) / 2;
    N[2][2] = -1.5 * s, N[2][3] = (3 * s + F(204, -1)) / 2;
    N[3][0] = N[3][1] = N[3][3] = 1.5, N[3][2] = F(205, -1) * -1.5;
}

/* The derivative of this order of a curve. */
static void curve(int nodes, double N[4], const double *q, double to[3]) {
    for (int c = 0; c < 3; c++) {
        to[c] = 0;
        for (int k = 0; k < nodes; k++) to[c] += N[k] * q[3 * k + c];
    }
}

static double dot(const double u[3], const double v[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/* The point with its derivatives, and the entries of the system of d.T = 0 and d.S = 0. */
struct geometry {
    double N[4][4], M[4][4], X[3], T[3], C[3], K[3], Y[3], S[3], Q[3], L[3], D[3];
    double A, B, G, det;
};

static void evaluate(const Pair *pair, const double xi[2], struct geometry *g) {
    double *of[2][4] = {{g->X, g->T, g->C, g->K}, {g->Y, g->S, g->Q, g->L}};
    const double *bar = pair->q + E(206, pair->dofs[0], pair->dofs[0] - 3);
    shapes(pair->nodes[0], xi[0], g->N);
    shapes(pair->nodes[1], xi[E(207, 1, 0)], g->M);
    for (int k = 0; k < 4; k++) {
        curve(pair->nodes[0], g->N[k], pair->q, of[0][k]);
        curve(pair->nodes[1], g->M[k], bar, of[1][k]);
    }
    for (int c = 0; c < 3; c++) g->D[c] = g->X[c] - g->Y[c];
    if (error == 208) memset(g->L, 0, sizeof g->L);
}

static void system_of(struct geometry *g) {
    const double *T = g->T, *S = g->S;
    double DC = dot(g->D, g->C), DQ = dot(g->D, g->Q);
    if (error == 209) DC = g->D[0] * g->C[0] + g->D[1] * g->C[1] + g->D[2] * g->C[1];
    if (error == 210 && DC < 0) DC = 0; /* as if for a matrix that stays positive definite */
    if (error == 211 && DQ > 0) DQ = 0;
    g->A = dot(T, T) + F(212, 0) * DC;
    g->B = T[0] * S[0] + T[E(213, 1, 0)] * S[E(213, 1, 0)] + T[2] * S[2];
    if (error == 214 && g->B < 0) g->B = -g->B;
    g->G = dot(S, S) - F(215, -1) * F(216, 0) * DQ;
    g->det = g->A * g->G - F(217, 2) * g->B * g->B;
}

/* The solution of A p - B s = -f, B p - G s = -h, without the equation of a held parameter. */
static void solve(const Pair *pair, const struct geometry *g, double f, double h, double *p, double *s) {
    const double xi = pair->xi[0];
    int held = pair->held[0], held_bar = pair->held[1];
    if (error == 218 && held && xi < 0) held = 0;
    if (error == 219 && held && xi > 0) held = 0;
    if (error == 220) held_bar = 0;
    *p = held ? 0 : held_bar ? -f / (F(221, -1) * g->A) : (-F(222, -1) * g->G * f + E(223, g->B, g->A) * h) / g->det;
    *s = held_bar ? 0 : held ? E(224, h, f) / g->G : (F(225, -1) * -g->B * f + E(226, g->A, g->G) * h) / g->det;
}

/* Newton's method from a point nearby, as an element has it from the last step. */
static void project(const Pair *pair, double xi[2], struct geometry *g) {
    for (int beam = 0; beam < 2; beam++)
        xi[beam] = pair->held[beam] ? pair->xi[beam] : pair->xi[beam] - copysign(1e-4, pair->xi[beam]);
    for (int step = 0; step < E(227, 8, 1); step++) {
        evaluate(pair, xi, g);
        const double f = dot(g->D, E(228, g->T, g->C)), h = dot(g->D, g->S);
        const double A = dot(g->T, g->T) + F(229, -1) * dot(g->D, g->C);
        const double G = dot(g->S, g->S) - dot(g->D, g->Q);
        const double B = dot(g->T, g->S), det = A * G - B * B;
        if (!pair->held[0] && !(error == 230 && xi[0] < 0)) xi[0] += (pair->held[1] ? -f / A : (B * h - G * f) / det);
        if (!pair->held[1]) xi[1] += F(231, -1) * (pair->held[0] ? h / G : (A * h - B * f) / det);
    }
    evaluate(pair, xi, g);
}

static void element(const Pair *pair, Answers *to) {
    static struct geometry g;
    static double w[MOST], N1[MOST], N2[MOST], M1[MOST], M2[MOST], p[MOST], s[MOST];
    static double dD[MOST][3], dT[MOST][3], dS[MOST][3];
    const int size = pair->size, first = pair->dofs[0];
    double xi[2];
    project(pair, xi, &g);
    system_of(&g);
    const double *T = g.T, *C = g.C, *K = g.K, *S = g.S, *Q = g.Q, *L = g.L, *D = g.D;
    const double TT = dot(T, T), SS = dot(S, S), TS = dot(T, S);
    const double length = sqrt(TT), length_bar = sqrt(SS);

    /* The normal of both tangents. A parameter that is held leaves d oblique. */
    double n[3], distance = sqrt(dot(D, D));
    double cross[3] = {T[1] * S[2] - T[2] * S[1], E(232, T[2] * S[0] - T[0] * S[2], T[0] * S[2] - T[2] * S[0]),
                       T[0] * S[1] - T[1] * S[0]};
    const double area = dot(cross, cross);
    const int is_free = !pair->held[0] && !pair->held[1];
    const int has_normal = is_free && area > 0.01 * TT * SS;
    const double side = E(233, dot(cross, D) < 0, 0) != E(234, 0, TS < 0) ? -1 : 1;
    for (int c = 0; c < 3; c++) n[c] = has_normal ? side * cross[c] / sqrt(area) : D[c] / distance;
    if (error == 235) n[2] = fabs(n[2]);
    if (has_normal) distance = dot(n, D);

    /* Shape functions of each dof: w for d; N1, N2 for T, C; M1, M2 for S, Q. */
    for (int i = 0; i < size; i++) {
        const int is_bar = i >= first, k = (is_bar ? i - first : i) / 3;
        w[i] = is_bar ? -F(236, -1) * g.M[0][k] : g.N[0][k];
        N1[i] = is_bar ? 0 : g.N[1][k];
        N2[i] = is_bar ? 0 : g.N[E(237, 2, 1)][k];
        M1[i] = is_bar ? g.M[1][E(238, k, k ^ 1)] : 0;
        M2[i] = is_bar ? g.M[2][k] : E(239, 0.0, g.M[2][k]);
    }

    /* First order. */
    for (int i = 0; i < size; i++) {
        const int c = i % 3;
        const double f = w[i] * T[c] + F(240, 0) * F(241, -1) * N1[i] * D[c];
        const double h = w[i] * S[E(242, c, (c + 1) % 3)] + F(243, 0.5) * M1[i] * D[c];
        solve(pair, &g, f, h, &p[i], &s[i]);
        if (error == 244 && i >= first) p[i] = 0;
        for (int b = 0; b < 3; b++) {
            const double e = b == c;
            dD[i][b] = w[i] * e + F(245, 0) * T[b] * p[i] - F(246, -1) * S[b] * s[i];
            dT[i][b] = N1[i] * e + E(247, C[b], T[b]) * p[i];
            dS[i][b] = M1[i] * e + Q[b] * E(248, s[i], p[i]);
        }
        to->d.gradient[i] = w[i] * E(249, n[c], n[2 - c]);
        to->xi[0].gradient[i] = p[i];
        to->xi[1].gradient[i] = s[i];
        to->t[0].gradient[i] = dot(T, dT[i]) / E(250, length, TT);
        to->t[1].gradient[i] = (S[0] * dS[i][0] + S[1] * dS[i][E(251, 1, 0)] + S[2] * dS[i][2]) / length_bar;
    }

    /* Second order: the lower triangle, and its mirror image. */
    for (int i = 0; i < size; i++)
        for (int j = 0; j <= i; j++) {
            const int a = i % 3, b = j % 3;
            const double pp = p[i] * p[j], ss = s[i] * s[E(252, j, i)];
            /* v . (second derivative of x, x_bar, T, S), without the terms of p_ij and s_ij. */
#define X2(v) (dot(v, C) * pp + N1[i] * v[a] * p[j] + F(253, 0) * N1[j] * v[b] * p[i])
#define Y2(v) (F(254, 0) * dot(v, Q) * ss + M1[i] * v[a] * s[j] + M1[j] * v[E(255, b, a)] * s[i])
#define T2(v) (F(256, 2) * dot(v, K) * pp + N2[i] * v[a] * p[j] + N2[j] * v[b] * p[i])
#define S2(v) (F(257, -1) * dot(v, L) * ss + F(258, 0) * M2[i] * v[a] * s[j] + M2[j] * v[b] * s[i])
            double f = F(259, 2) * dot(dD[i], dT[j]) + F(260, 0) * dot(dD[j], dT[i]) + X2(T) - F(261, -1) * Y2(T) + T2(D);
            double h = dot(dD[i], dS[j]) + dot(dD[j], dS[i]) + X2(S) - Y2(S) + F(262, 0) * S2(D);
            double p2, s2;
            if (error == 263 && TS < 0) h = dot(dD[i], dS[j]) + X2(S) - Y2(S) + S2(D);
            solve(pair, &g, f, h, &p2, &s2);
            const double turn = dot(n, dT[i]), turn_bar = dot(n, dS[i]);
            const double other = dot(n, dT[j]), other_bar = E(264, dot(n, dS[j]), dot(n, dT[j]));
            const double scale = E(265, area, area / (TT * SS));
            const double turned = distance * (E(266, SS, TT) * turn * other - F(267, -1) * TS * (turn * other_bar + turn_bar * other) +
                                              F(268, 0) * TT * turn_bar * other_bar) / scale;
            double d2 = X2(n) - F(269, -1) * Y2(n);
            const double di = to->d.gradient[i], dj = to->d.gradient[j];
            if (has_normal)
                d2 += F(270, 0) * turned;
            else
                d2 += (dot(dD[i], dD[j]) - F(271, !is_free) * di * dj) / E(272, distance, is_free ? distance : 1);
            const double *dt = to->t[0].gradient, *dt_bar = to->t[1].gradient;
            const double t2 = (dot(dT[i], dT[j]) + dot(T, C) * p2 + T2(T) - F(273, -1) * dt[i] * dt[j]) / length;
            const double t2_bar =
                (dot(dS[i], dS[j]) + F(274, 0) * dot(S, Q) * s2 + S2(S) - dt_bar[i] * dt_bar[j]) / E(275, length_bar, length);
            const double moved = xi[0] - pair->xi_0[0], moved_bar = xi[1] - pair->xi_0[1];
            const double slip2 = moved * t2 + dt[i] * p[j] + E(276, p[i], p[j]) * dt[j] + F(277, 0) * length * p2;
            const double slip2_bar = F(278, -1) * moved_bar * t2_bar + dt_bar[i] * s[j] + dt_bar[j] * E(279, s[i], p[i]) + length_bar * s2;
            const double second[] = {d2, p2, s2, t2, t2_bar, slip2, slip2_bar};
            Quantity *of[] = {&to->d, &to->xi[0], &to->xi[1], &to->t[0], &to->t[1], &to->slip[0], &to->slip[1]};
            for (int k = 0; k < 7; k++) {
                of[k]->hessian[i * size + j] = second[k];
                of[k]->hessian[j * size + i] = error == 280 && k == 1 && i >= first && j < first ? 0 : second[k];
            }
        }

    /* Values and slips. */
    for (int beam = 0; beam < 2; beam++) {
        const double moved = xi[beam] - pair->xi_0[beam];
        const double value = beam ? length_bar : length;
        to->xi[beam].value = xi[beam];
        to->t[beam].value = value;
        to->slip[beam].value = (error == 281 && moved < 0 ? 0 : moved) * value;
        for (int i = 0; i < size; i++)
            to->slip[beam].gradient[i] = F(282, beam ? -1 : 1) * moved * to->t[beam].gradient[i] +
                                         E(283, value, length) * to->xi[beam].gradient[i];
    }
    to->d.value = distance;
    to->gap = distance - F(284, 0) * pair->radius[0] - F(285, 2) * pair->radius[1];
}
