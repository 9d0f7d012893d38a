//! The definitions (4)-(15), evaluated over any scalar from positions alone.

use crate::curve::Curve;
use crate::linearization::Quantities;
use crate::number::{Differentiable, Extends, Real};
use crate::pair::Contact;
use nalgebra::{SVector, Vector3};

/// A curve with perturbed dofs, which is evaluated at parameters of the scalar `S`.
pub trait PositionAt<S> {
    /// The point at xi.
    fn position_at(&self, xi: S) -> Vector3<S>;
}

/// A curve with dofs in the scalar `T`; it has positions at every scalar that extends `T`.
#[derive(Clone, Copy, Debug)]
pub struct Perturbed<'a, C, T, const N: usize> {
    /// The curve.
    pub curve: &'a C,
    /// Its dofs, with their perturbations.
    pub q: SVector<T, N>,
}

impl<C: Curve<N>, T: Real, S: Extends<T>, const N: usize> PositionAt<S> for Perturbed<'_, C, T, N> {
    fn position_at(&self, xi: S) -> Vector3<S> {
        self.curve.position(&self.q.map(S::constant), xi)
    }
}

/// Position and tangent: the tangent is the eps part of the position at xi + eps.
pub(super) fn tangent<T: Differentiable>(
    beam: &(impl PositionAt<T::Dual> + ?Sized),
    xi: T,
) -> (Vector3<T>, Vector3<T>) {
    // Eq. (3), (6): x_C = x(ξ_C)   t = x_C,ξ. With dual numbers for ξ_C and the dofs their parts are total variations,
    // Eq. (23), (25) and (29).
    let point = beam.position_at(xi.dual(1.0)).map(T::parts);
    (point.map(|(re, _)| re), point.map(|(_, eps)| eps))
}

/// All quantities at the given parameters, from positions alone.
///
/// At the lifted closest point, this is exactly the chain of definitions of the paper.
#[doc(alias = "Eq. (15)")]
pub fn evaluate<T: Differentiable>(
    beam: &(impl PositionAt<T::Dual> + ?Sized),
    bar: &(impl PositionAt<T::Dual> + ?Sized),
    (xi, xi_bar): (T, T),
    contact: &Contact,
) -> Quantities<T> {
    quantities(tangent(beam, xi), tangent(bar, xi_bar), (xi, xi_bar), contact)
}

/// The same quantities from points and tangents.
pub(super) fn quantities<T: Real>(
    (x, t_vector): (Vector3<T>, Vector3<T>),
    (x_bar, t_bar_vector): (Vector3<T>, Vector3<T>),
    (xi, xi_bar): (T, T),
    contact: &Contact,
) -> Quantities<T> {
    // Eq. (7), (9): v = ‖v‖, and in the parts of the root Eq. (33), (34)
    let norm = |v: &Vector3<T>| v.dot(v).sqrt();
    // Eq. (8): d = x_C − x̄_C   t = x_C,ξ   t̄ = x̄_C,ξ̄
    let d_vector = x - x_bar;
    // Eq. (9)
    let (d, t, t_bar) = (norm(&d_vector), norm(&t_vector), norm(&t_bar_vector));
    Quantities {
        x,
        x_bar,
        d_vector,
        t_vector,
        t_bar_vector,
        d,
        t,
        t_bar,
        xi,
        xi_bar,
        // Eq. (15)
        g_n: d - (T::from(contact.radius) + T::from(contact.radius_bar)),
        // Eq. (14), from (12) and (13): the slip is small, and goes along the tangent
        g_t: t * (xi - T::from(contact.xi_0)),
        g_t_bar: t_bar * (xi_bar - T::from(contact.xi_bar_0)),
    }
}
