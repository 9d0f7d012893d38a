//! A sample with the values of all formulas, and the answers of the program.

use super::entries::inputs_of_parts;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::outputs::{OF_COMPONENTS, Output, RESULTS};
use super::tree::Name;
use super::values::{Value, Values};
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use crate::parallel;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

/// The rounding of an explanation over the difference that it explains.
const CLEAR: f64 = 1e-2;
/// The rounding of an explanation over that of the right formulas.
const COARSER: f64 = 1e3;
/// The rounding of an explanation over the largest answer of its kind.
const FINE: f64 = 1e-9;

/// A number of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    pub(super) output: Output,
    pub(super) number: RunningError,
    /// The largest number of its kind in all samples.
    size: f64,
    /// The rounding of the way of writing that loses the most digits here: the program may have written it so.
    rounding: f64,
    /// The ways of writing in which the formulas are right here, and lose no digits.
    pub(super) ways: [bool; WAYS],
}

impl Answer {
    /// Whether it is this number, to the rounding of a program that may be written in another way.
    pub(super) fn is(&self, number: RunningError) -> bool {
        let allowed = (CAREFUL * number.bound).max(self.rounding) + self.number.bound;
        (number.value - self.number.value).abs() <= allowed
    }

    /// The difference from the formulas, and what rounding explains.
    fn difference(&self, values: &(impl Values + ?Sized)) -> (f64, f64) {
        let RunningError { value, bound } = self.output.of(values);
        ((self.number.value - value).abs(), (CAREFUL * bound).max(self.rounding) + self.number.bound)
    }
}

pub(super) struct Point<'a> {
    pub(super) sample: &'a Sample,
    /// The values in each way of writing.
    pub(super) values: Vec<Arc<[Value]>>,
    pub(super) answers: Vec<Answer>,
    /// Values that are answers.
    pub(super) given: Vec<(Name, Value)>,
    /// The names that have values.
    pub(super) needed: Set,
    parts: OnceLock<Vec<Vec<Value>>>,
    estimates: [OnceLock<Vec<Value<f64>>>; WAYS],
    /// For two ways, the first the smaller one.
    unlike: [[OnceLock<Set>; WAYS]; WAYS],
}

impl Point<'_> {
    pub(super) fn among(&self, among: Set) -> impl Iterator<Item = &Answer> {
        self.answers.iter().filter(move |answer| among.has(answer.output.name))
    }

    /// Whether one of these answers is not that of the formulas.
    pub(super) fn is_wrong(&self, among: Set) -> bool {
        self.among(among).any(|answer| {
            let (difference, allowed) = answer.difference(&self.values[0][..]);
            difference.is_nan() || difference > allowed
        })
    }

    /// How far these answers are from the formulas, over the rounding.
    pub(super) fn clearness(&self, among: Set) -> f64 {
        let of = |answer: &Answer| {
            let (difference, allowed) = answer.difference(&self.values[0][..]);
            difference / allowed
        };
        self.among(among).map(of).filter(|of| of.is_finite()).fold(0.0, f64::max)
    }

    /// By how much these answers may differ from numbers that are about the right ones.
    pub(super) fn about(&self, among: Set, part: f64) -> f64 {
        let of = |answer: &Answer| {
            let (_, allowed) = answer.difference(&self.values[0][..]);
            part * answer.number.value.abs() + COARSER * allowed
        };
        self.among(among).map(of).fold(0.0, f64::max)
    }

    /// The values by the dofs of each block alone.
    pub(super) fn parts(&self) -> &[Vec<Value>] {
        let known = &self.sample.inputs.known;
        let of_inputs = |inputs: Vec<Value>| FORMULAS.values(0, &inputs, known, self.needed);
        self.parts
            .get_or_init(|| inputs_of_parts(&self.sample.inputs.values).into_iter().map(of_inputs).collect())
    }

    /// The values in a way of writing without their rounding.
    pub(super) fn estimates(&self, way: usize) -> &[Value<f64>] {
        self.estimates[way].get_or_init(|| self.values[way].iter().map(|of| of.to()).collect())
    }

    /// The names whose values in two ways of writing differ by more than rounding.
    pub(super) fn unlike(&self, way: usize, other: usize) -> Set {
        let differ = |name: &Name| self.values[way][*name].differs(self.values[other][*name]);
        *self.unlike[way.min(other)][way.max(other)]
            .get_or_init(|| (0..self.values[way].len()).filter(differ).collect())
    }

    /// Whether the changed formulas yield this answer. Rounding must not explain much more than before.
    pub(super) fn is_explained(&self, answer: &Answer, way: usize, changed: &impl Values) -> bool {
        let (before, allowed_before) = answer.difference(&self.values[way][..]);
        let (difference, allowed) = answer.difference(changed);
        let coarse = (COARSER * allowed_before).max(FINE * answer.size);
        difference <= allowed && (allowed < CLEAR * before || allowed <= coarse)
    }
}

impl Point<'_> {
    /// What must be added to the right answer, and how near it must be if it is estimated.
    pub(super) fn wanted(&self, answer: &Answer, way: usize) -> [f64; 2] {
        let (before, allowed) = answer.difference(&self.values[way][..]);
        // Of a wrong answer a small part may be left, also if the whole is small next to other answers.
        let most = if before > allowed { CLEAR * before } else { FINE * answer.size };
        let wanted = answer.number.value - answer.output.of(&self.values[way][..]).value;
        [wanted, 4.0 * most.max(COARSER * allowed)]
    }
}

