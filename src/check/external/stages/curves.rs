//! Errors of the curves, with the closest point that a program has with them.
//!
//! A program may take the point from the case, find it by an iteration that converges with its curves, or stop before that:
//! then its last Newton step leads from the point of its vectors to the parameters that it answers.

mod fit;

use super::formulas::{Answers, FirstWrong, Written};
use super::inputs::{Input, Vectors, with_single_derivatives};
use super::sample::Sample;
use crate::linearization::Quantity;
use crate::number::RunningError;
use crate::parallel;
use std::collections::BTreeSet;

/// The number of cases at which all errors are tried.
const PROBES: usize = 4;
/// The number of cases nearest to the right point, at which they are tried if the parameters are answered.
const NEAREST: usize = 3;
/// The number of wrong cases that must be explained.
const FEWEST: usize = 3;
/// The number of iterations.
const STEPS: usize = 15;
/// The step of differences.
const STEP: f64 = 1e-6;
/// The rounding of the parameters of a point.
const ROUNDING: f64 = 1e-15;
/// The same of a point from which a Newton step leads to another one.
const BEFORE: f64 = 1e-13;
/// An iteration has converged if its step is smaller.
const SAME: f64 = 1e-12;
/// The largest parameter of a point.
const LARGEST: f64 = 10.0;

/// Said of a program that stops before it has its closest point.
const NOT_CONVERGED: &str = "; the iteration for the closest point does not converge with it";

/// How a program with wrong curves has found its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Found {
    /// It is that of the case.
    Given,
    /// It is the closest point of the wrong curves.
    Closest,
    /// The point that is answered is one Newton step further.
    StepBefore,
}

/// The errors of cubic curves that yield all answers, in words.
pub(super) fn found(samples: &[Sample]) -> Vec<String> {
    if !samples.iter().all(Sample::is_cubic) {
        return Vec::new();
    }
    let wrong = FirstWrong::of_cases(samples);
    let cases: BTreeSet<usize> = wrong.iter().map(|of| samples[of.place].case).collect();
    let is_answered = samples.iter().any(|sample| sample.own[Quantity::Xi.component()][0].is_some());
    let has_own_point = is_answered && wrong.iter().any(|of| distance(&samples[of.place]) > 0.0);
    let probes = if has_own_point { nearest(samples, wrong) } else { wrong };
    if probes.is_empty() {
        return Vec::new();
    }
    let few = &probes[..probes.len().min(PROBES)];
    let told = |input: &Input, how: Found, answers: &Answers| {
        let mut left = 0;
        // Most fail at the first ones. An iteration with wrong curves may end anywhere.
        let may_be_left = if how == Found::StepBefore { few.len() / 2 } else { few.len() / 4 };
        let is_possible = few.iter().all(|of| {
            left += usize::from(!Wrong::new(input, &samples[of.place]).has_point(how, of));
            left <= may_be_left
        });
        is_possible.then(|| explained(input, how, answers, (samples, &cases))).flatten()
    };
    let inputs = with_single_derivatives(samples);
    let found = |how: Found| -> Vec<String> {
        let answers = Answers::of(samples, how == Found::Closest, true);
        let words = |input: &Input| Some(format!("{}{}", input.words, told(input, how, &answers)?));
        parallel::filter_map(&inputs, words)
    };
    if has_own_point {
        return found(Found::StepBefore);
    }
    let given = found(Found::Given);
    let given = if given.is_empty() { fit::found(samples, &probes, &cases) } else { given };
    if given.is_empty() && !is_answered { found(Found::Closest) } else { given }
}

/// Those of the cases with another point than the right one, and with the nearest: there, the iteration has nearly converged.
fn nearest(samples: &[Sample], mut wrong: Vec<FirstWrong>) -> Vec<FirstWrong> {
    let distance = |of: &FirstWrong| distance(&samples[of.place]);
    wrong.retain(|of| distance(of) > 0.0);
    wrong.sort_by(|one, other| distance(one).total_cmp(&distance(other)));
    wrong.truncate(NEAREST);
    wrong
}

