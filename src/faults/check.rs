//! The checks whose detection is measured.

use super::differences::{Differences, Rule};
use super::test_points::Sample;
use crate::check::serialized::by_name;
use crate::check::{EvaluationPoint, Verdict, judged};
use crate::linearization::closed_form::variations_in;
use crate::linearization::{COMPONENTS, Varied};
use crate::test_beam::RunningError2;
use crate::variant::{Rewrite, Step, Variant, by_invariance};
use std::cell::Cell;

/// A check of derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Check {
    /// Equality with AD over the prime field; regimes do not apply to it.
    Exact,
    /// The gate: AD within derived tolerances.
    Gate,
    /// Symmetry, translation, rotation and the unit of length, within derived tolerances, without a reference.
    Invariants,
    /// Symmetry alone.
    Symmetry,
    /// Finite differences, with the rule of a common tool.
    Differences(Rule),
}

by_name!(Check);

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

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Gate => "gate",
            Self::Invariants => "invariants",
            Self::Symmetry => "symmetry",
            Self::Differences(rule) => rule.name(),
        }
    }

    /// A description of the check.
    pub fn what(self) -> &'static str {
        match self {
            Self::Exact => "closed form and AD over a prime field, compared by ==; regimes do not apply",
            Self::Gate => "closed form and AD in f64, within tolerances derived from rounding",
            Self::Invariants => {
                "symmetry, translation, rotation and unit of length, with the same tolerances"
            }
            Self::Symmetry => "Delta-delta against itself, directions exchanged, with the same tolerances",
            Self::Differences(rule) => rule.what(),
        }
    }

    /// Whether it rejects the variant at this point.
    pub(super) fn rejects(self, variant: &Variant, sample: &Sample) -> bool {
        match self {
            Self::Exact => false,
            Self::Gate => matches!(judged(sample.compared(variant)), Verdict::Mismatch(_)),
            Self::Invariants => {
                let moved = [Rewrite::Moved, Rewrite::Turned, Rewrite::Ninths, Rewrite::DirectionsExchanged];
                let closed = sample.evaluation.closed(variant);
                moved.into_iter().any(|rewrite| is_violated(rewrite, variant, sample, &closed))
            }
            Self::Symmetry => {
                let closed = sample.evaluation.closed(variant);
                is_violated(Rewrite::DirectionsExchanged, variant, sample, &closed)
            }
            Self::Differences(rule) => Differences::new(variant, sample).rejects(rule),
        }
    }
}

/// Whether the variant at other beams differs from its value at these beams by more than rounding.
fn is_violated(
    rewrite: Rewrite,
    variant: &Variant,
    sample: &Sample,
    closed: &[Varied<RunningError2>; COMPONENTS],
) -> bool {
    let EvaluationPoint { at, form, contact, .. } = sample.evaluation;
    // The beams whose values replace operands, moved in the same way.
    let moved = Step::ALL.map(|step| {
        let partial = Cell::new(sample.evaluation.bounded(step));
        let [beam, bar] = &partial.get();
        let keep = |beams: [_; 2], at, form, contact: &_| {
            partial.set(beams);
            variations_in(form, &beams[0], &beams[1], at, contact)
        };
        by_invariance(rewrite, &keep, [beam, bar], at, form, contact);
        partial.get()
    });
    let [beam, bar] = &sample.evaluation.bounded(Step::Now);
    let of = |partial: [_; 2], at: (RunningError2, RunningError2), form, contact: &_| {
        let bounded = variant.formulas(&partial, at, form, contact);
        let plain = |step: Step| {
            let beams = if step == Step::Now { partial } else { moved[step as usize] };
            beams.map(|beam| beam.map(|v| v.map(|number: RunningError2| number.value)))
        };
        let values = variant.quantities(plain, (at.0.value, at.1.value), form, contact);
        // The values with the faults, and the bounds of the formulas without them.
        let mut values = values.components().into_iter().flat_map(Varied::parts);
        bounded.map(|parts| {
            parts.map(|RunningError2 { value, bound }| RunningError2 {
                value: values.next().unwrap_or(value),
                bound,
            })
        })
    };
    let Some(other) = by_invariance(rewrite, &of, [beam, bar], at, form, contact) else { return false };
    let differ = |x: f64, y: RunningError2, bound: f64| {
        let difference = (x - y.value).abs();
        difference > bound + y.bound[0] || difference.is_nan()
    };
    let plain = sample.evaluation.plain(variant);
    plain.iter().zip(closed).zip(other.components()).any(|((plain, closed), other)| {
        let bounds = closed.parts().map(|number| number.bound[0]);
        plain.parts().into_iter().zip(bounds).zip(other.parts()).any(|((x, bound), y)| differ(x, y, bound))
    })
}
