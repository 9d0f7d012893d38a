//! One beam at its closest point, as it enters the formulas.

use super::arithmetic::{Arithmetic, Dofs};
use crate::curve::{DofDerivatives, Geometry};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// The shape functions of a curve and their first two derivatives, each for all the dofs it belongs to.
///
/// Those of order 0 are negative on the bar beam, as they are in delta_u u_hat.
#[derive(Clone, Copy)]
pub(super) struct Spread<'a, T, const L: usize> {
    pub(super) n: &'a Dofs<T, L>,
    pub(super) n_xi: &'a Dofs<T, L>,
    pub(super) n_xixi: &'a Dofs<T, L>,
}

/// A curve at its closest point.
pub(super) struct Side<'a, T, V, const L: usize> {
    pub(super) x: V,
    pub(super) t: V,
    pub(super) t_xi: V,
    pub(super) t_xixi: V,
    pub(super) shapes: Spread<'a, T, L>,
}

impl<'a, T: Real, V: Copy, const L: usize> Side<'a, T, V, L> {
    /// From the shape functions by order.
    #[inline(always)]
    pub(super) fn new(
        f: impl Arithmetic<T, Vector = V>,
        [n, n_xi, n_xixi, n_xixixi]: [&[T]; 4],
        q: &SVector<T, L>,
        shapes: Spread<'a, T, L>,
    ) -> Self {
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
        Self { x, t, t_xi, t_xixi, shapes }
    }

    /// The same as vectors of three components.
    #[inline(always)]
    pub(super) fn geometry(&self, f: impl Arithmetic<T, Vector = V>) -> Geometry<T> {
        let [x, t, t_xi, t_xixi] =
            [self.x, self.t, self.t_xi, self.t_xixi].map(|v| Vector3::from(f.components(v)));
        Geometry { x, t, t_xi, t_xixi }
    }
}

/// The shape functions of a curve by order, each for all control vectors; nothing if it has none.
#[inline(always)]
pub(super) fn shapes<T: Real, const L: usize>(dofs: &impl DofDerivatives<T, L>) -> Option<[&[T]; 4]> {
    let shapes = [dofs.shapes(0)?, dofs.shapes(1)?, dofs.shapes(2)?, dofs.shapes(3)?];
    let [n, n_xi, n_xixi, n_xixixi] = shapes;
    (n.len().min(n_xi.len()).min(n_xixi.len()).min(n_xixixi.len()) >= L / 3).then_some(shapes)
}

/// The first three by order spread over the dofs, those of order 0 times `sign`.
#[inline(always)]
pub(super) fn spread<T: Real, const L: usize>(
    f: impl Arithmetic<T>,
    [n, n_xi, n_xixi, _]: [&[T]; 4],
    sign: T,
) -> (Dofs<T, L>, Dofs<T, L>, Dofs<T, L>) {
    (f.spread(n, sign), f.spread(n_xi, T::one()), f.spread(n_xixi, T::one()))
}