/// How far the point of a program is from the right one.
fn distance(sample: &Sample) -> f64 {
    let exact = exact(sample);
    (0..2).map(|i| (sample.xi[i].value - exact[i]).abs()).fold(0.0, f64::max)
}

fn exact(sample: &Sample) -> [f64; 2] {
    [Quantity::Xi, Quantity::XiBar].map(|of| sample.exact[of.component()][0].value)
}

/// If the error yields the answers, what is said beside it. An iteration with wrong curves may end anywhere, and rounding may hide
/// what is wrong, so half of the wrong cases are enough. Right answers must be right with the error, too.
fn explained(
    input: &Input,
    how: Found,
    answers: &Answers,
    (samples, wrong): (&[Sample], &BTreeSet<usize>),
) -> Option<String> {
    let mut written = Written::new(answers);
    let (mut explained, mut left, mut has_converged, mut first) = (0, 0, true, 0);
    for of_case in samples.chunk_by(|one, other| one.case == other.case) {
        let mut here = Wrong::new(input, &of_case[0]);
        let with = |xi: [f64; 2]| {
            let all: Vec<Sample> =
                of_case.iter().map(|sample| Wrong::new(input, sample).sample_at(xi, how)).collect();
            Some((xi, written.with(&all, answers, first)?))
        };
        let fitting: Vec<_> = here.points(how).into_iter().filter_map(with).collect();
        let is_wrong = wrong.contains(&of_case[0].case);
        let strict = fitting.iter().find(|(_, (_, is_strict))| is_wrong && *is_strict);
        if let Some((xi, _)) = strict {
            explained += 1;
            has_converged &= how != Found::StepBefore || is_same(*xi, here.xi()) && here.is_closest();
        }
        if let Some((_, (with_case, _))) = strict.or_else(|| fitting.first()) {
            written = with_case.clone();
        } else if is_wrong && 2 * (left + 1) <= wrong.len() {
            left += 1;
        } else {
            return None;
        }
        first += of_case.len();
    }
    let count = wrong.len();
    let of_iteration = if has_converged { "" } else { NOT_CONVERGED };
    let of_others = if left > 0 {
        format!("; at {left} of {count} wrong cases it does not explain the answers")
    } else {
        String::new()
    };
    (explained >= FEWEST && 2 * explained >= count).then(|| format!("{of_iteration}{of_others}"))
}

fn is_same(one: [f64; 2], other: [f64; 2]) -> bool {
    (0..2).all(|i| (one[i] - other[i]).abs() < SAME)
}

/// A sample with wrong curves.
struct Wrong<'a> {
    input: &'a Input,
    right: &'a Sample,
    here: Sample,
}

impl<'a> Wrong<'a> {
    fn new(input: &'a Input, right: &'a Sample) -> Self {
        Self { input, right, here: right.clone() }
    }

    fn xi(&self) -> [f64; 2] {
        self.right.xi.map(|xi| xi.value)
    }

    fn vectors(&mut self, xi: [f64; 2]) -> Vectors {
        self.here.move_to(xi);
        self.input.vectors(&self.here)
    }

    /// d.t and d.t_bar, and the Newton step to where they are zero.
    fn step(&mut self, xi: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let ([beam, bar], _) = self.vectors(xi);
        let [[x, t, bend, _], [x_bar, t_bar, bend_bar, _]] =
            [beam, bar].map(|of| of.map(|v| v.map(|c: RunningError| c.value)));
        let d = x - x_bar;
        let f = [d.dot(&t), d.dot(&t_bar)];
        let b = t.dot(&t_bar);
        let matrix = [[t.dot(&t) + d.dot(&bend), -b], [b, d.dot(&bend_bar) - t_bar.dot(&t_bar)]];
        (f, solved(matrix, f, self.right.held))
    }

    /// Whether the iteration has converged to the answered point.
    fn is_closest(&mut self) -> bool {
        let (own, held) = (self.xi(), self.right.held);
        root(&mut |xi| self.step(xi).0, own, held).is_some_and(|xi| is_same(xi, own))
    }

