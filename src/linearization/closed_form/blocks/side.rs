//! One beam at its closest point, as it enters the formulas.

use super::arithmetic::{Arithmetic, Dofs};
use crate::curve::{DofDerivatives, Geometry};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// A curve at its closest point.
pub(super) struct Side<T, V, const L: usize> {
    pub(super) x: V,
    pub(super) t: V,
    pub(super) t_xi: V,
    pub(super) t_xixi: V,
    /// The shape functions and their first two derivatives, by order, each for all the dofs it belongs to.
    ///
    /// Those of order 0 are negative on the bar beam, as they are in delta_u u_hat.
    pub(super) shapes: [Dofs<T, L>; 3],
}

impl<T: Real, V: Copy, const L: usize> Side<T, V, L> {
    /// Nothing if the curve has no shape functions.
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
        Some(Self { x, t, t_xi, t_xixi, shapes })
    }

    /// The same as vectors of three components.
    #[inline(always)]
    pub(super) fn geometry(&self, f: impl Arithmetic<T, Vector = V>) -> Geometry<T> {
        let [x, t, t_xi, t_xixi] =
            [self.x, self.t, self.t_xi, self.t_xixi].map(|v| Vector3::from(f.components(v)));
        Geometry { x, t, t_xi, t_xixi }
    }
}
