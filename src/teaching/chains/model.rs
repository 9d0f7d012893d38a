//! Two chains in contact, and Newton's method for one step.

use super::Chain;
use super::search::{self, Owner, Place};
use crate::closest_point::{Held, ProjectionError};
use crate::contact::{self, ContactError, Contribution, Element, History, NormalLaw, Outcome, Parameters};
use crate::linearization::closed_form::{Matrices, jets};
use crate::teaching::DOFS;
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

/// A part of the tangent of the contact that is left out. The residual is always exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftOut {
    /// The tangent is exact.
    Nothing,
    /// −F_N Hess g_N.
    NormalHessian,
    /// The motion of the closest point along the beams, in −F_N Hess g_N.
    Projection,
    /// The tangent of friction: all of K_T.
    Friction,
    /// μ (m A + m̄ Ā) ∇F_Nᵀ, by which friction in slip follows F_N.
    Cone,
}

impl LeftOut {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Nothing, Self::NormalHessian, Self::Projection, Self::Friction, Self::Cone];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::NormalHessian => "-F_N Hess g_N",
            Self::Projection => "motion of the closest point",
            Self::Friction => "K_T",
            Self::Cone => "mu (m A + m_bar A_bar) grad F_N'",
        }
    }
}

/// Two chains, the contact between them, and the dofs that are given.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The beam and the bar beam.
    pub chains: [Chain; 2],
    /// The contact.
    pub parameters: Parameters,
    /// The given dofs.
    pub given: Vec<usize>,
    /// The length of the residual, a force, at which a step has converged. Contact forces up to it are not resolved, and
    /// count as an open contact.
    pub tolerance: f64,
    /// The largest displacement of a node, a length, at which a step has converged. In thin beams a small residual alone
    /// does not tell: they resist bending by much smaller forces than stretching.
    pub precision: f64,
    /// The maximum number of linear systems in a step.
    pub iterations: usize,
}

/// A state of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The dofs of both chains.
    pub u: DVector<f64>,
    /// The history of the contact, and the elements it belongs to.
    pub history: (History, Owner),
}

/// A converged step, or one that was given up.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The length of the residual over the free dofs, of each iterate; the first is that of the predictor.
    pub residuals: Vec<f64>,
    /// The largest displacement of a node in each linear step, a length; the first is that of the predictor.
    pub increments: Vec<f64>,
    /// The last contact point.
    pub place: Place,
    /// The last contact forces.
    pub outcome: Outcome,
    /// Whether residual and increment became small.
    pub converged: bool,
}

/// Why a step has no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The closest point was not found.
    #[error(transparent)]
    Projection(#[from] ProjectionError),
    /// The contact element refused.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The tangent is singular or not finite.
    #[error("the tangent is singular in iteration {iteration}")]
    Singular {
        /// The iteration.
        iteration: usize,
    },
}

/// How near Phi/(mu F_N) is to 0 on the cone.
const ON_CONE: f64 = 1e-9;

/// The order of convergence, ln(d₃/d₂)/ln(d₂/d₁), of a sequence of norms.
///
/// It is measured from the last three norms of which rounding allows it: convergence of order two would leave the third of
/// them above `rounding`. There may be no such norms.
///
/// Norms of increments tell more than those of residuals: in thin beams bending by δ strains the axis by δ², and the residual
/// is large by this part in one iterate and not in the next.
pub fn order(norms: &[f64], rounding: f64) -> Option<f64> {
    let allows = |d: &&[f64]| d[1] < d[0] && d[1] * (d[1] / d[0]).powi(2) > rounding;
    let d = norms.windows(3).rev().find(allows)?;
    Some((d[2].max(rounding) / d[1]).ln() / (d[1] / d[0]).ln())
}

impl Model {
    /// The straight chains, without contact.
    pub fn reference(&self) -> State {
        let mut u = DVector::zeros(self.chains.iter().map(Chain::dofs).sum());
        for chain in &self.chains {
            chain.write_reference(&mut u);
        }
        State { u, history: (History::default(), [0, 0]) }
    }

