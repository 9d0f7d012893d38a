//! Lagrange multipliers: forces are unknowns beside the dofs, and each constraint has a row.
//!
//! The unknowns are Q, lambda, p and p_bar. lambda is the normal force; p and p_bar hold the contact point in stick. The
//! Lagrangian is E - lambda g_N + p (xi - xi_n) + p_bar (xi_bar - xi_bar_n), so the matrix is symmetric unless the beams slip.

use super::Values;
use super::closed_form::{self, Contribution, Kinematics, set_sum};
use super::{Decision, NormalLaw, State};
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::closed_form::Matrices;
use crate::number::Real;
use crate::pair::DofVector;

/// The normal law of a multiplier: F_N = lambda, whatever the gap is.
///
/// The contact is active where lambda - eps g_N > 0, the primal-dual active set. For lambda <= 0 there is no friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// lambda, a force.
    pub lambda: f64,
    /// eps > 0, a force over a length. It decides the active set and does not enter the equations.
    pub eps: f64,
}

impl NormalLaw for Multiplier {
    type Piece = ();

    fn piece(&self, g_n: f64) -> Option<()> {
        (self.lambda - self.eps * g_n > 0.0).then_some(())
    }

    fn force<T: Real>(&self, (): (), _: T) -> T {
        T::from(self.lambda)
    }

    fn stiffness<T: Real>(&self, (): (), _: T) -> T {
        T::zero()
    }

    fn opening_gap(&self) -> f64 {
        self.lambda / self.eps
    }

    fn invalid_parameter(&self) -> Option<(&'static str, f64)> {
        let Self { lambda, eps } = *self;
        if !lambda.is_finite() {
            Some(("lambda", lambda))
        } else if eps > 0.0 && eps.is_finite() {
            None
        } else {
            Some(("eps", eps))
        }
    }
}

/// The row and the column of an unknown beside the dofs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Border<T, const N: usize, const M: usize> {
    /// The derivative of R with respect to the unknown.
    pub column: DofVector<T, N, M>,
    /// The derivative of the constraint with respect to Q.
    pub row: DofVector<T, N, M>,
    /// The constraint: the residual of the row.
    pub constraint: T,
    /// The derivative of the constraint with respect to the unknown.
    pub corner: T,
}

/// Writes R and K with the unknown lambda, and returns its row -g_N = 0, or lambda = 0 if the contact is not active.
///
/// Friction is by penalty, with the cone of lambda.
pub fn write_normal<T, U, V, const N: usize, const M: usize>(
    decision: &Decision<'_, Multiplier>,
    jets: (&Jet<T, U>, &Jet<T, V>),
    at: (T, T),
    to: &mut Contribution<T, N, M>,
) -> (Values<T>, Border<T, N, M>)
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    let lambda = decision.parameters.law.lambda;
    let decision = if lambda > 0.0 { *decision } else { without_friction(decision) };
    let values = closed_form::write(&decision, jets, at, to);
    if decision.acting().is_none() {
        let zero = DofVector::zeros();
        let border = Border { column: zero, row: zero, constraint: T::from(lambda), corner: T::one() };
        return (values, border);
    }
    let side = T::from(if decision.is_crossed { -1.0 } else { 1.0 });
    let row = to.kinematics.d.gradient.times(-side);
    // ∂R/∂λ = −∇g_N, and in slip also μ (m A + m̄ Ā): R is then proportional to λ.
    let column =
        if decision.state == State::Slip { to.residual.times(T::one() / T::from(lambda)) } else { row };
    (values, Border { column, row, constraint: -values.g_n, corner: T::zero() })
}

/// Writes R and K of stick with the unknowns lambda, p and p_bar, and returns their rows -g_N, xi - xi_n and
/// xi_bar - xi_bar_n. A held parameter has no row.
///
/// Without a start of the slips, or if the contact is not active, only the row of lambda is left.
pub fn write_stick<T, U, V, const N: usize, const M: usize>(
    decision: &Decision<'_, Multiplier>,
    [p, p_bar]: [T; 2],
    jets: (&Jet<T, U>, &Jet<T, V>),
    at: (T, T),
    to: &mut Contribution<T, N, M>,
) -> (Values<T>, Border<T, N, M>, [Option<Border<T, N, M>>; 2])
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    let (values, of_lambda) = write_normal(&without_friction(decision), jets, at, to);
    let (Some(start), Some(_)) = (decision.start, decision.acting()) else {
        return (values, of_lambda, [None; 2]);
    };
    let held = decision.form.held;
    let Contribution { tangent, residual, kinematics: Kinematics { d, t, t_bar, xi, xi_bar } } = to;
    Matrices::in_formulation(jets.0, jets.1, decision.form)
        .write_without_slips(at, [d, t, t_bar, xi, xi_bar]);
    let zero = T::zero();
    let (p, p_bar) = (if held.xi { zero } else { p }, if held.xi_bar { zero } else { p_bar });
    // R += p ∇ξ + p̄ ∇ξ̄   K = −λ H_gN + p H_ξ + p̄ H_ξ̄
    *residual = residual.plus(p, &xi.gradient).plus(p_bar, &xi_bar.gradient);
    let side = T::from(if decision.is_crossed { -1.0 } else { 1.0 });
    let hessians = [(-values.f_n * side, &d.hessian), (p, &xi.hessian), (p_bar, &xi_bar.hessian)];
    set_sum(tangent, hessians, [] as [[&DofVector<T, N, M>; 2]; 0]);
    let border = |gradient: &DofVector<T, N, M>, xi: T, start: f64| Border {
        column: *gradient,
        row: *gradient,
        constraint: xi - T::from(start),
        corner: zero,
    };
    let of_p = (!held.xi).then(|| border(&xi.gradient, at.0, start.xi));
    let of_p_bar = (!held.xi_bar).then(|| border(&xi_bar.gradient, at.1, start.xi_bar));
    (values, of_lambda, [of_p, of_p_bar])
}

/// The size of the friction force of p and p_bar, to be compared with mu lambda. A held parameter has none.
///
/// `tangents` are t, t_bar and the cosine of their angle.
pub fn friction<T: Real>(p: Option<T>, p_bar: Option<T>, (t, t_bar, c): (T, T, T)) -> T {
    // F = p/t and F̄ = p̄/t̄ are covariant: |T|² = (F² + F̄² + 2 c F F̄)/(1 − c²)
    match (p.map(|p| p / t), p_bar.map(|p_bar| p_bar / t_bar)) {
        (Some(f), Some(f_bar)) => {
            let two = T::one() + T::one();
            ((f * f + f_bar * f_bar + two * c * f * f_bar) / (T::one() - c * c)).sqrt()
        }
        (Some(f), None) | (None, Some(f)) => (f * f).sqrt(),
        (None, None) => T::zero(),
    }
}

/// The same contact without friction.
fn without_friction<'a>(decision: &Decision<'a, Multiplier>) -> Decision<'a, Multiplier> {
    let state = if decision.state.has_friction() { State::Frictionless } else { decision.state };
    Decision { state, ..*decision }
}
