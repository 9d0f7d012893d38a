//! What a compared contact element is an example of.

use super::ElementAt;
use crate::check::serialized::by_name;
use crate::closest_point::Held;
use crate::contact::{State, Work};

enumeration! {
    /// A state, or a circumstance, of a contact element. An element is in several.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum ContactSituation {
        /// No force.
        Open => "open",
        /// A force without friction.
        Frictionless => "frictionless",
        /// Stick.
        Stick => "stick",
        /// Slip.
        Slip => "slip",
        /// Stick with -1e-5 < Phi/(mu F_N) <= 0.
        StickAtCone => "stick, at the cone",
        /// Slip with Phi/(mu F_N) < 1e-5.
        SlipAtCone => "slip, at the cone",
        /// One parameter is held at an end.
        OneHeld => "one end held",
        /// Both are held.
        BothHeld => "both ends held",
        /// In contact on the other side than before.
        Crossed => "crossed",
        /// The bar beam is moved until the centroids cross.
        ZeroDistance => "d = 0",
        /// A slip of the step by more than 1 in a parameter: half of a beam.
        LargeSlip => "large slip",
        /// Friction with the work of the rate of slip.
        RateWork => "work: rate",
        /// Friction with the work of the paper.
        PaperWork => "work: paper",
    }
}

by_name!(ContactSituation);

/// A set of situations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::check) struct ContactSituations(u16);

impl ContactSituations {
    /// Those of a number that is none of a contact element.
    pub(in crate::check) const NONE: Self = Self(0);

    /// The situations in the set.
    pub(in crate::check) fn iter(self) -> impl Iterator<Item = ContactSituation> {
        ContactSituation::ALL.into_iter().filter(move |&situation| self.0 & bit(situation) != 0)
    }

    /// The set with a situation, if the element is in it.
    fn with(self, situation: ContactSituation, is: bool) -> Self {
        if is { Self(self.0 | bit(situation)) } else { self }
    }

    /// The situations of an element with this Phi/(mu F_N).
    pub(in crate::check) fn of(element: &ElementAt, is_crossing: bool, yield_ratio: f64) -> Self {
        use ContactSituation as Is;
        let ElementAt { data, at, form, .. } = element;
        let (state, Held { xi, xi_bar }) = (element.state(), form.held);
        let acts = state != State::Open;
        let is_at_cone = yield_ratio.abs() < 1e-5;
        let slip = data.history.slips.map_or(0.0, |slips| {
            let of = |is_held: bool, now: f64, before: f64| if is_held { 0.0 } else { (now - before).abs() };
            of(xi, at.0, slips.xi).max(of(xi_bar, at.1, slips.xi_bar))
        });
        let of_state = match state {
            State::Open => Is::Open,
            State::Frictionless => Is::Frictionless,
            State::Stick => Is::Stick,
            State::Slip => Is::Slip,
        };
        Self::NONE
            .with(of_state, true)
            .with(Is::StickAtCone, state == State::Stick && is_at_cone)
            .with(Is::SlipAtCone, state == State::Slip && is_at_cone)
            .with(Is::OneHeld, acts && xi != xi_bar)
            .with(Is::BothHeld, acts && xi && xi_bar)
            .with(
                Is::Crossed,
                acts && !is_crossing && element.with(|decision| decision.is_crossed) == Some(true),
            )
            .with(Is::ZeroDistance, acts && is_crossing)
            .with(Is::LargeSlip, state.has_friction() && slip > 1.0)
            .with(Is::RateWork, state.has_friction() && data.parameters.work == Work::Rate)
            .with(Is::PaperWork, state.has_friction() && data.parameters.work == Work::Paper)
    }
}

fn bit(situation: ContactSituation) -> u16 {
    1 << situation as u16
}

impl Default for ContactSituations {
    fn default() -> Self {
        Self::NONE
    }
}
