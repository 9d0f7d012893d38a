//! The first wrong result of each case, and whether it is right with other curves.

use super::inputs::Inputs;
use super::list::FORMULAS;
use super::names::Set;
use super::outputs::Output;
use super::point::{numbers, points};
use super::right::{FINE, TANGENTS, is_near};
use super::tree::Name;
use super::values::{Number, Value};
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

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

    /// Whether the result is right in some way of writing.
    fn is_right(&self, inputs: &Inputs, answers: &[(Output, RunningError)], size: f64) -> bool {
        let first = FORMULAS.values(0, &inputs.values, &inputs.known, self.needed);
        self.has_way((inputs, first), answers, &|number, value| is_near(number, value, size))
    }

    /// Whether it may be right, without an evaluation of the rounding: it differs by this much `at_most`. `right` are the values
    /// with the right curves.
    fn may_be_right(
        &self,
        (inputs, right): (&Inputs, &[Value<f64>]),
        answers: &[(Output, RunningError)],
        at_most: f64,
    ) -> bool {
        if !answers.iter().any(|(output, _)| output.name == self.name) {
            return true;
        }
        let of: Vec<Value<f64>> = inputs.values.iter().map(|of| of.to()).collect();
        let first = FORMULAS.values_after(0, right, &of, &inputs.known, self.needed);
        let is_near = |number: RunningError, value: f64| {
            let left = (number.value - value).abs();
            left.is_nan() || left <= at_most
        };
        self.has_way((inputs, first), answers, &is_near)
    }

    /// Whether the answers are near to the values in some way of writing, of which those of the first are known.
    fn has_way<S: Number>(
        &self,
        (inputs, first): (&Inputs, Vec<Value<S>>),
        answers: &[(Output, RunningError)],
        is_near: &dyn Fn(RunningError, S) -> bool,
    ) -> bool {
        let is_right = |values: &[Value<S>]| {
            let mut of_name = answers.iter().filter(|(output, _)| output.name == self.name);
            of_name.all(|(output, number)| is_near(*number, output.of(values)))
        };
        self.ways.iter().any(|&way| match way {
            0 => is_right(&first),
            way => is_right(&FORMULAS.values_in(way, &first, &inputs.known, self.needed)),
        })
    }
}

/// At a case, the results that follow from the fewest names: right ones, and the first that is wrong.
pub(in crate::check::external::stages) struct FirstWrong {
    steps: Vec<Arc<Step>>,
    /// By how much each of them may differ from its answer, if it is evaluated without its rounding.
    at_most: Vec<f64>,
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
        let points = points(samples);
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
            let steps = steps[..=first].to_vec();
            let at_most = |step: &Arc<Step>| point.about(alone(step), FINE);
            let mut at_most: Vec<f64> = steps[..first].iter().map(at_most).collect();
            at_most.push(2.0 * FINE * size);
            Some(Self { steps, at_most, clearness, size, right, place })
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
        let right = FORMULAS.values(way, &inputs, known, step.needed);
        let mut answers = numbers(sample);
        answers.retain(|(output, _)| output.name == step.name);
        Some(Compared { way, step, right, answers })
    }

    /// Whether all of them are right at a sample with other curves.
    pub(in crate::check::external::stages) fn are_right(&self, sample: &Sample) -> bool {
        let answers = numbers(sample);
        let last = self.steps.len() - 1;
        let size = |i: usize| if i == last { self.size } else { f64::INFINITY };
        // Most curves do not yield the answers.
        self.may_be_right(self.steps.len(), &sample.inputs, &answers)
            && self.steps.iter().enumerate().all(|(i, step)| step.is_right(&sample.inputs, &answers, size(i)))
    }

    /// Whether those before the wrong one may stay right with these inputs.
    pub(in crate::check::external::stages) fn may_stay_right(
        &self,
        sample: &Sample,
        inputs: &Inputs,
    ) -> bool {
        self.may_be_right(self.steps.len() - 1, inputs, &numbers(sample))
    }

    fn may_be_right(&self, count: usize, inputs: &Inputs, answers: &[(Output, RunningError)]) -> bool {
        let mut steps = self.steps.iter().zip(&self.at_most).take(count);
        steps.all(|(step, at_most)| step.may_be_right((inputs, &self.right), answers, *at_most))
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
        let values = FORMULAS.values(self.way, &inputs.values, &inputs.known, self.step.needed);
        self.answers.iter().map(|(output, number)| output.of(&values[..]) - *number).collect()
    }

    /// The same without rounding.
    pub(in crate::check::external::stages) fn estimates(&self, inputs: &Inputs) -> Vec<f64> {
        let of: Vec<Value<f64>> = inputs.values.iter().map(|of| of.to()).collect();
        let values = FORMULAS.values_after(self.way, &self.right, &of, &inputs.known, self.step.needed);
        self.answers.iter().map(|(output, number)| output.of(&values[..]) - number.value).collect()
    }
}
