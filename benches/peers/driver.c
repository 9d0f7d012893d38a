/* The clock: calls a method on pair after pair. The result goes to the same memory each time, so it stays in the cache. Time
 * is the processor's, so that what else runs on the machine is left out. */
#define _POSIX_C_SOURCE 199309L
#include <stddef.h>
#include <time.h>

typedef void method(const double *q, double xi, double xib, double *out);
typedef void method_of_many(const double *const *q, double *out);

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static const double *pair(const double *first, size_t stride, size_t i) {
    return (const double *)((const char *)first + stride * i);
}

/* Nanoseconds for `count` pairs, one at a time. */
double run(method *f, const double *first, size_t stride, size_t count, double *out) {
    const double start = now();
    for (size_t i = 0; i < count; i++) {
        const double *q = pair(first, stride, i);
        f(q, q[24], q[25], out);
    }
    return now() - start;
}

/* The same, `together` of at most 64 at a time; `count` is a multiple of it. */
double run_together(method_of_many *f, size_t together, const double *first, size_t stride, size_t count, double *out) {
    const double start = now();
    for (size_t i = 0; i < count; i += together) {
        const double *q[64];
        for (size_t k = 0; k < together; k++) q[k] = pair(first, stride, i + k);
        f(q, out);
    }
    return now() - start;
}
