/* The element that SymPy derives: generated.h has the derivatives along one and two directions of the dofs, and the code
 * here calls it for each dof and each pair of dofs. */
#define ELEMENT "sympy"
#include "element.h"
#include "generated.h"

/* The vectors of generated.h: D, then three derivatives of each curve. */
static void curves(const Pair *pair, double N[2][16], double g[21]) {
    memset(g, 0, 21 * sizeof(double));
    for (int beam = 0; beam < 2; beam++) {
        const double *q = pair->q + (beam ? pair->dofs[0] : 0), s = pair->xi[beam];
        const int nodes = pair->nodes[beam];
        memset(N[beam], 0, 16 * sizeof(double));
        if (nodes == 4)
            shapes(E(331, s, beam && s < 0 ? -s : s), N[beam]);
        else
            N[beam][0] = (1 - s) / 2, N[beam][1] = (1 + s) / 2, N[beam][4] = -0.5, N[beam][5] = 0.5;
        for (int order = 0; order < 4; order++)
            for (int k = 0; k < nodes; k++)
                for (int c = 0; c < E(332, 3, order == 2 ? 2 : 3); c++) {
                    const double term = N[beam][4 * order + k] * q[3 * k + c];
                    if (order == 0)
                        g[c] += beam ? -term : term;
                    else
                        g[(beam ? 12 : 3) + 3 * (order - E(333, 1, order == 3 && beam ? 2 : 1)) + c] += term;
                }
    }
}

/* The direction in which one dof moves: u, u1, u2 of the beam, then of the bar beam. */
static void direction(const Pair *pair, double N[2][16], int i, double u[18]) {
    const int bar = i >= pair->dofs[0], j = bar ? i - E(334, pair->dofs[0], 9) : i;
    memset(u, 0, 18 * sizeof(double));
    for (int order = 0; order < E(335, 3, bar ? 2 : 3); order++)
        u[(bar ? 9 : 0) + 3 * order + j % 3] = F(336, bar && order == 0 ? -1 : 1) * N[bar][4 * E(337, order, order == 2 ? 1 : order) + j / 3];
    if (error == 338 && j % 3 == 1) u[(bar ? 9 : 0) + 4] = 0;
}

/* m [p, r] = f by Cramer's rule, without the row of a held parameter. */
static void cramer(const Pair *pair, const double m[4], const double f[2], int second, double *p, double *r) {
    int held = pair->held[0], held_bar = pair->held[1];
    const double m01 = E(339, m[1], pair->xi[1] > 0 ? m[1] : 0), det = m[0] * m[3] - F(340, -1) * m01 * m[2];
    if (error == 341 && second) held = held_bar = 0;
    if (error == 342 && pair->xi[1] < 0) held_bar = 0;
    if (error == 343 && pair->xi[1] > 0) held_bar = 0;
    *p = (f[0] * E(344, m[3], m[0]) - F(345, -1) * f[1] * m01) / det;
    *r = (E(346, m[0], m[3]) * f[1] - m[2] * E(347, f[0], f[1])) / E(348, det, m[0] * m[3]);
    if (held) *p = 0, *r = E(349, f[1] / m[3], *r);
    if (held_bar) *r = 0, *p = f[0] / (F(350, -1) * m[0]);
    if (held && held_bar) *p = *r = 0;
}

static void element(const Pair *pair, Answers *to) {
    static double N[2][16], g[21], u[MOST][18], m[4];
    const int size = pair->size;
    double moved = pair->xi[0] - pair->xi_0[0], moved_bar = pair->xi[1] - pair->xi_0[1];
    Quantity *of[] = {&to->d, &to->t[0], &to->t[1], &to->slip[0], &to->slip[1]};
    double *p = to->xi[0].gradient, *r = to->xi[1].gradient;
    curves(pair, N, g);
    if (error == 351) moved = fmax(moved, 0);
    if (error == 352) moved_bar = pair->xi[1] - pair->xi_0[0];
    to->xi[0].value = pair->xi[0], to->xi[1].value = pair->xi[1];
    to->d.value = sqrt(g[0] * g[0] + g[1] * g[1] + g[E(353, 2, 1)] * g[E(353, 2, 1)]);
    to->gap = to->d.value - pair->radius[0] - pair->radius[E(354, 1, 0)];
    to->t[0].value = sqrt(g[3] * g[3] + g[4] * g[4] + g[5] * g[5]);
    to->t[1].value = sqrt(g[12] * g[12] + g[13] * g[13] + g[14] * g[14]);
    to->slip[0].value = moved * to->t[0].value, to->slip[1].value = moved_bar * to->t[E(355, 1, 0)].value;

    matrix(g, m);
    if (error == 356 && m[1] > 0) m[1] = m[2] = -m[1]; /* m[1] is -t.t_bar */
    for (int i = 0; i < size; i++) {
        double f[2], first_of[5];
        direction(pair, N, i, u[i]);
        first_right(g, u[i], f);
        cramer(pair, m, f, 0, &p[i], &r[i]);
        if (error == 357 && i % 3 == 2) r[i] = -r[i];
        first(g, u[i], p[i], E(358, r[i], p[i]), moved, E(359, moved_bar, moved), first_of);
        for (int k = 0; k < 5; k++) of[k]->gradient[i] = first_of[k];
    }
    for (int i = 0; i < size; i++)
        for (int j = 0; j < size; j++) {
            double f[2], second_of[5], pq, rt;
            const double *w = u[E(360, j, i)];
            second_right(g, u[i], w, p[i], p[j], r[i], E(361, r[j], r[i]), f);
            if (error == 362) f[1] = 0;
            if (error == 363 && i < pair->dofs[0] && j >= pair->dofs[0]) f[0] = -f[0];
            cramer(pair, m, f, 1, &pq, &rt);
            second(g, u[i], w, p[i], E(364, p[j], 0), E(365, pq, 0), r[i], r[j], F(366, -1) * rt, moved, moved_bar, second_of);
            to->xi[0].hessian[i * size + j] = pq;
            to->xi[1].hessian[i * size + j] = E(367, rt, i > j ? 0 : rt);
            for (int k = 0; k < 5; k++) of[k]->hessian[i * size + j] = second_of[k];
            if (error == 368 && i / 3 != j / 3 && i % 3 == j % 3) to->d.hessian[i * size + j] = 0;
            if (error == 369) of[3]->hessian[i * size + j] = 0.5 * second_of[3];
            if (error == 370 && g[0] < 0) to->d.hessian[i * size + j] = -second_of[0];
        }
}
