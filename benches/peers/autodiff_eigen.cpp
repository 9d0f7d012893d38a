// Eigen's AutoDiffScalar over itself, 24 variables.
#include "chord.hpp"
#include "peer.h"
#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

using First = Eigen::AutoDiffScalar<Eigen::Matrix<double, 24, 1>>;
using Second = Eigen::AutoDiffScalar<Eigen::Matrix<First, 24, 1>>;

template <int COUNT> static void differentiate(const double *dofs, double xi, double xib, double *out) {
    Second q[24], to[5];
    for (int i = 0; i < 24; i++) {
        q[i].value() = First(dofs[i], 24, i);
        for (int j = 0; j < 24; j++) q[i].derivatives()(j) = First(i == j ? 1.0 : 0.0, Eigen::Matrix<double, 24, 1>::Zero());
    }
    quantities(q, Chord(dofs, xi, xib), xi, xib, COUNT == 1 ? 1 : 2, COUNT > 1, to);
    for (int k = 0; k < COUNT; k++, out += PEER_FULL) {
        out[PEER_VALUE] = to[k].value().value();
        for (int i = 0; i < 24; i++) {
            out[PEER_GRADIENT + i] = to[k].derivatives()(i).value();
            for (int j = 0; j < 24; j++) out[PEER_HESSIAN + 24 * i + j] = to[k].derivatives()(i).derivatives()(j);
        }
    }
}

extern "C" void eigen_d_full(const double *q, double xi, double xib, double *out) { differentiate<1>(q, xi, xib, out); }
extern "C" void eigen_all_full(const double *q, double xi, double xib, double *out) { differentiate<5>(q, xi, xib, out); }
