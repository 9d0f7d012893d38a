/* A contact element with friction: residual and tangent, in 3-vectors. It has no gradient of a scalar slip or of the angle
 * between the tangents: the trial force, its return to the cone and their derivatives are vectors.
 *
 *     friction ERROR < vectors.jsonl > answers.jsonl
 *
 * X, T, C, K: the curve and its derivatives; Y, S, Q, L: those of the bar beam. p and s: derivatives of xi and xi_bar. */
#define ELEMENT "friction"
#define ONLY "[\"residual\",\"tangent\"]"
#include "element.h"

typedef double Vector[3];

static double dot(const Vector u, const Vector v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/* Derivatives of the shape functions, and of the curve. */
static void curve(int nodes, double x, const double *q, double N[4][4], Vector of[4]) {
    const double hermite[4][4] = {
        {(2 - 3 * x + x * x * x) / 4, (1 - x - F(456, -1) * x * x + x * x * x) / 4,
         (2 + 3 * x - x * x * x) / 4, (-1 - x + x * x + x * x * x) / 4},
        {(-3 + 3 * x * x) / 4, E(462, -1 - 2 * x + 3 * x * x, -(1 - x) * (1 - 3 * x)) / 4, (3 - 3 * x * x) / 4,
         (-F(457, -1) * F(459, -1) + 2 * x + 3 * x * x) / 4},
        {E(463, 1.5 * x, 1.3 * x + 0.2) * F(460, 0.5), (-1 + 3 * x) / 2, -1.5 * x, (1 + 3 * x) / 2},
        {1.5, 1.5, -1.5 * F(458, -1) * E(461, 1, x < 0 ? -1 : 1), 1.5}};
    const double linear[4][4] = {{(1 - x) / 2, (1 + x) / 2}, {-0.5, 0.5}};
    memcpy(N, nodes == 2 ? linear : hermite, sizeof linear);
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 3; c++) {
            of[k][c] = 0;
            for (int i = 0; i < nodes; i++) of[k][c] += N[k][i] * q[3 * i + c];
        }
}

/* The geometry: gradients of g = d, xi and xi_bar, of the vectors d, T and S; Hessians of d, xi and xi_bar,
 * and of T.T/2 and S.S/2 without the part of these. */
static Vector D, n, x[4], y[4], dD[MOST], dT[MOST], dS[MOST];
static double d, g[MOST], p[MOST], s[MOST], Hg[MOST][MOST], Hp[MOST][MOST], Hs[MOST][MOST];
static double Ht2[MOST][MOST], Hs2[MOST][MOST];

static void solve(const Pair *of, double a, double b, double a_bar, double f, double h, double *to, double *to_bar) {
    const double det = a * a_bar - b * b;
    *to = of->held[0] ? 0 : of->held[1] ? -f / a : (b * h - a_bar * f) / det;
    *to_bar = of->held[1] ? 0 : of->held[0] ? h / a_bar : (a * h - b * f) / det;
}

