//! A tangent that is right but for its place: exchanged, symmetrised, or one triangle mirrored.

use super::list::FORMULAS;
use super::names::Set;
use super::point::{Point, points};
use super::values::Value;
use crate::check::external::stages::Reading;
use crate::check::external::stages::sample::{Along, Sample};
use crate::number::RunningError;

/// K and its transpose at each sample, and whether a combination of both is the answer.
fn is_answered(points: &[Point], of: &dyn Fn(RunningError, RunningError) -> RunningError) -> bool {
    let tangent = Set::from_iter([FORMULAS.name("K")]);
    let needed = FORMULAS.needed(tangent);
    let is_right = |point: &Point| {
        let Sample { inputs, .. } = point.sample;
        point.among(tangent).all(|answer| {
            let values = |inputs_of: &[Value]| FORMULAS.values(0, inputs_of, &inputs.known, needed);
            let number = |inputs: &[Value]| answer.output.of(&values(inputs)[..]);
            answer.is(of(number(&inputs.values), number(&FORMULAS.exchanged(&inputs.values))))
        })
    };
    !points.is_empty() && points.iter().all(is_right)
}

/// What is wrong with the places of the entries.
pub(super) fn reading(own: &[Point], entries: &dyn Fn(Along) -> Vec<Sample>) -> Option<Reading> {
    let told = |words: &str| {
        let words = format!("in the tangent {words}");
        Some(Reading::new(vec![words.clone()], words))
    };
    if is_answered(own, &|_, transposed| transposed) {
        return told("rows and columns are exchanged");
    }
    let half = RunningError::from(0.5);
    if is_answered(own, &|own, transposed| half * (own + transposed)) {
        return told("its symmetric part stands in its place");
    }
    let samples = [Along::Lower, Along::Upper].map(entries);
    let [lower, upper] = samples.each_ref().map(|samples| points(samples));
    for (right, other, words) in [(&lower, &upper, "below"), (&upper, &lower, "above")] {
        if is_answered(right, &|own, _| own) && is_answered(other, &|_, transposed| transposed) {
            return told(&format!(
                "the triangle {words} the diagonal is mirrored, although it is not symmetric"
            ));
        }
    }
    None
}
