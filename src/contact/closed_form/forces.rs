//! The forces at a point, and the return to the cone.

use crate::contact::geometry::{Gap, Trial};
use crate::contact::{Decision, NormalLaw, State, Values};
use crate::number::Real;

/// The forces at a point, and the return.
pub(in crate::contact) struct Forces<T> {
    pub(super) f_n: T,
    pub(super) k: T,
    pub(super) rho: T,
    /// ε_T, and μ.
    pub(super) eps_t: T,
    pub(super) mu: T,
    /// l = e − c ē and its twin; 0 if held.
    pub(super) l: T,
    pub(super) l_bar: T,
    /// Φ/(μ F_N); not used without friction.
    pub(super) yield_ratio: T,
}

impl<T: Real> Forces<T> {
    pub(in crate::contact) fn new<L: NormalLaw>(
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

    pub(in crate::contact) fn values(&self, gap: &Gap<T>, trial: Option<&Trial<T>>) -> Values<T> {
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
