//! The cause of wrong answers: the numbers of the program in each equation.
//!
//! The equations follow each other: closest point, d and g_N, first order of xi and d, second order of both, tangents,
//! slips, contact element. In each the numbers of the program stand for all that came before. So its residual is zero to
//! rounding if this step of the program is right, whatever was wrong before. A residual that is not zero is a sum of few terms
//! with the same factors in all cases: a term that is missing, that has the wrong sign, in which something else stands in
//! the place of a factor. Gradients and Hessians are contracted with random directions, so that each term is a number.
//!
//! Errors of the curves are in all equations. They are tried first, as changes of the vectors that the equations are
//! made of. A wrong Hessian whose one triangle was computed and mirrored is compared entry by entry.

mod condition;
mod equations;
mod inputs;
mod judgement;
mod point;
mod rows;
mod sample;
mod search;
mod sentences;
mod terms;
mod words;

use super::answers::Answers;
use super::compare::Demands;
use super::vectors::Vector;
use equations::{CLOSEST_POINT, equations};
use judgement::{Cases, Status, examined, is_wrong, judged};
use point::Point;
use rayon::prelude::*;
use sample::{Along, Sample, samples};
use sentences::{of_curves, of_status, result_words};
use std::cell::OnceCell;

/// What the equations say of the answers of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Traced {
    /// The errors that explain the first equation that is not satisfied: several if they yield the same numbers.
    pub(super) causes: Vec<Reading>,
    /// The largest residual of this equation over the size of its terms, and what the errors leave of it.
    pub(super) deviation: Option<[f64; 2]>,
    /// The number of cases.
    pub(super) cases: usize,
    /// The first equation that is not satisfied, as a sentence without its full stop.
    pub(super) place: String,
    /// What is wrong beyond it, as sentences.
    pub(super) beyond: Vec<String>,
}

impl Traced {
    /// Adds what was found of the sums of an equation, with its readings.
    fn add(&mut self, found: &[Status], readings: Vec<Vec<Reading>>, is_first: bool) {
        for (status, readings) in found.iter().zip(readings) {
            let Some(reading) = readings.first() else { continue };
            let is_known = self.causes.iter().any(|cause| readings.iter().any(|of| of.name == cause.name));
            if is_first && self.causes.is_empty() {
                self.causes = readings;
                if let Status::Explained(cause) = status {
                    self.deviation = Some(cause.deviation);
                }
            } else if !is_known && self.beyond.len() < BEYOND {
                self.beyond.push(format!("Beyond it {}.", reading.words));
            }
        }
    }

    /// Whether one error explains everything.
    pub(super) fn is_of_one_error(&self) -> bool {
        self.causes.first().is_some_and(|cause| cause.errors == 1) && self.beyond.is_empty()
    }
}

/// One or two errors that explain the numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reading {
    /// The number of errors.
    pub(super) errors: usize,
    /// Its name.
    pub(super) name: String,
    /// What is wrong, as a sentence without its full stop.
    pub(super) words: String,
    /// The factor of a term less one.
    pub(super) coefficient: Option<f64>,
}

/// The number of equations in which pairs of errors are looked for.
const WITH_PAIRS: usize = 2;
/// The number of sentences on what is wrong beyond the first equation.
const BEYOND: usize = 1;

/// The first equation that the answers do not satisfy, and the error that explains it; nothing if all are satisfied.
pub(super) fn traced(cases: &[&(Vector, Answers)], demands: &Demands) -> Option<Traced> {
    let of = |along: Along| -> Vec<Sample> {
        let numbered: Vec<_> = cases.par_iter().enumerate().collect();
        numbered
            .into_par_iter()
            .flat_map_iter(|(i, (vector, answers))| samples(i, vector, answers, demands, along))
            .collect()
    };
    let random = of(Along::Random);
    let has_arrays = random.first()?.has_arrays;
    let equations = equations(has_arrays);
    let points: Vec<Point> = random.iter().map(Point::new).collect();
    let judged_at = |e: usize| {
        let (wrong, right) = judged(&equations[e], &points);
        is_wrong(&wrong, &right).then_some((e, (wrong, right)))
    };
    let all_wrong: Vec<(usize, Cases)> = (0..equations.len()).into_par_iter().filter_map(judged_at).collect();
    let (first, (of_first, others)) = all_wrong.first()?;
    let first = &equations[*first];
    let wrong: Vec<usize> = all_wrong.iter().map(|(e, _)| *e).collect();
    let mut traced = Traced {
        cases: of_first.len() + others.len(),
        place: format!(
            "{} does not satisfy its equation{} at {} of {} cases",
            result_words(first),
            sentences::number(first),
            of_first.len(),
            of_first.len() + others.len()
        ),
        ..Traced::default()
    };
    if wrong.iter().all(|e| equations[*e].number == CLOSEST_POINT) {
        traced.place = "all equations but those of the closest point are satisfied".into();
        traced.causes = vec![sentences::of_closest_point(&points, of_first, others)];
        return Some(traced);
    }
    if wrong.len() > 1 {
        traced.causes =
            inputs::found(&equations, &random, &wrong).iter().map(|words| of_curves(words)).collect();
        if !traced.causes.is_empty() {
            return Some(traced);
        }
    }
    let entries = [Along::Lower, Along::Upper].map(|along| (along, OnceCell::new()));
    let mut with_pairs = 0;
    let of_one_error: Vec<_> =
        all_wrong.par_iter().map(|(e, cases)| examined(&equations[*e], &points, cases, false)).collect();
    for ((e, cases), mut found) in all_wrong.iter().zip(of_one_error) {
        let (equation, mut words_of_triangle) = (&equations[*e], "");
        let in_entries = |with_pairs: bool| {
            let is_matrix = has_arrays && equation.results.iter().all(|(_, part)| *part == 3);
            entries.iter().filter(|_| is_matrix).find_map(|(along, samples)| {
                let points: Vec<Point> = samples.get_or_init(|| of(*along)).iter().map(Point::new).collect();
                let found = examined(equation, &points, &judged(equation, &points), with_pairs);
                let words = if *along == Along::Lower { "below" } else { "above" };
                is_known(&found).then_some((found, words))
            })
        };
        if !is_known(&found)
            && let Some(in_entries) = in_entries(false)
        {
            (found, words_of_triangle) = in_entries;
        }
        if !is_known(&found) && with_pairs < WITH_PAIRS {
            with_pairs += 1;
            found = examined(equation, &points, cases, true);
            if !is_known(&found)
                && let Some(in_entries) = in_entries(true)
            {
                (found, words_of_triangle) = in_entries;
            }
        }
        let readings: Vec<_> = found
            .iter()
            .map(|status| of_status(equation, status, &points, cases, words_of_triangle))
            .collect();
        traced.add(&found, readings, *e == wrong[0]);
    }
    Some(traced)
}

fn is_known(found: &[Status]) -> bool {
    !found.iter().any(|status| matches!(status, Status::Unknown))
}

#[cfg(test)]
mod tests;
