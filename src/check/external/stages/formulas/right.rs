//! Whether the formulas yield the answers of a program without a change, each result in one way of writing.

use super::inputs::Inputs;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::outputs::Output;
use super::point::{numbers, points};
use super::tree::Name;
use super::values::Value;
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
        values(&self.ways, sample, self.needed).any(|(_, values)| {
            let mut of_name = answers.iter().filter(|(output, _)| output.name == self.name);
            of_name.all(|(output, number)| is_near(*number, output.of(&values[..]), size))
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
            Some(Self { steps: steps[..=first].to_vec(), clearness, size, place })
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

    /// By how much its answers at a sample differ from the formulas in one of these ways, with these inputs.
    pub(in crate::check::external::stages) fn differences(
        &self,
        way: usize,
        sample: &Sample,
        inputs: &Inputs,
    ) -> Vec<RunningError> {
        let Some(step) = self.steps.last() else { return Vec::new() };
        let values = FORMULAS.values(way, &inputs.values, &inputs.known, &[], step.needed);
        let mut answers = numbers(sample);
        answers.retain(|(output, _)| output.name == step.name);
        answers.into_iter().map(|(output, number)| output.of(&values[..]) - number).collect()
    }

    /// Whether all of them are right at a sample.
    pub(in crate::check::external::stages) fn are_right(&self, sample: &Sample) -> bool {
        let answers = numbers(sample);
        let last = self.steps.len() - 1;
        let size = |i: usize| if i == last { self.size } else { f64::INFINITY };
        self.steps.iter().enumerate().all(|(i, step)| step.is_right(sample, &answers, size(i)))
    }
}

/// The values in each of these ways of writing.
fn values<'a>(
    ways: &'a [usize],
    sample: &'a Sample,
    needed: Set,
) -> impl Iterator<Item = (usize, Arc<Vec<Value>>)> + 'a {
    let Inputs { values, known, .. } = &sample.inputs;
    let first = Arc::new(FORMULAS.values(0, values, known, &[], needed));
    ways.iter().map(move |&way| match way {
        0 => (0, Arc::clone(&first)),
        way => (way, Arc::new(FORMULAS.values_in(way, &first, known, &[], needed))),
    })
}

/// Whether rounding explains the difference, and is small next to a size.
fn is_near(answer: RunningError, value: RunningError, size: f64) -> bool {
    let allowed = CAREFUL * value.bound + answer.bound;
    (answer.value - value.value).abs() <= allowed && allowed <= FINE * size
}

/// A result, and which parameters are held: a program may have formulas of their own for the ends.
type Answered = (Output, [bool; 2]);

/// The ways in which a program may have written each of its results.
#[derive(Default)]
pub(in crate::check::external::stages) struct Written(BTreeMap<Answered, [bool; WAYS]>);

impl Written {
    /// Whether the formulas yield all answers at these samples of a case too. If not, nothing is learnt of them. The forms of the
    /// second variation of d are the same at a closest point alone. If `is_strict`, rounding must be small. Without `with_tangent`,
    /// the tangent is left out.
    pub(in crate::check::external::stages) fn yields(
        &mut self,
        samples: &[Sample],
        (is_closest, with_tangent): (bool, bool),
        is_strict: bool,
    ) -> bool {
        let mut left = self.0.clone();
        let all: [usize; WAYS] = std::array::from_fn(|way| way);
        let mut sizes: BTreeMap<Name, f64> = BTreeMap::new();
        for (output, number) in samples.iter().flat_map(numbers) {
            let size = sizes.entry(output.name).or_default();
            *size = size.max(if is_strict { number.value.abs() } else { f64::INFINITY });
        }
        let are_right = samples.iter().all(|sample| {
            let mut numbers = numbers(sample);
            let is_one = |output: &Output, names: [&str; 2]| names.contains(&&*FORMULAS.names.0[output.name]);
            numbers.retain(|(output, _)| {
                (is_closest || !is_one(output, ["Dd|d|", "Ddg_N"]))
                    && (with_tangent || !is_one(output, TANGENTS))
            });
            let needed = FORMULAS.needed(numbers.iter().map(|(output, _)| output.name).collect());
            for (way, values) in values(&all, sample, needed) {
                for (output, number) in &numbers {
                    let of = left.entry((*output, sample.held)).or_insert([true; WAYS]);
                    of[way] &= is_near(*number, output.of(&values[..]), sizes[&output.name]);
                }
            }
            left.values().all(|ways| ways.contains(&true))
        });
        if are_right {
            self.0 = left;
        }
        are_right
    }
}
