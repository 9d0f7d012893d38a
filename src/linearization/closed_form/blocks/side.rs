//! One beam at its closest point, as it enters the formulas.

use super::arithmetic::Arithmetic;
use crate::curve::DofDerivatives;
use crate::number::Real;
use nalgebra::SVector;

/// A curve at its closest point.
pub(super) struct Side<T, V, const L: usize> {
    pub(super) x: V,
    pub(super) t: V,
    pub(super) t_xi: V,
    pub(super) t_xixi: V,
    /// The shape functions and their first two derivatives, by order, each for all the dofs it belongs to.
    ///
    /// Those of order 0 are negative on the bar beam, as they are in delta_u u_hat.
    pub(super) shapes: [[T; L]; 3],
    /// The gradients of xi and xi_bar.
    pub(super) g: [T; L],
    pub(super) g_bar: [T; L],
}

impl<T: Real, V: Copy, const L: usize> Side<T, V, L> {
    /// Without the gradients; nothing if the curve has no shape functions.
    #[inline(always)]
    pub(super) fn new(
        f: impl Arithmetic<T, Vector = V>,
        dofs: &impl DofDerivatives<T, L>,
        q: &SVector<T, L>,
        sign: T,
    ) -> Option<Self> {
        let [n, n_xi, n_xixi, n_xixixi] =
            [dofs.shapes(0)?, dofs.shapes(1)?, dofs.shapes(2)?, dofs.shapes(3)?];
        if n.len().min(n_xi.len()).min(n_xixi.len()).min(n_xixixi.len()) < L / 3 {
            return None;
        }
        let [q] = &q.data.0;
        let first = f.control_vector(q, 0);
        let mut x = f.times(n[0], first);
        let mut t = f.times(n_xi[0], first);
        let mut t_xi = f.times(n_xixi[0], first);
        let mut t_xixi = f.times(n_xixixi[0], first);
        for a in 1..L / 3 {
            let point = f.control_vector(q, a);
            x = f.times_plus(n[a], point, x);
            t = f.times_plus(n_xi[a], point, t);
            t_xi = f.times_plus(n_xixi[a], point, t_xi);
            t_xixi = f.times_plus(n_xixixi[a], point, t_xixi);
        }
        let shapes = [f.spread(n, sign), f.spread(n_xi, T::one()), f.spread(n_xixi, T::one())];
        let nil = [T::zero(); L];
        Some(Self { x, t, t_xi, t_xixi, shapes, g: nil, g_bar: nil })
    }

    /// A vector times u_hat and a vector times a first derivative, along the dofs, and a multiple of `rest`.
    #[inline(always)]
    pub(super) fn along(
        &self,
        f: impl Arithmetic<T, Vector = V>,
        [hat, first]: [V; 2],
        (factor, rest): (T, &[T; L]),
    ) -> [T; L] {
        let [s, s_xi, _] = &self.shapes;
        f.dofs([(s, f.tile(hat)), (s_xi, f.tile(first))], [(factor, rest)])
    }
}
