//! The distance, its gradient and its Hessian.

use super::arithmetic::{Arithmetic, Dofs, by_axis};
use super::frame::{Frame, points};
use super::target::Target;
use crate::linearization::closed_form::form::{unit_normal, weights};
use crate::linearization::closed_form::{Projection, Sound};
use crate::number::Real;
use nalgebra::Vector3;

/// The distance, its normal n and the rows of K, its Hessian in the positions.
struct Distance<T, V> {
    value: T,
    n: V,
    k: [V; 3],
}

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<'_, T, V, N, M> {
    /// d.
    #[inline(always)]
    pub(super) fn write_d<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(&self, f: A, to: &mut W) {
        let Self { beam, bar, g, g_bar, u, u_bar, .. } = self;
        let Distance { value, n, k } =
            if self.chosen.form.sign().is_some() { self.along_normal(f) } else { self.by_length(f) };
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
        let (u_i, u_bar_i) = (f.components(*u), f.components(*u_bar));
        // n·δᵤu,ξ and n·δᵤū,ξ̄
        let by_n: Dofs<T, N> = f.dofs([(beam.shapes.n_xi, tile)], []);
        let by_n_bar: Dofs<T, M> = f.dofs([(bar.shapes.n_xi, tile)], []);
        let k = k.map(
            #[inline(always)]
            |row| f.tile(row),
        );
        let (mut rows, mut rows_bar) = ([Dofs::<T, N>::zeros(); 3], [Dofs::<T, M>::zeros(); 3]);
        for i in 0..3 {
            f.set(&mut rows[i], [(beam.shapes.n, k[i])], [(u_i[i], &by_n)]);
            f.set(&mut rows_bar[i], [(bar.shapes.n, k[i])], [(u_bar_i[i], &by_n_bar)]);
        }
        f.each::<N>(
            #[inline(always)]
            |a, i| {
                let r = 3 * a + i;
                let (s, by_n) = (beam.shapes.n[r], by_n[r]);
                let (row, row_bar) = to.row(a, i);
                f.set(row, [], [(s, &rows[i]), (by_n, g.xi)]);
                f.set(row_bar, [], [(s, &rows_bar[i]), (by_n, g_bar.xi)]);
            },
        );
        f.each::<M>(
            #[inline(always)]
            |a, i| {
                let r = 3 * a + i;
                let (s, by_n) = (bar.shapes.n[r], -by_n_bar[r]);
                let (row, row_bar) = to.row_bar(a, i);
                f.set(row, [], [(s, &rows[i]), (by_n, g.xi_bar)]);
                f.set(row_bar, [], [(s, &rows_bar[i]), (by_n, g_bar.xi_bar)]);
            },
        );
    }

    /// n = d/d   K = (I − nnᵀ + t uᵀ + t̄ ūᵀ)/d
    #[inline(always)]
    fn by_length<A: Arithmetic<T, Vector = V>>(&self, f: A) -> Distance<T, V> {
        let Self { beam, bar, d, squares, u, u_bar, .. } = self;
        let value = squares[3].sqrt();
        let curvature = T::one() / value;
        let n = f.times(curvature, *d);
        let (by_t, by_t_bar) = (f.times(curvature, beam.t), f.times(curvature, bar.t));
        let (by_t, by_t_bar) = (f.components(by_t), f.components(by_t_bar));
        let minus_n = f.components(f.times(-curvature, n));
        let (x, y, z) = by_axis(
            #[inline(always)]
            |i| {
                let k = f.times_plus(minus_n[i], n, f.along(i, curvature));
                f.times_plus(by_t_bar[i], *u_bar, f.times_plus(by_t[i], *u, k))
            },
        );
        Distance { value, n, k: [x, y, z] }
    }

    /// n = ± t × t̄/|t × t̄|   K = T W Tᵀ with T = [t, −t̄]
    #[inline]
    fn along_normal<A: Arithmetic<T, Vector = V>>(&self, f: A) -> Distance<T, V> {
        let points = points(f, self.beam, self.bar);
        let n = unit_normal(&(points.cross() * self.chosen.sign));
        let det = Projection::with(&Sound, &points, self.chosen.form).det();
        let [w_11, w_12, w_22] = weights(&points, &n, -det);
        let (t, t_bar) = (points.beam.t, points.bar.t);
        let (by_t, by_t_bar) = (t * w_11 - t_bar * w_12, t_bar * w_22 - t * w_12);
        let vector = |v: Vector3<T>| f.vector(v.into());
        let (x, y, z) = by_axis(|i| vector(by_t * t[i] + by_t_bar * t_bar[i]));
        Distance { value: n.dot(&points.d), n: vector(n), k: [x, y, z] }
    }
}
