//! Detection limits: the smallest relative error of a term that the gate detects.

use super::test_points::{Sample, test_points};
use crate::check::serialized::short;
use crate::check::{Comparison, Regime};
use crate::number::Label;
use crate::parallel;
use crate::variant::{Variant, catalogue};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The relative change of a term that measures sensitivity: large compared with rounding, small enough to be linear.
pub(super) const NUDGE: f64 = 1.0 / 1024.0;

/// The smallest relative error that exceeds a tolerance, at the most sensitive point. Two digits of it are written.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Limit(#[serde(with = "short")] pub f64);

/// The detection limits of all terms in these regimes, by the name of the term.
pub fn limits(seed: u64, regimes: &[Regime]) -> BTreeMap<String, BTreeMap<Regime, Limit>> {
    let of_regime = |&regime: &Regime| {
        let points = test_points(seed, regime);
        let samples: Vec<_> =
            points.iter().flat_map(|(case, point)| Sample::in_all_forms(case, point)).collect();
        let named = |(label, limit, _): (Label, Limit, usize)| (label.to_string(), regime, limit);
        of_terms(&samples).into_iter().map(named).collect::<Vec<_>>()
    };
    let mut all: BTreeMap<_, BTreeMap<_, _>> = BTreeMap::new();
    for (term, regime, limit) in parallel::flat_map(regimes, of_regime) {
        all.entry(term).or_default().insert(regime, limit);
    }
    all
}

/// The detection limit of each term, and the number of the sample with it.
pub(super) fn of_terms(samples: &[Sample<'_>]) -> Vec<(Label, Limit, usize)> {
    let mut labels: Vec<_> = catalogue().into_iter().map(|fault| fault.label).collect();
    labels.dedup();
    let unmodified = parallel::map(samples, |sample| sample.compared(&Variant::Unmodified));
    let limit = |&label: &Label| {
        let nudged = Variant::Weighted(label, 1.0 + NUDGE);
        let at = |i: usize| (smallest(&unmodified[i], &samples[i].compared(&nudged)), i);
        let (limit, i) = (0..samples.len()).map(at).min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((label, Limit(limit), i))
    };
    parallel::filter_map(&labels, limit)
}

/// The relative error at which some entry exceeds its tolerance.
fn smallest(unmodified: &[Comparison], nudged: &[Comparison]) -> f64 {
    unmodified
        .iter()
        .zip(nudged)
        .map(|(unmodified, nudged)| sensitivity(unmodified, nudged))
        .fold(f64::INFINITY, f64::min)
}

/// The relative error at which this entry exceeds its tolerance, from the change that a nudge causes.
pub(super) fn sensitivity(unmodified: &Comparison, nudged: &Comparison) -> f64 {
    // Both sides of an entry may change: for a matrix entry, both are from the closed form.
    let before = unmodified.closed - unmodified.other;
    let change = (nudged.closed - nudged.other - before).abs() / NUDGE;
    if unmodified.is_meaningful() && change > 0.0 { unmodified.tolerance / change } else { f64::INFINITY }
}
