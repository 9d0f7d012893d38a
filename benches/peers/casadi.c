/* What CasADi generated, as a peer: -DFUNCTION, its name and that of its file, -DSOURCE, and -DTASK_ALL for task B. */
#include SOURCE
#include "peer.h"

#define JOIN(a, b) a##b
#define NAMED(function) JOIN(function, _full)

void NAMED(FUNCTION)(const double *q, double xi, double xib, double *out) {
    const double *given[3] = {q, &xi, &xib};
    double *result[15];
    for (int k = 0; k < 5; k++) {
        result[3 * k] = out + PEER_FULL * k + PEER_VALUE;
        result[3 * k + 1] = out + PEER_FULL * k + PEER_GRADIENT;
        result[3 * k + 2] = out + PEER_FULL * k + PEER_HESSIAN;
    }
    FUNCTION(given, result, 0, 0, 0);
}
