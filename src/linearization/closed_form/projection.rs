//! The two-by-two system for the variations of xi and xi_bar, of first and of second order.

use super::{Formulation, Points};
use crate::closest_point::Held;
use crate::curve::Geometry;
use crate::number::{Formula, Real, named};
use nalgebra::Vector3;

/// The matrix of the orthogonality conditions at the closest point.
///
/// At an end of a beam the parameter is held, and its row and column are removed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection<T> {
    /// a = t . t + d . t,xi.
    pub a: T,
    /// b = t . t_bar.
    pub b: T,
    /// a_bar = -t_bar . t_bar + d . t_bar,xi_bar: *minus* the counterpart of a.
    pub a_bar: T,
    /// Which parameters are held at an end.
    pub held: Held,
    /// The replacement of products that cancel, in a [`Formulation`] with cross products.
    pub cross_products: Option<CrossProducts<T>>,
}

/// The results of the cross products of the tangents, which replace products that cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrossProducts<T> {
    /// D.
    pub det: T,
    /// u and u_bar, the factors of w in the solution for R = -t.w - e, R_bar = -t_bar.w - e_bar.
    pub u: [Vector3<T>; 2],
}

impl<T: Real> CrossProducts<T> {
    #[inline]
    fn new(points: &Points<T>) -> Self {
        let Points { beam: x, bar: y, d } = points;
        let c = points.cross();
        let (e, e_bar) = (d.dot(&x.t_xi), d.dot(&y.t_xi));
        // D = −c·c + (d·t,ξ) ā + (d·t̄,ξ̄) t·t with c = t × t̄
        let det = -named(Formula::Det, "c.c", c.dot(&c))
            + named(Formula::Det, "d.t,xi a_bar", e * (e_bar - y.t.dot(&y.t)))
            + named(Formula::Det, "d.t_bar,xi t.t", e_bar * x.t.dot(&x.t));
        // D u = t̄ × c − (d·t̄,ξ̄) t   D ū = t × c − (d·t,ξ) t̄
        let u =
            named(Formula::U, "t_bar x c", y.t.cross(&c)) - named(Formula::U, "d.t_bar,xi t", x.t * e_bar);
        let u_bar =
            named(Formula::UBar, "t x c", x.t.cross(&c)) - named(Formula::UBar, "d.t,xi t_bar", y.t * e);
        Self { det, u: [u / det, u_bar / det] }
    }
}

impl<T: Real> Projection<T> {
    /// Sets the matrix up from the geometry of both curves at the closest point.
    #[inline]
    pub fn new(beam: &Geometry<T>, bar: &Geometry<T>, held: Held) -> Self {
        Self::in_formulation(&Points::new(beam, bar), Formulation::paper(held))
    }

    /// The same in the given formulation.
    #[inline]
    #[doc(alias = "Eq. (50)")]
    #[doc(alias = "Eq. (55)")]
    pub fn in_formulation(points: &Points<T>, form: Formulation) -> Self {
        let Points { beam: Geometry { t, t_xi, .. }, bar: y, d } = points;
        let (t_bar, t_bar_xi) = (&y.t, &y.t_xi);
        // Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
        let a = named(Formula::A, "t.t", t.dot(t)) + named(Formula::A, "d.t,xi", d.dot(t_xi));
        let b = named(Formula::B, "t.t_bar", t.dot(t_bar));
        let a_bar = -named(Formula::ABar, "t_bar.t_bar", t_bar.dot(t_bar))
            + named(Formula::ABar, "d.t_bar,xi", d.dot(t_bar_xi));
        let cross_products = form.uses_cross_products().then(|| CrossProducts::new(points));
        Self { a, b, a_bar, held: form.held, cross_products }
    }

    /// D = a a_bar + b^2, negative at a nondegenerate minimum (positive definite Hessian of d^2/2).
    #[inline]
    #[doc(alias = "Eq. (52)")]
    pub fn det(&self) -> T {
        self.cross_products
            .map_or_else(|| self.a * self.a_bar + self.b * self.b, |cross_products| cross_products.det)
    }

    /// (delta xi, delta xi_bar) from the right-hand sides R and R_bar, of first or of second order.
    #[inline]
    #[doc(alias = "Eq. (56)")]
    #[doc(alias = "Eq. (59)")]
    pub fn solve(&self, r: T, r_bar: T) -> (T, T) {
        let Self { a, b, a_bar, held, cross_products } = *self;
        let zero = T::zero();
        match (held.xi, held.xi_bar) {
            (false, false) => {
                // Eq. (52): D = a ā + b²
                let det = cross_products.map_or_else(
                    || named(Formula::Det, "a a_bar", a * a_bar) + named(Formula::Det, "b b", b * b),
                    |cross_products| cross_products.det,
                );
                // Eq. (52), (59): δξ = (ā R + b R̄)/D   δξ̄ = (−b R + a R̄)/D
                let xi = named(Formula::Xi, "a_bar R", a_bar * r) + named(Formula::Xi, "b R_bar", b * r_bar);
                let xi_bar =
                    -named(Formula::XiBar, "b R", b * r) + named(Formula::XiBar, "a R_bar", a * r_bar);
                (xi / det, xi_bar / det)
            }
            // One parameter is held at an end, so only the other row remains: R̄ = ā δξ̄ or R = a δξ.
            (true, false) => (zero, named(Formula::XiBarAlone, "R_bar / a_bar", r_bar / a_bar)),
            (false, true) => (named(Formula::XiAlone, "R / a", r / a), zero),
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
