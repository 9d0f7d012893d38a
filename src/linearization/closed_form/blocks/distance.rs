//! The distance, its gradient and its Hessian.

use super::arithmetic::{Arithmetic, by_axis};
use super::frame::Frame;
use super::target::Target;
use crate::number::Real;

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<T, V, N, M> {
    /// d.
    #[inline(always)]
    pub(super) fn write_d<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(&self, f: A, to: &mut W) {
        let Self { beam, bar, d, squares, u, u_bar, .. } = self;
        let distance = squares[3].sqrt();
        let curvature = T::one() / distance;
        let n = f.times(curvature, *d);
        // Eq. (4), (37): δd = n·δᵤû
        *to.value() = distance;
        let tile = f.tile(n);
        let (gradient, gradient_bar) = to.gradient();
        f.set(gradient, [(&beam.shapes[0], tile)], []);
        f.set(gradient_bar, [(&bar.shapes[0], tile)], []);
        if !W::SECOND {
            return;
        }
        // Eq. (40), (51): Δδd = δᵤû·K Δᵤû + (δᵤû·u)(n·Δᵤu,ξ) + (δᵤû·ū)(n·Δᵤū,ξ̄) + n·δᵤu,ξ Δξ − n·δᵤū,ξ̄ Δξ̄
        // with K = (I − nnᵀ + t uᵀ + t̄ ūᵀ)/d
        let (by_t, by_t_bar) = (f.times(curvature, beam.t), f.times(curvature, bar.t));
        let (by_t, by_t_bar) = (f.components(by_t), f.components(by_t_bar));
        let minus_n = f.components(f.times(-curvature, n));
        let (u_i, u_bar_i) = (f.components(*u), f.components(*u_bar));
        // n·δᵤu,ξ and n·δᵤū,ξ̄
        let by_n: [T; N] = f.dofs([(&beam.shapes[1], tile)], []);
        let by_n_bar: [T; M] = f.dofs([(&bar.shapes[1], tile)], []);
        let k = by_axis(
            #[inline(always)]
            |i| {
                let k = f.times_plus(minus_n[i], n, f.along(i, curvature));
                f.tile(f.times_plus(by_t_bar[i], *u_bar, f.times_plus(by_t[i], *u, k)))
            },
        );
        let rows: [[T; N]; 3] = by_axis(
            #[inline(always)]
            |i| f.dofs([(&beam.shapes[0], k[i])], [(u_i[i], &by_n)]),
        );
        let rows_bar: [[T; M]; 3] = by_axis(
            #[inline(always)]
            |i| f.dofs([(&bar.shapes[0], k[i])], [(u_bar_i[i], &by_n_bar)]),
        );
        for a in 0..N / 3 {
            for i in 0..3 {
                let r = 3 * a + i;
                let (s, by_n) = (beam.shapes[0][r], by_n[r]);
                let (row, row_bar) = to.row(r);
                f.set(row, [], [(s, &rows[i]), (by_n, &beam.g)]);
                f.set(row_bar, [], [(s, &rows_bar[i]), (by_n, &bar.g)]);
            }
        }
        for a in 0..M / 3 {
            for i in 0..3 {
                let r = 3 * a + i;
                let (s, by_n) = (bar.shapes[0][r], -by_n_bar[r]);
                let (row, row_bar) = to.row_bar(r);
                f.set(row, [], [(s, &rows[i]), (by_n, &beam.g_bar)]);
                f.set(row_bar, [], [(s, &rows_bar[i]), (by_n, &bar.g_bar)]);
            }
        }
    }
}
