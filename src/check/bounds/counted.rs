//! The bounds and the true errors at each closest point, counted.

use super::record::{Bounds, Measured, Points, Side, Violation};
use crate::check::distribution::Distribution;
use crate::check::draw::Case;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::regime::Regime;
use crate::check::verdict::{Comparison, Order};
use crate::closest_point::{Search, closest_points};
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::{DoubleDouble, RunningError, RunningErrorBy};
use crate::pair::Contact;
use crate::variant::{G_N, Returned, Variant, scalar_of};
use std::collections::BTreeMap;

/// Errors below this part of the closed form's bound are noise of double-double and count as no error.
const NOISE: f64 = 1e-14;
/// A tolerance above this part of the scale is not meaningful.
const MEANINGFUL: f64 = 1e-3;

/// The counts.
#[derive(Debug, Default)]
pub(super) struct Counted {
    points: BTreeMap<Regime, Points>,
    counts: BTreeMap<(Regime, Side, Order), Counts>,
    violations: BTreeMap<u64, Violation>,
}

/// The orders of the parts of a component.
const ORDERS: [Order; 4] = [Order::Value, Order::First, Order::First, Order::Second];

/// What the functions of the kernel return, with the bounds of the kernel over numbers with bounds.
fn of_kernel(evaluation: &EvaluationPoint, mut add: impl FnMut([usize; 2], RunningError)) {
    let Some((functions, bounds)) = evaluation.kernel() else { return };
    // g_N is d less the sum of the radii.
    let Contact { radius, radius_bar, .. } = *evaluation.contact;
    let radii = RunningError::from(radius) + RunningError::from(radius_bar);
    for (i, parts) in functions.iter().flat_map(|Returned { answers, .. }| answers) {
        for (k, value) in parts.iter().enumerate() {
            let number = scalar_of(*i).and_then(|scalar| bounds[scalar][k]);
            let number = number.map(|d| if (*i, k) == (G_N, 0) { d - radii } else { d });
            if let (Some(value), Some(RunningError { bound, .. })) = (*value, number) {
                add([*i, k], RunningError { value, bound });
            }
        }
    }
}

#[derive(Clone, Debug, Default)]
struct Counts {
    overestimation: Distribution,
    error: Distribution,
    exact: u64,
    unbounded: u64,
}

impl Counted {
    pub(super) fn add(&mut self, case: &Case) {
        let mut points = Points::default();
        let [beam, bar] = case.beams();
        let minima = closest_points(beam, bar, &Search::default()).map(|found| found.minima);
        for point in minima.unwrap_or_default() {
            let evaluation = EvaluationPoint::new([beam, bar], &case.contact, &point).ok();
            let Some((evaluation, precise)) =
                evaluation.and_then(|evaluation| evaluation.precise().map(|precise| (evaluation, precise)))
            else {
                points.left_out += 1;
                continue;
            };
            points.measured += 1;
            points.not_meaningful += u64::from(self.add_point(case, &evaluation, &precise));
        }
        let sum = self.points.entry(case.regime).or_default();
        sum.measured += points.measured;
        sum.not_meaningful += points.not_meaningful;
        sum.left_out += points.left_out;
    }

    /// Measures a point, and returns whether some tolerance is not meaningful there.
    fn add_point(
        &mut self,
        case: &Case,
        evaluation: &EvaluationPoint,
        precise: &[Varied<DoubleDouble>; COMPONENTS],
    ) -> bool {
        let scales = evaluation.scales(&Variant::Unmodified);
        let closed = evaluation.closed(&Variant::Unmodified);
        let sides = [(Side::Closed, closed), (Side::Chord, evaluation.chord())];
        let mut add = |side: Side, [i, k]: [usize; 2], number: RunningError| {
            let error = (DoubleDouble::from(number.value) - precise[i].parts()[k]).abs().value();
            let counts = self.counts.entry((case.regime, side, ORDERS[k])).or_default();
            let noise = NOISE * sides[0].1[i].parts()[k].bound[0];
            let scale = scales[i].parts()[k].scale;
            if !counts.add(number, if error <= noise { 0.0 } else { error }, scale) {
                let (quantity, part) = (Quantity::of_component(i), Varied::<f64>::PARTS[k]);
                self.blame(case.number, Violation { side, quantity, part, bound: number.bound, error });
            }
        };
        let mut not_meaningful = false;
        for of in (0..COMPONENTS).flat_map(|i| (0..ORDERS.len()).map(move |k| [i, k])) {
            let [i, k] = of;
            let mut tolerance = 0.0;
            for (side, numbers) in &sides {
                let RunningErrorBy { value, bound: [bound, _] } = numbers[i].parts()[k];
                tolerance += bound;
                add(*side, of, RunningError { value, bound });
            }
            let scale = MEANINGFUL * scales[i].parts()[k].scale;
            not_meaningful |= !(tolerance <= scale && tolerance.is_finite()) && tolerance != 0.0;
        }
        of_kernel(evaluation, |of, number| add(Side::Kernel, of, number));
        for (comparison, exact) in evaluation.precise_element(&sides[1].1, precise) {
            self.add_element(case, &comparison, exact);
        }
        not_meaningful
    }

