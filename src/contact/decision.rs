//! The state of a contact, decided once in `f64`. After that both methods evaluate formulas without a branch.

use super::geometry::{Gap, Trial};
use super::values::Values;
use super::{ContactError, History, NormalLaw, Parameters, Slips, Start};
use crate::closest_point::Held;
use crate::linearization::closed_form::{Formulation, Points};
use crate::number::Real;
use crate::pair::Contact;

enumeration! {
    /// The state of a contact.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum State {
        /// No contact: residual and tangent are zero.
        Open => "open",
        /// Contact without friction: mu = 0, the first step of a contact, or both parameters held.
        Frictionless => "frictionless",
        /// The trial force lies in Coulomb's cone.
        Stick => "stick",
        /// The trial force lies outside, and is scaled back to the cone.
        Slip => "slip",
    }
}

impl State {
    /// Whether friction acts.
    pub fn has_friction(self) -> bool {
        matches!(self, Self::Stick | Self::Slip)
    }
}

/// All that is decided about a contact at a point, and the constants of the step.
#[derive(Debug)]
pub struct Decision<'a, L: NormalLaw> {
    /// The parameters of the element.
    pub parameters: &'a Parameters<L>,
    /// The radii.
    pub contact: Contact,
    /// The start of the slips, if friction is possible.
    pub start: Option<Start>,
    /// The state.
    pub state: State,
    /// The piece of the normal law; none if open.
    pub piece: Option<L::Piece>,
    /// The held parameters, and the formulas of the geometry.
    pub form: Formulation,
    /// Whether the beam is on the other side of the bar beam, so that n is against d and d_s < 0.
    pub is_crossed: bool,
}

impl<L: NormalLaw> Clone for Decision<'_, L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L: NormalLaw> Copy for Decision<'_, L> {}

/// From this cosine on, the normal tells the side.
const TURNED: f64 = std::f64::consts::FRAC_1_SQRT_2;

impl<'a, L: NormalLaw> Decision<'a, L> {
    /// Decides at contact points.
    pub(crate) fn new(
        parameters: &'a Parameters<L>,
        contact: Contact,
        points: &Points<f64>,
        at: (f64, f64),
        held: Held,
        history: &History,
    ) -> Result<Self, ContactError> {
        let form = Formulation::at(points, held);
        let mut decision = Self {
            parameters,
            contact,
            start: None,
            state: State::Open,
            piece: None,
            form,
            is_crossed: false,
        };
        let mut gap = decision.gap(points);
        if let Some(previous) = history.normal {
            let cosine = gap.n.dot(&previous);
            if cosine.abs() < TURNED {
                return Err(ContactError::NormalTurned { cosine });
            }
            decision.is_crossed = cosine < 0.0;
            if decision.is_crossed {
                gap = decision.gap(points);
            }
        }
        let in_range = |name, value: f64, least: f64| {
            if value >= least && value.is_finite() {
                Ok(value)
            } else {
                Err(ContactError::Result { name, value })
            }
        };
        let g_n = in_range("g_N", gap.g_n, f64::NEG_INFINITY)?;
        decision.piece = parameters.law.piece(g_n);
        let Some(piece) = decision.piece else { return Ok(decision) };
        let f_n = in_range("F_N", parameters.law.force(piece, g_n), 0.0)?;
        in_range("k", parameters.law.stiffness(piece, g_n), f64::NEG_INFINITY)?;
        decision.state = State::Frictionless;
        decision.start =
            if parameters.mu > 0.0 && !(held.xi && held.xi_bar) { history.start(held) } else { None };
        let Some(start) = decision.start else { return Ok(decision) };
        let trial = Trial::new(points, at, held, &start);
        // Φ = ε_T γ − μ F_N, and Φ = 0 sticks.
        let force = in_range("eps_T gamma", parameters.eps_t * trial.gamma, 0.0)?;
        decision.state = if force > parameters.mu * f_n { State::Slip } else { State::Stick };
        Ok(decision)
    }

    /// The same contact in another state with friction.
    ///
    /// At the cone both states have the same residual, and the tangents of the two sides.
    ///
    /// # Errors
    /// [`ContactError::BothHeld`] for stick and slip of two ends, and [`ContactError::History`] if there are no slips.
    pub fn in_state(self, state: State, at: (f64, f64)) -> Result<Self, ContactError> {
        let Held { xi, xi_bar } = self.form.held;
        if state.has_friction() && xi && xi_bar {
            return Err(ContactError::BothHeld { xi: at.0, xi_bar: at.1 });
        }
        if state.has_friction() && self.start.is_none() {
            return Err(ContactError::History { name: "slips", value: f64::NAN });
        }
        Ok(Self { state, ..self })
    }

    /// The history of the next step, if this state is the converged one.
    pub(crate) fn next_history(
        &self,
        points: &Points<f64>,
        (xi, xi_bar): (f64, f64),
        values: &Values<f64>,
    ) -> History {
        let memory = self.parameters.normal_memory;
        let remembers =
            self.state != State::Open || memory == f64::INFINITY || points.d.norm() <= memory * self.radii();
        let slips = || Slips {
            xi,
            xi_bar,
            e: values.e,
            e_bar: values.e_bar,
            held: self.form.held,
            cosine: points.beam.t.dot(&points.bar.t) / (points.beam.t.norm() * points.bar.t.norm()),
            is_slipping: self.state == State::Slip,
        };
        History { normal: remembers.then_some(values.normal), slips: (self.state != State::Open).then(slips) }
    }

    /// The gap at these points.
    pub(super) fn gap<T: Real>(&self, points: &Points<T>) -> Gap<T> {
        Gap::new(points, self.form, self.is_crossed, self.contact)
    }

    /// r + r_bar.
    pub(super) fn radii(&self) -> f64 {
        self.contact.radius + self.contact.radius_bar
    }

    /// The piece of the law and its start, as far as a force acts.
    pub(crate) fn acting(&self) -> Option<(L::Piece, Option<Start>)> {
        let start = if self.state.has_friction() { self.start } else { None };
        if self.state == State::Open { None } else { Some((self.piece?, start)) }
    }
}
