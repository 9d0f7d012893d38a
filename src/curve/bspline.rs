//! One span of a B-spline of any degree.

use super::shapes::{by_order, control_vectors, count, go, times_linear, triangle};
use super::{Curve, CurveError, Jet, Shapes};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// One span of a B-spline of degree `P` - 1.
///
/// A span of degree p = P - 1 depends on `P` control points and on 2 p knots k_0 <= .. <= k_(2p - 1). The span is the
/// middle interval, from k_(p - 1) to k_p, to which xi in [-1, 1] is mapped affinely. Span number m of a whole knot
/// vector is [K_m, K_(m + 1)]. Its local knots are K_(m - p + 1), .., K_(m + p), its control points number m - p to m.
/// Dofs, node-major: the coordinates of the control points, all in the user's unit of length; `N = 3 P`. If p knots
/// coincide on either side, the curve is a [`Bezier`](super::Bezier) curve.
///
/// Source: C. de Boor, *A Practical Guide to Splines*, chapters IX and X: the position by his repeated interpolation,
/// the jet by the recursion of Cox and de Boor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BSpline<const P: usize> {
    /// The knots from the start of the span leftwards, in the coordinate xi, so `left[0]` = -1; the last is not used.
    left: [f64; P],
    /// The knots from the end of the span rightwards, in the coordinate xi, so `right[0]` = 1; the last is not used.
    right: [f64; P],
}

impl<const P: usize> BSpline<P> {
    /// The span in the middle of 2 (`P` - 1) knots.
    ///
    /// # Errors
    /// If the number of knots is wrong, if a knot is not finite or less than the one before it, or if the span has no
    /// length.
    pub fn new(knots: &[f64]) -> Result<Self, CurveError> {
        const { assert!(P >= 2, "a curve has at least two control points") };
        let degree = P - 1;
        if knots.len() != 2 * degree {
            return Err(CurveError::KnotCount { found: knots.len(), expected: 2 * degree });
        }
        if let Some((index, &knot)) = knots.iter().enumerate().find(|(_, knot)| !knot.is_finite()) {
            return Err(CurveError::KnotNotFinite { index, knot });
        }
        if let Some(index) = (1..knots.len()).find(|&i| knots[i] < knots[i - 1]) {
            return Err(CurveError::KnotsDecrease { index });
        }
        let (start, end) = (knots[degree - 1], knots[degree]);
        let half = 0.5 * end - 0.5 * start;
        let left = std::array::from_fn(|i| (knots[(degree - 1).saturating_sub(i)] - start) / half - 1.0);
        let right = std::array::from_fn(|i| (knots[(degree + i).min(2 * degree - 1)] - end) / half + 1.0);
        if half > 0.0 && left.iter().chain(&right).all(|knot: &f64| knot.is_finite()) {
            Ok(Self { left, right })
        } else {
            Err(CurveError::EmptySpan { start, end })
        }
    }

    /// The basis functions that do not vanish on the span, each with its first three derivatives.
    pub(super) fn functions<T: Real>(&self, xi: T) -> [[T; 4]; P] {
        let mut functions = [[T::zero(); 4]; P];
        functions[0][0] = T::one();
        for degree in 1..P {
            // N_i = (ξ - k_i) / (k_{i+p} - k_i) N_i + (k_{i+p+1} - ξ) / (k_{i+p+1} - k_{i+1}) N_{i+1}, from the left.
            let mut rising = [T::zero(); 4];
            for (i, function) in functions.iter_mut().enumerate().take(degree) {
                let (left, right) = (T::from(self.left[degree - 1 - i]), T::from(self.right[i]));
                let slope = T::one() / (right - left);
                let falling = times_linear(function, (right - xi) * slope, -slope);
                let next = times_linear(function, (xi - left) * slope, slope);
                *function = std::array::from_fn(|k| rising[k] + falling[k]);
                rising = next;
            }
            functions[degree] = rising;
        }
        functions
    }

    /// The point at xi of the spline with the given control points, of any dimension.
    pub(super) fn interpolate<T: Real, const D: usize>(
        &self,
        points: [SVector<T, D>; P],
        xi: T,
    ) -> SVector<T, D> {
        triangle(points, |level, i, point, to| {
            let (left, right) = (T::from(self.left[P - 1 - level - i]), T::from(self.right[i]));
            go(point, to, (xi - left) / (right - left));
        })
    }

    /// Bounds of the norms of the spline with these control points and of its first three derivatives. Every
    /// derivative is a spline too and lies in the convex hull of its own control points.
    pub(super) fn bounds<const D: usize>(&self, mut net: [SVector<f64, D>; P]) -> [f64; 4] {
        let mut bounds = [0.0; 4];
        for (level, bound) in bounds.iter_mut().enumerate().take(P) {
            if level > 0 {
                for i in 0..P - level {
                    let width = self.right[i] - self.left[P - 1 - level - i];
                    net[i] = (net[i + 1] - net[i]) * (count(P - level) / width);
                }
            }
            *bound = net.iter().take(P - level).map(SVector::norm).fold(0.0, f64::max);
        }
        bounds
    }
}

impl<const P: usize, const N: usize> Curve<N> for BSpline<P> {
    type Dofs<T: Real> = Shapes<T, P>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        self.interpolate(control_vectors(q), xi)
    }

    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Shapes<T, P>> {
        Shapes::jet(by_order(&self.functions(xi)), q)
    }

    /// The length of the longest control vector of x,xixixi, which is a B-spline too. Exact up to the cubic.
    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64 {
        let [_, _, _, third] = self.bounds(control_vectors::<f64, P, N>(q));
        third
    }

    fn is_cubic(&self) -> bool {
        P <= 4
    }
}
