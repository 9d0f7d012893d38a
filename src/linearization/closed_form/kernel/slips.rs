//! The slip along a beam, g_T = t (xi - xi_0): eqs. (20) and (21).

use super::arithmetic::{Arithmetic, Dofs};
use super::target::Target;
use crate::number::Real;

/// Writes the slip for a difference in the parameter, from its gradients, and from the written parameter and length.
#[inline(always)]
pub(super) fn write_slip<T: Real, A: Arithmetic<T>, W: Target<T, N, M>, const N: usize, const M: usize>(
    f: A,
    slip: T,
    (g, g_other): (&Dofs<T, N>, &Dofs<T, M>),
    (of_parameter, of_length): (&mut W, &mut W),
    to: &mut W,
) {
    let length = *of_length.value();
    *to.value() = length * slip;
    let (mut of_t, mut of_t_other) = (Dofs::<T, N>::zeros(), Dofs::<T, M>::zeros());
    let (gradient, gradient_other) = of_length.gradient();
    of_t.copy_from_slice(gradient);
    of_t_other.copy_from_slice(gradient_other);
    let (gradient, gradient_other) = to.gradient();
    f.set(gradient, [], [(slip, &of_t), (length, g)]);
    f.set(gradient_other, [], [(slip, &of_t_other), (length, g_other)]);
    if !W::SECOND {
        return;
    }
    f.each_vector::<N>(
        #[inline(always)]
        |a| {
            for i in 0..3 {
                let r = 3 * a + i;
                let (xi, xi_other) = of_parameter.row(a, i);
                let (t, t_other) = of_length.row(a, i);
                let (row, row_other) = to.row(a, i);
                let (by_t, by_g) = (of_t[r], g[r]);
                f.set_from(row, [(slip, t), (length, xi)], [], [(by_t, g), (by_g, &of_t)]);
                let from = [(slip, &*t_other), (length, &*xi_other)];
                f.set_from(row_other, from, [], [(by_t, g_other), (by_g, &of_t_other)]);
            }
        },
    );
    f.each_vector::<M>(
        #[inline(always)]
        |a| {
            for i in 0..3 {
                let r = 3 * a + i;
                let (xi, xi_other) = of_parameter.row_bar(a, i);
                let (t, t_other) = of_length.row_bar(a, i);
                let (row, row_other) = to.row_bar(a, i);
                let (by_t, by_g) = (of_t_other[r], g_other[r]);
                f.set_from(row, [(slip, t), (length, xi)], [], [(by_t, g), (by_g, &of_t)]);
                let from = [(slip, &*t_other), (length, &*xi_other)];
                f.set_from(row_other, from, [], [(by_t, g_other), (by_g, &of_t_other)]);
            }
        },
    );
}
