//! Residual and tangent of a contact element over the field.
//!
//! The field has no order, so the state is drawn. The start of the slips is drawn until the trial force has a square root.

use super::Element;
use crate::closest_point::Held;
use crate::contact::ad::virtual_work;
use crate::contact::{
    Contribution, Decision, Law, Parameters, Piece, Start, State, Work, closed_form, contracted,
};
use crate::linearization::closed_form::{Formulation, Points};
use crate::linearization::{Quantities, Varied};
use crate::number::{HyperDual, PrimeField, Real};
use crate::pair::{Contact, DofVector};
use crate::test_beam::{DOFS, PaddedBeam};
use crate::variant::CONTACT;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// A contact element in a given state.
#[derive(Debug)]
pub(crate) struct Situation {
    parameters: Parameters,
    start: Start,
    state: State,
    piece: Piece,
    is_crossed: bool,
}

impl Situation {
    /// Draws an element for a point with these tangents.
    pub(super) fn draw(
        points: &Points<PrimeField>,
        at: (PrimeField, PrimeField),
        held: Held,
        rng: &mut ChaCha8Rng,
    ) -> Self {
        let states: &[State] = if held.xi && held.xi_bar {
            &[State::Frictionless]
        } else {
            &[State::Frictionless, State::Stick, State::Slip]
        };
        let state = states[rng.random_range(0..states.len())];
        let (eps, g_0) = (dyadic(rng), dyadic(rng));
        let law = match rng.random_range(0..3_u8) {
            0 => Law::Linear { eps },
            1 => Law::Lpqp { eps, g_0 },
            _ => Law::Augmented { eps, lambda: dyadic(rng) },
        };
        // A square, so that eps_T times the root of gamma^2 is the root of eps_T^2 gamma^2 in the field.
        let mut parameters = Parameters::with_friction(law, dyadic(rng).powi(2), dyadic(rng));
        parameters.work = if rng.random() { Work::Rate } else { Work::Paper };
        let piece = if rng.random() { Piece::Parabola } else { Piece::Line };
        let is_crossed = rng.random();
        let start = loop {
            let e = |is_held: bool, e: f64| if is_held { 0.0 } else { e };
            let start = Start {
                xi: dyadic(rng),
                xi_bar: dyadic(rng),
                e: e(held.xi, dyadic(rng)),
                e_bar: e(held.xi_bar, dyadic(rng)),
            };
            if state != State::Slip || has_length(points, at, held, &start) {
                break start;
            }
        };
        Self { parameters, start, state, piece, is_crossed }
    }

    /// An element in this state, with a force on the parabola.
    pub(crate) fn of_state(state: State, work: Work, held: Held) -> Self {
        let law = Law::Lpqp { eps: 2.5, g_0: 1.5 };
        let e = |is_held: bool, e: f64| if is_held { 0.0 } else { e };
        let start = Start { xi: 0.25, xi_bar: -0.75, e: e(held.xi, 0.5), e_bar: e(held.xi_bar, 0.625) };
        let parameters = Parameters { work, ..Parameters::with_friction(law, 3.5, 0.375) };
        Self { parameters, start, state, piece: Piece::Parabola, is_crossed: false }
    }

    /// An element whose residual and tangent have the highest degrees.
    pub(super) fn of_highest_degree(held: Held) -> Self {
        let state = if held.xi && held.xi_bar { State::Frictionless } else { State::Slip };
        Self::of_state(state, Work::Rate, held)
    }

    pub(crate) fn decision(&self, contact: Contact, form: Formulation) -> Decision<'_, Law> {
        let Self { ref parameters, start, state, piece, is_crossed } = *self;
        Decision { parameters, contact, start: Some(start), state, piece: Some(piece), form, is_crossed }
    }

    /// Both sides: the residual along both directions, and the tangent between them in both orders.
    pub(super) fn sides<T: Real>(
        &self,
        [(jet, vectors), (jet_bar, vectors_bar)]: &[PaddedBeam<T>; 2],
        at: (T, T),
        form: Formulation,
        ad: &[Varied<T>],
    ) -> Element<T> {
        let decision = self.decision(CONTACT, form);
        let directions = |k: usize| DofVector { beam: vectors[k], bar: vectors_bar[k] };
        let mut to = Box::new(Contribution::<T, DOFS, DOFS>::zeros());
        closed_form::write(&decision, (jet, jet_bar), at, &mut to);
        let closed = contracted(&to.residual, &to.tangent, &[directions(1), directions(2)]);
        let quantities = Quantities::of_varied(ad);
        let exchanged = quantities.map(|x| HyperDual::new(x.re, x.eps2, x.eps1, x.eps1eps2));
        let (along, other) = (virtual_work(&decision, &quantities), virtual_work(&decision, &exchanged));
        Element { candidate: candidate(self.state), closed, ad: [along.re, other.re, along.eps, other.eps] }
    }
}

fn candidate(state: State) -> &'static str {
    match state {
        State::Open => "contact element, open",
        State::Frictionless => "contact element, frictionless",
        State::Stick => "contact element, stick",
        State::Slip => "contact element, slip",
    }
}

/// A number that is not zero.
fn dyadic(rng: &mut ChaCha8Rng) -> f64 {
    f64::from(rng.random_range(1..=1 << 20)) / 1024.0
}

/// Whether the trial force has a length in the field.
fn has_length(points: &Points<PrimeField>, at: (PrimeField, PrimeField), held: Held, start: &Start) -> bool {
    let along = |t: &nalgebra::Vector3<PrimeField>, xi: PrimeField, start: f64, e: f64, is_held: bool| {
        let slip = if is_held { PrimeField::new(0) } else { xi - PrimeField::from(start) };
        t * (slip + PrimeField::from(e) / t.dot(t).sqrt())
    };
    let trial = along(&points.beam.t, at.0, start.xi, start.e, held.xi)
        - along(&points.bar.t, at.1, start.xi_bar, start.e_bar, held.xi_bar);
    let square = trial.dot(&trial);
    square.is_square() && square != PrimeField::new(0)
}
