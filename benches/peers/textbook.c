/* The closed form in the form of a textbook: gradients are vectors of 24 numbers, Hessians sums of their outer
 * products, and the terms of the shape functions are added to their blocks. The compiler optimizes the loops. */
#include "peer.h"
#include <math.h>

typedef double vector[24];

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Shape functions and the curve, with three derivatives each. */
struct curve {
    double s[4][4], x[4][3];
};

static struct curve curve(const double *q, double z) {
    struct curve c = {.s = {{.25 * (2 - 3 * z + z * z * z), .25 * (1 - z - z * z + z * z * z),
                             .25 * (2 + 3 * z - z * z * z), .25 * (-1 - z + z * z + z * z * z)},
                            {.75 * (z * z - 1), .25 * (3 * z * z - 2 * z - 1), .75 * (1 - z * z),
                             .25 * (3 * z * z + 2 * z - 1)},
                            {1.5 * z, .5 * (3 * z - 1), -1.5 * z, .5 * (3 * z + 1)},
                            {1.5, 1.5, -1.5, 1.5}}};
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) {
            c.x[k][i] = 0;
            for (int a = 0; a < 4; a++) c.x[k][i] += c.s[k][a] * q[3 * a + i];
        }
    return c;
}

/* to += factor (A_k or B_k)' w */
static void add(double *to, double factor, const double *shapes, const double *w) {
    for (int a = 0; a < 4; a++)
        for (int i = 0; i < 3; i++) to[3 * a + i] += factor * shapes[a] * w[i];
}

/* to += factor (A_k' B_l) in the block that starts at row and column */
static void add_product(double *h, int row, int column, double factor, const double *s, const double *z) {
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++)
            for (int i = 0; i < 3; i++) h[24 * (row + 3 * a + i) + column + 3 * b + i] += factor * s[a] * z[b];
}

/* Common terms of all quantities. */
struct first {
    struct curve x, y;
    double d[3], distance, a, b, c, p, q, r;
    vector g, h;
};

static void first(const double *q, double xi, double xib, struct first *o) {
    o->x = curve(q, xi);
    o->y = curve(q + 12, xib);
    for (int i = 0; i < 3; i++) o->d[i] = o->x.x[0][i] - o->y.x[0][i];
    const double *d = o->d, *t = o->x.x[1], *t1 = o->x.x[2], *u = o->y.x[1], *u1 = o->y.x[2];
    o->distance = sqrt(dot(d, d));
    o->a = dot(t, t) + dot(d, t1), o->b = dot(t, u), o->c = dot(d, u1) - dot(u, u);
    const double det = o->a * o->c + o->b * o->b;
    o->p = o->c / det, o->q = o->b / det, o->r = o->a / det;
    vector right = {0}, right_bar = {0};
    add(right, -1, o->x.s[0], t), add(right, -1, o->x.s[1], d), add(right + 12, 1, o->y.s[0], t);
    add(right_bar, -1, o->x.s[0], u), add(right_bar + 12, 1, o->y.s[0], u), add(right_bar + 12, -1, o->y.s[1], d);
    for (int j = 0; j < 24; j++) {
        o->g[j] = o->p * right[j] + o->q * right_bar[j];
        o->h[j] = o->r * right_bar[j] - o->q * right[j];
    }
}

static void distance(const struct first *o, double *out) {
    double *gradient = out + PEER_GRADIENT, *h = out + PEER_HESSIAN, n[3];
    const double inverse = 1 / o->distance;
    for (int i = 0; i < 3; i++) n[i] = o->d[i] * inverse;
    out[PEER_VALUE] = o->distance;
    for (int j = 0; j < 24; j++) gradient[j] = 0;
    add(gradient, 1, o->x.s[0], n), add(gradient + 12, -1, o->y.s[0], n);
    for (int i = 0; i < 24; i++)
        for (int j = 0; j < 24; j++)
            h[24 * i + j] = inverse * (o->b * (o->g[i] * o->h[j] + o->h[i] * o->g[j]) - o->a * o->g[i] * o->g[j]
                                       + o->c * o->h[i] * o->h[j] - gradient[i] * gradient[j]);
    add_product(h, 0, 0, inverse, o->x.s[0], o->x.s[0]);
    add_product(h, 0, 12, -inverse, o->x.s[0], o->y.s[0]);
    add_product(h, 12, 0, -inverse, o->y.s[0], o->x.s[0]);
    add_product(h, 12, 12, inverse, o->y.s[0], o->y.s[0]);
}

