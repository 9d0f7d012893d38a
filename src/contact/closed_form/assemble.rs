//! The sums of residual and tangent, from the forces and the linearized geometry.

use super::contribution::{Contribution, Kinematics};
use super::forces::Forces;
use crate::contact::geometry::Trial;
use crate::contact::{BlockMatrix, Decision, NormalLaw, State, Work};
use crate::linearization::BlockHessian;
use crate::linearization::closed_form::Points;
use crate::linearization::dispatch::dispatch_simd;
use crate::number::Real;
use crate::pair::DofVector;
use crate::source_fault::source_fault;
use nalgebra::{SMatrix, SVector, Vector3};

/// Adds up residual and tangent from the gradients and Hessians of the geometry.
///
/// `gradients` returns A₁ᵀw and B₁ᵀw̄ for two vectors.
pub(in crate::contact) fn assemble<T: Real, L: NormalLaw, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    forces: &Forces<T>,
    trial: Option<&Trial<T>>,
    points: &Points<T>,
    gradients: impl Fn(&Vector3<T>, &Vector3<T>) -> DofVector<T, N, M>,
    to: &mut Contribution<T, N, M>,
) {
    // Eq. (57)-(59) are the Hessians of d, t, t̄, ξ and ξ̄.
    let Contribution { tangent, residual, kinematics: Kinematics { d, t, t_bar, xi, xi_bar } } = to;
    let Forces { f_n, k, rho, eps_t, mu, l, l_bar, .. } = *forces;
    let side = T::from(if decision.is_crossed { -1.0 } else { 1.0 });
    // Eq. (18): ∇g_N is ∇d. R_N = −F_N ∇g_N   K_N = k ∇g_N∇g_Nᵀ − F_N H_gN   ∇F_N = −k ∇g_N
    let by_d = -f_n * side;
    let normal = d.gradient.times(k);
    let Some(trial) = trial else {
        *residual = d.gradient.times(by_d);
        set_sum(tangent, [(by_d, &d.hessian)], [[&d.gradient, &normal]]);
        return;
    };
    let Trial { tau, tau_bar, c, u, u_bar, e, e_bar, gamma, .. } = *trial;
    let (g, g_bar, grad_t, grad_t_bar) = (&xi.gradient, &xi_bar.gradient, &t.gradient, &t_bar.gradient);
    // Eq. (20): ∇e = t g + (ξ − ξₙ) ∇t
    let grad_e = g.times(t.value).plus(u, grad_t);
    let grad_e_bar = g_bar.times(t_bar.value).plus(u_bar, grad_t_bar);
    // ∇c = J_tᵀ(τ̄ − c τ)/t + J_t̄ᵀ(τ − c τ̄)/t̄ with J_tᵀv = A₁ᵀv + (v·t,ξ) g
    let (v, v_bar) = ((tau_bar - tau * c) / t.value, (tau - tau_bar * c) / t_bar.value);
    let grad_c =
        gradients(&v, &v_bar).plus(v.dot(&points.beam.t_xi), g).plus(v_bar.dot(&points.bar.t_xi), g_bar);
    // ∇l = ∇e − c ∇ē − ē ∇c
    let grad_l = grad_e.plus(-c, &grad_e_bar).plus(-e_bar, &grad_c);
    let grad_l_bar = grad_e_bar.plus(-c, &grad_e).plus(source_fault!("sign-of-grad-c": e, -e), &grad_c);
    let force = eps_t * rho;
    let (f, f_bar) = (force * l, force * l_bar);
    let (mut grad_f, mut grad_f_bar) = (grad_l.times(force), grad_l_bar.times(force));
    if decision.state == State::Slip {
        // ∇γ = (l ∇e + l̄ ∇ē − e ē ∇c)/γ   ∇ρ = μ/(ε_T γ) ∇F_N − (ρ/γ) ∇γ   ∇F = ε_T (ρ ∇l + l ∇ρ)
        let of_gamma = -force / (gamma * gamma);
        let (s, s_bar) = (e - c * e_bar, e_bar - c * e);
        let grad_force = d
            .gradient
            .times(-(mu * k * side) / gamma)
            .plus(of_gamma * s, &grad_e)
            .plus(of_gamma * s_bar, &grad_e_bar)
            .plus(source_fault!("gamma-without-angle": T::zero(), -of_gamma * e * e_bar), &grad_c);
        grad_f = grad_f.plus(l, &grad_force);
        grad_f_bar = grad_f_bar.plus(l_bar, &grad_force);
    }
    let (t, t_bar, of_t, of_t_bar) = (t.value, t_bar.value, &t.hessian, &t_bar.hessian);
    // R_T = F A + F̄ Ā with A = t g
    *residual = d.gradient.times(by_d).plus(f * t, g).plus(f_bar * t_bar, g_bar);
    // A∇Fᵀ + F H_A with H_A = g∇tᵀ + t H_ξ
    let with_g = grad_f.times(t).plus(f, grad_t);
    let with_g_bar = grad_f_bar.times(t_bar).plus(f_bar, grad_t_bar);
    let hessians = [(by_d, &d.hessian), (f * t, &xi.hessian), (f_bar * t_bar, &xi_bar.hessian)];
    let outer = [[&d.gradient, &normal], [g, &with_g], [g_bar, &with_g_bar]];
    match decision.parameters.work {
        Work::Rate => set_sum(tangent, hessians, outer),
        Work::Paper => {
            // Eq. (20) and (21): A also has (ξ − ξₙ)∇t, and H_A has (ξ − ξₙ) H_t + ∇t gᵀ
            *residual = residual.plus(f * u, grad_t).plus(f_bar * u_bar, grad_t_bar);
            let with_t = grad_f.times(u).plus(f, g);
            let with_t_bar = grad_f_bar.times(u_bar).plus(f_bar, g_bar);
            let [of_d, of_xi, of_xi_bar] = hessians;
            let hessians = [of_d, of_xi, of_xi_bar, (f * u, of_t), (f_bar * u_bar, of_t_bar)];
            let [by_d, by_g, by_g_bar] = outer;
            let outer = [by_d, by_g, by_g_bar, [grad_t, &with_t], [grad_t_bar, &with_t_bar]];
            set_sum(tangent, hessians, outer);
        }
    }
}

