//! The sums that the matrices are made of: products of Jacobians, the length of a vector, a slip.

use super::terms::{Label, Terms};
use crate::curve::{DofDerivatives, Geometry};
use crate::linearization::Expansion;
use crate::number::Real;
use crate::pair::DofVector;
use nalgebra::{SMatrix, Vector3};

/// Adds factor A_kᵀB_l to a block.
#[inline]
pub(super) fn add_product<
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    const N: usize,
    const M: usize,
>(
    block: &mut SMatrix<T, N, M>,
    factor: T,
    (a, k): (&U, usize),
    (b, l): (&V, usize),
) {
    if let (Some(shapes), Some(shapes_bar)) = (a.shapes(k), b.shapes(l)) {
        // Coordinates do not mix: A_k = [N₁I, N₂I, ..], so that A_kᵀB_l has a multiple of I for each pair of functions.
        for (j, &shape_bar) in shapes_bar.iter().enumerate() {
            for (i, &shape) in shapes.iter().enumerate() {
                let product = shape * (shape_bar * factor);
                for c in 0..3 {
                    block[(3 * i + c, 3 * j + c)] += product;
                }
            }
        }
    } else {
        // The column of B_l takes the place of w in the gradient of w·x,ξ..ξ.
        let columns = b.jacobian(l) * factor;
        for j in 0..M {
            let mut column = block.column_mut(j);
            column += a.gradient(k, &columns.column(j).into_owned());
        }
    }
}

/// The length of a tangent, but for A₁ᵀA₁/t + K_t(w) in its Hessian, written over `to`; returns 1/t and w = t/t.
#[inline]
pub(super) fn write_length<T: Real, const N: usize, const M: usize>(
    (terms, bar): (&impl Terms<T, Geometry<T>>, bool),
    of: &Geometry<T>,
    a_transposed: impl Fn(usize, &Vector3<T>) -> DofVector<T, N, M>,
    xi: &Expansion<T, N, M>,
    to: &mut Expansion<T, N, M>,
) -> (T, Vector3<T>) {
    let term = |name, term: &dyn Fn(&Geometry<T>) -> T| terms.term(Label { name, bar }, of, term);
    let Expansion { value, gradient, hessian } = to;
    *value = of.t.dot(&of.t).sqrt();
    let (inverse, half, g) = (T::one() / *value, T::from(0.5), &xi.gradient);
    let w = of.t * inverse;
    // ∇t = J_tᵀw
    let first = term("grad t: w.t,xi g", &|o| w.dot(&o.t_xi));
    *gradient = a_transposed(1, &terms.term(Label { name: "grad t: A1'w", bar }, of, |_| w)).plus(first, g);
    // H_t = (w·t,ξ) H_ξ + S_t(w) + (J_tᵀJ_t − ∇t∇tᵀ)/t with J_tᵀJ_t = A₁ᵀA₁ + sym(g, A₁ᵀt,ξ) + (t,ξ·t,ξ) ggᵀ
    let squares = half
        * (term("H_t: w.t,xixi gg'", &|o| w.dot(&o.t_xixi))
            + term("H_t: t,xi.t,xi gg'", &|o| o.t_xi.dot(&o.t_xi)) * inverse);
    let with_g = a_transposed(2, &terms.term(Label { name: "H_t: A2'w g'", bar }, of, |_| w))
        .plus(inverse, &a_transposed(1, &terms.term(Label { name: "H_t: A1't,xi g'", bar }, of, |o| o.t_xi)))
        .plus(squares, g);
    let with_gradient = gradient.times(-term("H_t: grad t grad t'", &|_| half * inverse));
    let first = term("H_t: w.t,xi H_xi", &|o| w.dot(&o.t_xi));
    hessian.set_sum([(first, &xi.hessian)], [(g, &with_g), (gradient, &with_gradient)]);
    (inverse, w)
}

/// g_T = t (xi - xi_0), written over `to`.
#[inline]
pub(super) fn write_slip<T: Real, const N: usize, const M: usize>(
    (terms, bar): (&impl Terms<T, ()>, bool),
    t: &Expansion<T, N, M>,
    xi: &Expansion<T, N, M>,
    xi_0: f64,
    to: &mut Expansion<T, N, M>,
) {
    let slip = xi.value - T::from(xi_0);
    let term = |name, value: T| terms.term(Label { name, bar }, &(), |()| value);
    // Eq. (20): ∇g_T = (ξ − ξ₀)∇t + t g   Eq. (21): H = (ξ − ξ₀)H_t + ∇t gᵀ + g∇tᵀ + t H_ξ
    to.value = t.value * slip;
    to.gradient = t
        .gradient
        .times(term("grad g_T: slip grad t", slip))
        .plus(term("grad g_T: t g", t.value), &xi.gradient);
    let with_g = xi.gradient.times(term("H_g_T: grad t g'", T::one()));
    to.hessian.set_sum(
        [(term("H_g_T: slip H_t", slip), &t.hessian), (term("H_g_T: t H_xi", t.value), &xi.hessian)],
        [(&t.gradient, &with_g)],
    );
}
