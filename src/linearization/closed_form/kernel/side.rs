//! The data of one beam at its closest point that the formulas use.

use super::arithmetic::{Arithmetic, Dofs};
use crate::curve::{DofDerivatives, Geometry};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// The shape functions of a curve and their first two derivatives, each for all the dofs it belongs to.
///
/// Those of order 0 are negative on the bar beam, as in delta_u u_hat.
#[derive(Clone, Copy)]
pub(super) struct Spread<'a, T, const L: usize> {
    pub(super) n: &'a Dofs<T, L>,
    pub(super) n_xi: &'a Dofs<T, L>,
    pub(super) n_xixi: &'a Dofs<T, L>,
}

/// A curve at its closest point: x, t, t,xi and t,xixi.
#[derive(Clone, Copy)]
pub(super) struct Point<V> {
    pub(super) x: V,
    pub(super) t: V,
    pub(super) t_xi: V,
    pub(super) t_xixi: V,
}

/// A curve at its closest point, with its shape functions.
pub(super) struct Side<'a, T, V, const L: usize> {
    pub(super) at: Point<V>,
    pub(super) shapes: Spread<'a, T, L>,
}

impl<V: Copy> Point<V> {
    /// Computes the point from the shape functions by order.
    #[inline(always)]
    pub(super) fn new<T: Real, const L: usize>(
        f: impl Arithmetic<T, Vector = V>,
        shapes: Shapes<'_, T>,
        q: &SVector<T, L>,
    ) -> Self {
        // The compiler then knows the length too.
        let [n, n_xi, n_xixi, n_xixixi] = shapes.map(
            #[inline(always)]
            |n| &n[..L / 3],
        );
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
        Self { x, t, t_xi, t_xixi }
    }

    /// The same point in vectors of three components.
    #[inline(always)]
    pub(super) fn geometry<T: Real>(&self, f: impl Arithmetic<T, Vector = V>) -> Geometry<T> {
        let [x, t, t_xi, t_xixi] =
            [self.x, self.t, self.t_xi, self.t_xixi].map(|v| Vector3::from(f.components(v)));
        Geometry { x, t, t_xi, t_xixi }
    }
}

/// The shape functions of a curve by order, each for all control vectors.
pub(super) type Shapes<'a, T> = [&'a [T]; 4];

/// The shape functions of a curve; nothing if it has none.
#[inline(always)]
pub(super) fn shapes<T: Real, const L: usize>(dofs: &impl DofDerivatives<T, L>) -> Option<Shapes<'_, T>> {
    let of = |order| dofs.shapes(order)?.get(..L / 3);
    Some([of(0)?, of(1)?, of(2)?, of(3)?])
}

/// The first three orders, spread over the dofs. Those of order 0 are multiplied by `sign`.
#[inline(always)]
pub(super) fn spread<T: Real, const L: usize>(
    f: impl Arithmetic<T>,
    [n, n_xi, n_xixi, _]: Shapes<'_, T>,
    sign: T,
) -> (Dofs<T, L>, Dofs<T, L>, Dofs<T, L>) {
    (f.spread(n, sign), f.spread(n_xi, T::one()), f.spread(n_xixi, T::one()))
}
