//! The sums in the matrices: products of Jacobians, the length of a vector, a slip.

use crate::curve::{DofDerivatives, Geometry};
use crate::linearization::Derivatives;
use crate::number::{Formula, Real, Which};
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
        // The column of B_l replaces w in the gradient of w·x,ξ..ξ.
        let columns = b.jacobian(l) * factor;
        for j in 0..M {
            let mut column = block.column_mut(j);
            column += a.gradient(k, &columns.column(j).into_owned());
        }
    }
}

/// The length of a tangent, without A₁ᵀA₁/t + K_t(w) in its Hessian, written over `to`. Returns 1/t and w = t/t.
#[inline]
pub(super) fn write_length<T: Real, const N: usize, const M: usize>(
    of: Which,
    Geometry { t, t_xi, t_xixi, .. }: &Geometry<T>,
    a_transposed: impl Fn(usize, &Vector3<T>) -> DofVector<T, N, M>,
    xi: &Derivatives<T, N, M>,
    to: &mut Derivatives<T, N, M>,
) -> (T, Vector3<T>) {
    let Derivatives { value, gradient, hessian } = to;
    *value = t.dot(t).sqrt();
    let (inverse, half, g) = (T::one() / *value, T::from(0.5), &xi.gradient);
    let w = t * inverse;
    // ∇t = J_tᵀw
    let first = of.named(Formula::GradT, "w.t,xi g", w.dot(t_xi));
    *gradient = a_transposed(1, &of.named(Formula::GradT, "A1'w", w)).plus(first, g);
    // H_t = (w·t,ξ) H_ξ + S_t(w) + (J_tᵀJ_t − ∇t∇tᵀ)/t with J_tᵀJ_t = A₁ᵀA₁ + sym(g, A₁ᵀt,ξ) + (t,ξ·t,ξ) ggᵀ
    let squares = half
        * (of.named(Formula::HessianT, "w.t,xixi gg'", w.dot(t_xixi))
            + of.named(Formula::HessianT, "t,xi.t,xi gg'", t_xi.dot(t_xi)) * inverse);
    let with_g = a_transposed(2, &of.named(Formula::HessianT, "A2'w g'", w))
        .plus(inverse, &a_transposed(1, &of.named(Formula::HessianT, "A1't,xi g'", *t_xi)))
        .plus(squares, g);
    let with_gradient = gradient.times(-of.named(Formula::HessianT, "grad t grad t'", half * inverse));
    let first = of.named(Formula::HessianT, "w.t,xi H_xi", w.dot(t_xi));
    hessian.set_sum(&[(first, &xi.hessian)], &[[g, &with_g], [gradient, &with_gradient]]);
    (inverse, w)
}

/// g_T = t (xi - xi_0), written over `to`.
#[inline]
pub(super) fn write_slip<T: Real, const N: usize, const M: usize>(
    of: Which,
    t: &Derivatives<T, N, M>,
    xi: &Derivatives<T, N, M>,
    xi_0: f64,
    to: &mut Derivatives<T, N, M>,
) {
    let slip = xi.value - T::from(xi_0);
    // Eq. (20): ∇g_T = (ξ − ξ₀)∇t + t g   Eq. (21): H = (ξ − ξ₀)H_t + ∇t gᵀ + g∇tᵀ + t H_ξ
    to.value = t.value * slip;
    to.gradient = t
        .gradient
        .times(of.named(Formula::GradGT, "slip grad t", slip))
        .plus(of.named(Formula::GradGT, "t g", t.value), &xi.gradient);
    let with_g = xi.gradient.times(of.named(Formula::HessianGT, "grad t g'", T::one()));
    to.hessian.set_sum(
        &[
            (of.named(Formula::HessianGT, "slip H_t", slip), &t.hessian),
            (of.named(Formula::HessianGT, "t H_xi", t.value), &xi.hessian),
        ],
        &[[&t.gradient, &with_g]],
    );
}
