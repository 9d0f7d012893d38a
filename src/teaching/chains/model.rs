//! Two chains in contact, and Newton's method for one step.

use super::Chain;
use super::search::{self, Owner, Place};
use crate::closest_point::{ClosestPoint, ProjectionError};
use crate::contact::{
    self, ContactError, Contribution, Decision, Element, History, Law, Outcome, Parameters,
};
use crate::curve::Hermite;
use crate::linearization::closed_form::jets;
use crate::number::Real;
use crate::pair::DofVector;
use crate::teaching::DOFS;
use crate::teaching::terms::{Components, Tangent, Terms};
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

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
        tangent: Tangent,
    ) -> Result<Step, ModelError> {
        let mut u = state.u.clone();
        let mut increment = DVector::zeros(u.len());
        for &(dof, by) in moves {
            increment[dof] = by;
        }
        let (mut residual, mut matrix, ..) = self.system(state, &u, Tangent::EXACT)?;
        let mut step: Option<Step> = None;
        for iteration in 0..=self.iterations {
            self.solve((&residual, &matrix), &mut increment, solved)
                .ok_or(ModelError::Singular { iteration })?;
            u += &increment;
            let moved = self.largest_displacement(&increment);
            increment.fill(0.0);
            let (place, outcome);
            (residual, matrix, place, outcome) = self.system(state, &u, tangent)?;
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
        tangent: Tangent,
    ) -> Result<(DVector<f64>, DMatrix<f64>, Place, Outcome), ModelError> {
        let (mut residual, mut matrix) = (DVector::zeros(u.len()), DMatrix::zeros(u.len(), u.len()));
        for chain in &self.chains {
            chain.add(u, &mut residual, &mut matrix);
        }
        let place = search::nearest(&self.chains, u)?;
        let (history, from) = converged.history;
        let history = search::carried(&self.chains, &converged.u, history, from, place.owner);
        let mut to = Contribution::zeros();
        let outcome = self.contact(u, &place, &history, tangent, &mut to)?;
        self.add_contact(&to, place.owner, &mut residual, &mut matrix);
        Ok((residual, matrix, place, outcome))
    }

    /// Adds residual and tangent of the contact of two elements.
    pub(super) fn add_contact<T: Real>(
        &self,
        of: &Contribution<T, DOFS, DOFS>,
        owner: Owner,
        residual: &mut DVector<T>,
        tangent: &mut DMatrix<T>,
    ) {
        let at: [usize; 2] = [0, 1].map(|k| self.chains[k].node(owner[k]));
        let dof = |i: usize| if i < DOFS { at[0] + i } else { at[1] + i - DOFS };
        for i in 0..2 * DOFS {
            residual[dof(i)] += of.residual.entry(i);
            for j in 0..2 * DOFS {
                tangent[(dof(i), dof(j))] += of.tangent.entry(i, j);
            }
        }
    }

    /// Residual and tangent of the contact.
    fn contact(
        &self,
        u: &DVector<f64>,
        place: &Place,
        history: &History,
        tangent: Tangent,
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
        if tangent == Tangent::EXACT && !slips_on(&outcome, history) {
            return Ok(outcome);
        }
        let decision = decided(&element, &q, &place.point, history, &outcome)?;
        if tangent == Tangent::EXACT {
            contact::closed_form::write(&decision, (&jet, &jet_bar), at, to);
            return Ok(outcome);
        }
        let terms = Terms::new(&decision, (&jet, &jet_bar), at, tangent.components);
        let matrix = match tangent.left_out {
            Some(term) => terms.without(term),
            None if tangent.is_lagged => terms.lagged(),
            None => terms.tangent(),
        };
        for i in 0..2 * DOFS {
            to.residual.set(i, terms.residual[i]);
            for j in 0..2 * DOFS {
                to.tangent.set(i, j, matrix[(i, j)]);
            }
        }
        if tangent.components == Components::Contravariant && terms.state.has_friction() {
            outcome.state = terms.state;
            if let Some(slips) = &mut outcome.next.slips {
                [slips.e, slips.e_bar] = terms.returned;
                slips.is_slipping = terms.state == contact::State::Slip;
            }
        }
        Ok(outcome)
    }

    /// Solves for the free increments; those of given dofs are input. `solution` is that of a matrix and a right side.
    pub(super) fn solve<T: Real>(
        &self,
        (residual, tangent): (&DVector<T>, &DMatrix<T>),
        increment: &mut DVector<T>,
        solution: impl FnOnce(&DMatrix<T>, &DVector<T>) -> Option<DVector<T>>,
    ) -> Option<()> {
        let free = self.free_dofs();
        let right = self.free(&-(residual + tangent * &*increment));
        let matrix = DMatrix::from_fn(free.len(), free.len(), |i, j| tangent[(free[i], free[j])]);
        for (&dof, &by) in free.iter().zip(&solution(&matrix, &right)?) {
            increment[dof] = by;
        }
        Some(())
    }

    pub(super) fn largest_displacement(&self, increment: &DVector<f64>) -> f64 {
        let nodes = self.chains.iter().flat_map(|chain| (0..=chain.elements).map(|node| chain.node(node)));
        nodes.map(|node| increment.fixed_rows::<3>(node).norm()).fold(0.0, f64::max)
    }

    fn free_dofs(&self) -> Vec<usize> {
        let all: usize = self.chains.iter().map(Chain::dofs).sum();
        (0..all).filter(|dof| !self.given.contains(dof)).collect()
    }

    pub(super) fn free<T: Real>(&self, all: &DVector<T>) -> DVector<T> {
        let free = self.free_dofs();
        DVector::from_fn(free.len(), |i, _| all[free[i]])
    }
}

/// The finite solution of a linear system.
fn solved(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    matrix.clone().lu().solve(right).filter(|x| x.iter().all(|x| x.is_finite()))
}

/// Whether a contact that sticks by rounding slips: a step begins on the cone after a slip, and goes on slipping as a rule.
fn slips_on(outcome: &Outcome, history: &History) -> bool {
    outcome.state == contact::State::Stick
        && history.slips.is_some_and(|slips| slips.is_slipping)
        && outcome.values.yield_ratio > -ON_CONE
}

/// The state of a contact, which slips on if it did so before.
pub(super) fn decided<'a>(
    element: &Element<'a, Hermite, Hermite, Law, DOFS, DOFS>,
    q: &DofVector<f64, DOFS, DOFS>,
    point: &ClosestPoint,
    history: &History,
    outcome: &Outcome,
) -> Result<Decision<'a, Law>, ContactError> {
    let decision = element.decide(q, point, history)?;
    if slips_on(outcome, history) {
        return decision.in_state(contact::State::Slip, (point.xi, point.xi_bar));
    }
    Ok(decision)
}
