//! Residual and tangent in closed form, over any scalar and for every curve.
//!
//! The formulas are in `docs/contact-element.md`. Gradients and Hessians of the geometry are those of
//! [`Matrices`]. "row" is the dof of the residual.

use super::geometry::{Gap, Trial};
use super::{BlockMatrix, Decision, NormalLaw, State, Work};
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::closed_form::kernel::{self, DistanceAlone, WithoutSlips};
use crate::linearization::closed_form::{Matrices, Points};
use crate::linearization::dispatch::dispatch_simd;
use crate::linearization::{BlockHessian, Derivatives};
use crate::number::Real;
use crate::pair::{Contact, DofVector};
use crate::source_fault::source_fault;
use nalgebra::{SMatrix, SVector, Vector3};

/// Residual and tangent of a contact, and memory for the geometry.
#[derive(Clone, Copy, Debug)]
pub struct Contribution<T, const N: usize, const M: usize> {
    /// K, the derivative of R.
    pub tangent: BlockMatrix<T, N, M>,
    /// R, the contribution to the internal forces.
    pub residual: DofVector<T, N, M>,
    pub(super) kinematics: Kinematics<T, N, M>,
}

impl<T: Real, const N: usize, const M: usize> Contribution<T, N, M> {
    /// Zeros, to be overwritten.
    pub fn zeros() -> Self {
        let zero = Derivatives::zero;
        let kinematics = Kinematics { d: zero(), t: zero(), t_bar: zero(), xi: zero(), xi_bar: zero() };
        Self { tangent: BlockMatrix::zeros(), residual: DofVector::zeros(), kinematics }
    }

    /// Sets residual and tangent to zero.
    pub(super) fn set_zero(&mut self) {
        self.residual = DofVector::zeros();
        self.tangent.set_zero();
    }
}

/// The quantities that the element uses, with their derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kinematics<T, const N: usize, const M: usize> {
    pub(super) d: Derivatives<T, N, M>,
    pub(super) t: Derivatives<T, N, M>,
    pub(super) t_bar: Derivatives<T, N, M>,
    pub(super) xi: Derivatives<T, N, M>,
    pub(super) xi_bar: Derivatives<T, N, M>,
}

/// The forces and lengths of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values<T> {
    /// g_N, a length.
    pub g_n: T,
    /// n, the unit normal from the bar beam to the beam.
    pub normal: Vector3<T>,
    /// F_N, positive in compression.
    pub f_n: T,
    /// T, the friction force on the beam; the bar beam has -T.
    pub traction: Vector3<T>,
    /// F = T·τ, the friction force along the beam; 0 if xi is held.
    pub f: T,
    /// F̄ = -T·τ̄; 0 if xi_bar is held.
    pub f_bar: T,
    /// g_T, the slip of the step along the beam, a length.
    pub g_t: T,
    /// g_T_bar, the slip of the step along the bar beam.
    pub g_t_bar: T,
    /// e, the elastic slip after the return.
    pub e: T,
    /// e_bar, the same along the bar beam.
    pub e_bar: T,
    /// rho, the factor of the return: 1 in stick, less in slip.
    pub rho: T,
    /// Phi/(mu F_N) with Phi = eps_T gamma - mu F_N: at most 0 in stick. -1 without friction.
    pub yield_ratio: T,
}

/// Writes residual and tangent at contact points, from the jets of both curves there.
pub fn write<T, U, V, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    jets: (&Jet<T, U>, &Jet<T, V>),
    at: (T, T),
    to: &mut Contribution<T, N, M>,
) -> Values<T>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    L: NormalLaw,
{
    write_with(decision, jets, at, to, |_, _| false)
}

/// [`write`] with the kernel, as far as it applies to the curves.
pub(super) fn write_by_kernel<U, V, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    jets: (&Jet<f64, U>, &Jet<f64, V>),
    q: &DofVector<f64, N, M>,
    at: (f64, f64),
    to: &mut Contribution<f64, N, M>,
) -> Values<f64>
where
    U: DofDerivatives<f64, N>,
    V: DofDerivatives<f64, M>,
    L: NormalLaw,
{
    // The slips of the pair are not requested, so its reference parameters are not used.
    let unused = &Contact::default();
    write_with(decision, jets, at, to, |has_friction, [d, t, t_bar, xi, xi_bar]| {
        if has_friction {
            let request = &mut WithoutSlips { d, xi, xi_bar, t, t_bar };
            kernel::write_of_jets(jets, q, at, decision.form, unused, request)
        } else {
            kernel::write_of_jets(jets, q, at, decision.form, unused, &mut DistanceAlone { d })
        }
    })
}

/// Writes residual and tangent. `written` may write the geometry, with friction or without it, and tells whether it did.
fn write_with<T, U, V, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    (jet, jet_bar): (&Jet<T, U>, &Jet<T, V>),
    at: (T, T),
    to: &mut Contribution<T, N, M>,
    written: impl FnOnce(bool, [&mut Derivatives<T, N, M>; 5]) -> bool,
) -> Values<T>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    L: NormalLaw,
{
    let points = Points::new(&jet.geometry, &jet_bar.geometry);
    let gap = Gap::new(&points, decision);
    let Some((piece, start)) = decision.acting() else {
        to.set_zero();
        return Values::open(&gap);
    };
    let Kinematics { d, t, t_bar, xi, xi_bar } = &mut to.kinematics;
    if !written(start.is_some(), [d, t, t_bar, xi, xi_bar]) {
        let matrices = Matrices::in_formulation(jet, jet_bar, decision.form);
        if start.is_some() {
            matrices.write_without_slips(at, [d, t, t_bar, xi, xi_bar]);
        } else {
            matrices.write_d(d);
        }
    }
    let trial = start.map(|start| Trial::new(&points, at, decision.form.held, &start));
    let forces = Forces::new(decision, piece, &gap, trial.as_ref());
    let gradients = |w: &Vector3<T>, w_bar: &Vector3<T>| DofVector {
        beam: jet.dofs.gradient(1, w),
        bar: jet_bar.dofs.gradient(1, w_bar),
    };
    assemble(decision, &forces, trial.as_ref(), &points, gradients, to);
    forces.values(&gap, trial.as_ref())
}

