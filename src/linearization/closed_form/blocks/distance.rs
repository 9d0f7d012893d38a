//! The distance, its gradient and its Hessian.

use super::arithmetic::{Arithmetic, by_axis};
use super::frame::{Frame, points};
use super::target::Target;
use crate::linearization::closed_form::form;
use crate::number::Real;

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<T, V, N, M> {
    /// d.
    #[inline(always)]
    pub(super) fn write_d<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(&self, f: A, to: &mut W) {
        let Self { beam, bar, u, u_bar, .. } = self;
        let Metric { distance, n, curvature, k_t, k_t_bar } = self.metric(f);
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
        let (minus_n, t, t_bar) =
            (f.components(f.times(-curvature, n)), f.components(beam.t), f.components(bar.t));
        let (u_i, u_bar_i) = (f.components(*u), f.components(*u_bar));
        // n·δᵤu,ξ and n·δᵤū,ξ̄
        let by_n: [T; N] = f.dofs([(&beam.shapes[1], tile)], []);
        let by_n_bar: [T; M] = f.dofs([(&bar.shapes[1], tile)], []);
        let k = by_axis(
            #[inline(always)]
            |i| {
                let k = f.times_plus(minus_n[i], n, f.along(i, curvature));
                f.tile(f.times_plus(t_bar[i], k_t_bar, f.times_plus(t[i], k_t, k)))
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
    /// The distance and what does not depend on the dofs in its variations.
    #[inline(always)]
    fn metric<A: Arithmetic<T, Vector = V>>(&self, f: A) -> Metric<T, V> {
        let Self { beam, bar, d, u, u_bar, .. } = self;
        if let Some(sign) = self.form.sign() {
            // K = T W Tᵀ with T = [t, −t̄]
            let points = points(f, beam, bar, *d);
            let c = points.beam.t.cross(&points.bar.t) * <T as From<f64>>::from(sign);
            let n = form::unit_normal(&c);
            // det H = 1/(p q̄ + q²) up to its sign
            let [p, q, q_bar] = self.inverse;
            let [w, w_mixed, w_bar] = form::weights(&points, &n, -T::one() / (p * q_bar + q * q));
            return Metric {
                distance: n.dot(&points.d),
                n: f.vector(n.data.0[0]),
                curvature: T::zero(),
                k_t: f.combined([(w, beam.t), (-w_mixed, bar.t)]),
                k_t_bar: f.combined([(w_bar, bar.t), (-w_mixed, beam.t)]),
            };
        }
        // K = (I − nnᵀ + t uᵀ + t̄ ūᵀ)/d
        let distance = self.d2.sqrt();
        let curvature = T::one() / distance;
        let n = f.times(curvature, *d);
        Metric { distance, n, curvature, k_t: f.times(curvature, *u), k_t_bar: f.times(curvature, *u_bar) }
    }
}

/// The distance, n, and K = `curvature` (I − nnᵀ) + t `k_t`ᵀ + t̄ `k_t_bar`ᵀ.
struct Metric<T, V> {
    distance: T,
    n: V,
    curvature: T,
    k_t: V,
    k_t_bar: V,
}
