//! The distance, its gradient and its Hessian.

use super::arithmetic::{Arithmetic, Dofs, by_axis};
use super::frame::{Frame, Products};
use super::target::Target;
use crate::number::Real;

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
        // One axis after the other: unrolled, the rows do not stay in registers.
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

    /// n = d/d   K = (I − nnᵀ + t uᵀ + t̄ ūᵀ)/d
    #[inline(always)]
    fn by_length<A: Arithmetic<T, Vector = V>>(&self, f: A) -> Distance<T, V> {
        let Self { beam, bar, products: Products { d, .. }, u, u_bar, .. } = self;
        let value = f.dot(*d, *d).sqrt();
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

    /// n = ± c/|c| with c = t × t̄   K = T W Tᵀ with T = [t, −t̄]
    ///
    /// This K is that of [`Self::by_length`] without its quotient by d: as H = TᵀT + d E, it has W = (TᵀT)⁻¹ E H⁻¹ with
    /// (TᵀT)⁻¹ = [[t̄·t̄, b], [b, t·t]]/c·c, E = diag(n·t,ξ, −n·t̄,ξ̄) and H⁻¹ = [[p, −q], [−q, −q̄]].
    #[inline(always)]
    fn along_normal<A: Arithmetic<T, Vector = V>>(&self, f: A) -> Distance<T, V> {
        let Self { beam, bar, products, over_c2, chosen, inverse: [p, q, q_bar], .. } = self;
        let Products { tangents: [t2, t_bar2, b], c, c2, c_d, .. } = *products;
        let scale = chosen.sign * c2.sqrt() * *over_c2;
        let n = f.times(scale, c);
        let by_c2 = scale * *over_c2;
        let (e, e_bar) = (by_c2 * f.dot(c, beam.t_xi), -by_c2 * f.dot(c, bar.t_xi));
        let (q_e, b_e_bar) = (*q * e, b * e_bar);
        let w_11 = f.mul_add(*p * t_bar2, e, -(*q * b_e_bar));
        let minus_w_12 = f.mul_add(t_bar2, q_e, *q_bar * b_e_bar);
        let w_22 = -f.mul_add(b, q_e, *q_bar * t2 * e_bar);
        let by_t = f.components(f.combined([(w_11, beam.t), (minus_w_12, bar.t)]));
        let by_t_bar = f.components(f.combined([(w_22, bar.t), (minus_w_12, beam.t)]));
        let (x, y, z) = by_axis(
            #[inline(always)]
            |i| f.combined([(by_t[i], beam.t), (by_t_bar[i], bar.t)]),
        );
        Distance { value: scale * c_d, n, k: [x, y, z] }
    }
}
