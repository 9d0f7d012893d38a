//! A derivative of a shape function that is wrong by any polynomial, at the closest point of the case.

use super::Found;
use crate::check::external::stages::formulas::{Answers, FirstWrong};
use crate::check::external::stages::inputs::{Derivative, derivatives, error_by_beam};
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use crate::parallel;
use std::collections::BTreeSet;

/// The number of cases at which the error is solved for.
const TRIED: usize = 16;
/// An error for which right answers would be wrong, if they follow from the derivative.
const TRIED_ERROR: f64 = 0.1;
/// The number of samples of a case that are used.
const SAMPLES: usize = 3;
/// The number of cases that it may leave, more than it explains.
const LEFT: usize = 2;
/// The number of errors that must be known.
const FEWEST: usize = 3;

/// Said if the tangent is left out.
const WITHOUT_TANGENT: &str = "; what follows for the tangent was not looked at";

/// The errors that yield all answers, in words.
pub(super) fn found(samples: &[Sample], wrong: &[FirstWrong], cases: &BTreeSet<usize>) -> Vec<String> {
    let all = derivatives(samples);
    let answers = [true, false].map(|with_tangent| Answers::of(samples, false, with_tangent));
    let told = |of: &Derivative| {
        let in_way = |way: &usize| of.with_errors(&errors(of, *way, samples, wrong)?, &all);
        let input = wrong.first()?.ways().iter().find_map(in_way)?;
        let explained = |answers: &Answers| super::explained(&input, Found::Given, answers, (samples, cases));
        // A program may have its own form of the tangent, which is the same at closest points alone.
        let without = || explained(&answers[1]).filter(|_| !wrong.iter().any(FirstWrong::is_tangent));
        let more = explained(&answers[0]).or_else(|| without().map(|more| more + WITHOUT_TANGENT))?;
        Some(format!("{}{more}", input.words))
    };
    parallel::filter_map(&all, told)
}

/// By how much it is wrong at the parameters of some cases, if that explains the first wrong result in each of them.
fn errors(of: &Derivative, way: usize, samples: &[Sample], wrong: &[FirstWrong]) -> Option<Vec<(f64, f64)>> {
    let (mut errors, mut left, mut solved) = (Vec::new(), 0, 0);
    for first in wrong.iter().take(TRIED) {
        let case = samples[first.place].case;
        let here: Vec<&Sample> = samples.iter().filter(|sample| sample.case == case).take(SAMPLES).collect();
        let inputs = |sample: &Sample, by: [f64; 2]| {
            let mut inputs = sample.inputs.clone();
            let (geometry, moved) = of.vectors(sample, by);
            inputs.set_curves(sample.xi, &geometry, &moved);
            inputs
        };
        let error = || {
            let compared: Vec<_> =
                here.iter().filter_map(|sample| Some((*sample, first.compared(way, sample)?))).collect();
            let residuals = |by: [f64; 2]| -> Vec<RunningError> {
                compared.iter().flat_map(|(sample, of)| of.differences(&inputs(sample, by))).collect()
            };
            let estimates = |by: [f64; 2]| -> Vec<f64> {
                compared.iter().flat_map(|(sample, of)| of.estimates(&inputs(sample, by))).collect()
            };
            error_by_beam(of.beams.0, &residuals, &estimates)
        };
        // What follows from the derivative, and is right, shows that the derivative is right.
        let sample = &samples[first.place];
        let may_be_wrong = first.may_stay_right(sample, &inputs(sample, [TRIED_ERROR; 2]));
        let Some(by) = may_be_wrong.then(error).flatten() else {
            left += 1;
            if left > LEFT + solved {
                return None;
            }
            continue;
        };
        solved += 1;
        errors.extend(of.beams.0.iter().filter_map(|&beam| Some((here[0].xi[beam].value, by[beam]?))));
    }
    (errors.len() >= FEWEST).then_some(errors)
}