    /// Moves given dofs by these increments, finds the equilibrium, and keeps the history if it was found.
    ///
    /// The predictor is a linear step from the last equilibrium, with the given dofs at their new values. Every iteration
    /// then starts from the history of the last equilibrium.
    ///
    /// # Errors
    /// [`ModelError`] with the reason why an iterate has no residual or no next iterate.
    pub fn step(
        &self,
        state: &mut State,
        moves: &[(usize, f64)],
        left_out: LeftOut,
    ) -> Result<Step, ModelError> {
        let mut u = state.u.clone();
        let mut increment = DVector::zeros(u.len());
        for &(dof, by) in moves {
            increment[dof] = by;
        }
        let (mut residual, mut tangent, ..) = self.system(state, &u, LeftOut::Nothing)?;
        let mut step: Option<Step> = None;
        for iteration in 0..=self.iterations {
            self.solve(&residual, &tangent, &mut increment).ok_or(ModelError::Singular { iteration })?;
            u += &increment;
            let moved = self.largest_displacement(&increment);
            increment.fill(0.0);
            let (place, outcome);
            (residual, tangent, place, outcome) = self.system(state, &u, left_out)?;
            let norm = self.free(&residual).norm();
            let (mut residuals, mut increments) =
                step.take().map(|step| (step.residuals, step.increments)).unwrap_or_default();
            residuals.push(norm);
            increments.push(moved);
            let converged = norm <= self.tolerance && moved <= self.precision;
            let now = step.insert(Step { residuals, increments, place, outcome, converged });
            if now.converged {
                *state = State { u, history: (outcome.next, place.owner) };
                return Ok(now.clone());
            }
        }
        step.ok_or(ModelError::Singular { iteration: 0 })
    }

    /// Residual and tangent over all dofs, the contact point, and what the contact element says about it.
    ///
    /// # Errors
    /// [`ModelError`] if there is no closest point or the contact element refuses it.
    pub fn system(
        &self,
        converged: &State,
        u: &DVector<f64>,
        left_out: LeftOut,
    ) -> Result<(DVector<f64>, DMatrix<f64>, Place, Outcome), ModelError> {
        let (mut residual, mut tangent) = (DVector::zeros(u.len()), DMatrix::zeros(u.len(), u.len()));
        for chain in &self.chains {
            chain.add(u, &mut residual, &mut tangent);
        }
        let place = search::nearest(&self.chains, u)?;
        let (history, from) = converged.history;
        let history = search::carried(&self.chains, &converged.u, history, from, place.owner);
        let mut to = Contribution::zeros();
        let outcome = self.contact(u, &place, &history, left_out, &mut to)?;
        let at: [usize; 2] = [0, 1].map(|k| self.chains[k].node(place.owner[k]));
        let dof = |i: usize| if i < DOFS { at[0] + i } else { at[1] + i - DOFS };
        for i in 0..2 * DOFS {
            residual[dof(i)] += to.residual.entry(i);
            for j in 0..2 * DOFS {
                tangent[(dof(i), dof(j))] += to.tangent.entry(i, j);
            }
        }
        Ok((residual, tangent, place, outcome))
    }