/* H = -x P - y P_bar */
static void parameter(const struct first *o, double x, double y, const double *with, const double *with_bar, double *h) {
    for (int i = 0; i < 24; i++)
        for (int j = 0; j < 24; j++)
            h[24 * i + j] = o->g[i] * with[j] + with[i] * o->g[j] + o->h[i] * with_bar[j] + with_bar[i] * o->h[j];
    add_product(h, 0, 0, -x, o->x.s[0], o->x.s[1]), add_product(h, 0, 0, -x, o->x.s[1], o->x.s[0]);
    add_product(h, 0, 12, x, o->x.s[1], o->y.s[0]), add_product(h, 12, 0, x, o->y.s[0], o->x.s[1]);
    add_product(h, 0, 12, -y, o->x.s[0], o->y.s[1]), add_product(h, 12, 0, -y, o->y.s[1], o->x.s[0]);
    add_product(h, 12, 12, y, o->y.s[0], o->y.s[1]), add_product(h, 12, 12, y, o->y.s[1], o->y.s[0]);
}

static void parameters(const struct first *o, double xi, double xib, double *to, double *to_bar) {
    const struct curve *x = &o->x, *y = &o->y;
    const double *d = o->d, *t = x->x[1], *t1 = x->x[2], *t2 = x->x[3], *u = y->x[1], *u1 = y->x[2], *u2 = y->x[3];
    vector alpha = {0}, beta = {0}, alpha_bar = {0}, beta_bar = {0}, with, with_bar;
    add(alpha, 1, x->s[0], t1), add(alpha, 2, x->s[1], t), add(alpha, 1, x->s[2], d), add(alpha + 12, -1, y->s[0], t1);
    add(beta, -1, x->s[1], u), add(beta + 12, -1, y->s[1], t);
    add(alpha_bar, 1, x->s[0], u1), add(alpha_bar + 12, -1, y->s[0], u1), add(alpha_bar + 12, -2, y->s[1], u);
    add(alpha_bar + 12, 1, y->s[2], d);
    add(beta_bar, 1, x->s[1], u), add(beta_bar + 12, 1, y->s[1], t);
    const double c1 = 1.5 * dot(t, t1) + .5 * dot(d, t2), c2 = dot(u, t1), c3 = dot(t, u1);
    const double c4 = .5 * dot(d, u2) - 1.5 * dot(u, u1);
    for (int j = 0; j < 24; j++) {
        alpha[j] += c1 * o->g[j] - c2 * o->h[j];
        beta[j] -= .5 * c3 * o->h[j];
        alpha_bar[j] += c4 * o->h[j] + c3 * o->g[j];
        beta_bar[j] += .5 * c2 * o->g[j];
        to[PEER_GRADIENT + j] = o->g[j];
        to_bar[PEER_GRADIENT + j] = o->h[j];
    }
    to[PEER_VALUE] = xi, to_bar[PEER_VALUE] = xib;
    for (int j = 0; j < 24; j++) {
        with[j] = -o->p * alpha[j] - o->q * beta_bar[j];
        with_bar[j] = -o->q * alpha_bar[j] - o->p * beta[j];
    }
    parameter(o, o->p, o->q, with, with_bar, to + PEER_HESSIAN);
    for (int j = 0; j < 24; j++) {
        with[j] = o->q * alpha[j] - o->r * beta_bar[j];
        with_bar[j] = -o->r * alpha_bar[j] + o->q * beta[j];
    }
    parameter(o, -o->q, o->r, with, with_bar, to_bar + PEER_HESSIAN);
}

/* The length of a tangent whose dofs start at `start`; g and the Hessian are those of its parameter. */
static void length(const struct curve *x, int start, const double *g, const double *second, double *out) {
    const double *t = x->x[1], *t1 = x->x[2], *t2 = x->x[3], value = sqrt(dot(t, t)), inverse = 1 / value;
    double *gradient = out + PEER_GRADIENT, *h = out + PEER_HESSIAN, w[3];
    for (int i = 0; i < 3; i++) w[i] = t[i] * inverse;
    const double slope = dot(w, t1), square = .5 * (dot(w, t2) + dot(t1, t1) * inverse);
    vector with;
    out[PEER_VALUE] = value;
    for (int j = 0; j < 24; j++) gradient[j] = slope * g[j], with[j] = square * g[j];
    add(gradient + start, 1, x->s[1], w);
    add(with + start, 1, x->s[2], w), add(with + start, inverse, x->s[1], t1);
    for (int i = 0; i < 24; i++)
        for (int j = 0; j < 24; j++)
            h[24 * i + j] = slope * second[24 * i + j] + g[i] * with[j] + with[i] * g[j]
                            - inverse * gradient[i] * gradient[j];
    add_product(h, start, start, inverse, x->s[1], x->s[1]);
}

void text_d_full(const double *q, double xi, double xib, double *out) {
    struct first o;
    first(q, xi, xib, &o);
    distance(&o, out);
}

void text_all_full(const double *q, double xi, double xib, double *out) {
    struct first o;
    first(q, xi, xib, &o);
    distance(&o, out);
    parameters(&o, xi, xib, out + PEER_FULL, out + 2 * PEER_FULL);
    length(&o.x, 0, o.g, out + PEER_FULL + PEER_HESSIAN, out + 3 * PEER_FULL);
    length(&o.y, 12, o.h, out + 2 * PEER_FULL + PEER_HESSIAN, out + 4 * PEER_FULL);
}
