//! The contact element of a case: its parameters, its history, and what it does at the closest point.

mod draw;
mod situation;

use super::evaluation_point::EvaluationPoint;
use crate::contact::ad::{ForceValues, force_values, virtual_work};
use crate::contact::{ContactError, Decision, History, Law, Parameters, State};
use crate::linearization::closed_form::{Formulation, Points};
use crate::linearization::{Quantities, Varied};
use crate::number::{HyperDual, Real};
use crate::pair::Contact;
use crate::test_beam::RunningError2;

pub use situation::ContactSituation;
pub(in crate::check) use situation::ContactSituations;

/// The parameters and the history of a contact element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementData {
    /// Normal law, friction, and its work.
    pub parameters: Parameters,
    /// What the last converged step has left.
    pub history: History,
}

/// State and forces of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::check) struct Forces<T> {
    /// The index of the state.
    pub(in crate::check) state: T,
    pub(in crate::check) f_n: T,
    /// F = T·τ and F̄ = −T·τ̄.
    pub(in crate::check) covariant: [T; 2],
    /// T is the first times τ less the second times τ̄.
    pub(in crate::check) contravariant: [T; 2],
}

impl ElementData {
    /// Checks parameters and history.
    ///
    /// # Errors
    /// [`ContactError`] with the first number that is out of range.
    pub fn check(&self) -> Result<(), ContactError> {
        self.parameters.check()?;
        self.history.check()
    }

    /// The element at a closest point.
    ///
    /// # Errors
    /// [`ContactError`] if the point does not define it.
    pub(in crate::check) fn at(&self, evaluation: &EvaluationPoint) -> Result<ElementAt, ContactError> {
        self.with_contact(evaluation, *evaluation.contact)
    }

    /// The same with other radii.
    pub(in crate::check) fn with_contact(
        &self,
        evaluation: &EvaluationPoint,
        contact: Contact,
    ) -> Result<ElementAt, ContactError> {
        self.check()?;
        let at = ElementAt {
            data: *self,
            points: evaluation.points(),
            contact,
            at: (evaluation.at.0.value, evaluation.at.1.value),
            form: evaluation.form,
            state: None,
        };
        at.decided()?;
        Ok(at)
    }
}

/// A contact element at a closest point.
#[derive(Clone, Debug)]
pub(crate) struct ElementAt {
    data: ElementData,
    points: Points<f64>,
    contact: Contact,
    at: (f64, f64),
    form: Formulation,
    /// The state, if it is not the one of these numbers.
    state: Option<State>,
}

impl ElementAt {
    fn decided(&self) -> Result<Decision<'_, Law>, ContactError> {
        let Self { data: ElementData { parameters, history }, points, contact, at, form, state } = self;
        let decision = Decision::new(parameters, *contact, points, *at, form.held, history)?;
        let decision = Decision { form: *form, ..decision };
        state.map_or(Ok(decision), |state| decision.in_state(state, *at))
    }

    /// Calls `f` with the decision. Nothing if there is none, which [`ElementData::at`] excludes.
    pub(crate) fn with<R>(&self, f: impl FnOnce(&Decision<'_, Law>) -> R) -> Option<R> {
        self.decided().ok().map(|decision| f(&decision))
    }

    pub(in crate::check) fn history(&self) -> &History {
        &self.data.history
    }

    pub(crate) fn state(&self) -> State {
        self.with(|decision| decision.state).unwrap_or(State::Open)
    }

    /// The largest stiffness, for numbers that are exactly zero.
    pub(in crate::check) fn stiffness(&self) -> f64 {
        let (Law::Linear { eps } | Law::Lpqp { eps, .. } | Law::Augmented { eps, .. }) =
            self.data.parameters.law;
        eps.max(self.data.parameters.eps_t)
    }

    /// The same element in the formulas of `form`.
    fn in_formulation(&self, form: Formulation) -> Self {
        Self { form, ..self.clone() }
    }

    /// The element in the other state with friction, if rounding leaves open whether it sticks or slips.
    pub(in crate::check) fn other_state(&self, all: &[Varied<RunningError2>]) -> Option<Self> {
        let other = match self.state() {
            State::Stick => State::Slip,
            State::Slip => State::Stick,
            _ => return None,
        };
        let excess = self.with(|decision| force_values(decision, &Quantities::of_varied(all)))?.excess;
        let is_open = excess.value.abs() <= 2.0 * excess.bound[1];
        is_open.then(|| Self { state: Some(other), ..self.clone() })
    }

    /// R along the directions and K between them as variations, and the forces, from the components of the quantities in any
    /// arithmetic. `form` has the formulas that d came from.
    pub(in crate::check) fn numbers<T: Real>(
        &self,
        all: &[Varied<T>],
        form: Formulation,
    ) -> Option<(Varied<T>, Forces<T>)> {
        let quantities = Quantities::of_varied(all);
        let exchanged = quantities.map(|x| HyperDual::new(x.re, x.eps2, x.eps1, x.eps1eps2));
        self.in_formulation(form).with(|decision| {
            let (along, other) = (virtual_work(decision, &quantities), virtual_work(decision, &exchanged));
            let ForceValues { f_n, covariant, contravariant, .. } = force_values(decision, &quantities);
            let work = Varied { value: T::zero(), delta: along.re, linear: other.re, second: along.eps };
            let state = T::from(index(decision.state));
            (work, Forces { state, f_n, covariant, contravariant })
        })
    }
}

/// The index of a state, as a number.
pub(in crate::check) fn index(state: State) -> f64 {
    f64::from(state as u8)
}
