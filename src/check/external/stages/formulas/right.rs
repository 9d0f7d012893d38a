//! Whether the formulas yield the answers of a program without a change, each result in one way of writing.

use super::inputs::Inputs;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::outputs::Output;
use super::point::{numbers, points};
use super::tree::Name;
use super::values::{Number, Value};
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The rounding of a wrong result over the largest result of its kind at a case.
const FINE: f64 = 1e-6;

/// The tangents of both kinds of elements.
const TANGENTS: [&str; 2] = ["K", "K_p"];

/// A result, with the names that it follows from and the ways in which these are written.
struct Step {
    name: Name,
    needed: Set,
    ways: Vec<usize>,
}

impl Step {
    fn new(name: Name) -> Self {
        let needed = FORMULAS.needed(Set::from_iter([name]));
        Self { name, needed, ways: FORMULAS.distinct_ways(needed) }
    }

    /// Whether the result is right at a sample in some way of writing.
    fn is_right(&self, sample: &Sample, answers: &[(Output, RunningError)], size: f64) -> bool {
        let Inputs { values, known, .. } = &sample.inputs;
        let first = FORMULAS.values(0, values, known, &[], self.needed);
        self.has_way((sample, first), answers, &|number, value| is_near(number, value, size))
    }

    /// Whether it may be right, without an evaluation of the rounding. `right` are the values with the right curves.
    fn may_be_right(
        &self,
        (sample, right): (&Sample, &[Value<f64>]),
        answers: &[(Output, RunningError)],
        size: f64,
    ) -> bool {
        let Inputs { values, known, .. } = &sample.inputs;
        let inputs: Vec<Value<f64>> = values.iter().map(|of| of.to()).collect();
        let first = FORMULAS.values_after(0, right, &inputs, known, self.needed);
        let is_near = |number: RunningError, value: f64| {
            let left = (number.value - value).abs();
            left.is_nan() || left <= 2.0 * FINE * size
        };
        self.has_way((sample, first), answers, &is_near)
    }

    /// Whether the answers are near to the values in some way of writing, of which those of the first are known.
    fn has_way<S: Number>(
        &self,
        (sample, first): (&Sample, Vec<Value<S>>),
        answers: &[(Output, RunningError)],
        is_near: &dyn Fn(RunningError, S) -> bool,
    ) -> bool {
        let known = &sample.inputs.known;
        let is_right = |values: &[Value<S>]| {
            let mut of_name = answers.iter().filter(|(output, _)| output.name == self.name);
            of_name.all(|(output, number)| is_near(*number, output.of(values)))
        };
        self.ways.iter().any(|&way| match way {
            0 => is_right(&first),
            way => is_right(&FORMULAS.values_in(way, &first, known, &[], self.needed)),
        })
    }
}

/// At a case, the results that follow from the fewest names: right ones, and the first that is wrong.
pub(in crate::check::external::stages) struct FirstWrong {
    steps: Vec<Arc<Step>>,
    /// How far the last one is from the right one, over the rounding.
    clearness: f64,
    /// The size of its answer.
    size: f64,
    /// The values at the sample.
    right: Arc<[Value<f64>]>,
    /// The sample, by its place.
    pub(in crate::check::external::stages) place: usize,
}

impl FirstWrong {
    /// Those of all cases at which a result is wrong, the simplest and clearest first.
    pub(in crate::check::external::stages) fn of_cases(samples: &[Sample]) -> Vec<Self> {
        let points = points(samples, Set::default());
        let names: BTreeSet<Name> =
            points.iter().flat_map(|point| &point.answers).map(|answer| answer.output.name).collect();
        let mut steps: Vec<Arc<Step>> = names.into_iter().map(|name| Arc::new(Step::new(name))).collect();
        steps.sort_by_key(|step| step.needed.names().count());
        let of_sample = |place: usize| {
            let point = &points[place];
            let alone = |step: &Arc<Step>| Set::from_iter([step.name]);
            let first = steps.iter().position(|step| point.is_wrong(alone(step)))?;
            let clearness = point.clearness(alone(&steps[first]));
            let of_first = point.among(alone(&steps[first])).map(|answer| answer.number.value.abs());
            let size = of_first.fold(0.0, f64::max);
            let right = point.estimates(0).into();
            Some(Self { steps: steps[..=first].to_vec(), clearness, size, right, place })
        };
        let order = |one: &Self, other: &Self| {
            one.steps.len().cmp(&other.steps.len()).then(other.clearness.total_cmp(&one.clearness))
        };
        let mut of_cases: BTreeMap<usize, Self> = BTreeMap::new();
        for of in (0..samples.len()).filter_map(of_sample) {
            let case = samples[of.place].case;
            if of_cases.get(&case).is_none_or(|known| order(&of, known).is_lt()) {
                of_cases.insert(case, of);
            }
        }
        let mut found: Vec<Self> = of_cases.into_values().collect();
        found.sort_by(order);
        found
    }