    /// Residual and tangent of the contact, without the part that is left out.
    fn contact(
        &self,
        u: &DVector<f64>,
        place: &Place,
        history: &History,
        left_out: LeftOut,
        to: &mut Contribution<f64, DOFS, DOFS>,
    ) -> Result<Outcome, ModelError> {
        let pair = search::pair(&self.chains);
        let q = search::dofs(&self.chains, u, place.owner);
        let element = Element::new(&pair, &self.parameters)?;
        let mut outcome = element.evaluate(&q, &place.point, history, to)?;
        if outcome.values.f_n <= self.tolerance {
            (outcome.state, outcome.next) = (contact::State::Open, outcome.next.opened());
            *to = Contribution::zeros();
            return Ok(outcome);
        }
        let at = (place.point.xi, place.point.xi_bar);
        let (jet, jet_bar) = jets(&pair, &q, at);
        // A step begins on the cone after a slip, up to rounding, and goes on slipping as a rule.
        let was_slipping = history.slips.is_some_and(|slips| slips.is_slipping);
        if outcome.state == contact::State::Stick && was_slipping && outcome.values.yield_ratio > -ON_CONE {
            let slipping = element.decide(&q, &place.point, history)?.in_state(contact::State::Slip, at)?;
            contact::closed_form::write(&slipping, (&jet, &jet_bar), at, to);
        }
        if left_out == LeftOut::Nothing {
            return Ok(outcome);
        }
        let decision = element.decide(&q, &place.point, history)?;
        let mut normal = Contribution::<f64, DOFS, DOFS>::zeros();
        let frictionless = decision.in_state(contact::State::Frictionless, at)?;
        contact::closed_form::write(&frictionless, (&jet, &jet_bar), at, &mut normal);
        // R_N = −F_N ∇g_N
        let (f_n, k) = (outcome.values.f_n, self.stiffness(&outcome));
        let gradient = normal.residual.times(-1.0 / f_n);
        let both = Held { xi: true, xi_bar: true };
        let frozen = Matrices::<_, _, _, DOFS, DOFS>::new(&jet, &jet_bar, both).d();
        let change = |i: usize, j: usize| match left_out {
            LeftOut::NormalHessian => k * gradient.entry(i) * gradient.entry(j) - normal.tangent.entry(i, j),
            LeftOut::Projection => {
                let frozen = frozen.hessian.entry(i, j);
                let side = if decision.is_crossed { -1.0 } else { 1.0 };
                k * gradient.entry(i) * gradient.entry(j) - side * f_n * frozen - normal.tangent.entry(i, j)
            }
            LeftOut::Friction => normal.tangent.entry(i, j) - to.tangent.entry(i, j),
            LeftOut::Cone if outcome.state == contact::State::Slip => {
                // μ (m A + m̄ Ā) = R_T/F_N   ∇F_N = −k ∇g_N
                (to.residual.entry(i) - normal.residual.entry(i)) / f_n * k * gradient.entry(j)
            }
            LeftOut::Nothing | LeftOut::Cone => 0.0,
        };
        let changes = DMatrix::from_fn(2 * DOFS, 2 * DOFS, change);
        for i in 0..2 * DOFS {
            for j in 0..2 * DOFS {
                to.tangent.set(i, j, to.tangent.entry(i, j) + changes[(i, j)]);
            }
        }
        Ok(outcome)
    }

    /// k = −dF_N/dg_N.
    fn stiffness(&self, outcome: &Outcome) -> f64 {
        let law = &self.parameters.law;
        let g_n = outcome.values.g_n;
        law.piece(g_n).map_or(0.0, |piece| law.stiffness(piece, g_n))
    }

    /// Solves for the free increments; those of given dofs are input.
    fn solve(
        &self,
        residual: &DVector<f64>,
        tangent: &DMatrix<f64>,
        increment: &mut DVector<f64>,
    ) -> Option<()> {
        let free = self.free_dofs();
        let right = self.free(&-(residual + tangent * &*increment));
        let matrix = DMatrix::from_fn(free.len(), free.len(), |i, j| tangent[(free[i], free[j])]);
        let solution = matrix.lu().solve(&right).filter(|x| x.iter().all(|x| x.is_finite()))?;
        for (&dof, &by) in free.iter().zip(&solution) {
            increment[dof] = by;
        }
        Some(())
    }

    fn largest_displacement(&self, increment: &DVector<f64>) -> f64 {
        let nodes = self.chains.iter().flat_map(|chain| (0..=chain.elements).map(|node| chain.node(node)));
        nodes.map(|node| increment.fixed_rows::<3>(node).norm()).fold(0.0, f64::max)
    }

    fn free_dofs(&self) -> Vec<usize> {
        let all: usize = self.chains.iter().map(Chain::dofs).sum();
        (0..all).filter(|dof| !self.given.contains(dof)).collect()
    }

    fn free(&self, all: &DVector<f64>) -> DVector<f64> {
        let free = self.free_dofs();
        DVector::from_fn(free.len(), |i, _| all[free[i]])
    }
}