static void geometry(const Pair *of) {
    static double N[4][4], M[4][4], w[4][MOST];
    const int first = of->dofs[0];
    curve(of->nodes[0], of->xi[0], of->q, N, x);
    curve(of->nodes[1], of->xi[1], of->q + first, M, y);
    const double *T = x[1], *C = x[2], *S = y[1], *Q = y[2];
    for (int c = 0; c < 3; c++) D[c] = x[0][c] - y[0][c];
    d = sqrt(dot(D, D));
    for (int c = 0; c < 3; c++) n[c] = D[c] / d;
    const double a = dot(T, T) + dot(D, C), b = dot(T, S), a_bar = dot(S, S) - dot(D, Q);
    for (int i = 0; i < of->size; i++) {
        const int c = i % 3, is_bar = i >= first;
        for (int k = 0; k < 4; k++) w[k][i] = is_bar ? M[k][(i - first) / 3] : N[k][i / 3];
        const double sign = is_bar ? -1 : 1;
        const double f = sign * w[0][i] * T[c] + (is_bar ? 0 : w[1][i] * D[c]);
        const double h = sign * w[0][i] * S[c] + (is_bar ? w[1][i] * D[c] : 0);
        solve(of, a, b, a_bar, f, h, &p[i], &s[i]);
        for (int k = 0; k < 3; k++) {
            dD[i][k] = T[k] * p[i] - S[k] * s[i] + (k == c ? sign * w[0][i] : 0);
            dT[i][k] = C[k] * p[i] + (k == c && !is_bar ? w[1][i] : 0);
            dS[i][k] = Q[k] * s[i] + (k == c && is_bar ? w[1][i] : 0);
        }
        g[i] = dot(n, dD[i]);
    }
    for (int i = 0; i < of->size; i++)
        for (int j = 0; j < of->size; j++) {
            /* The second derivatives of x, x_bar, T and S, without those of xi and xi_bar. */
            Vector X2, Y2, T2, S2, D2;
            for (int k = 0; k < 3; k++) {
                const double u = k == i % 3, v = k == j % 3;
                const double u_x = i < first ? u : 0, v_x = j < first ? v : 0;
                const double u_y = i < first ? 0 : u, v_y = j < first ? 0 : v;
                X2[k] = C[k] * p[i] * p[j] + u_x * w[1][i] * p[j] + v_x * w[1][j] * p[i];
                T2[k] = x[3][k] * p[i] * p[j] + u_x * w[2][i] * p[j] + v_x * w[2][j] * p[i];
                Y2[k] = Q[k] * s[i] * s[j] + u_y * w[1][i] * s[j] + v_y * w[1][j] * s[i];
                S2[k] = y[3][k] * s[i] * s[j] + u_y * w[2][i] * s[j] + v_y * w[2][j] * s[i];
                D2[k] = X2[k] - Y2[k];
            }
            const double f = dot(dD[i], dT[j]) + dot(dD[j], dT[i]) + dot(T, D2) + dot(D, T2);
            const double h = dot(dD[i], dS[j]) + dot(dD[j], dS[i]) + dot(S, D2) + dot(D, S2);
            solve(of, a, b, a_bar, f, h, &Hp[i][j], &Hs[i][j]);
            if (of->held[1] && !of->held[0]) Hp[i][j] += E(466, 0, b * h / (a * a_bar));
            Ht2[i][j] = dot(dT[i], dT[j]) + dot(T, T2);
            Hs2[i][j] = dot(dS[i], dS[j]) + dot(S, S2);
            Hg[i][j] = (dot(dD[i], dD[j]) + dot(D, D2) - g[i] * g[j]) / d;
        }
}

/* Parameters and history. */
typedef struct {
    char law;
    double eps, g_0, lambda, eps_t, mu, normal[3], xi_n[2], e_n[2], cosine, kept[3];
    int is_paper, has_slips, was_held[2], has_kept;
} Data;

static int read_data(const char *line, Data *to) {
    const char *at = after(line, "\"element\":{\"law\":\"");
    if (!at) return 0;
    memset(to, 0, sizeof *to);
    to->law = at[1]; /* linear, lpqp, augmented: i, p, u */
    numbers(after(at, "\"eps_N\":"), 1, &to->eps);
    if (to->law == 'p') numbers(after(at, "\"g_0\":"), 1, &to->g_0);
    if (to->law == 'u') numbers(after(at, "\"lambda\":"), 1, &to->lambda);
    numbers(after(at, "\"eps_T\":"), 1, &to->eps_t);
    numbers(after(at, "\"mu\":"), 1, &to->mu);
    to->is_paper = !strncmp(after(at, "\"work\":\""), "paper", 5);
    numbers(after(at, "\"normal\":["), 3, to->normal);
    at = after(at, "\"slips\":");
    to->has_slips = *at == '{';
    if (to->has_slips) {
        numbers(after(at, "\"xi\":"), 1, &to->xi_n[0]);
        numbers(after(at, "\"xi_bar\":"), 1, &to->xi_n[1]);
        numbers(after(at, "\"e\":"), 1, &to->e_n[0]);
        numbers(after(at, "\"e_bar\":"), 1, &to->e_n[1]);
        numbers(after(at, "\"cosine\":"), 1, &to->cosine);
        at = after(at, "\"held\":\"");
        const int both = !strncmp(at, "both", 4);
        to->was_held[0] = both || !strncmp(at, "xi\"", 3);
        to->was_held[1] = both || !strncmp(at, "xi_bar\"", 7);
    }
    return 1;
}

