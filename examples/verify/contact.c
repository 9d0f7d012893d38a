/* Answers the cases of `beamgap export --element` with your own contact element with friction.
 *
 *     beamgap export --element --family segment -o vectors.jsonl
 *     cc -O2 contact.c -o contact -lm
 *     beamgap verify vectors.jsonl --run ./contact
 *
 * This program is for two straight beams, the family `segment`. For yours, change
 * 1. FAMILY and BEAM_DOFS, the name of the family and its dofs a beam,
 * 2. `element`,
 * 3. HEAD: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
 *
 * Equation numbers are those of Zavarise (2007). The other formulas are in docs/contact-element.md.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FAMILY "segment"
#define HEAD "{\"schema\":\"beamgap-answers/1\",\"program\":\"contact.c\",\"only\":[\"residual\",\"tangent\"]}\n"
enum { BEAM_DOFS = 6, DOFS = 2 * BEAM_DOFS };

/* Which parameters are held at an end of their beam. */
struct held {
    int xi, xi_bar;
};

/* Parameters and history. Numbers that a case does not have are zero. */
struct data {
    int is_lpqp, is_paper, has_normal, has_slips;
    double eps_N, g_0, lambda, eps_T, mu, normal[3];
    double xi, xi_bar, e, e_bar, cosine; /* of the last step, and what was held: */
    struct held held;
};

struct answers {
    const char *state;
    double F_N, F, F_bar, residual[DOFS], tangent[DOFS][DOFS];
};

