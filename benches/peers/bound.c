/* A lower bound on the time of the row form on this machine: the products of its rows and the stores of its result.
 *
 * A row of d is two products of four numbers a vector, a row of xi or xi_bar three, one of t or t_bar two to four (eight
 * over the three blocks). Of 36 + 36 + 36 vectors above the diagonal task A has 216 products and task B 1440. The stores
 * are 144 vectors a quantity in full, 108 in the upper layout. Latency and the work before the rows are not counted. */
#include "peer.h"
#include <immintrin.h>

/* The registers are named, because the compiler would otherwise keep the sums in memory. */
#define P(i) __asm__ volatile("vfmadd231pd %%ymm15, %%ymm15, %%ymm" #i ::: "ymm" #i);
#define Z(i) __asm__ volatile("vxorpd %%ymm" #i ", %%ymm" #i ", %%ymm" #i ::: "ymm" #i);
#define S __asm__ volatile("vmovupd %%ymm14, %0" : "=m"(*(__m256d *)to)); to += 4;
#define ZEROS Z(0) Z(1) Z(2) Z(3) Z(4) Z(5) Z(6) Z(7) Z(8) Z(9) Z(10) Z(11) Z(14) Z(15)

#define BOUND(name, times, ...)                                                \
    void bound_##name(const double *q, double xi, double xib, double *to) {    \
        (void)q, (void)xi, (void)xib;                                          \
        ZEROS                                                                  \
        for (int k = 0; k < times; k++) { __VA_ARGS__ }                        \
    }

BOUND(d_full, 18, P(0) S P(1) P(2) S P(3) S P(4) P(5) S P(6) S P(7) P(8) S P(9) S P(10) P(11) S)
BOUND(d_upper, 18, P(0) P(1) S P(2) P(3) S P(4) P(5) S P(6) P(7) S P(8) P(9) S P(10) P(11) S)
BOUND(all_full, 120, P(0) P(1) S P(2) P(3) S P(4) P(5) S P(6) P(7) S P(8) P(9) S P(10) P(11) S)
BOUND(all_upper, 60, P(0) P(1) P(2) S P(3) P(4) P(5) S P(6) P(7) S P(8) P(9) P(10) S P(11) P(0) P(1) S P(2) P(3) S
                     P(4) P(5) P(6) S P(7) P(8) P(9) S P(10) P(11) S)
