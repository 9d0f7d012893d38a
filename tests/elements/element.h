/* Reads the cases of `beamgap export` and writes the answers for `beamgap verify`. The three elements share it.
 *
 *     matrices ERROR < vectors.jsonl > answers.jsonl
 *
 * ERROR is a number of errors.csv, or 0 for the element without an error. Beams are cubic Hermite curves or segments.
 * Index 0 is the beam, index 1 the bar beam. */
#ifndef ELEMENT_H
#define ELEMENT_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 24 }; /* dofs of both beams */

/* The error that is put in. E: an expression and the wrong one. F: the factor of a term under this error, else 1. */
static int error = 0;
#define E(number, right, wrong) (error == (number) ? (wrong) : (right))
#define F(number, factor) (error == (number) ? (double)(factor) : 1.0)

/* A case: control vectors and dofs of each beam, all dofs, the closest point, whether each parameter is held at an end. */
typedef struct {
    int nodes[2], dofs[2], size;
    double q[MOST], xi[2], xi_0[2], radius[2];
    int held[2];
} Pair;

/* A quantity with its gradient and its Hessian, which is `size` by `size`, row by row. */
typedef struct {
    double value, gradient[MOST], hessian[MOST * MOST];
} Quantity;

typedef struct {
    Quantity d, xi[2], t[2], slip[2];
    double gap; /* the value of g_N, which has the derivatives of d */
} Answers;

/* The text after a key, which is searched after `from`. */
static const char *after(const char *from, const char *key) {
    const char *at = from ? strstr(from, key) : NULL;
    return at ? at + strlen(key) : NULL;
}

static const char *numbers(const char *from, int count, double *to) {
    for (int i = 0; from && i < count; i++) {
        char *end;
        to[i] = strtod(from, &end);
        from = end == from ? NULL : end + 1; /* a comma, or the closing bracket */
    }
    return from;
}

/* Reads a case. Returns whether it has a closest point and beams of these families. */
static int read_case(const char *line, Pair *pair) {
    const char *at = line;
    pair->size = 0;
    for (int beam = 0; beam < 2; beam++) {
        at = after(after(at, beam ? "\"bar\":{" : "\"beam\":{"), "\"family\":\"");
        if (!at) return 0;
        pair->nodes[beam] = !strncmp(at, "hermite\"", 8) ? 4 : !strncmp(at, "segment\"", 8) ? 2 : 0;
        pair->dofs[beam] = 3 * pair->nodes[beam];
        if (!pair->nodes[beam]) return 0;
        at = numbers(after(at, "\"q\":["), pair->dofs[beam], pair->q + pair->size);
        pair->size += pair->dofs[beam];
    }
    at = numbers(after(at, "\"radius\":"), 1, &pair->radius[0]);
    at = numbers(after(at, "\"radius_bar\":"), 1, &pair->radius[1]);
    at = numbers(after(at, "\"xi_0\":"), 1, &pair->xi_0[0]);
    at = numbers(after(at, "\"xi_bar_0\":"), 1, &pair->xi_0[1]);
    at = numbers(after(after(at, "\"point\":{"), "\"xi\":"), 1, &pair->xi[0]);
    at = numbers(after(at, "\"xi_bar\":"), 1, &pair->xi[1]);
    at = after(at, "\"held\":\"");
    if (!at) return 0;
    pair->held[0] = !strncmp(at, "xi\"", 3) || !strncmp(at, "both\"", 5);
    pair->held[1] = !strncmp(at, "xi_bar\"", 7) || !strncmp(at, "both\"", 5);
    return 1;
}

static void print(const char *name, const double *of, int count) {
    printf(",\"%s\":[", name);
    for (int i = 0; i < count; i++) printf(isfinite(of[i]) ? "%s%.17g" : "%snull", i ? "," : "", of[i]);
    printf("]");
}

static inline void print_quantity(const char *name, const Quantity *of, int size) {
    printf(isfinite(of->value) ? ",\"%s\":{\"value\":%.17g" : ",\"%s\":{\"value\":null", name, of->value);
    print("gradient", of->gradient, size);
    print("hessian", of->hessian, size * size);
    printf("}");
}

/* Answers a case, written in `line`. Returns whether it can. */
static int answer(const char *line, const Pair *pair);

#ifndef ONLY
#define ONLY "[\"d\",\"t\",\"t_bar\",\"xi\",\"xi_bar\",\"g_N\",\"g_T\",\"g_T_bar\"]"

/* The formulas of the geometry. Each program has its own. */
static void element(const Pair *pair, Answers *to);

static int answer(const char *line, const Pair *pair) {
    static Answers of;
    static Quantity gap;
    (void)line;
    memset(&of, 0, sizeof of);
    element(pair, &of);
    print_quantity("d", &of.d, pair->size);
    gap = of.d;
    gap.value = of.gap;
    print_quantity("g_N", &gap, pair->size);
    print_quantity("xi", &of.xi[0], pair->size);
    print_quantity("xi_bar", &of.xi[1], pair->size);
    print_quantity("t", &of.t[0], pair->size);
    print_quantity("t_bar", &of.t[1], pair->size);
    print_quantity("g_T", &of.slip[0], pair->size);
    print_quantity("g_T_bar", &of.slip[1], pair->size);
    return 1;
}
#endif

int main(int count, char **arguments) {
    static char line[1 << 20];
    static Pair pair;
    if (count > 1) error = atoi(arguments[1]);
    if (!fgets(line, sizeof line, stdin)) return 1; /* the head of the cases */
    printf("{\"schema\":\"beamgap-answers/1\",\"program\":\"" ELEMENT "\",\"only\":" ONLY "}\n");
    while (fgets(line, sizeof line, stdin)) {
        const char *id = after(line, "\"id\":\"");
        if (!id) return 1;
        printf("{\"id\":\"%.*s\"", (int)strcspn(id, "\""), id);
        if (!read_case(line, &pair) || !answer(line, &pair)) printf(",\"result\":\"degenerate\""); /* not answered */
        printf("}\n");
        fflush(stdout);
    }
    return 0;
}

#endif
