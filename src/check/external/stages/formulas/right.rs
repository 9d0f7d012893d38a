//! Whether the formulas yield the answers of a program without a change, each result in one way of writing.

use super::inputs::Inputs;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::outputs::Output;
use super::point::numbers;
use super::tree::Name;
use super::values::Value;
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The rounding of a wrong result over the largest result of its kind at a case.
pub(super) const FINE: f64 = 1e-6;

/// The tangents of both kinds of elements.
pub(super) const TANGENTS: [&str; 2] = ["K", "K_p"];

/// Whether rounding explains the difference, and is small next to a size.
pub(super) fn is_near(answer: RunningError, value: RunningError, size: f64) -> bool {
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
                    0 => Arc::new(FORMULAS.values(0, values, known, of.needed)),
                    _ => Arc::new(FORMULAS.values_in(way, &all[0], known, of.needed)),
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
