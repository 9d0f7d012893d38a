//! The gradient and the Hessian of the distance.

use super::arithmetic::{Arithmetic, Dofs};
use super::frame::Frame;
use super::solution::{Distance, Solution};
use super::target::Target;
use crate::number::Real;

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<'_, T, V, N, M> {
    /// d.
    #[inline(always)]
    pub(super) fn write_d<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(&self, f: A, to: &mut W) {
        let Self { beam, bar, g, g_bar, .. } = self;
        let Solution { u, u_bar, distance: Distance { value, n, k }, .. } = self.solution;
        // Eq. (4), (37): δd = n·δᵤû
        *to.value() = value;
        let tile = f.tile(n);
        let (gradient, gradient_bar) = to.gradient();
        f.set(gradient, [(beam.shapes.n, tile)], []);
        f.set(gradient_bar, [(bar.shapes.n, tile)], []);
        if !W::SECOND {
            return;
        }
        // Eq. (40), (51): Δδd = δᵤû·K Δᵤû + (δᵤû·u)(n·Δᵤu,ξ) + (δᵤû·ū)(n·Δᵤū,ξ̄) + n·δᵤu,ξ Δξ − n·δᵤū,ξ̄ Δξ̄
        let (u_i, u_bar_i) = (f.components(u), f.components(u_bar));
        // n·δᵤu,ξ and n·δᵤū,ξ̄
        let by_n: Dofs<T, N> = f.dofs([(beam.shapes.n_xi, tile)], []);
        let by_n_bar: Dofs<T, M> = f.dofs([(bar.shapes.n_xi, tile)], []);
        let k = k.map(
            #[inline(always)]
            |row| f.tile(row),
        );
        // One axis after the other, because the rows do not stay in registers if the loop is unrolled.
        for i in 0..3 {
            let rows: Dofs<T, N> = f.dofs([(beam.shapes.n, k[i])], [(u_i[i], &by_n)]);
            let rows_bar: Dofs<T, M> = f.dofs([(bar.shapes.n, k[i])], [(u_bar_i[i], &by_n_bar)]);
            f.each_vector::<N>(
                #[inline(always)]
                |a| {
                    let r = 3 * a + i;
                    let (s, by_n) = (beam.shapes.n[r], by_n[r]);
                    let (row, row_bar) = to.row(a, i);
                    f.set(row, [], [(s, &rows), (by_n, g.xi)]);
                    f.set(row_bar, [], [(s, &rows_bar), (by_n, g_bar.xi)]);
                },
            );
            f.each_vector::<M>(
                #[inline(always)]
                |a| {
                    let r = 3 * a + i;
                    let (s, by_n) = (bar.shapes.n[r], -by_n_bar[r]);
                    let (row, row_bar) = to.row_bar(a, i);
                    f.set(row, [], [(s, &rows), (by_n, g.xi_bar)]);
                    f.set(row_bar, [], [(s, &rows_bar), (by_n, g_bar.xi_bar)]);
                },
            );
        }
    }
}