/* The elastic slips at the start of the step: the force along the beam that stays free is kept where the other one becomes held. */
static void start(const Data *of, const int held[2], double cosine, double e[2]) {
    e[0] = F(412, 0) * F(445, 0) * of->e_n[0];
    e[1] = F(412, 0) * F(414, -1) * F(446, 0) * of->e_n[1];
    const int exchanged = held[0] != of->was_held[0] && held[1] != of->was_held[1];
    if (exchanged && (of->was_held[0] || of->was_held[1])) e[0] = e[1] = 0;
    const double by = F(447, 0) * F(448, -1) * E(449, of->cosine, cosine);
    const double e_0 = e[0] - by * e[1], e_1 = e[1] - by * e[0];
    if (held[1]) e[0] = e_0, e[1] = 0;
    if (held[0]) e[0] = 0, e[1] = e_1;
}

/* F_N and k. */
static double law(const Data *of, double gap, double *k) {
    const double force = of->lambda * F(401, 0) - of->eps * gap;
    *k = of->eps;
    if (of->law == 'p' && gap > 0) {
        const double rest = of->g_0 - gap;
        *k = rest > 0 ? E(452, of->eps * rest / (F(402, 2) * of->g_0), of->eps / 2) : 0;
        const double parabola = of->eps * rest * rest / (2 * of->g_0);
        return rest > 0 ? E(453, E(454, parabola, of->eps * gap * gap / (2 * of->g_0)), of->eps * rest / 4) : 0;
    }
    if (of->law == 'p') return force + E(403, of->eps * of->g_0 / 2, 0);
    if ((force > 0 && !(error == 455 && gap > 0)) || error == 404) return force;
    return *k = 0;
}

static double R[MOST], K[MOST * MOST];
/* The elastic slips after the return, and whether the beams are in contact. */
static double returned[2];
static int is_closed;

