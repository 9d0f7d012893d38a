//! The common data of the quantities: a pair at its closest point, and the gradients of its parameters.

use super::arithmetic::{Arithmetic, Dofs};
use super::products::Products;
use super::side::{Side, Spread};
use super::solution::Solution;
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