static double dot(const double u[3], const double v[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/* The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1. */
static void along(const double shapes[4], const double w[3], double to[DOFS]) {
    for (int i = 0; i < DOFS; i++) to[i] = shapes[i / 3] * w[i % 3];
}

/* An entry of v w^T + w v^T, and of the matrix of delta u . Delta u. */
static double both(const double v[], const double w[], int i, int j) { return v[i] * w[j] + w[i] * v[j]; }
static double block(const double of[4], const double with[4], int i, int j) {
    return i % 3 == j % 3 ? of[i / 3] * with[j / 3] : 0;
}

/* Laws: F_N, and k = -dF_N/dg_N. */
static double normal_law(const struct data *of, double gap, double *k) {
    const int is_between = of->is_lpqp && gap > 0;
    *k = is_between ? of->eps_N * (of->g_0 - gap) / of->g_0 : of->eps_N;
    const double force = is_between ? *k * (of->g_0 - gap) / 2 : of->lambda + of->eps_N * (of->g_0 / 2 - gap);
    if (*k > 0 && force > 0) return force;
    return *k = 0;
}

/* YOUR ELEMENT. Here: two straight beams, 12 dofs; t,xi and all that has it is zero.
 * q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1]. radii: r + r_bar. */
static void element(const double q[DOFS], double xi, double xi_bar, struct held held, double radii,
                    const struct data *of, struct answers *to) {
    /* Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar. */
    const double shapes[4] = {(1 - xi) / 2, (1 + xi) / 2, -(1 - xi_bar) / 2, -(1 + xi_bar) / 2};
    const double slopes[4] = {-0.5, 0.5, 0, 0}, slopes_bar[4] = {0, 0, -0.5, 0.5};
    const int free_xi = !held.xi, free_bar = !held.xi_bar, is_free = free_xi && free_bar;
    double d[3] = {0}, t[3] = {0}, t_bar[3] = {0}, n[3];
    for (int i = 0; i < DOFS; i++) {
        d[i % 3] += shapes[i / 3] * q[i];
        t[i % 3] += slopes[i / 3] * q[i];
        t_bar[i % 3] += slopes_bar[i / 3] * q[i];
    }

    /* Geometry. Eq. (50) and (52), reduced to one equation or none if parameters are held at an end. */
    const double a = dot(t, t), b = dot(t, t_bar), a_bar = -dot(t_bar, t_bar), det = a * a_bar + b * b;
    double inverse[2][2] = {{free_xi / a, 0}, {0, free_bar / a_bar}};
    if (is_free) {
        inverse[0][0] = a_bar / det, inverse[0][1] = b / det;
        inverse[1][0] = -b / det, inverse[1][1] = a / det;
    }
    double Gt[DOFS], Gt_bar[DOFS], A1d[DOFS], B1d[DOFS], g[DOFS], g_bar[DOFS];
    along(shapes, t, Gt), along(shapes, t_bar, Gt_bar);
    along(slopes, d, A1d), along(slopes_bar, d, B1d);
    for (int i = 0; i < DOFS; i++) {
        const double r = -Gt[i] - A1d[i], r_bar = -Gt_bar[i] - B1d[i];
        g[i] = inverse[0][0] * r + inverse[0][1] * r_bar;
        g_bar[i] = inverse[1][0] * r + inverse[1][1] * r_bar;
    }
    /* n = d/|d|; t x t_bar has the same direction, also where the beams cross. It keeps the side of the last step. */
    for (int c = 0; c < 3; c++) {
        const int next = (c + 1) % 3, last = (c + 2) % 3;
        n[c] = is_free ? t[next] * t_bar[last] - t[last] * t_bar[next] : d[c];
    }
    const double side = dot(n, of->has_normal ? of->normal : d) < 0 ? -1 : 1, length = side * sqrt(dot(n, n));
    for (int c = 0; c < 3; c++) n[c] /= length;
    const double d_s = dot(n, d);
    double grad_gap[DOFS], A1n[DOFS], B1n[DOFS];
    along(shapes, n, grad_gap); /* eq. (37) */
    along(slopes, n, A1n), along(slopes_bar, n, B1n);

    /* Normal. */
    double k;
    to->F_N = normal_law(of, d_s - radii, &k);
    to->state = to->F_N > 0 ? "frictionless" : "open";
    const int has_friction = to->F_N > 0 && of->mu > 0 && of->has_slips && (free_xi || free_bar);

    /* Slip, eq. (15) and (20), and trial. A parameter that becomes held loses its part of the elastic slip. */
    const double abs_t = sqrt(a), abs_t_bar = sqrt(-a_bar), c = b / (abs_t * abs_t_bar);
    const double u = free_xi && has_friction ? xi - of->xi : 0, u_bar = free_bar && has_friction ? xi_bar - of->xi_bar : 0;
    double e = of->e, e_bar = of->e_bar;
    if (!is_free && (held.xi != of->held.xi || held.xi_bar != of->held.xi_bar)) {
        const int was_free = !of->held.xi && !of->held.xi_bar;
        e = was_free && free_xi ? of->e - of->cosine * of->e_bar : 0;
        e_bar = was_free && free_bar ? of->e_bar - of->cosine * of->e : 0;
    }
    e += abs_t * u, e_bar += abs_t_bar * u_bar;
    double tau[3], tau_bar[3], s[3], turn[3], turn_bar[3];
    for (int m = 0; m < 3; m++) {
        tau[m] = t[m] / abs_t, tau_bar[m] = t_bar[m] / abs_t_bar;
        s[m] = e * tau[m] - e_bar * tau_bar[m];
        turn[m] = (tau_bar[m] - c * tau[m]) / abs_t, turn_bar[m] = (tau[m] - c * tau_bar[m]) / abs_t_bar;
    }
    const double gamma = sqrt(dot(s, s));
    const double l = free_xi * dot(s, tau), l_bar = -free_bar * dot(s, tau_bar); /* e - c e_bar, e_bar - c e */

    /* Return to the cone. */
    const int slips = has_friction && of->eps_T * gamma > of->mu * to->F_N;
    const double rho = slips ? of->mu * to->F_N / (of->eps_T * gamma) : has_friction ? 1 : 0;
    if (has_friction) to->state = slips ? "slip" : "stick";
    to->F = of->eps_T * rho * l, to->F_bar = of->eps_T * rho * l_bar;

    /* The gradients of F and F_bar; of work, A and A_bar: with "paper", A = grad g_T. */
    double grad_t[DOFS], grad_t_bar[DOFS], turned[DOFS], turned_bar[DOFS];
    double grad_F[DOFS], grad_F_bar[DOFS], A[DOFS], A_bar[DOFS];
    along(slopes, tau, grad_t), along(slopes_bar, tau_bar, grad_t_bar);
    along(slopes, turn, turned), along(slopes_bar, turn_bar, turned_bar);
    for (int i = 0; i < DOFS; i++) {
        const double grad_e = abs_t * g[i] + u * grad_t[i], grad_e_bar = abs_t_bar * g_bar[i] + u_bar * grad_t_bar[i];
        const double grad_c = turned[i] + turned_bar[i], grad_F_N = -k * grad_gap[i];
        const double grad_l = grad_e - c * grad_e_bar - e_bar * grad_c;
        const double grad_l_bar = grad_e_bar - c * grad_e - e * grad_c;
        double grad_rho = 0;
        if (slips) {
            const double grad_gamma = (l * grad_e + l_bar * grad_e_bar - e * e_bar * grad_c) / gamma;
            grad_rho = of->mu / (of->eps_T * gamma) * grad_F_N - rho / gamma * grad_gamma;
        }
        grad_F[i] = of->eps_T * (rho * grad_l + l * grad_rho);
        grad_F_bar[i] = of->eps_T * (rho * grad_l_bar + l_bar * grad_rho);
        A[i] = abs_t * g[i] + of->is_paper * u * grad_t[i];
        A_bar[i] = abs_t_bar * g_bar[i] + of->is_paper * u_bar * grad_t_bar[i];
        to->residual[i] = -to->F_N * grad_gap[i] + to->F * A[i] + to->F_bar * A_bar[i];
    }

    /* Tangent. */
    double grad_a[DOFS], grad_a_bar[DOFS], A1t_bar[DOFS], B1t[DOFS], grad_b[DOFS];
    along(slopes, t, grad_a), along(slopes_bar, t_bar, grad_a_bar);
    along(slopes, t_bar, A1t_bar), along(slopes_bar, t, B1t);
    for (int i = 0; i < DOFS; i++) grad_a[i] *= 2, grad_a_bar[i] *= -2, grad_b[i] = A1t_bar[i] + B1t[i];
    for (int i = 0; i < DOFS; i++)
        for (int j = 0; j < DOFS; j++) {
            /* The Hessian of the gap: eq. (40), or if both parameters are free a form that also holds at d = 0. */
            const double turning = inverse[0][0] * A1n[i] * A1n[j] + inverse[0][1] * both(A1n, B1n, i, j) -
                                   inverse[1][1] * B1n[i] * B1n[j];
            const double moved = Gt[i] * g[j] - Gt_bar[i] * g_bar[j] - grad_gap[i] * grad_gap[j];
            const double H_gap = is_free ? both(A1n, g, i, j) - both(B1n, g_bar, i, j) + d_s * turning
                                         : (block(shapes, shapes, i, j) + moved) / d_s + A1n[i] * g[j] - B1n[i] * g_bar[j];
            /* The derivatives of eq. (50), solved as eq. (52). */
            const double GA = block(shapes, slopes, i, j) + block(slopes, shapes, i, j);
            const double GB = block(shapes, slopes_bar, i, j) + block(slopes_bar, shapes, i, j);
            const double r = -GA - both(grad_a, g, i, j) + both(grad_b, g_bar, i, j);
            const double r_bar = -GB - both(grad_b, g, i, j) - both(grad_a_bar, g_bar, i, j);
            const double H_xi = inverse[0][0] * r + inverse[0][1] * r_bar;
            const double H_xi_bar = inverse[1][0] * r + inverse[1][1] * r_bar;
            double H_A = g[i] * grad_t[j] + abs_t * H_xi, H_A_bar = g_bar[i] * grad_t_bar[j] + abs_t_bar * H_xi_bar;
            if (of->is_paper) {
                const double H_t = (block(slopes, slopes, i, j) - grad_t[i] * grad_t[j]) / abs_t;
                const double H_t_bar = (block(slopes_bar, slopes_bar, i, j) - grad_t_bar[i] * grad_t_bar[j]) / abs_t_bar;
                H_A += grad_t[i] * g[j] + u * H_t;
                H_A_bar += grad_t_bar[i] * g_bar[j] + u_bar * H_t_bar;
            }
            const double K_N = k * grad_gap[i] * grad_gap[j] - to->F_N * H_gap;
            const double K_T = A[i] * grad_F[j] + A_bar[i] * grad_F_bar[j] + to->F * H_A + to->F_bar * H_A_bar;
            to->tangent[i][j] = K_N + K_T;
        }
}

/* The text after a key, which is searched after `from`. */
static const char *after(const char *from, const char *key) {
    const char *at = from ? strstr(from, key) : NULL;
    return at ? at + strlen(key) : NULL;
}

static int numbers(const char *from, int count, double to[]) {
    for (int i = 0; i < count; i++) {
        char *end;
        if (!from) return 0;
        to[i] = strtod(from, &end);
        if (end == from) return 0;
        from = end + 1; /* a comma, or the closing bracket */
    }
    return 1;
}

/* The number after a key; zero if there is none. */
static double number(const char *from, const char *key) {
    const char *at = after(from, key);
    return at ? strtod(at, NULL) : 0;
}

static struct held read_held(const char *from) {
    const char *word = after(from, "\"held\":\"");
    const int both = word && !strncmp(word, "both", 4);
    return (struct held){both || (word && !strncmp(word, "xi\"", 3)), both || (word && !strncmp(word, "xi_bar", 6))};
}

static struct data read_data(const char *from) {
    const char *slips = after(from, "\"slips\":{"), *law = after(from, "\"law\":\"");
    struct data to = {.has_slips = slips != NULL,
                      .is_lpqp = !strncmp(law, "lpqp", 4),
                      .is_paper = after(from, "\"work\":\"paper") != NULL,
                      .eps_N = number(from, "\"eps_N\":"),
                      .g_0 = number(from, "\"g_0\":"),
                      .lambda = number(from, "\"lambda\":"),
                      .eps_T = number(from, "\"eps_T\":"),
                      .mu = number(from, "\"mu\":"),
                      .xi = number(slips, "\"xi\":"),
                      .xi_bar = number(slips, "\"xi_bar\":"),
                      .e = number(slips, "\"e\":"),
                      .e_bar = number(slips, "\"e_bar\":"),
                      .cosine = number(slips, "\"cosine\":"),
                      .held = read_held(slips)};
    to.has_normal = numbers(after(from, "\"normal\":["), 3, to.normal);
    return to;
}

static void print(const char *name, const double numbers[], int count) {
    printf(",\"%s\":[", name);
    for (int i = 0; i < count; i++) printf("%s%.17g", i ? "," : "", numbers[i]);
    printf("]");
}

int main(void) {
    char *line = NULL;
    size_t size = 0;
    if (getline(&line, &size, stdin) < 0) return 1; /* the head of the cases */
    printf(HEAD);
    while (getline(&line, &size, stdin) >= 0) {
        const char *id = after(line, "\"id\":\""), *beam = after(line, "\"beam\":{");
        const char *bar = after(beam, "\"bar\":{"), *data = after(bar, "\"element\":{");
        const char *point = after(bar, "\"point\":{"), *family = "\"family\":\"" FAMILY "\"";
        double q[DOFS];
        if (!id || !beam || !bar) return 1;
        if (strncmp(beam, family, strlen(family)) || strncmp(bar, family, strlen(family))) {
            fprintf(stderr, "contact.c is for the family %s; a case has another one. Change FAMILY, BEAM_DOFS and element.\n",
                    FAMILY);
            return 1;
        }
        const int is_regular = after(point, "\"held\":\"") && numbers(after(beam, "\"q\":["), BEAM_DOFS, q) &&
                               numbers(after(bar, "\"q\":["), BEAM_DOFS, q + BEAM_DOFS);
        if (is_regular && !data) {
            fprintf(stderr, "contact.c: a case has no element. Write the cases with `beamgap export --element`.\n");
            return 1;
        }
        printf("{\"id\":\"%.*s\"", (int)strcspn(id, "\""), id);
        if (is_regular) {
            struct answers answers;
            const struct data of = read_data(data);
            const double radii = number(bar, "\"radius\":") + number(bar, "\"radius_bar\":");
            element(q, number(point, "\"xi\":"), number(point, "\"xi_bar\":"), read_held(point), radii, &of, &answers);
            printf(",\"state\":\"%s\",\"F_N\":%.17g,\"F\":%.17g,\"F_bar\":%.17g", answers.state, answers.F_N, answers.F,
                   answers.F_bar);
            print("residual", answers.residual, DOFS);
            print("tangent", &answers.tangent[0][0], DOFS * DOFS);
            printf("}\n");
        } else {
            printf(",\"result\":\"degenerate\"}\n"); /* the case has no regular closest point */
        }
        fflush(stdout);
    }
    free(line);
    return 0;
}
