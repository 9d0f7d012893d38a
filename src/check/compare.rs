//! One case through both linearizations, entry by entry.

mod doors;

use super::arbitration::DIFFERENCES;
use super::config::{CheckConfig, Oracles};
use super::draw::{Case, place_in_regime};
use super::evaluation_point::EvaluationPoint;
use super::oracle::differences;
use super::verdict::{Comparison, Inconclusive, Order, Verdict, is_decided};
use crate::closest_point::{ClosestPoint, ProjectionError, Search, closest_points};
use crate::linearization::ad::{evaluate, newton, stationary};
use crate::linearization::{COMPONENTS, Quantities, Quantity, Varied};
use crate::number::{RunningError, TermScale};
use crate::pair::Contact;
use crate::source_fault::source_fault;
use crate::test_beam::{AnyBeam, RunningError2};
use crate::variant::{Door, SCALAR_COMPONENTS, SCALARS, Variant};
use num_dual::HyperDual64;

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
}

/// Compares two beams with the oracles, and with what the functions of their own curves return at a closest point.
pub(super) fn compare_beams(
    config: &CheckConfig,
    costly: Costly,
    [beam, bar]: [&dyn AnyBeam; 2],
    contact: &Contact,
    own: &dyn Fn(&ClosestPoint) -> Vec<Door>,
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
    own: &dyn Fn(&ClosestPoint) -> Vec<Door>,
) -> Verdict {
    let (closed, references) = (Closed::new(&config.variant, evaluation), References::new(evaluation));
    let mut entries = closed.compared_with(&references);
    if closed.is_out_of_range() || references.is_out_of_range() {
        return Verdict::Inconclusive(Inconclusive::OutOfRange, entries);
    }
    // Faults are injected into the formulas that the kernel is compared with.
    if config.variant == Variant::Unmodified && !source_fault!("functions-left-out": true, false) {
        entries.extend(closed.kernel(evaluation));
        entries.extend(closed.own(&own(&evaluation.point), evaluation, &references));
        if costly.routes {
            entries.extend(closed.routes(evaluation, &references));
        }
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

/// The closed form under check, with all results that the comparison needs.
pub(crate) struct Closed {
    plain: [Varied<f64>; COMPONENTS],
    exchanged: [Varied<f64>; COMPONENTS],
    scales: [Varied<TermScale>; COMPONENTS],
    bounds: [Varied<RunningError2>; COMPONENTS],
    matrices: [[RunningError; 3]; SCALARS],
}

/// Automatic differentiation: two routes of num-dual, and our own numbers with bounds.
pub(crate) struct References {
    newton: [Varied<f64>; COMPONENTS],
    stationary: [Varied<f64>; COMPONENTS],
    chord: [Varied<RunningError2>; COMPONENTS],
}

/// Products below this scale may have lost digits to underflow.
const SMALLEST: f64 = 1e-280;

fn is_finite(varied: &Varied<RunningError2>) -> bool {
    varied.parts().iter().all(|part| part.value.is_finite())
}

impl References {
    /// Whether some number overflows.
    fn is_out_of_range(&self) -> bool {
        !self.chord.iter().all(is_finite)
    }

    /// Differentiates at a closest point.
    pub(crate) fn new(evaluation: &EvaluationPoint) -> Self {
        let EvaluationPoint { beams: [beam, bar], held, at: (xi, xi_bar), .. } = *evaluation;
        let at = (xi.value, xi_bar.value);
        Self {
            newton: hyper_dual(evaluation, newton(beam, bar, at, held)),
            stationary: hyper_dual(evaluation, stationary(beam, bar, at, held)),
            chord: evaluation.chord(),
        }
    }
}

impl Closed {
    /// Evaluates the closed form at a closest point.
    pub(crate) fn new(variant: &Variant, evaluation: &EvaluationPoint) -> Self {
        Self {
            plain: evaluation.plain(variant),
            exchanged: evaluation.exchanged(variant),
            scales: evaluation.scales(variant),
            bounds: evaluation.closed(variant),
            matrices: evaluation.matrices(variant),
        }
    }

    /// Whether some number of the closed form without faults overflows, or some term underflows.
    fn is_out_of_range(&self) -> bool {
        let is_out =
            |scale: TermScale| !scale.scale.is_finite() || (scale.scale > 0.0 && scale.scale < SMALLEST);
        !self.bounds.iter().all(is_finite)
            || self.scales.iter().any(|scale| scale.parts().into_iter().any(is_out))
    }

    /// All comparisons at one closest point.
    pub(crate) fn compared_with(&self, references: &References) -> Vec<Comparison> {
        let mut entries = Vec::with_capacity(16 * COMPONENTS);
        for i in 0..COMPONENTS {
            let (quantity, axis) = (Quantity::of_component(i), Quantity::axis_of_component(i));
            let closed = self.plain[i].parts();
            let scale = self.scales[i].parts().map(|scale| scale.scale);
            let bounds = self.bounds[i].parts().map(|bounded| bounded.bound);
            let bound = bounds.map(|[bound, _]| bound);
            let own = references.chord[i].parts();
            let routes = [
                references.newton[i].parts(),
                references.stationary[i].parts(),
                own.map(|bounded| bounded.value),
            ];
            // num-dual solves for the closest point in `f64` again, so its bound includes the resulting error.
            let [near, far] =
                [0, 1].map(|l| std::array::from_fn::<f64, 4, _>(|k| bounds[k][l] + own[k].bound[l]));
            for ((against, other), tolerance) in ROUTES.into_iter().zip(routes).zip([far, far, near]) {
                for (k, order) in
                    [Order::Value, Order::First, Order::First, Order::Second].into_iter().enumerate()
                {
                    entries.push(Comparison {
                        quantity,
                        axis,
                        order,
                        part: Varied::<f64>::PARTS[k],
                        against,
                        closed: closed[k],
                        other: other[k],
                        scale: scale[k],
                        bound: bound[k],
                        tolerance: tolerance[k],
                    });
                }
            }
            if !source_fault!("symmetry-left-out": true, false) {
                entries.push(self.symmetry(i));
            }
        }
        entries.extend((0..SCALARS).flat_map(|i| self.matrix(i)));
        entries
    }

    /// A second variation against itself with the directions exchanged.
    pub(crate) fn symmetry(&self, i: usize) -> Comparison {
        Comparison {
            quantity: Quantity::of_component(i),
            axis: Quantity::axis_of_component(i),
            order: Order::Symmetry,
            part: Varied::<f64>::PARTS[3],
            against: "itself, directions exchanged",
            closed: self.plain[i].second,
            other: self.exchanged[i].second,
            scale: self.scales[i].second.scale,
            bound: self.bounds[i].second.bound[0],
            tolerance: 2.0 * self.bounds[i].second.bound[0],
        }
    }

    /// Gradient and Hessian of a scalar, contracted with the directions, against the variations.
    fn matrix(&self, scalar: usize) -> [Comparison; 3] {
        [1, 2, 3].map(|k| self.contracted(MATRICES, [scalar, k], self.matrices[scalar][k - 1]))
    }

    /// A contracted part of a scalar, against the variation.
    fn contracted(&self, against: &'static str, [scalar, k]: [usize; 2], other: RunningError) -> Comparison {
        let i = SCALAR_COMPONENTS[scalar];
        let bound = self.bounds[i].parts()[k].bound[0];
        Comparison {
            quantity: Quantity::of_component(i),
            axis: None,
            order: Order::Matrix,
            part: Varied::<f64>::PARTS[k],
            against,
            closed: self.plain[i].parts()[k],
            other: other.value,
            scale: self.scales[i].parts()[k].scale,
            bound,
            tolerance: bound + other.bound,
        }
    }
}

fn hyper_dual(evaluation: &EvaluationPoint, lifted: (HyperDual64, HyperDual64)) -> [Varied<f64>; COMPONENTS] {
    let [beam, bar] = evaluation.beams;
    let quantities: Quantities<HyperDual64> = evaluate(beam, bar, lifted, evaluation.contact);
    quantities.map(Varied::from).components()
}

#[cfg(test)]
mod tests;
