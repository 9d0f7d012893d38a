//! The Bezier curve of any degree.

use super::shapes::{by_order, control_vectors, count, times_linear, triangle};
use super::{Curve, Jet, Shapes};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// The Bezier curve of degree `P` - 1 with `P` control points.
///
/// Its parameter is u = (xi + 1) / 2 in [0, 1]. Dofs, node-major: the coordinates of the control points P_0, P_1, ..,
/// all in the user's unit of length; `N = 3 P` for `P` control points, that is for the degree p = P - 1.
///
/// ```math
/// x(xi) = sum_i B_i P_i,   B_i = binomial(p, i) u^i (1 - u)^(p - i)
/// ```
///
/// Source: G. Farin, *Curves and Surfaces for CAGD*, 5th ed., chapters 4 (de Casteljau, the position) and 5 (Bernstein
/// polynomials, the jet).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bezier<const P: usize>;

impl<const P: usize> Bezier<P> {
    /// The curve family; it has no parameters.
    pub const fn new() -> Self {
        const { assert!(P >= 2, "a curve has at least two control points") };
        Self
    }
}

impl<const P: usize, const N: usize> Curve<N> for Bezier<P> {
    type Dofs<T: Real> = Shapes<T, P>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        let half = T::from(0.5);
        let (u, v) = ((T::one() + xi) * half, (T::one() - xi) * half);
        // Both weights are used, so that the curve starts and ends exactly in its control points.
        triangle(control_vectors::<T, P, N>(q), |_, _, point, to| *point = *point * v + to * u)
    }

    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Shapes<T, P>> {
        let half = T::from(0.5);
        let (u, v) = ((T::one() + xi) * half, (T::one() - xi) * half);
        let mut binomial = 1.0;
        let functions: [[T; 4]; P] = std::array::from_fn(|i| {
            let start = [T::from(binomial), T::zero(), T::zero(), T::zero()];
            let falling = (i + 1..P).fold(start, |f, _| times_linear(&f, v, -half));
            binomial *= count(P - 1 - i) / count(i + 1);
            (0..i).fold(falling, |f, _| times_linear(&f, u, half))
        });
        Shapes::jet(by_order(&functions), q)
    }

    /// x,xixixi is a Bezier curve too and lies in the convex hull of its control points: p (p - 1) (p - 2) / 8
    /// times the third differences of the P_i. The bound is the length of the longest one. Exact up to the cubic.
    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64 {
        let mut net = control_vectors::<f64, P, N>(q);
        let mut factor = 0.125;
        for level in 1..=3.min(P - 1) {
            factor *= count(P - level);
            for i in 0..P - level {
                net[i] = net[i + 1] - net[i];
            }
        }
        net.iter().take(P.saturating_sub(3)).map(|d| factor * d.norm()).fold(0.0, f64::max)
    }

    fn is_cubic(&self) -> bool {
        P <= 4
    }
}
