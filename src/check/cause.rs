//! The likely cause of mismatches with injected faults: the closed form is treated as a program, and its answers are
//! explained.

use super::draw::Case;
use super::external::{
    Demands, Evaluator, Explanation, Formulas, Report, Vector, compare_answers, explain_own,
};
use crate::variant::Variant;
use serde::Serialize;

/// The number of mismatches whose cases are answered.
const ANSWERED: usize = 60;

/// The explanation of the difference that injected faults make.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LikelyCause {
    /// The explanation.
    pub explanation: Explanation,
}

/// Explains the mismatches of injected faults at the cases with these numbers; nothing if there is nothing to compare.
///
/// The closed form without the faults is the reference. Without injected faults the closed form itself is wrong. There is
/// then no reference for its terms, and none is named.
pub fn likely_cause(variant: &Variant, seed: u64, numbers: &[u64]) -> Option<LikelyCause> {
    if *variant == Variant::Unmodified {
        return None;
    }
    let step = numbers.len().div_ceil(ANSWERED).max(1);
    let vector = |number: &u64| {
        let Case { regime, .. } = Case::draw(seed, *number);
        let case = Case::draw(seed, *number).data();
        Vector {
            id: number.to_string(),
            regime: regime.name().to_owned(),
            case,
            element: None,
            steps: Vec::new(),
            point: None,
            place: None,
        }
    };
    let vectors: Vec<Vector> = numbers.iter().step_by(step).map(vector).collect();
    let demands = Demands::default();
    let program = Evaluator { variant: variant.clone(), formulas: Formulas::Chosen, ..Evaluator::default() };
    let mut report = Report::default();
    for vector in vectors {
        let Some(answers) = program.answered(&vector) else { continue };
        if let Ok(found) = compare_answers(&vector, &answers, &demands) {
            report.add(vector, Some(answers), found);
        }
    }
    Some(LikelyCause { explanation: explain_own(&report.kept, &report.right, &demands)? })
}
