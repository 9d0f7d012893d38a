/* The interface of every C and C++ peer: the linearization of two cubic Hermite curves at a given closest point.
 *
 * q      24 dofs: beam x1, t1, x2, t2, then bar beam x1, t1, x2, t2; dx/dxi = t at the nodes
 * xi     parameter of the closest point on the beam, xib on the bar beam; interior
 * out    one block for each quantity: d in task A; d, xi, xi_bar, t, t_bar in task B
 *
 * A block, in doubles; hessians are row-major, all rows are written in full:
 *
 *   full    0 value   8 gradient[24]   32 hessian[24][24]                                    stride PEER_FULL  = 608
 *   upper   0 value   8 gradient[24]   32 beam[12][12]   176 mixed[12][12]   320 bar[12][12]
 *                                                                                            stride PEER_UPPER = 464
 *
 * The rows of mixed are dofs of the beam, its columns dofs of the bar beam. Numbers 1 to 7 of a block are padding and
 * are not written. Any alignment is valid, 64 bytes is the fastest. */
#ifndef BEAMGAP_PEER_H
#define BEAMGAP_PEER_H

enum {
    PEER_VALUE = 0,
    PEER_GRADIENT = 8,
    PEER_HESSIAN = 32,
    PEER_BEAM = 32,
    PEER_MIXED = 176,
    PEER_BAR = 320,
    PEER_FULL = 608,
    PEER_UPPER = 464
};

#ifdef __cplusplus
extern "C" {
#endif

/* reference.cpp: structure-exploiting rows, AVX2 and FMA. */
void ref_d_full(const double q[24], double xi, double xib, double *out);
void ref_d_upper(const double q[24], double xi, double xib, double *out);
void ref_all_full(const double q[24], double xi, double xib, double *out);
void ref_all_upper(const double q[24], double xi, double xib, double *out);

#ifdef __cplusplus
}
#endif
#endif
