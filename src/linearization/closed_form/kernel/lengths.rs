//! The length of a tangent: eq. (58), sorted by g, in section 7 of the [derivation](super::super::derivation).
//!
//! Terms that are not multiples of g belong to the beam of the tangent.

use super::arithmetic::{Arithmetic, Dofs, by_axis};
use super::side::{Point, Side, Spread};
use super::target::Target;
use crate::number::Real;

/// Writes the length of the tangent of `own` from the gradient and the written Hessian of its parameter.
#[inline(always)]
pub(super) fn write_length<T: Real, A: Arithmetic<T>, W: Target<T, N, M>, const N: usize, const M: usize>(
    f: A,
    own: &Side<'_, T, A::Vector, N>,
    (g, g_other): (&Dofs<T, N>, &Dofs<T, M>),
    of_parameter: &mut W,
    to: &mut W,
) {
    let Point { t, t_xi, t_xixi, .. } = own.at;
    let Spread { n_xi: s_xi, n_xixi: s_xixi, .. } = own.shapes;
    let one = T::one();
    let value = f.dot(t, t).sqrt();
    let inverse = one / value;
    let w = f.times(inverse, t);
    let kappa = f.dot(w, t_xi);
    let tile = f.tile(w);
    *to.value() = value;
    let (gradient, gradient_other) = to.gradient();
    f.set(gradient, [(s_xi, tile)], [(kappa, g)]);
    f.set(gradient_other, [], [(kappa, g_other)]);
    if !W::SECOND {
        return;
    }
    // (t,ξ·t,ξ − κ²)/t is the part of t,ξ normal to t, times t,ξ. This product has no cancellation.
    let across = f.times(inverse, f.times_plus(-kappa, w, t_xi));
    let in_g = f.dot(w, t_xixi) + f.dot(across, t_xi);
    let b: Dofs<T, N> = f.dofs([(s_xixi, tile), (s_xi, f.tile(across))], []);
    let m: Dofs<T, N> = f.dofs([], [(one, &b), (in_g, g)]);
    let m_other: Dofs<T, M> = f.dofs([], [(in_g, g_other)]);
    // The rows of A₁ᵀ(I − wwᵀ)A₁/t that belong to u,ξ
    let by_w = f.components(f.times(-inverse, w));
    let (x, y, z): (Dofs<T, N>, Dofs<T, N>, Dofs<T, N>) = by_axis(
        #[inline(always)]
        |i| f.dofs([(s_xi, f.tile(f.times_plus(by_w[i], w, f.along(i, inverse))))], []),
    );
    f.each_vector::<N>(
        #[inline(always)]
        |a| {
            for (i, across) in [&x, &y, &z].into_iter().enumerate() {
                let r = 3 * a + i;
                let (from, from_other) = of_parameter.row(a, i);
                let (row, row_other) = to.row(a, i);
                f.set_from(row, [(kappa, from)], [], [(g[r], &m), (b[r], g), (s_xi[r], across)]);
                f.set_from(row_other, [(kappa, from_other)], [], [(m[r], g_other)]);
            }
        },
    );
    f.each_vector::<M>(
        #[inline(always)]
        |a| {
            for i in 0..3 {
                let r = 3 * a + i;
                let (from, from_other) = of_parameter.row_bar(a, i);
                let (row, row_other) = to.row_bar(a, i);
                f.set_from(row, [(kappa, from)], [], [(g_other[r], &m)]);
                f.set_from(row_other, [(kappa, from_other)], [], [(g_other[r], &m_other)]);
            }
        },
    );
}
