//! Shrinks a case with a fault to a small case with the same fault.
//!
//! A drawn case has some sixty numbers of seventeen digits. Most faults occur in two straight beams with two
//! unit directions too. So the case is edited, and an edit stays if it makes the case smaller and does not change the
//! diagnosis. This greedy search ends when no edit helps or the budget is spent. The closest point is searched for anew
//! each time: a case without a regular one has no diagnosis.

mod edit;
mod frame;
mod simpler;

use super::CaseData;
use super::config::{CheckConfig, Oracles};
use super::diagnosis::Finding;
use super::draw::Case;
use super::summary::Summary;
use crate::test_beam::TestBeam;
use crate::variant::Variant;
use edit::edits;

/// The maximum number of comparisons for a case. One takes about half a millisecond.
const BUDGET: usize = 1000;

/// A shrunk mismatch.
#[derive(Clone, Debug, PartialEq)]
pub struct Shrunk {
    /// The number of the case that it comes from.
    pub number: u64,
    /// The shrunk case.
    pub case: CaseData,
    /// The first wrong number.
    pub finding: Finding,
}

/// The first `most` cases that did not agree, shrunk; one for each diagnosis.
pub fn shrink_mismatches(variant: &Variant, seed: u64, summary: &Summary, most: usize) -> Vec<Shrunk> {
    let config = CheckConfig { variant: variant.clone(), oracles: Oracles::Ad };
    let find = |case: &CaseData| Finding::of(&case.compare(&config).ok()?);
    let mut shrunk: Vec<Shrunk> = Vec::new();
    for &number in summary.mismatches.keys().take(most) {
        let case = Case::draw(seed, number).data();
        let Some(Finding { diagnosis, minimum, is_clear, .. }) = find(&case) else { continue };
        if shrunk.iter().all(|known| known.finding.diagnosis != diagnosis) {
            // The shrunk case must be able to pass, and must have no more minima before the one in question.
            let simple = |found: &Finding| found.minimum <= minimum && (found.is_clear || !is_clear);
            let case = shrink(&case, |case| Some(find(case).filter(simple)?.diagnosis));
            shrunk.extend(find(&case).map(|finding| Shrunk { number, case, finding }));
        }
    }
    shrunk
}

/// The smallest case found for which `diagnose` returns the same as for `case`; `case` itself if it defines no beams.
pub fn shrink<D: PartialEq>(case: &CaseData, diagnose: impl Fn(&CaseData) -> D) -> CaseData {
    if case.beams().is_err() {
        return case.clone();
    }
    let diagnosis = diagnose(case);
    // Edits insert ones and whole numbers, so lengths must be near one first. A verdict does not depend on the unit.
    let mut case = frame::near_one(case).filter(|case| diagnose(case) == diagnosis).unwrap_or(case.clone());
    let (mut size, mut budget) = (Size::of(&case), BUDGET);
    loop {
        let before = size;
        for edit in edits(&case) {
            let Some(candidate) = edit.apply(&case) else { continue };
            let candidate_size = Size::of(&candidate);
            if candidate_size < size {
                if budget == 0 {
                    return case;
                }
                budget -= 1;
                if diagnose(&candidate) == diagnosis {
                    (case, size) = (candidate, candidate_size);
                }
            }
        }
        if size == before {
            return case;
        }
    }
}

/// The size of a case: the families count first, in the order of [`Family`](crate::test_beam::Family), then the dofs
/// that vary, then those that are not zero, then the lengths of the written numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Size {
    families: usize,
    varied: usize,
    not_zero: usize,
    digits: usize,
}

impl Size {
    fn of(case: &CaseData) -> Self {
        let contact =
            [case.contact.radius, case.contact.radius_bar, case.contact.xi_0, case.contact.xi_bar_0];
        let mut size = Self { families: 0, varied: 0, not_zero: 0, digits: 0 };
        size.not_zero += not_zero(&contact);
        size.digits += digits(&contact);
        for TestBeam { family, parameters, q, dq, linear_dq } in &case.test_beams {
            size.families += *family as usize;
            size.varied += not_zero(dq) + not_zero(linear_dq);
            size.not_zero += not_zero(q);
            size.digits +=
                [parameters, q, dq, linear_dq].map(|numbers| digits(numbers)).iter().sum::<usize>();
        }
        size
    }
}

fn not_zero(numbers: &[f64]) -> usize {
    numbers.iter().filter(|&&number| number != 0.0).count()
}

/// The length of the written numbers. Zero counts 0, one counts 1, and any other number counts more.
fn digits(numbers: &[f64]) -> usize {
    let length = |&number: &f64| match number {
        0.0 => 0,
        1.0 => 1,
        _ => 1 + number.to_string().len().min(format!("{number:e}").len()),
    };
    numbers.iter().map(length).sum()
}
