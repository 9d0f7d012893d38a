// What CasADi generated, for four pairs at once: its code, unchanged, over a type of four numbers. -DFUNCTION, -DSOURCE.
// Number k of the result is in the four doubles out[4k..4k+4], one a pair.
#include <cmath>
#include <immintrin.h>
#include <math.h>

#include "peer.h"

struct Lanes {
    __m256d v;
    Lanes() = default;
    Lanes(__m256d v) : v(v) {}
    Lanes(double x) : v(_mm256_set1_pd(x)) {}
    Lanes &operator+=(Lanes y) { return *this = v + y.v; }
    Lanes &operator-=(Lanes y) { return *this = v - y.v; }
    Lanes &operator*=(Lanes y) { return *this = v * y.v; }
    Lanes &operator/=(Lanes y) { return *this = v / y.v; }
};
static inline Lanes operator+(Lanes x, Lanes y) { return x.v + y.v; }
static inline Lanes operator-(Lanes x, Lanes y) { return x.v - y.v; }
static inline Lanes operator*(Lanes x, Lanes y) { return x.v * y.v; }
static inline Lanes operator/(Lanes x, Lanes y) { return x.v / y.v; }
static inline Lanes operator-(Lanes x) { return -x.v; }
static inline Lanes sqrt(Lanes x) { return _mm256_sqrt_pd(x.v); }

#define casadi_real Lanes
#include SOURCE

#define JOIN(a, b) a##b
#define NAMED(function) JOIN(function, _lanes)

extern "C" void NAMED(FUNCTION)(const double *const q[4], double *out) {
    Lanes dofs[26];
    for (int i = 0; i < 26; i++) dofs[i] = Lanes(_mm256_setr_pd(q[0][i], q[1][i], q[2][i], q[3][i]));
    const Lanes *given[3] = {dofs, dofs + 24, dofs + 25};
    Lanes *const to = reinterpret_cast<Lanes *>(out), *result[15];
    for (int k = 0; k < 5; k++) {
        result[3 * k] = to + PEER_FULL * k + PEER_VALUE;
        result[3 * k + 1] = to + PEER_FULL * k + PEER_GRADIENT;
        result[3 * k + 2] = to + PEER_FULL * k + PEER_HESSIAN;
    }
    FUNCTION(given, result, nullptr, nullptr, 0);
}