static void element(const Pair *of, const Data *data) {
    const int size = of->size;
    const double *T = x[1], *S = y[1];
    const Vector across = {T[1] * S[2] - T[2] * S[1], T[2] * S[0] - T[0] * S[2], T[0] * S[1] - T[1] * S[0]};
    const double side = E(465, dot(n, data->normal), dot(n, across)) < 0 && error != 405 ? -1 : 1;
    double k, force = law(data, side * d - of->radius[0] - F(406, 0) * of->radius[1], &k);
    const double t = sqrt(dot(T, T)), t_bar = sqrt(dot(S, S));
    const int both = of->held[0] && of->held[1];
    const int has_friction = force > 0 && data->mu > 0 && data->has_slips && !both;
    Vector tau, tau_bar, trial, m, of_work, of_work_bar, traction = {0, 0, 0};
    for (int i = 0; i < size; i++) {
        R[i] = -force * E(407, side, 1) * g[i];
        for (int j = 0; j < size; j++)
            K[i * size + j] = F(408, 0) * F(409, 2) * k * g[i] * g[j] - F(410, 0) * F(411, -1) * force * side * Hg[i][j];
    }
    is_closed = force > 0;
    returned[0] = returned[1] = 0;
    if (!has_friction) return;
    const double xi_n = E(467, data->xi_n[0], (float)data->xi_n[0]);
    const double u = of->held[0] ? 0 : F(450, 0) * (of->xi[0] - xi_n);
    const double u_bar = of->held[1] ? 0 : F(450, 0) * (of->xi[1] - data->xi_n[1]);
    double e_n[2];
    start(data, of->held, dot(T, S) / (t * t_bar), e_n);
    const double e = e_n[0] + E(413, t, t_bar) * u, e_bar = e_n[1] + t_bar * u_bar;
    for (int c = 0; c < 3; c++) tau[c] = T[c] / t, tau_bar[c] = S[c] / t_bar;
    /* Error 451 keeps the elastic slip of the last step as a vector in space. */
    const int is_kept = error == 451 && data->has_kept && !of->held[0] && !of->held[1];
    const double own = is_kept ? e - e_n[0] : e, own_bar = is_kept ? e_bar - e_n[1] : e_bar;
    for (int c = 0; c < 3; c++)
        trial[c] = own * tau[c] - F(415, -1) * own_bar * tau_bar[c] + (is_kept ? data->kept[c] : 0);
    const double gamma = E(416, sqrt(dot(trial, trial)), sqrt(e * e + e_bar * e_bar));
    const double cone = data->mu * force;
    const int slips = data->eps_t * gamma > cone * E(464, 1, 1.001) && error != 417;
    const double factor = F(418, -1) * (slips ? E(419, cone, force) / gamma : data->eps_t);
    returned[0] = factor / data->eps_t * e, returned[1] = factor / data->eps_t * e_bar;
    for (int c = 0; c < 3; c++) {
        traction[c] = factor * trial[c];
        m[c] = trial[c] / gamma;
    }
    if (error == 420) /* two directions without coupling */
        for (int c = 0; c < 3; c++) {
            const double cosine = dot(tau, tau_bar), f = factor * e, f_bar = factor * e_bar;
            traction[c] = ((f + cosine * f_bar) * tau[c] - (f_bar + cosine * f) * tau_bar[c]) / (1 - cosine * cosine);
        }
    const double along = dot(traction, tau), along_bar = -dot(traction, tau_bar);
    const int is_paper = E(421, data->is_paper, !data->is_paper);
    for (int i = 0; i < size; i++) {
        for (int c = 0; c < 3; c++) of_work[c] = T[c] * p[i], of_work_bar[c] = F(422, -1) * S[c] * s[i];
        const double dt = dot(tau, dT[i]), dt_bar = dot(tau_bar, dS[i]);
        R[i] += dot(traction, of_work) - dot(traction, of_work_bar);
        if (is_paper) R[i] += along * u * dt + F(423, 0) * along_bar * u_bar * dt_bar;
    }
    for (int j = 0; j < size; j++) {
        Vector dtau, dtau_bar, dtrial, dtraction;
        const double dt = dot(tau, dT[j]), dt_bar = dot(tau_bar, dS[j]);
        const double de = F(424, 0) * t * p[j] + F(425, 0) * u * dt;
        const double de_bar = t_bar * s[j] + F(426, -1) * u_bar * dt_bar;
        for (int c = 0; c < 3; c++) {
            dtau[c] = F(427, 0) * (dT[j][c] - F(428, 0) * tau[c] * dt) / t;
            dtau_bar[c] = F(427, 0) * F(429, 0) * (dS[j][c] - tau_bar[c] * dt_bar) / t_bar;
            dtrial[c] = de * tau[c] + own * dtau[c] - de_bar * tau_bar[c] - F(430, -1) * own_bar * dtau_bar[c];
        }
        const double dgamma = dot(m, dtrial), dforce = F(431, 0) * F(432, -1) * -k * side * g[j];
        for (int c = 0; c < 3; c++)
            dtraction[c] = slips ? data->mu * dforce * m[c] +
                                       F(433, 0) * factor * (dtrial[c] - F(434, 0) * F(435, -1) * m[c] * dgamma)
                                 : F(436, 0) * factor * dtrial[c];
        for (int i = 0; i < size; i++) {
            for (int c = 0; c < 3; c++) of_work[c] = T[c] * p[i], of_work_bar[c] = S[c] * s[i];
            double sum = dot(dtraction, of_work) - F(437, 0) * dot(dtraction, of_work_bar);
            sum += F(438, 0) * dot(traction, dT[j]) * p[i] - F(439, 0) * dot(traction, dS[j]) * s[i];
            sum += F(440, 0) * dot(traction, T) * Hp[i][j] - F(441, 0) * F(442, -1) * dot(traction, S) * Hs[i][j];
            if (is_paper) {
                /* F (xi - xi_n) grad t and its twin. */
                const double df = dot(dtraction, tau) + dot(traction, dtau);
                const double df_bar = -dot(dtraction, tau_bar) - dot(traction, dtau_bar);
                const double dti = dot(tau, dT[i]), dti_bar = dot(tau_bar, dS[i]);
                const double Ht = (Ht2[i][j] + dot(T, x[2]) * Hp[i][j] - dti * dt) / t;
                const double Ht_bar = (Hs2[i][j] + dot(S, y[2]) * Hs[i][j] - dti_bar * dt_bar) / t_bar;
                sum += df * u * dti + along * (p[j] * dti + u * Ht);
                sum += df_bar * u_bar * dti_bar + along_bar * (s[j] * dti_bar + u_bar * Ht_bar);
            }
            K[i * size + j] += sum;
        }
    }
    if (error == 443 || error == 444)
        for (int i = 0; i < size; i++)
            for (int j = 0; j < i; j++) {
                double *one = &K[i * size + j], *other = &K[j * size + i];
                *one = error == 443 ? (*one + *other) / 2 : *other;
                *other = *one;
            }
}

