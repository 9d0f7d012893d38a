//! The likely cause of mismatches: the closed form is treated as a program, and its answers are explained.

use super::draw::Case;
use super::external::{
    Demands, Evaluator, Explanation, Formulas, Report, Vector, compare_answers, explain, reference,
};
use crate::variant::Variant;
use serde::Serialize;

/// The number of mismatches whose cases are answered.
const ANSWERED: usize = 60;

/// The explanation of the difference between closed form and automatic differentiation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LikelyCause {
    /// The explanation.
    pub explanation: Explanation,
    /// Whether it says how the closed form would agree, instead of what is wrong with it.
    pub is_remedy: bool,
}

/// Explains the mismatches at the cases with these numbers; nothing if there is nothing to compare at them.
///
/// For injected faults, the closed form without them is the reference. Without injected faults, the closed form is
/// wrong, and the search looks for the change with which it agrees with automatic differentiation.
pub fn likely_cause(variant: &Variant, seed: u64, numbers: &[u64]) -> Option<LikelyCause> {
    let step = numbers.len().div_ceil(ANSWERED).max(1);
    let vector = |number: &u64| {
        let Case { regime, .. } = Case::draw(seed, *number);
        let case = Case::draw(seed, *number).data();
        Vector { id: number.to_string(), regime: regime.name().to_owned(), case, point: None, place: None }
    };
    let vectors: Vec<Vector> = numbers.iter().step_by(step).map(vector).collect();
    let demands = Demands::default();
    if *variant == Variant::Unmodified {
        let cases: Vec<_> =
            vectors.into_iter().filter_map(|vector| Some((vector.clone(), reference(&vector)?))).collect();
        return Some(LikelyCause { explanation: explain(&cases, &demands)?, is_remedy: true });
    }
    let program = Evaluator { variant: variant.clone(), formulas: Formulas::Chosen, ..Evaluator::default() };
    let mut report = Report::default();
    for vector in vectors {
        let Some(answers) = program.answered(&vector) else { continue };
        if let Ok(found) = compare_answers(&vector, &answers, &demands) {
            report.add(vector, Some(answers), found);
        }
    }
    let explanation = explain(&report.kept, &demands)?;
    Some(LikelyCause { explanation, is_remedy: false })
}
