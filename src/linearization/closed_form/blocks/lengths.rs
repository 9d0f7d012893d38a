//! The length of a tangent.
//!
//! With w = t/t, kappa = w . t,xi, and g the gradient of xi,
//!
//! ```text
//! ∇t = A₁ᵀw + κ g     H_t = κ H_ξ + g mᵀ + b gᵀ + A₁ᵀ(I − wwᵀ)A₁/t
//! b = A₂ᵀw + A₁ᵀ(t,ξ − κ w)/t     m = b + (w·t,ξξ + (t,ξ·t,ξ − κ²)/t) g
//! ```
//!
//! which is eq. (58), sorted by g. What is not a multiple of g belongs to the tangent's own beam.

use super::arithmetic::{Arithmetic, by_axis};
use super::side::Side;
use crate::number::Real;

/// The length of a tangent: all that its Hessian is made of but that of xi, along the dofs of its `own` beam and those of the `other`.
pub(super) struct Length<T, const N: usize, const M: usize> {
    pub(super) value: T,
    pub(super) kappa: T,
    /// b.
    pub(super) b: [T; N],
    /// m.
    pub(super) m: [T; N],
    pub(super) m_other: [T; M],
    /// The rows of A_1'(I - ww')A_1/t that belong to u,xi.
    pub(super) across: [[T; N]; 3],
}

impl<T: Real, const N: usize, const M: usize> Length<T, N, M> {
    /// From the tangent's own beam and the gradient of xi; writes the gradient.
    #[inline(always)]
    pub(super) fn new<V: Copy, A: Arithmetic<T, Vector = V>>(
        f: A,
        own: &Side<T, V, N>,
        (g, g_other): (&[T; N], &[T; M]),
        (gradient, gradient_other): (&mut [T], &mut [T]),
    ) -> Self {
        let Side { t, t_xi, t_xixi, shapes: [_, s_xi, s_xixi], .. } = own;
        let one = T::one();
        let value = f.dot(*t, *t).sqrt();
        let inverse = one / value;
        let w = f.times(inverse, *t);
        let kappa = f.dot(w, *t_xi);
        // (t,ξ·t,ξ − κ²)/t is the part of t,ξ across t, times t,ξ: no cancellation.
        let across = f.times(inverse, f.times_plus(-kappa, w, *t_xi));
        let in_g = f.dot(w, *t_xixi) + f.dot(across, *t_xi);
        let tile = f.tile(w);
        f.set(gradient, [(s_xi, tile)], [(kappa, g)]);
        f.set(gradient_other, [], [(kappa, g_other)]);
        let b: [T; N] = f.dofs([(s_xixi, tile), (s_xi, f.tile(across))], []);
        let m = f.dofs([], [(one, &b), (in_g, g)]);
        let m_other = f.dofs([], [(in_g, g_other)]);
        let by_w = f.components(f.times(-inverse, w));
        let rows = by_axis(
            #[inline(always)]
            |i| f.dofs([(s_xi, f.tile(f.times_plus(by_w[i], w, f.along(i, inverse))))], []),
        );
        Self { value, kappa, b, m, m_other, across: rows }
    }
}