/* Whether the program finds the closest point of a case itself, with the held parameters of the case. */
static int finds(void) { return error == 459 || error == 460; }

/* The closest point next to the one of the pair: the method of Gauss and Newton, and at last Newton's. A parameter is held at an
 * end. */
static void find(Pair *of) {
    static double N[4][4];
    for (int k = 0; k < 400; k++) {
        const double bend = k < 390 ? 0 : 1;
        curve(of->nodes[0], of->xi[0], of->q, N, x);
        curve(of->nodes[1], of->xi[1], of->q + of->dofs[0], N, y);
        for (int c = 0; c < 3; c++) D[c] = x[0][c] - y[0][c];
        const double f = dot(D, x[1]), h = dot(D, y[1]);
        if (!finds()) {
            of->held[0] = (of->xi[0] >= 1 && f < 0) || (of->xi[0] <= -1 && f > 0);
            of->held[1] = (of->xi[1] >= 1 && h > 0) || (of->xi[1] <= -1 && h < 0);
        }
        double step[2];
        const double a = dot(x[1], x[1]) + bend * dot(D, x[2]), a_bar = dot(y[1], y[1]) - bend * dot(D, y[2]);
        solve(of, a, dot(x[1], y[1]), a_bar, f, h, &step[0], &step[1]);
        for (int i = 0; i < 2; i++) of->xi[i] = fmax(-1, fmin(1, of->xi[i] + step[i]));
    }
}

/* Goes through the earlier steps of a case, and keeps the history of its own. */
static void go_through(const char *at, Pair pair, Data *data) {
    data->has_slips = 0;
    memset(data->normal, 0, sizeof data->normal);
    for (at = after(at, "\"beam\":["); at; at = after(at, "\"beam\":[")) {
        at = numbers(at, pair.dofs[0], pair.q);
        at = numbers(after(at, "\"bar\":["), pair.dofs[1], pair.q + pair.dofs[0]);
        find(&pair);
        geometry(&pair);
        element(&pair, data);
        const double side = dot(n, data->normal) < 0 ? -1 : 1;
        const double t = sqrt(dot(x[1], x[1])), t_bar = sqrt(dot(y[1], y[1]));
        for (int c = 0; c < 3; c++) {
            data->normal[c] = side * n[c];
            data->kept[c] = returned[0] * x[1][c] / t - returned[1] * y[1][c] / t_bar;
        }
        data->has_slips = is_closed;
        data->has_kept = 1;
        data->cosine = dot(x[1], y[1]) / (t * t_bar);
        memcpy(data->xi_n, pair.xi, sizeof data->xi_n);
        memcpy(data->e_n, returned, sizeof data->e_n);
        memcpy(data->was_held, pair.held, sizeof data->was_held);
        const char *end = strstr(at, "}");
        if (end && end[1] == ']') break;
    }
}

static int answer(const char *line, const Pair *pair) {
    static Data data;
    if (!read_data(line, &data)) return 0;
    const char *steps = after(line, "\"steps\":[");
    if (steps) go_through(steps, *pair, &data);
    Pair here = *pair;
    if (finds()) find(&here);
    geometry(&here);
    element(&here, &data);
    print("residual", R, pair->size);
    print("tangent", K, pair->size * pair->size);
    return 1;
}