    fn add_element(&mut self, case: &Case, comparison: &Comparison, exact: DoubleDouble) {
        let Comparison { quantity, part, other, scale, bound, .. } = *comparison;
        let error = (DoubleDouble::from(other) - exact).abs().value();
        let (order, bound) =
            (if part.starts_with("residual") { Order::First } else { Order::Second }, 2.0 * bound);
        let counts = self.counts.entry((case.regime, Side::Element, order)).or_default();
        if !counts.add(
            RunningError { value: other, bound },
            if error <= NOISE * bound { 0.0 } else { error },
            scale,
        ) {
            self.blame(case.number, Violation { side: Side::Element, quantity, part, bound, error });
        }
    }

    fn blame(&mut self, case: u64, violation: Violation) {
        let excess = |violation: &Violation| violation.error / violation.bound;
        match self.violations.get(&case) {
            Some(known) if excess(known) >= excess(&violation) => {}
            _ => drop(self.violations.insert(case, violation)),
        }
    }

    pub(super) fn merge(mut self, other: Self) -> Self {
        for (key, counts) in &other.counts {
            self.counts.entry(*key).or_default().merge(counts);
        }
        for (regime, points) in &other.points {
            let sum = self.points.entry(*regime).or_default();
            sum.measured += points.measured;
            sum.not_meaningful += points.not_meaningful;
            sum.left_out += points.left_out;
        }
        self.violations.extend(other.violations);
        self
    }

    pub(super) fn bounds(self) -> Bounds {
        let mut all: BTreeMap<_, Counts> = BTreeMap::new();
        let mut regimes: BTreeMap<_, BTreeMap<_, _>> = BTreeMap::new();
        for ((regime, side, order), counts) in &self.counts {
            all.entry((*side, *order)).or_default().merge(counts);
            regimes.entry((*side, *order)).or_default().insert(*regime, counts.measured());
        }
        let all = all.into_iter().map(|(key, counts)| (key, counts.measured())).collect();
        Bounds { points: self.points, all, regimes, violations: self.violations }
    }
}

impl Counts {
    /// Counts a number; false if its bound is violated.
    fn add(&mut self, number: RunningError, error: f64, scale: f64) -> bool {
        if !number.bound.is_finite() {
            self.unbounded += 1;
        } else if error == 0.0 {
            self.exact += 1;
        } else {
            self.overestimation.add(number.bound / error);
            self.error.add(error / scale);
            return error <= number.bound;
        }
        true
    }

    fn merge(&mut self, other: &Self) {
        self.overestimation.merge(&other.overestimation);
        self.error.merge(&other.error);
        self.exact += other.exact;
        self.unbounded += other.unbounded;
    }

    fn measured(&self) -> Measured {
        Measured {
            entries: self.overestimation.count(),
            exact: self.exact,
            unbounded: self.unbounded,
            overestimation: self.overestimation.quantiles(),
            error: self.error.quantiles(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        Case, Comparison, Counted, Counts, DoubleDouble, EvaluationPoint, RunningError, Search,
        closest_points,
    };

    /// Both triangles of a Hessian and both blocks between the beams round differently: in these cases by more than the
    /// bound of those that `Derivatives` stores.
    #[test]
    fn bounds_of_the_kernel_hold_in_every_layout() {
        for (seed, number) in
            [(0x5eed, 1_099_511_630_826), (0x5eed, 1_099_511_632_980), (9, 1_099_511_722_543)]
        {
            let mut counted = Counted::default();
            counted.add(&Case::draw(seed, number));
            assert!(counted.violations.is_empty(), "{seed}, {number}: {:?}", counted.violations);
        }
    }

    /// Inside of both beams a second element is measured, where the centroids cross.
    #[test]
    fn contact_elements_are_measured_where_the_distance_is_zero() {
        let (mut inside, mut with_distance, mut without) = (0, 0, 0);
        for number in 0..33 {
            let case = Case::draw(7, number);
            let [beam, bar] = case.beams();
            for point in closest_points(beam, bar, &Search::default()).map(|found| found.minima).unwrap() {
                let Ok(evaluation) = EvaluationPoint::new([beam, bar], &case.contact, &point) else {
                    continue;
                };
                let Some(precise) = evaluation.precise() else { continue };
                let numbers = evaluation.precise_element(&evaluation.chord(), &precise);
                let is_crossing = |of: &&(Comparison, DoubleDouble)| of.0.against.ends_with("d = 0");
                let crossing = numbers.iter().filter(is_crossing).count();
                inside += usize::from(point.is_interior());
                with_distance += usize::from(numbers.len() > crossing);
                without += usize::from(crossing > 0);
            }
        }
        assert!(
            with_distance > inside && 10 * without > 9 * inside,
            "{with_distance}, {without} of {inside}"
        );
    }

    #[test]
    fn an_error_beyond_its_bound_is_told() {
        let mut counts = Counts::default();
        assert!(counts.add(RunningError::new(1.0, 1e-16), 1e-16, 1.0));
        assert!(counts.add(RunningError::new(1.0, f64::INFINITY), 1e-16, 1.0));
        assert!(counts.add(RunningError::new(0.0, 0.0), 0.0, 1.0));
        assert!(!counts.add(RunningError::new(1.0, 1e-16), 1.1e-16, 1.0));
        assert!(!counts.add(RunningError::new(1.0, 0.0), 1e-30, 1.0));
        assert!(!counts.add(RunningError::new(1.0, 1e-16), f64::NAN, 1.0));
        assert_eq!((counts.exact, counts.unbounded), (1, 1));
    }
}
