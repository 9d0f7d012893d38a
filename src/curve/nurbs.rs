//! One span of a non-uniform rational B-spline whose weights are fixed parameters.

use super::shapes::control_vectors;
use super::{BSpline, Curve, CurveError, Jet, Shapes};
use crate::number::Real;
use nalgebra::{SVector, Vector1, Vector3};

/// One span of a rational B-spline of degree `P` - 1 with given weights.
///
/// Dofs, node-major: the coordinates of the control points P_i, all in the user's unit of length; `N = 3 P`. The span,
/// its knots and its control points are those of [`BSpline`]. With N_i its basis functions and w_i > 0 the weights,
///
/// ```math
/// x(xi) = A / W = sum_i R_i P_i,   A = sum_i N_i w_i P_i,   W = sum_i N_i w_i,   R_i = N_i w_i / W
/// ```
///
/// so the curve is linear in its dofs. [`NurbsWeighted`](super::NurbsWeighted) has the weights among its dofs.
///
/// Source: L. Piegl, W. Tiller, *The NURBS Book*, 2nd ed., sections 4.2 and 4.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nurbs<const P: usize> {
    span: BSpline<P>,
    weights: [f64; P],
}

impl<const P: usize> Nurbs<P> {
    /// The span in the middle of 2 (`P` - 1) knots, with one weight for every control point.
    ///
    /// # Errors
    /// If the knots are invalid for a [`BSpline`], or if a weight is not positive and finite.
    pub fn new(knots: &[f64], weights: [f64; P]) -> Result<Self, CurveError> {
        let span = BSpline::new(knots)?;
        match weights.iter().enumerate().find(|&(_, &weight)| !(weight > 0.0 && weight.is_finite())) {
            Some((index, &weight)) => Err(CurveError::Weight { index, weight }),
            None => Ok(Self { span, weights }),
        }
    }
}

impl<const P: usize, const N: usize> Curve<N> for Nurbs<P> {
    type Dofs<T: Real> = Shapes<T, P>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        let points = control_vectors::<T, P, N>(q);
        let weighted =
            std::array::from_fn(|i| (points[i] * T::from(self.weights[i])).push(self.weights[i].into()));
        let a = self.span.interpolate(weighted, xi);
        a.xyz() / a.w
    }

    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Shapes<T, P>> {
        let functions = self.span.functions(xi);
        let mut n = [[T::zero(); P]; 4];
        let mut w = [T::zero(); 4];
        for (i, (function, &weight)) in functions.iter().zip(&self.weights).enumerate() {
            for k in 0..4 {
                n[k][i] = function[k] * T::from(weight);
                w[k] += n[k][i];
            }
        }
        // Leibniz' rule for N_i w_i = W R_i, solved for R_i^(k): n[k] is N_i^(k) w_i before and R_i^(k) after.
        for k in 0..4 {
            let (lower, upper) = n.split_at_mut(k);
            for (i, r) in upper[0].iter_mut().enumerate() {
                for j in 1..=k {
                    *r -= T::from(BINOMIALS[k][j]) * w[j] * lower[k - j][i];
                }
                *r /= w[0];
            }
        }
        Shapes::jet(n, q)
    }

    /// By the quotient rule, from bounds of A, W and their derivatives; see `rational_bound`.
    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64 {
        rational_bound(&self.span, control_vectors::<f64, P, N>(q), self.weights)
    }
}

/// `BINOMIALS[k][j]`: k over j.
pub(super) const BINOMIALS: [[f64; 4]; 4] =
    [[1.0, 0.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0], [1.0, 2.0, 1.0, 0.0], [1.0, 3.0, 3.0, 1.0]];

/// The sum over j, from `first` to k, of binomial(k, j) times the vector of j.
#[inline]
pub(super) fn leibniz<T: Real>(k: usize, first: usize, vector: impl Fn(usize) -> Vector3<T>) -> Vector3<T> {
    (first..=k).fold(Vector3::zeros(), |sum, j| sum + vector(j) * T::from(BINOMIALS[k][j]))
}

/// A bound of ‖x,xixixi‖ of a rational span; infinite unless all weights are positive.
///
/// The point is taken relative to the mean of the control points. From A^(k) = sum_j binomial(k, j) W^(j) x^(k-j),
/// with ‖A^(k)‖ <= a_k and |W^(k)| <= w_k by the control vectors of both splines, and W >= the least weight,
/// ‖x^(k)‖ <= b_k = (a_k + sum over j > 0 of binomial(k, j) w_j b_(k-j)) / (least weight); b_0 is the distance of the
/// farthest control point, as x lies within their convex hull. Equal weights give the bound of the B-spline.
pub(super) fn rational_bound<const P: usize>(
    span: &BSpline<P>,
    points: [Vector3<f64>; P],
    weights: [f64; P],
) -> f64 {
    if !weights.iter().all(|&weight| weight > 0.0) {
        return f64::INFINITY;
    }
    let least = weights.iter().copied().fold(f64::INFINITY, f64::min);
    let mean = points.iter().sum::<Vector3<f64>>() / super::shapes::count(P);
    let points = points.map(|point| point - mean);
    let a = span.bounds(std::array::from_fn(|i| points[i] * weights[i]));
    let w = span.bounds(weights.map(Vector1::new));
    let mut b = [0.0; 4];
    b[0] = points.iter().map(Vector3::norm).fold(0.0, f64::max);
    for k in 1..4 {
        let products: f64 = (1..=k).map(|j| BINOMIALS[k][j] * w[j] * b[k - j]).sum();
        b[k] = (a[k] + products) / least;
    }
    b[3]
}