    /// The ways in which a program may have written the first that is wrong.
    pub(in crate::check::external::stages) fn ways(&self) -> &[usize] {
        self.steps.last().map_or(&[], |step| &step.ways)
    }

    /// Whether it is the tangent.
    pub(in crate::check::external::stages) fn is_tangent(&self) -> bool {
        self.steps.last().is_some_and(|step| TANGENTS.contains(&&*FORMULAS.names.0[step.name]))
    }

    /// The answers at a sample to the first that is wrong.
    pub(in crate::check::external::stages) fn compared<'a>(
        &'a self,
        way: usize,
        sample: &'a Sample,
    ) -> Option<Compared<'a>> {
        let (step, Inputs { values, known, .. }) = (self.steps.last()?, &sample.inputs);
        let inputs: Vec<Value<f64>> = values.iter().map(|of| of.to()).collect();
        let right = FORMULAS.values(way, &inputs, known, &[], step.needed);
        let mut answers = numbers(sample);
        answers.retain(|(output, _)| output.name == step.name);
        Some(Compared { way, step, right, answers })
    }

    /// Whether all of them are right at a sample.
    pub(in crate::check::external::stages) fn are_right(&self, sample: &Sample) -> bool {
        let answers = numbers(sample);
        let last = self.steps.len() - 1;
        let size = |i: usize| if i == last { self.size } else { f64::INFINITY };
        // Most curves do not yield the wrong answer.
        self.steps[last].may_be_right((sample, &self.right), &answers, self.size)
            && self.steps.iter().enumerate().all(|(i, step)| step.is_right(sample, &answers, size(i)))
    }
}

/// The answers at a sample to the first result that is wrong, in one way of writing.
pub(in crate::check::external::stages) struct Compared<'a> {
    way: usize,
    step: &'a Step,
    /// The values with the right curves.
    right: Vec<Value<f64>>,
    answers: Vec<(Output, RunningError)>,
}

impl Compared<'_> {
    /// By how much the formulas differ from the answers with these inputs.
    pub(in crate::check::external::stages) fn differences(&self, inputs: &Inputs) -> Vec<RunningError> {
        let values = FORMULAS.values(self.way, &inputs.values, &inputs.known, &[], self.step.needed);
        self.answers.iter().map(|(output, number)| output.of(&values[..]) - *number).collect()
    }

    /// The same without rounding.
    pub(in crate::check::external::stages) fn estimates(&self, inputs: &Inputs) -> Vec<f64> {
        let of: Vec<Value<f64>> = inputs.values.iter().map(|of| of.to()).collect();
        let values = FORMULAS.values_after(self.way, &self.right, &of, &inputs.known, self.step.needed);
        self.answers.iter().map(|(output, number)| output.of(&values[..]) - number.value).collect()
    }
}

/// Whether rounding explains the difference, and is small next to a size.
fn is_near(answer: RunningError, value: RunningError, size: f64) -> bool {
    let allowed = CAREFUL * value.bound + answer.bound;
    (answer.value - value.value).abs() <= allowed && allowed <= FINE * size
}

/// An answer of a sample.
struct Answer {
    output: Output,
    number: RunningError,
    /// The largest of its kind at its case.
    size: f64,
    /// The place of its result in [`Written`].
    place: usize,
}