/// The forces at a point, and the return.
pub(super) struct Forces<T> {
    f_n: T,
    k: T,
    rho: T,
    /// ε_T, and μ.
    eps_t: T,
    mu: T,
    /// l = e − c ē and its twin; 0 if held.
    l: T,
    l_bar: T,
    yield_ratio: T,
}

impl<T: Real> Forces<T> {
    pub(super) fn new<L: NormalLaw>(
        decision: &Decision<'_, L>,
        piece: L::Piece,
        gap: &Gap<T>,
        trial: Option<&Trial<T>>,
    ) -> Self {
        let Decision { parameters, form, state, .. } = decision;
        let (f_n, k) = (parameters.law.force(piece, gap.g_n), parameters.law.stiffness(piece, gap.g_n));
        let (eps_t, mu) = (T::from(parameters.eps_t), T::from(parameters.mu));
        let (zero, one) = (T::zero(), T::one());
        let Some(Trial { e, e_bar, c, gamma, .. }) = trial else {
            return Self { f_n, k, rho: one, eps_t, mu, l: zero, l_bar: zero, yield_ratio: -one };
        };
        // ρ = μ F_N/(ε_T γ) in slip
        let cone = mu * f_n;
        let rho = if *state == State::Slip { cone / (eps_t * *gamma) } else { one };
        let l = if form.held.xi { zero } else { *e - *c * *e_bar };
        let l_bar = if form.held.xi_bar { zero } else { *e_bar - *c * *e };
        Self { f_n, k, rho, eps_t, mu, l, l_bar, yield_ratio: eps_t * *gamma / cone - one }
    }

    pub(super) fn values(&self, gap: &Gap<T>, trial: Option<&Trial<T>>) -> Values<T> {
        let Self { f_n, rho, eps_t, l, l_bar, yield_ratio, .. } = *self;
        let Gap { n, g_n } = *gap;
        let open = Values { f_n, ..Values::open(gap) };
        let Some(trial) = trial else { return open };
        let (g_t, g_t_bar) = (trial.t * trial.u, trial.t_bar * trial.u_bar);
        let force = eps_t * rho;
        Values {
            g_n,
            normal: n,
            f_n,
            traction: trial.s * force,
            f: force * l,
            f_bar: force * l_bar,
            g_t,
            g_t_bar,
            e: rho * trial.e,
            e_bar: rho * trial.e_bar,
            rho,
            yield_ratio,
        }
    }
}

impl<T: Real> Values<T> {
    /// No force.
    pub(super) fn open(gap: &Gap<T>) -> Self {
        let zero = T::zero();
        Self {
            g_n: gap.g_n,
            normal: gap.n,
            f_n: zero,
            traction: Vector3::zeros(),
            f: zero,
            f_bar: zero,
            g_t: zero,
            g_t_bar: zero,
            e: zero,
            e_bar: zero,
            rho: T::one(),
            yield_ratio: -T::one(),
        }
    }
}

/// Adds up residual and tangent from the gradients and Hessians of the geometry.
///
/// `gradients` returns A₁ᵀw and B₁ᵀw̄ for two vectors.
pub(super) fn assemble<T: Real, L: NormalLaw, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    forces: &Forces<T>,
    trial: Option<&Trial<T>>,
    points: &Points<T>,
    gradients: impl Fn(&Vector3<T>, &Vector3<T>) -> DofVector<T, N, M>,
    to: &mut Contribution<T, N, M>,
) {
    let Contribution { tangent, residual, kinematics: Kinematics { d, t, t_bar, xi, xi_bar } } = to;
    let Forces { f_n, k, rho, eps_t, mu, l, l_bar, .. } = *forces;
    let side = T::from(if decision.is_crossed { -1.0 } else { 1.0 });
    // R_N = −F_N ∇g_N   K_N = k ∇g_N∇g_Nᵀ − F_N H_gN   ∇F_N = −k ∇g_N
    let by_d = -f_n * side;
    let normal = d.gradient.times(k);
    let Some(trial) = trial else {
        *residual = d.gradient.times(by_d);
        set_sum(tangent, [(by_d, &d.hessian)], [[&d.gradient, &normal]]);
        return;
    };
    let Trial { tau, tau_bar, c, u, u_bar, e, e_bar, gamma, .. } = *trial;
    let (g, g_bar, grad_t, grad_t_bar) = (&xi.gradient, &xi_bar.gradient, &t.gradient, &t_bar.gradient);
    // ∇e = t g + (ξ − ξₙ) ∇t, eq. (20)
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
            // A also has (ξ − ξₙ)∇t, and H_A has (ξ − ξₙ) H_t + ∇t gᵀ
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
pub(super) fn set_sum<T: Real, const H: usize, const O: usize, const N: usize, const M: usize>(
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
