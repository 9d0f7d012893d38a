/* Answers the cases of `beamgap export` with your own element.
 *
 *     beamgap export --family segment -o vectors.jsonl
 *     cc -O2 adapter.c -o adapter -lm
 *     beamgap verify vectors.jsonl --run ./adapter
 *
 * This program is for two straight beams, the family `segment`. For yours, change
 * 1. FAMILY and BEAM_DOFS, the name of the family and its dofs a beam,
 * 2. `element`, and what `main` prints of it,
 * 3. HEAD: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FAMILY "segment"
#define HEAD \
    "{\"schema\":\"beamgap-answers/1\",\"program\":\"adapter.c\"," \
    "\"only\":[\"d\",\"xi:first\",\"xi_bar:first\"]}\n"
enum { BEAM_DOFS = 6, DOFS = 2 * BEAM_DOFS };

struct answers {
    double d, d_gradient[DOFS], d_hessian[DOFS][DOFS];
    double xi_gradient[DOFS], xi_bar_gradient[DOFS];
};

static double dot(const double u[3], const double v[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/* The gradient of w . delta u for a vector w. */
static void along(const double shapes[4], const double w[3], double to[DOFS]) {
    for (int i = 0; i < DOFS; i++) to[i] = shapes[i / 3] * w[i % 3];
}

/* YOUR ELEMENT. Here: two straight beams, 12 dofs, by the equations of Zavarise (2007).
 * q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
 * xi_held, xi_bar_held: whether the parameter is held at an end of its beam. */
static void element(const double q[DOFS], double xi, double xi_bar, int xi_held, int xi_bar_held,
                    struct answers *to) {
    /* Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar. */
    const double shapes[4] = {(1 - xi) / 2, (1 + xi) / 2, -(1 - xi_bar) / 2, -(1 + xi_bar) / 2};
    const double slopes[4] = {-0.5, 0.5, 0, 0}, slopes_bar[4] = {0, 0, -0.5, 0.5};
    double d[3] = {0}, t[3] = {0}, t_bar[3] = {0}, n[3];
    for (int i = 0; i < DOFS; i++) {
        d[i % 3] += shapes[i / 3] * q[i];
        t[i % 3] += slopes[i / 3] * q[i];
        t_bar[i % 3] += slopes_bar[i / 3] * q[i];
    }
    to->d = sqrt(dot(d, d));
    for (int c = 0; c < 3; c++) n[c] = d[c] / to->d;
    double A1d[DOFS], B1d[DOFS], Gt[DOFS], Gt_bar[DOFS];
    along(slopes, d, A1d);
    along(slopes_bar, d, B1d);
    along(shapes, t, Gt);
    along(shapes, t_bar, Gt_bar);
    along(shapes, n, to->d_gradient); /* eq. (37) */
    const double a = dot(t, t), b = dot(t, t_bar), a_bar = -dot(t_bar, t_bar);
    const double det = a * a_bar + b * b;
    double *g = to->xi_gradient, *g_bar = to->xi_bar_gradient;
    for (int i = 0; i < DOFS; i++) {
        /* Eq. (50) and (52), reduced to one equation or none if parameters are held at an end. */
        const double r = -Gt[i] - A1d[i], r_bar = -Gt_bar[i] - B1d[i];
        g[i] = xi_held ? 0 : xi_bar_held ? r / a : (a_bar * r + b * r_bar) / det;
        g_bar[i] = xi_bar_held ? 0 : xi_held ? r_bar / a_bar : (-b * r + a * r_bar) / det;
    }
    for (int i = 0; i < DOFS; i++)
        for (int j = 0; j < DOFS; j++) {
            /* Eq. (40). */
            const double GG = i % 3 == j % 3 ? shapes[i / 3] * shapes[j / 3] : 0;
            const double moved = Gt[i] * g[j] - Gt_bar[i] * g_bar[j];
            const double turned = A1d[i] * g[j] - B1d[i] * g_bar[j];
            to->d_hessian[i][j] = (GG + moved + turned - to->d_gradient[i] * to->d_gradient[j]) / to->d;
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

static void print(const char *name, const double numbers[], int count) {
    printf("\"%s\":[", name);
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
        const char *bar = after(beam, "\"bar\":{"), *point = after(bar, "\"point\":{");
        const char *held = after(point, "\"held\":\"");
        double q[DOFS], xi[1], xi_bar[1];
        const char *family = "\"family\":\"" FAMILY "\"";
        if (!id || !beam || !bar) return 1;
        if (strncmp(beam, family, strlen(family)) || strncmp(bar, family, strlen(family))) {
            fprintf(stderr, "adapter.c is for the family %s; a case has another one. Change FAMILY, BEAM_DOFS and element.\n",
                    FAMILY);
            return 1;
        }
        printf("{\"id\":\"%.*s\"", (int)strcspn(id, "\""), id);
        if (held && numbers(after(beam, "\"q\":["), BEAM_DOFS, q) &&
            numbers(after(bar, "\"q\":["), BEAM_DOFS, q + BEAM_DOFS) && numbers(after(point, "\"xi\":"), 1, xi) &&
            numbers(after(point, "\"xi_bar\":"), 1, xi_bar)) {
            struct answers answers;
            const int both = !strncmp(held, "both", 4);
            element(q, *xi, *xi_bar, both || !strncmp(held, "xi\"", 3), both || !strncmp(held, "xi_bar", 6),
                    &answers);
            printf(",\"d\":{\"value\":%.17g,", answers.d);
            print("gradient", answers.d_gradient, DOFS);
            printf(",");
            print("hessian", &answers.d_hessian[0][0], DOFS * DOFS);
            printf("},\"xi\":{");
            print("gradient", answers.xi_gradient, DOFS);
            printf("},\"xi_bar\":{");
            print("gradient", answers.xi_bar_gradient, DOFS);
            printf("}}\n");
        } else {
            printf(",\"result\":\"degenerate\"}\n"); /* the case has no regular closest point */
        }
        fflush(stdout);
    }
    free(line);
    return 0;
}
