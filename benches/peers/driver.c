/* Measures the time of a method on one pair after another. The results share one buffer, which stays in the cache.
 * The time is that of the processor, so that other programs on the machine are not counted. */
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

/* The same, with `together` pairs at a time, at most 64; `count` is a multiple of `together`. */
double run_together(method_of_many *f, size_t together, const double *first, size_t stride, size_t count, double *out) {
    const double start = now();
    for (size_t i = 0; i < count; i += together) {
        const double *q[64];
        for (size_t k = 0; k < together; k++) q[k] = pair(first, stride, i + k);
        f(q, out);
    }
    return now() - start;
}