/// The samples with their answers.
pub(super) fn points(samples: &[Sample]) -> Vec<Point<'_>> {
    let numbers: Vec<_> = samples.iter().map(numbers).collect();
    let answered = numbers.iter().flatten().map(|(output, _)| output.name);
    // Programs of the geometry alone have no numbers of a contact element.
    let of_geometry = FORMULAS.needed(RESULTS.iter().copied().collect()).or((0..FORMULAS.inputs).collect());
    let is_of_geometry = answered.collect::<Set>().without(of_geometry).is_empty();
    let needed = if is_of_geometry { of_geometry } else { (0..FORMULAS.names.0.len()).collect() };
    let same = FORMULAS.same_ways(needed);
    let of_sample = |i: usize| Point::new((&samples[i], numbers[i].clone()), (needed, same));
    let mut points = parallel::indices(samples.len(), of_sample);
    let mut sizes = BTreeMap::new();
    for Answer { output, number, .. } in points.iter().flat_map(|point| &point.answers) {
        let size: &mut f64 = sizes.entry(output.name).or_default();
        *size = size.max(number.value.abs());
    }
    for answer in points.iter_mut().flat_map(|point| &mut point.answers) {
        answer.size = sizes[&answer.output.name];
    }
    points
}

/// The same points with the answers to some results in the place of the formulas' own numbers.
pub(super) fn with_given<'a>(points: &[Point<'a>], given: Set) -> Vec<Point<'a>> {
    parallel::map(points, |point| point.with_given(given))
}

impl<'a> Point<'a> {
    /// `same` has for each way of writing the first one with the same formulas.
    fn new(
        (sample, numbers): (&'a Sample, Vec<(Output, RunningError)>),
        (needed, same): (Set, [usize; WAYS]),
    ) -> Self {
        let list = &*FORMULAS;
        let inputs = &sample.inputs;
        let mut values = vec![Arc::<[Value]>::from(list.values(0, &inputs.values, &inputs.known, needed))];
        for way in 1..WAYS {
            values.push(if same[way] < way {
                Arc::clone(&values[same[way]])
            } else {
                list.values_in(way, &values[0], &inputs.known, needed).into()
            });
        }
        let is_right = |output: Output, way: usize| {
            let [one, right] = [way, 0].map(|way| output.of(&values[way][..]));
            (one.value - right.value).abs() <= CAREFUL * (one.bound + right.bound)
        };
        let answer = |(output, number): (Output, RunningError)| {
            let ways: [bool; WAYS] = std::array::from_fn(|way| way == 0 || is_right(output, way));
            let roundings =
                (0..WAYS).filter(|way| ways[*way]).map(|way| CAREFUL * output.of(&values[way][..]).bound);
            let rounding = roundings.filter(|of| of.is_finite()).fold(0.0, f64::max);
            Answer { output, number, size: 0.0, rounding, ways }
        };
        let answers = numbers.into_iter().map(answer).collect();
        Self::of(sample, values, answers, (Vec::new(), needed))
    }

    fn of(
        sample: &'a Sample,
        values: Vec<Arc<[Value]>>,
        answers: Vec<Answer>,
        (given, needed): (Vec<(Name, Value)>, Set),
    ) -> Self {
        let (parts, estimates, unlike) = Default::default();
        Self { sample, values, answers, given, needed, parts, estimates, unlike }
    }

    fn with_given(&self, given: Set) -> Self {
        let of = |Answer { output, number, .. }: &Answer| (output.name, Value::Number(*number));
        let given: Vec<_> = self.among(given).map(of).collect();
        let with = |way: usize| {
            let known = &self.sample.inputs.known;
            FORMULAS.values_with(way, &self.values[way], known, &given, self.needed).into()
        };
        let mut values: Vec<Arc<[Value]>> = Vec::with_capacity(WAYS);
        for way in 0..WAYS {
            let same = (0..way).find(|same| Arc::ptr_eq(&self.values[*same], &self.values[way]));
            values.push(same.map_or_else(|| with(way), |same| Arc::clone(&values[same])));
        }
        Self::of(self.sample, values, self.answers.clone(), (given, self.needed))
    }
}

/// The numbers of the program by the results that they are.
pub(super) fn numbers(sample: &Sample) -> Vec<(Output, RunningError)> {
    let mut numbers = Vec::new();
    for (outputs, own) in OF_COMPONENTS.iter().zip(&sample.own) {
        numbers.extend(outputs.iter().zip(own).filter_map(|(output, number)| output.zip(*number)));
    }
    let scalar = |(name, number)| (Output { name, axis: None }, number);
    numbers.extend(sample.inputs.forces.iter().copied().map(scalar));
    if let Some(element) = &sample.element {
        let [residual, _, tangent] = element.numbers;
        let [of_residual, of_tangent] = if element.stiffness.is_some() { ["R_p", "K_p"] } else { ["R", "K"] };
        let of = [(of_residual, residual), (of_tangent, tangent)];
        numbers
            .extend(of.into_iter().filter_map(|(name, number)| Some(scalar((FORMULAS.name(name), number?)))));
    }
    numbers
}

/// The clearest samples at which one of these answers is wrong: one of each case in turn.
pub(super) fn probes<'a>(
    points: impl Iterator<Item = &'a Point<'a>>,
    among: Set,
    count: usize,
) -> Vec<&'a Point<'a>> {
    let mut wrong: Vec<&Point> = points.filter(|point| point.is_wrong(among)).collect();
    wrong.sort_by(|one, other| other.clearness(among).total_cmp(&one.clearness(among)));
    let mut cases = BTreeSet::new();
    wrong.retain(|point| cases.insert(point.sample.case));
    wrong.truncate(count);
    wrong
}
