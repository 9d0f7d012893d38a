//! Residual and tangent in closed form, over any scalar and for every curve.
//!
//! The formulas are in `docs/contact-element.md`. Gradients and Hessians of the geometry are those of
//! [`Matrices`]. "row" is the dof of the residual.

mod assemble;

use super::geometry::{Gap, Trial};
use super::{BlockMatrix, Decision, NormalLaw, State};
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::Derivatives;
use crate::linearization::closed_form::kernel::{self, DistanceAlone, WithoutSlips};
use crate::linearization::closed_form::{Matrices, Points};
use crate::number::Real;
use crate::pair::{Contact, DofVector};
use assemble::assemble;
pub(super) use assemble::set_sum;
use nalgebra::Vector3;

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

impl<const N: usize, const M: usize> Contribution<f64, N, M> {
    /// The first entry of R, or of the diagonal of K, that is infinite or not a number, with the name of its array.
    /// To look at all of K would cost a tenth of its computation.
    pub(super) fn not_finite(&self) -> Option<(&'static str, f64)> {
        let Self { tangent: k, residual: r, .. } = self;
        // One running sum: an instruction an entry. It may overflow by itself.
        let of_r = r.beam.data.0[0].iter().chain(&r.bar.data.0[0]).fold(0.0, |sum, entry| sum + entry);
        let sum = (0..N).fold(of_r, |sum, i| sum + k.beam.data.0[i][i]);
        let sum = (0..M).fold(sum, |sum, i| sum + k.bar.data.0[i][i]);
        if sum.is_finite() {
            return None;
        }
        let residual = r.beam.iter().chain(r.bar.iter()).map(|&entry| ("R", entry));
        let diagonal = (0..N).map(|i| k.beam[(i, i)]).chain((0..M).map(|i| k.bar[(i, i)]));
        residual.chain(diagonal.map(|entry| ("K", entry))).find(|(_, entry)| !entry.is_finite())
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
pub(crate) fn write_by_kernel<U, V, L, const N: usize, const M: usize>(
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
    /// Φ/(μ F_N); not used without friction.
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
            return Self { f_n, k, rho: one, eps_t, mu, l: zero, l_bar: zero, yield_ratio: zero };
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
        let Some(trial) = trial else { return Values { f_n, ..Values::open(gap) } };
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