/// Sets a matrix to the sum of factor * Hessian over all `hessians` and of u vᵀ over all pairs (u, v) in `outer`.
#[inline]
pub(in crate::contact) fn set_sum<T: Real, const H: usize, const O: usize, const N: usize, const M: usize>(
    to: &mut BlockMatrix<T, N, M>,
    hessians: [(T, &BlockHessian<T, N, M>); H],
    outer: [[&DofVector<T, N, M>; 2]; O],
) {
    let BlockMatrix { beam, bar_beam, beam_bar, bar } = to;
    let factors = hessians.map(|(factor, _)| factor);
    let of = hessians.map(|(_, hessian)| hessian);
    let columns = (outer.map(|[_, v]| &v.beam), outer.map(|[_, v]| &v.bar));
    let rows = (outer.map(|[u, _]| &u.beam), outer.map(|[u, _]| &u.bar));
    dispatch_simd!({
        set_block(beam, factors, |h, j| of[h].beam.data.0[j], rows.0, columns.0);
        set_block(
            bar_beam,
            factors,
            |h, j| std::array::from_fn(|i| of[h].mixed.data.0[i][j]),
            rows.1,
            columns.0,
        );
        set_block(beam_bar, factors, |h, j| of[h].mixed.data.0[j], rows.0, columns.1);
        set_block(bar, factors, |h, j| of[h].bar.data.0[j], rows.1, columns.1);
    });
}

/// Sets a block in [`set_sum`], column by column. `column_of` returns a column of a Hessian.
#[inline(always)]
fn set_block<T: Real, const H: usize, const O: usize, const N: usize, const M: usize>(
    to: &mut SMatrix<T, N, M>,
    factors: [T; H],
    column_of: impl Fn(usize, usize) -> [T; N],
    rows: [&SVector<T, N>; O],
    columns: [&SVector<T, M>; O],
) {
    for (j, column) in to.data.0.iter_mut().enumerate() {
        let mut sums = [T::zero(); N];
        for (h, &factor) in factors.iter().enumerate() {
            for (sum, entry) in sums.iter_mut().zip(column_of(h, j)) {
                *sum += entry * factor;
            }
        }
        for (u, v) in rows.iter().zip(&columns) {
            for (sum, &u) in sums.iter_mut().zip(&u.data.0[0]) {
                *sum += u * v[j];
            }
        }
        *column = sums;
    }
}
