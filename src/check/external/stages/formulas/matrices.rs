//! A tangent that is right but for its place: exchanged, symmetrised, or one triangle mirrored.

use super::list::FORMULAS;
use super::names::Set;
use super::point::numbers;
use super::values::Value;
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::Reading;
use crate::check::external::stages::sample::{Along, Sample};
use crate::number::RunningError;

/// K and its transpose at each sample, and whether a combination of both is the answer.
fn is_answered(samples: &[Sample], of: &dyn Fn(RunningError, RunningError) -> RunningError) -> bool {
    let list = &*FORMULAS;
    let tangent = list.name("K");
    let needed = list.needed(Set::from_iter([tangent]));
    let is_right = |sample: &Sample| {
        let inputs = &sample.inputs;
        let answer = numbers(sample).into_iter().find(|(output, _)| output.name == tangent);
        let Some((_, answer)) = answer else { return true };
        let of_inputs =
            |values: &[Value]| list.values(0, values, &inputs.known, &[], needed)[tangent].number();
        let number = of(of_inputs(&inputs.values), of_inputs(&list.exchanged(&inputs.values)));
        (number.value - answer.value).abs() <= CAREFUL * number.bound + answer.bound
    };
    !samples.is_empty() && samples.iter().all(is_right)
}

/// What is wrong with the places of the entries.
pub(super) fn reading(samples: &[Sample], entries: &dyn Fn(Along) -> Vec<Sample>) -> Option<Reading> {
    let told = |words: &str| {
        let words = format!("in the tangent {words}");
        Some(Reading { names: vec![words.clone()], words, coefficient: None })
    };
    if is_answered(samples, &|_, transposed| transposed) {
        return told("rows and columns are exchanged");
    }
    let half = RunningError::from(0.5);
    if is_answered(samples, &|own, transposed| half * (own + transposed)) {
        return told("its symmetric part stands in its place");
    }
    let [lower, upper] = [Along::Lower, Along::Upper].map(entries);
    for (right, other, words) in [(&lower, &upper, "below"), (&upper, &lower, "above")] {
        if is_answered(right, &|own, _| own) && is_answered(other, &|_, transposed| transposed) {
            return told(&format!(
                "the triangle {words} the diagonal is mirrored, although it is not symmetric"
            ));
        }
    }
    None
}
