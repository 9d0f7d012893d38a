//! The checks that are put to the test.

use super::differences::{Differences, Rule};
use super::panel::Sample;
use crate::check::{Site, Verdict, When, judged};
use crate::linearization::closed_form::{Sound, variations_with};
use crate::linearization::{COMPONENTS, Varied};
use crate::specimen::Bounded2;
use crate::subject::{Rewrite, Subject, by_invariance};
use std::cell::Cell;

/// A way of checking derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Check {
    /// Equality with AD over the prime field; it knows no regime.
    Exact,
    /// The gate: AD within derived tolerances.
    Gate,
    /// Symmetry, translation, rotation and the unit of length, within derived tolerances, and no reference.
    Invariants,
    /// Symmetry alone.
    Symmetry,
    /// Finite differences, by the rule of a common tool.
    Differences(Rule),
}

impl Check {
    /// All checks.
    pub const ALL: [Self; 8] = [
        Self::Exact,
        Self::Gate,
        Self::Invariants,
        Self::Symmetry,
        Self::Differences(Rule::Torch),
        Self::Differences(Rule::Jax),
        Self::Differences(Rule::SciPy),
        Self::Differences(Rule::Taylor),
    ];

    /// The name, as tables have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Gate => "gate",
            Self::Invariants => "invariants",
            Self::Symmetry => "symmetry",
            Self::Differences(rule) => rule.name(),
        }
    }

    /// What it does, in words.
    pub fn what(self) -> &'static str {
        match self {
            Self::Exact => "closed form and AD over a prime field, compared by ==; it knows no regime",
            Self::Gate => "closed form and AD in f64, within tolerances derived from rounding",
            Self::Invariants => {
                "symmetry, translation, rotation and unit of length, with the same tolerances"
            }
            Self::Symmetry => "Delta-delta against itself, directions exchanged, with the same tolerances",
            Self::Differences(rule) => rule.what(),
        }
    }

    /// Whether it accuses the subject at this point.
    pub(super) fn accuses(self, subject: &Subject, sample: &Sample) -> bool {
        match self {
            Self::Exact => false,
            Self::Gate => matches!(judged(sample.compared(subject)), Verdict::Mismatch(_)),
            Self::Invariants => {
                let moved = [Rewrite::Moved, Rewrite::Turned, Rewrite::Ninths, Rewrite::DirectionsExchanged];
                let closed = sample.site.closed(subject);
                moved.into_iter().any(|rewrite| is_violated(rewrite, subject, sample, &closed))
            }
            Self::Symmetry => {
                let closed = sample.site.closed(subject);
                is_violated(Rewrite::DirectionsExchanged, subject, sample, &closed)
            }
            Self::Differences(rule) => Differences::new(subject, sample).accuses(rule),
        }
    }
}

/// Whether the subject at other beams is not what it is at these, beyond rounding.
fn is_violated(
    rewrite: Rewrite,
    subject: &Subject,
    sample: &Sample,
    closed: &[Varied<Bounded2>; COMPONENTS],
) -> bool {
    let Site { at, form, contact, .. } = sample.site;
    // The beams of the step before, moved alike.
    let moved = Cell::new(sample.site.bounded(When::Before));
    let [beam, bar] = &sample.site.bounded(When::Before);
    let keep = |frozen: [_; 2], at, form, contact: &_| {
        moved.set(frozen);
        variations_with(&Sound, &frozen[0], &frozen[1], at, form, contact)
    };
    by_invariance(rewrite, &keep, [beam, bar], at, form, contact);

    let [beam, bar] = &sample.site.bounded(When::Now);
    let of = |frozen: [_; 2], at, form, contact: &_| {
        subject.quantities(&frozen, || moved.get(), at, form, contact)
    };
    let Some(other) = by_invariance(rewrite, &of, [beam, bar], at, form, contact) else { return false };
    let differ = |x: Bounded2, y: Bounded2| {
        let difference = (x.value - y.value).abs();
        difference > x.bound[0] + y.bound[0] || difference.is_nan()
    };
    closed
        .iter()
        .zip(other.components())
        .any(|(closed, other)| closed.parts().into_iter().zip(other.parts()).any(|(x, y)| differ(x, y)))
}
