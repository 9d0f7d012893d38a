//! A sample with the values of all formulas, and the answers of the program.

use super::changes::Change;
use super::list::FORMULAS;
use super::tree::Name;
use super::values::Value;
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use std::collections::BTreeMap;

/// The rounding of an explanation over the difference that it explains.
const CLEAR: f64 = 1e-2;
/// The rounding of an explanation over that of the right formulas.
const COARSER: f64 = 1e3;

/// The rounding of an explanation over the largest answer of its kind.
const FINE: f64 = 1e-9;

/// A number of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    pub(super) number: RunningError,
    /// The largest number of its kind in all samples.
    size: f64,
}

pub(super) struct Point<'a> {
    pub(super) sample: &'a Sample,
    pub(super) known: &'a [(Name, Value)],
    pub(super) values: Vec<Value>,
    pub(super) answers: Vec<(Name, Answer)>,
    /// Values that are answers.
    given: Vec<(Name, Value)>,
}

impl Point<'_> {
    /// The difference of an answer from the formula, and what rounding explains.
    fn difference(name: Name, answer: Answer, values: &[Value]) -> (f64, f64) {
        let RunningError { value, bound } = values[name].number();
        ((answer.number.value - value).abs(), CAREFUL * bound + answer.number.bound)
    }

    fn among<'a>(&'a self, among: &'a [Name]) -> impl Iterator<Item = (Name, Answer)> + 'a {
        self.answers.iter().copied().filter(|(name, _)| among.contains(name))
    }

    /// Whether one of these answers is not that of the formulas.
    pub(super) fn is_wrong(&self, among: &[Name]) -> bool {
        self.among(among).any(|(name, answer)| {
            let (difference, allowed) = Self::difference(name, answer, &self.values);
            difference.is_nan() || difference > allowed
        })
    }

    /// How far these answers are from the formulas, over the rounding.
    pub(super) fn clearness(&self, among: &[Name]) -> f64 {
        let of = |(name, answer)| {
            let (difference, allowed) = Self::difference(name, answer, &self.values);
            difference / allowed
        };
        self.among(among).map(of).filter(|of| of.is_finite()).fold(0.0, f64::max)
    }

    /// The values with the changed formulas.
    pub(super) fn changed(&self, way: usize, change: &Change) -> Vec<Value> {
        FORMULAS.changed(way, (&self.values, self.known), change, &self.given)
    }

    /// Whether the changed formulas yield these answers. Rounding must not explain much more than before.
    pub(super) fn is_explained(&self, way: usize, change: &Change, among: &[Name]) -> bool {
        let values = self.changed(way, change);
        self.among(among).all(|(name, answer)| {
            let (before, allowed_before) = Self::difference(name, answer, &self.values);
            let (difference, allowed) = Self::difference(name, answer, &values);
            let coarse = (COARSER * allowed_before).max(FINE * answer.size);
            difference <= allowed && (allowed < CLEAR * before || allowed <= coarse)
        })
    }
}

/// The samples that have an element, in one way of writing. Answers that are `given` stand for the formulas' own numbers.
pub(super) fn points<'a>(samples: &'a [Sample], way: usize, given: &[Name]) -> Vec<Point<'a>> {
    let mut points: Vec<Point> = samples.iter().filter_map(|sample| point(sample, way, given)).collect();
    let mut sizes = BTreeMap::new();
    for (name, Answer { number, .. }) in points.iter().flat_map(|point| &point.answers) {
        let size: &mut f64 = sizes.entry(*name).or_default();
        *size = size.max(number.value.abs());
    }
    for (name, answer) in points.iter_mut().flat_map(|point| &mut point.answers) {
        answer.size = sizes[name];
    }
    points
}

fn point<'a>(sample: &'a Sample, way: usize, given: &[Name]) -> Option<Point<'a>> {
    let list = &*FORMULAS;
    let element = sample.element.as_ref()?;
    let inputs = element.inputs.as_ref()?;
    let mut numbers = inputs.forces.clone();
    numbers.extend(element.numbers[0].map(|number| (list.name("R"), number)));
    numbers.extend(element.numbers[2].map(|number| (list.name("K"), number)));
    // Another way of writing may not be valid here, or lose digits.
    if way > 0 {
        let [own, right] = [way, 0].map(|way| list.values(way, &inputs.values, &inputs.known, &[]));
        let is_right = |(name, _): &(Name, RunningError)| {
            let (one, other) = (own[*name].number(), right[*name].number());
            (one.value - other.value).abs() <= CAREFUL * (one.bound + other.bound)
        };
        if !numbers.iter().all(is_right) {
            return None;
        }
    }
    let fixed = numbers.iter().filter(|(name, _)| given.contains(name));
    let fixed: Vec<_> = fixed.map(|(name, number)| (*name, Value::Number(*number))).collect();
    let values = list.values(way, &inputs.values, &inputs.known, &fixed);
    let answers = numbers.into_iter().map(|(name, number)| (name, Answer { number, size: 0.0 })).collect();
    Some(Point { sample, known: &inputs.known, values, answers, given: fixed })
}