/// The answers of a sample, and what they follow from.
struct OfSample {
    answers: Vec<Answer>,
    needed: Set,
    /// For each way of writing the first one with the same formulas.
    same: [usize; WAYS],
}

/// The answers of all samples, which do not depend on the curves.
pub(in crate::check::external::stages) struct Answers {
    of_samples: Vec<OfSample>,
    places: usize,
}

impl Answers {
    /// The forms of the second variation of d are the same at a closest point alone, and are left out elsewhere. Without
    /// `with_tangent`, the tangent is left out.
    pub(in crate::check::external::stages) fn of(
        samples: &[Sample],
        is_closest: bool,
        with_tangent: bool,
    ) -> Self {
        let is_one = |output: &Output, names: [&str; 2]| names.contains(&&*FORMULAS.names.0[output.name]);
        let is_compared = |output: &Output| {
            (is_closest || !is_one(output, ["Dd|d|", "Ddg_N"])) && (with_tangent || !is_one(output, TANGENTS))
        };
        // A program may have formulas of their own for the ends.
        let mut places: BTreeMap<(Output, [bool; 2]), usize> = BTreeMap::new();
        let mut of_samples = Vec::new();
        for of_case in samples.chunk_by(|one, other| one.case == other.case) {
            let all: Vec<_> = of_case.iter().map(numbers).collect();
            let mut sizes: BTreeMap<Name, f64> = BTreeMap::new();
            for (output, number) in all.iter().flatten() {
                let size = sizes.entry(output.name).or_default();
                *size = size.max(number.value.abs());
            }
            for (sample, mut numbers) in of_case.iter().zip(all) {
                numbers.retain(|(output, _)| is_compared(output));
                let needed = FORMULAS.needed(numbers.iter().map(|(output, _)| output.name).collect());
                let answer = |(output, number): (Output, RunningError)| {
                    let next = places.len();
                    let place = *places.entry((output, sample.held)).or_insert(next);
                    Answer { output, number, size: sizes[&output.name], place }
                };
                let answers = numbers.into_iter().map(answer).collect();
                of_samples.push(OfSample { answers, needed, same: FORMULAS.same_ways(needed) });
            }
        }
        Self { of_samples, places: places.len() }
    }
}

/// The ways in which a program may have written each of its results; a bit for each way.
#[derive(Clone)]
pub(in crate::check::external::stages) struct Written(Vec<u16>);

impl Written {
    /// All ways.
    pub(in crate::check::external::stages) fn new(answers: &Answers) -> Self {
        Self(vec![(1 << WAYS) - 1; answers.places])
    }

    /// What is left if the formulas yield all answers at the samples of a case too, and whether rounding is small next to them.
    /// The samples have other curves, and the answers of those from number `first` on.
    pub(in crate::check::external::stages) fn with(
        &self,
        samples: &[Sample],
        answers: &Answers,
        first: usize,
    ) -> Option<(Self, bool)> {
        let [mut left, mut strictly] = [self.clone(), self.clone()];
        for (sample, of) in samples.iter().zip(&answers.of_samples[first..]) {
            let Inputs { values, known, .. } = &sample.inputs;
            let mut all: Vec<Arc<Vec<Value>>> = Vec::with_capacity(WAYS);
            for way in 0..WAYS {
                all.push(match of.same[way] {
                    same if same < way => Arc::clone(&all[same]),
                    0 => Arc::new(FORMULAS.values(0, values, known, &[], of.needed)),
                    _ => Arc::new(FORMULAS.values_in(way, &all[0], known, &[], of.needed)),
                });
            }
            for answer in &of.answers {
                let is_near = |size| {
                    let is_near =
                        |way: &usize| is_near(answer.number, answer.output.of(&all[*way][..]), size);
                    (0..WAYS).filter(is_near).fold(0, |bits, way| bits | 1 << way)
                };
                left.0[answer.place] &= is_near(f64::INFINITY);
                strictly.0[answer.place] &= is_near(answer.size);
                if left.0[answer.place] == 0 {
                    return None;
                }
            }
        }
        let is_strict = !strictly.0.contains(&0);
        Some((if is_strict { strictly } else { left }, is_strict))
    }
}
