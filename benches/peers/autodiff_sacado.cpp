// Sacado's SFad over itself, 24 variables.
#include "chord.hpp"
#include "peer.h"
#include <Sacado_Fad_SFad.hpp>

using First = Sacado::Fad::SFad<double, 24>;
using Second = Sacado::Fad::SFad<First, 24>;

template <int COUNT> static void differentiate(const double *dofs, double xi, double xib, double *out) {
    Second q[24], to[5];
    for (int i = 0; i < 24; i++) q[i] = Second(24, i, First(24, i, dofs[i]));
    quantities(q, Chord(dofs, xi, xib), xi, xib, COUNT == 1 ? 1 : 2, COUNT > 1, to);
    for (int k = 0; k < COUNT; k++, out += PEER_FULL) {
        out[PEER_VALUE] = to[k].val().val();
        for (int i = 0; i < 24; i++) {
            out[PEER_GRADIENT + i] = to[k].dx(i).val();
            for (int j = 0; j < 24; j++) out[PEER_HESSIAN + 24 * i + j] = to[k].dx(i).dx(j);
        }
    }
}

extern "C" void sacado_d_full(const double *q, double xi, double xib, double *out) { differentiate<1>(q, xi, xib, out); }
extern "C" void sacado_all_full(const double *q, double xi, double xib, double *out) { differentiate<5>(q, xi, xib, out); }
