//! One case through both linearizations, entry by entry.

mod closed;
mod functions;

use super::arbitration::DIFFERENCES;
use super::config::{CheckConfig, Oracles};
use super::draw::{Case, place_in_regime};
use super::element::ContactSituation;
use super::evaluation_point::EvaluationPoint;
use super::oracle::differences;
use super::verdict::{Comparison, Inconclusive, Verdict, is_decided};
use crate::closest_point::{ClosestPoint, ProjectionError, Search, closest_points};
use crate::linearization::Varied;
use crate::pair::Contact;
use crate::source_fault::source_fault;
use crate::test_beam::AnyBeam;
use crate::variant::{Returned, Variant};

pub(crate) use closed::{Closed, References};

/// The routes of automatic differentiation.
pub(super) const ROUTES: [&str; 3] =
    ["hyper-dual, Newton", "hyper-dual, stationary", "own hyper-dual, chord"];

/// The name of the matrices in [`Comparison::against`].
pub(super) const MATRICES: &str = "gradient and Hessian";

/// A verdict for each closest point, and one without a point if there is none or there may be more.
pub type Compared = Vec<(Option<ClosestPoint>, Verdict)>;

/// Compares a case with the oracles at each of its closest points.
pub fn compare(config: &CheckConfig, case: &Case) -> Compared {
    compare_beams(config, Costly::of_case(config, case.number), case.beams(), &case.contact, &|_| Vec::new())
}

/// What takes long and is computed for a sample of the cases.
#[derive(Clone, Copy, Debug)]
pub(super) struct Costly {
    /// The differences in double-double.
    pub(super) differences: bool,
    /// The functions for any curve and all routes of automatic differentiation.
    pub(super) routes: bool,
}

/// All routes are compared in one of this many cases of each regime. It has no factor in common with the 121 pairs of
/// families, so all pairs are reached.
const ROUTES_EVERY: u64 = 8;

impl Costly {
    fn of_case(config: &CheckConfig, number: u64) -> Self {
        let differences = config.oracles.asks_differences(number);
        Self { differences, routes: compares_routes(number) }
    }
}

/// Whether all routes are compared in the case of this number.
pub(crate) fn compares_routes(number: u64) -> bool {
    place_in_regime(number).is_multiple_of(ROUTES_EVERY)
}

impl Comparison {
    /// Whether the reference is the differences in double-double.
    pub(crate) fn is_by_differences(&self) -> bool {
        self.against == DIFFERENCES
    }

    /// Whether it is wrong if the other number is larger by `by`.
    pub(crate) fn is_wrong_with(&self, by: f64) -> bool {
        Self { other: self.other + by, ..*self }.is_wrong()
    }

    /// Whether it is of a contact element with d = 0.
    pub(crate) fn is_with_crossing(&self) -> bool {
        self.situations.iter().any(|situation| situation == ContactSituation::ZeroDistance)
    }
}

/// Compares two beams with the oracles, and with what the functions of their own curves return at a closest point.
pub(super) fn compare_beams(
    config: &CheckConfig,
    costly: Costly,
    [beam, bar]: [&dyn AnyBeam; 2],
    contact: &Contact,
    own: &dyn Fn(&ClosestPoint) -> Vec<Returned>,
) -> Compared {
    let found = match closest_points(beam, bar, &Search::default()) {
        Ok(found) => found,
        Err(ProjectionError::ZeroTangent { .. }) => {
            return vec![(None, Verdict::Inconclusive(Inconclusive::ZeroTangent, Vec::new()))];
        }
        Err(_) => return vec![(None, Verdict::Inconclusive(Inconclusive::SearchFailed, Vec::new()))],
    };
    let at_point = |point: &ClosestPoint| match EvaluationPoint::new([beam, bar], contact, point) {
        Ok(evaluation) => verdict(config, costly, &evaluation, own),
        Err(reason) => Verdict::Inconclusive(reason, Vec::new()),
    };
    let compared = source_fault!("only-the-first": 1, found.minima.len());
    let minima = found.minima.iter().take(compared);
    let mut verdicts: Vec<_> = minima.map(|point| (Some(*point), at_point(point))).collect();
    if !found.unresolved.is_empty() || verdicts.is_empty() {
        verdicts.push((None, Verdict::Inconclusive(Inconclusive::Unresolved, Vec::new())));
    }
    verdicts
}

fn verdict(
    config: &CheckConfig,
    costly: Costly,
    evaluation: &EvaluationPoint,
    own: &dyn Fn(&ClosestPoint) -> Vec<Returned>,
) -> Verdict {
    let (closed, references) = (Closed::new(&config.variant, evaluation), References::new(evaluation));
    let mut entries = closed.compared_with(&references);
    if closed.is_out_of_range() || references.is_out_of_range() {
        return Verdict::Inconclusive(Inconclusive::OutOfRange, entries);
    }
    // Faults are injected into the formulas that the kernel is compared with.
    if config.variant == Variant::Unmodified && !source_fault!("functions-left-out": true, false) {
        let own = own(&evaluation.point);
        entries.extend(closed.functions(evaluation, &references, &own, costly.routes));
    }
    let unclear = config.oracles != Oracles::Ad && !is_decided(entries.iter());
    if is_apart(&entries) || unclear || costly.differences {
        by_differences(evaluation, &mut entries);
    }
    judged(entries)
}

/// The verdict from the entries of a closest point.
pub(crate) fn judged(entries: Vec<Comparison>) -> Verdict {
    if is_apart(&entries) {
        Verdict::Mismatch(entries)
    } else if is_decided(entries.iter()) {
        Verdict::Pass(entries)
    } else {
        Verdict::Inconclusive(Inconclusive::NotMeaningful, entries)
    }
}

/// Whether some entry differs beyond rounding.
fn is_apart(entries: &[Comparison]) -> bool {
    entries.iter().any(Comparison::is_wrong)
}

/// Adds the comparisons with the differences, where they exist.
fn by_differences(evaluation: &EvaluationPoint, entries: &mut Vec<Comparison>) {
    let Some(differences) = differences(evaluation) else { return };
    // All components are compared with the first route, part by part.
    let first: Vec<_> = entries.iter().filter(|entry| entry.against == ROUTES[0]).copied().collect();
    let told = differences.into_iter().flat_map(Varied::parts);
    entries.extend(first.into_iter().zip(told).map(|(entry, told)| {
        let other = told.value.value();
        // Half an ulp is added for the `f64` that shows the double-double number.
        let tolerance = entry.bound + told.error + 0.5 * f64::EPSILON * other.abs();
        Comparison { against: DIFFERENCES, other, tolerance, ..entry }
    }));
}

#[cfg(test)]
mod tests;