    /// Whether the first wrong result, and those before it, are right at a point that the program may have.
    fn has_point(&mut self, how: Found, first: &FirstWrong) -> bool {
        self.points(how).into_iter().any(|xi| first.are_right(&self.sample_at(xi, how)))
    }

    /// The parameters that the vectors of the program may have.
    fn points(&mut self, how: Found) -> Vec<[f64; 2]> {
        let (own, held) = (self.xi(), self.right.held);
        if how == Found::Given || held == [true; 2] {
            return vec![own];
        }
        let closest = root(&mut |xi| self.step(xi).0, own, held);
        if how == Found::Closest {
            return closest.into_iter().collect();
        }
        if closest.is_some_and(|xi| (0..2).all(|i| (xi[i] - own[i]).abs() < ROUNDING)) {
            return vec![own];
        }
        let after = |xi: [f64; 2], step: [f64; 2]| std::array::from_fn(|i| xi[i] + step[i] - own[i]);
        let starts = closest.into_iter().chain([own, exact(self.right)]);
        let mut before = |start| root(&mut |xi| after(xi, self.step(xi).1), start, held);
        let mut points: Vec<[f64; 2]> = starts.filter_map(&mut before).collect();
        // Near the closest point, rounding decides where the last step began.
        points.extend(closest.filter(|xi| is_same(*xi, own)));
        // A program may evaluate its vectors again after the last step.
        points.push(own);
        points
    }

    /// The sample with the wrong curves at these parameters. Those of the slips are the ones that are answered.
    fn sample_at(&mut self, xi: [f64; 2], how: Found) -> Sample {
        let (mut geometry, moved) = self.vectors(xi);
        let rounding = if how == Found::StepBefore { BEFORE } else { 10.0 * ROUNDING };
        for [x, t, bend, third] in &mut geometry {
            let by_rounding = [*t, *bend, *third];
            for (vector, along) in [x, t, bend].into_iter().zip(by_rounding) {
                vector.iter_mut().zip(&along).for_each(|(to, by)| to.bound += rounding * by.value.abs());
            }
        }
        let is_answered = self.right.own[Quantity::Xi.component()][0].is_some();
        let slipping = if is_answered { self.xi() } else { xi };
        let slipping =
            [0, 1].map(|i| RunningError { value: slipping[i], bound: self.right.xi[i].bound + ROUNDING });
        let mut sample = self.here.clone();
        sample.inputs.set_curves(slipping, &geometry, &moved);
        (sample.geometry, sample.moved) = (geometry, moved);
        sample
    }
}

/// The step of the parameters that are not held.
fn solved([[a, b], [c, e]]: [[f64; 2]; 2], f: [f64; 2], held: [bool; 2]) -> [f64; 2] {
    match held {
        [true, true] => [0.0; 2],
        [true, false] => [0.0, -f[1] / e],
        [false, true] => [-f[0] / a, 0.0],
        [false, false] => {
            let det = a * e - b * c;
            [-(e * f[0] - b * f[1]) / det, -(a * f[1] - c * f[0]) / det]
        }
    }
}

/// A zero, found by Newton's method with differences.
fn root(f: &mut impl FnMut([f64; 2]) -> [f64; 2], start: [f64; 2], held: [bool; 2]) -> Option<[f64; 2]> {
    let mut xi = start;
    for _ in 0..STEPS {
        let here = f(xi);
        let mut matrix = [[0.0; 2]; 2];
        for k in 0..2 {
            let [next, last] = [STEP, -STEP].map(|by| {
                let mut moved = xi;
                moved[k] += by;
                f(moved)
            });
            for i in 0..2 {
                matrix[i][k] = (next[i] - last[i]) / (2.0 * STEP);
            }
        }
        let step = solved(matrix, here, held);
        let is_possible = step.iter().zip(xi).all(|(step, xi)| (xi + step).abs() < LARGEST);
        if !is_possible {
            return None;
        }
        xi = [xi[0] + step[0], xi[1] + step[1]];
        if step.iter().all(|step| step.abs() < SAME) {
            return Some(xi);
        }
    }
    None
}
