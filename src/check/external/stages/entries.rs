//! Which entries of a gradient or a Hessian are wrong, and what is wrong there.
//!
//! An equation that no error explains is looked at along single dofs. If only some entries are wrong, they are stated: those
//! of a beam, of an axis, of a control vector, of a block, of a triangle. The numbers there may be zero or have the wrong sign, or
//! an error of the equation may explain them.

mod statements;

use super::Samples;
use super::equations::Equation;
use super::judgement::{Cases, Status, examined, excess};
use super::point::Point;
use super::sample::{Along, Sample};
use super::sentences::READINGS;
use crate::linearization::Quantity;
use crate::number::RunningError;
use statements::statement;

/// The number of wrong cases whose entries are looked at.
const CASES: usize = 6;

/// The residual of a wrong entry over its rounding. A little more than rounding is that of a program that computes in another
/// order.
const CLEAR: f64 = 100.0;

/// What was found of the entries.
pub(super) struct Entries {
    /// What was found of each sum of the equation: an error that explains the wrong entries, or nothing.
    pub(super) found: Vec<Status>,
    /// Which entries are wrong, as the end of a sentence; empty if all are.
    pub(super) which: String,
}

/// The entries at which an equation is wrong, of a gradient or a Hessian. Nothing if they have nothing in common.
pub(super) fn entries(equation: &Equation, wrong: &[usize], of: &impl Samples) -> Option<Entries> {
    let part = equation.results[0].1;
    let along = match part {
        1 => Along::EachDof,
        3 => Along::EachEntry,
        _ => return None,
    };
    let step = (wrong.len() / CASES).max(1);
    let few: Vec<usize> = wrong.iter().step_by(step).take(CASES).copied().collect();
    let mut samples = of(along, &|case| few.contains(&case));
    // Cases with the same numbers of dofs.
    let count = |case: usize| samples.iter().filter(|sample| sample.case == case).count();
    let counts: Vec<(usize, usize)> = few.iter().map(|case| (*case, count(*case))).collect();
    let size = counts.first()?.1;
    samples.retain(|sample| counts.contains(&(sample.case, size)));
    // Each entry is a case of its own.
    let mut dofs = Vec::new();
    for (k, sample) in samples.iter_mut().enumerate() {
        if k < size {
            dofs.push(sample.dofs?);
        }
        sample.case = k;
    }
    let points: Vec<Point> = samples.iter().map(Point::new).collect();
    let excess = excess(equation, &points, points.len());
    let is_clear = |k: &usize| excess[*k].is_some_and(|of| of > CLEAR);
    let mut is_wrong = vec![false; size];
    (0..points.len()).filter(is_clear).for_each(|k| is_wrong[k % size] = true);
    let cases: Cases = (0..points.len()).partition(|k| is_wrong[k % size]);
    let which =
        if cases.1.is_empty() { String::new() } else { statement(&samples[0].nodes, &dofs, &is_wrong)? };
    if let Some(words) = relation(equation, part, &samples, &is_wrong) {
        return Some(Entries { found: vec![Status::Stated(words)], which });
    }
    let mut found = examined(equation, &points, &cases, false);
    // In few entries many terms yield the same numbers.
    for status in &mut found {
        if matches!(status, Status::Explained(cause) if cause.readings.len() > READINGS) {
            *status = Status::Unknown;
        }
    }
    Some(Entries { found, which })
}

/// What the wrong entries are, if they are zero, or a multiple of the exact ones.
fn relation(equation: &Equation, part: usize, samples: &[Sample], is_wrong: &[bool]) -> Option<String> {
    let size = is_wrong.len();
    let mut words = Vec::new();
    for (quantity, _) in &equation.results {
        let numbers = |k: usize| {
            let at = quantity.component();
            Some((samples[k].own[at][part]?, samples[k].exact[at][part]))
        };
        let holds = |k: usize, factor: f64| {
            numbers(k).is_some_and(|(own, exact): (RunningError, RunningError)| {
                let bound = own.bound + (1.0 + factor.abs()) * exact.bound;
                (own.value - factor * exact.value).abs() <= CLEAR * bound
            })
        };
        if (0..samples.len()).all(|k| holds(k, 1.0)) {
            continue;
        }
        let of_factor = |(factor, _): &&(f64, &str)| {
            (0..samples.len()).all(|k| holds(k, if is_wrong[k % size] { *factor } else { 1.0 }))
        };
        words.push(format!("{} {}", name(*quantity, part), RELATIONS.iter().find(of_factor)?.1));
    }
    (!words.is_empty()).then(|| words.join(" and "))
}

/// What stands in the place of the right numbers.
const RELATIONS: [(f64, &str); 4] =
    [(0.0, "is zero"), (-1.0, "has the wrong sign"), (2.0, "is doubled"), (0.5, "is halved")];

fn name(quantity: Quantity, part: usize) -> String {
    format!("the {} of {}", if part == 1 { "gradient" } else { "Hessian" }, quantity.name())
}
