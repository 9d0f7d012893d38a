//! The two-by-two system that the variations of xi and xi_bar solve, to first and to second order alike.

use crate::closest_point::Active;
use crate::curve::Geometry;
use crate::number::Real;
use nalgebra::Vector3;

/// The matrix of the orthogonality conditions at the closest point, ready to be solved with.
///
/// At an end of a beam the parameter is held and its row and column drop out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "Eq. (50)")]
#[doc(alias = "Eq. (55)")]
pub struct Projection<T> {
    /// a = t . t + d . t,xi.
    pub a: T,
    /// b = t . t_bar.
    pub b: T,
    /// a_bar = -t_bar . t_bar + d . t_bar,xi_bar: *minus* the twin of a.
    pub a_bar: T,
    /// Which parameters are held at an end.
    pub active: Active,
}

impl<T: Real> Projection<T> {
    /// Sets the matrix up from the geometry of both curves at the closest point.
    #[inline]
    pub fn new(beam: &Geometry<T>, bar: &Geometry<T>, active: Active) -> Self {
        let (t, t_bar) = (&beam.t, &bar.t);
        let d: Vector3<T> = beam.x - bar.x;
        // Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
        let a = t.dot(t) + d.dot(&beam.t_xi);
        let b = t.dot(t_bar);
        let a_bar = -t_bar.dot(t_bar) + d.dot(&bar.t_xi);
        Self { a, b, a_bar, active }
    }

    /// D = a a_bar + b^2, negative at a strict minimum.
    #[inline]
    #[doc(alias = "Eq. (52)")]
    pub fn det(&self) -> T {
        self.a * self.a_bar + self.b * self.b
    }

    /// (delta xi, delta xi_bar) from the right-hand sides R and R_bar, of first or of second order.
    #[inline]
    #[doc(alias = "Eq. (56)")]
    #[doc(alias = "Eq. (59)")]
    pub fn solve(&self, r: T, r_bar: T) -> (T, T) {
        let Self { a, b, a_bar, active } = *self;
        let zero = T::zero();
        match (active.xi, active.xi_bar) {
            (false, false) => {
                // Eq. (52), (59): δξ = (ā R + b R̄)/D   δξ̄ = (−b R + a R̄)/D
                let det = self.det();
                ((a_bar * r + b * r_bar) / det, (-b * r + a * r_bar) / det)
            }
            // An end holds one parameter: the other row alone remains, R̄ = ā δξ̄ or R = a δξ.
            (true, false) => (zero, r_bar / a_bar),
            (false, true) => (r / a, zero),
            (true, true) => (zero, zero),
        }
    }

    /// The inverse matrix [[p, q], [r, s]], so that (delta xi, delta xi_bar) = (p R + q R_bar, r R + s R_bar).
    #[inline]
    pub fn inverse(&self) -> [[T; 2]; 2] {
        let (zero, one) = (T::zero(), T::one());
        let ((p, r), (q, s)) = (self.solve(one, zero), self.solve(zero, one));
        [[p, q], [r, s]]
    }
}
