//! The common data of the quantities: a pair at its closest point, and the gradients of its parameters.

use super::arithmetic::{Arithmetic, Dofs};
use super::side::{Point, Side, Spread};
use super::solution::Solution;
use crate::linearization::closed_form::formulation::Squares;
use crate::number::Real;

/// A pair at its closest point.
///
/// Vectors over the dofs are references, because moving such a vector costs as much as computing it.
pub(super) struct Frame<'a, T, V, const N: usize, const M: usize> {
    pub(super) beam: &'a Side<'a, T, V, N>,
    pub(super) bar: &'a Side<'a, T, V, M>,
    /// The gradients along the dofs of the beam, and of the bar beam.
    pub(super) g: Gradients<'a, T, N>,
    pub(super) g_bar: Gradients<'a, T, M>,
    pub(super) products: Products<T, V>,
    pub(super) solution: Solution<T, V>,
}

/// The gradients of the parameters along the dofs of one beam.
#[derive(Clone, Copy)]
pub(super) struct Gradients<'a, T, const L: usize> {
    pub(super) xi: &'a Dofs<T, L>,
    pub(super) xi_bar: &'a Dofs<T, L>,
}

/// d, and the products of d and the tangents that the formulas share.
#[derive(Clone, Copy)]
pub(super) struct Products<T, V> {
    /// The vector d.
    pub(super) d: V,
    /// t·t, t̄·t̄ and t·t̄.
    pub(super) tangents: [T; 3],
    /// c = t × t̄ with c·c and c·d: along the normal of both tangents.
    pub(super) c: V,
    pub(super) c2: T,
    pub(super) c_d: T,
}

impl<T: Real, V: Copy> Products<T, V> {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic<T, Vector = V>>(f: A, (beam, bar): (&Point<V>, &Point<V>)) -> Self {
        let d = f.times_plus(-T::one(), bar.x, beam.x);
        let tangents = [f.dot(beam.t, beam.t), f.dot(bar.t, bar.t), f.dot(beam.t, bar.t)];
        let c = f.cross(beam.t, bar.t);
        Self { d, tangents, c, c2: f.dot(c, c), c_d: f.dot(c, d) }
    }

    /// The products that decide between the formulations.
    #[inline(always)]
    pub(super) fn squares<A: Arithmetic<T, Vector = V>>(
        &self,
        f: A,
        (beam, bar): (&Point<V>, &Point<V>),
    ) -> Squares<T> {
        let [t2, t_bar2, _] = self.tangents;
        let t_xi2 = [f.dot(beam.t_xi, beam.t_xi), f.dot(bar.t_xi, bar.t_xi)];
        Squares { t2: [t2, t_bar2], t_xi2, c2: self.c2, c_d: self.c_d }
    }
}

/// The gradients of xi and xi_bar along the dofs of one beam. The given multiples of d belong to its u,xi.
#[inline(always)]
pub(super) fn along<T: Real, A: Arithmetic<T>, const L: usize>(
    f: A,
    side: &Side<'_, T, A::Vector, L>,
    (u, u_bar): (A::Vector, A::Vector),
    ([by_d, bar_by_d], d): ([T; 2], A::Vector),
) -> (Dofs<T, L>, Dofs<T, L>) {
    let Spread { n, n_xi, .. } = side.shapes;
    let minus_u_bar = f.times(-T::one(), u_bar);
    let xi = [(n, f.tile(u)), (n_xi, f.tile(f.times(by_d, d)))];
    let xi_bar = [(n, f.tile(minus_u_bar)), (n_xi, f.tile(f.times(bar_by_d, d)))];
    (f.dofs(xi, []), f.dofs(xi_bar, []))
}
