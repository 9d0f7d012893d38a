//! The answers to a case against the references at its closest point.

mod converted;

use super::answers::Answers;
use super::conventions::Conventions;
use super::error::{ExternalError, Place};
use super::only::Only;
use super::vectors::{Outcome, Vector, held_name};
use crate::check::Answer;
use crate::check::candidate::{Entry, Sides, is_doubted};
use crate::check::diagnosis::place;
use crate::check::serialized::number;
use crate::check::verdict::Comparison;
use crate::linearization::Quantity;
pub(super) use converted::Converted;
use serde::{Deserialize, Serialize};

/// The requirements for answers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demands {
    /// The conventions of the program.
    pub conventions: Conventions,
    /// The required significant digits, where they are attainable. The default is the digits of a careful evaluation
    /// of the textbook formulas.
    pub digits: Option<u8>,
}

/// The judgement of a number of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Judgement {
    /// It is correct, to the attainable digits.
    Agrees,
    /// It is correct, but has fewer digits than the best formulas keep there.
    Loses,
    /// Rounding explains more than a thousandth of its scale, so it is not meaningful.
    Unclear,
    /// It differs by more than rounding.
    Wrong,
}

/// A number of an answer with its reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judged {
    /// The comparison; its tolerance is that of the judgement.
    pub comparison: Comparison,
    /// The judgement.
    pub judgement: Judgement,
    /// The difference from the formulas that lose the fewest digits.
    #[serde(with = "number")]
    pub loss: f64,
    /// The difference from them that their careful evaluation explains.
    #[serde(with = "number")]
    pub attainable: f64,
    /// The size of the terms of these formulas.
    #[serde(with = "number")]
    pub scale: f64,
    /// The size of the number. For a gradient or a Hessian along the directions it is the sum of the absolute values of
    /// the terms, for a parameter it is 1.
    #[serde(with = "number")]
    pub size: f64,
    /// Whether a careful evaluation of the textbook formulas explains the difference.
    pub is_rounding: bool,
    /// Whether it is a gradient or a Hessian, contracted with the directions.
    pub is_contracted: bool,
    /// The largest change of the number if each number of the answer changes by one.
    #[serde(skip)]
    pub sensitivity: f64,
}

/// The result of the answers to a case.
#[derive(Clone, Debug, PartialEq)]
pub enum CaseFound {
    /// There is no reference for this case.
    Degenerate(Outcome),
    /// There is no answer, although there is a reference.
    Missing,
    /// The program gave no number.
    Unanswered,
    /// The program declared that there is no closest point, or that it is degenerate, although it is valid.
    Declined,
    /// The program states that it does not answer this case, and gave no number.
    NotAsked,
    /// All its numbers, and whether the references disagree among themselves.
    Compared(Vec<Judged>, bool),
}

/// Half a unit of the last of `digits` significant digits, over the number: the largest relative change by rounding.
pub(super) fn half_unit(digits: u8) -> f64 {
    0.5 * 10.0_f64.powi(1 - i32::from(digits))
}

impl Entry {
    /// The judgement under these demands, and its tolerance.
    pub(super) fn judged(self, digits: Option<u8>) -> Judged {
        let Self {
            comparison, loss, attainable, best_scale: scale, size, is_contracted, sensitivity, ..
        } = self;
        let is_parameter = matches!(
            (comparison.quantity, comparison.order),
            (Quantity::Xi | Quantity::XiBar, crate::check::Order::Value)
        );
        let size = if is_parameter { 1.0 } else { size.max(comparison.other.abs()) };
        // Digits are those of the number. Its terms may be so much larger that no digit of it were asked for.
        let limit = digits.map(|digits| attainable.max(half_unit(digits) * size));
        let (is_meaningful, is_right) = match limit {
            None => (self.is_meaningful_with(comparison.tolerance, 0.0), comparison.agrees()),
            Some(limit) => (
                self.is_meaningful_with(attainable, scale.max(size)),
                loss <= limit || comparison.difference() <= limit,
            ),
        };
        let judgement = match (is_meaningful, is_right) {
            (false, _) => Judgement::Unclear,
            (true, true) if loss > attainable => Judgement::Loses,
            (true, true) => Judgement::Agrees,
            (true, false) => Judgement::Wrong,
        };
        // The difference that rounding may explain under the demands.
        let tolerance = limit.unwrap_or(comparison.tolerance);
        let is_rounding = comparison.agrees();
        let comparison = Comparison { tolerance, ..comparison };
        Judged {
            comparison,
            judgement,
            loss,
            attainable,
            scale,
            size,
            is_rounding,
            is_contracted,
            sensitivity,
        }
    }
}

/// Gradients and Hessians along other directions.
fn along_others(vector: &Vector, answers: &Answers, demands: &Demands) -> Result<Vec<Judged>, String> {
    let has_arrays = |answer: &Answer| answer.gradient.is_some() || answer.hessian.is_some();
    if !answers.answers.iter().any(has_arrays) && !answers.has_element() {
        return Ok(Vec::new());
    }
    let vector = vector.along_others();
    let entries = vector.evaluated(|evaluation| {
        let element = vector.element_at(&evaluation)?;
        let (sides, _) = Sides::new(evaluation, &vector.case.test_beams);
        let converted = Converted::new(&vector, &sides, element, &demands.conventions);
        converted.entries(answers, &demands.conventions)
    });
    let entries = entries.unwrap_or(Ok(Vec::new()))?;
    let contracted = entries.into_iter().filter(|entry| entry.is_contracted);
    Ok(contracted.map(|entry| entry.judged(demands.digits)).collect())
}

/// Compares the answers to a case. Gradients and Hessians are compared along two pairs of directions: those of the case,
/// and others that the program cannot know.
///
/// # Errors
/// If an answer has the wrong number of entries.
pub fn compare_answers(
    vector: &Vector,
    answers: &Answers,
    demands: &Demands,
) -> Result<CaseFound, ExternalError> {
    compare_case(vector, Some(answers), demands, &Only::default())
}

/// Compares the answers to a case, if there are any, of a program that answers only some cases.
pub(super) fn compare_case(
    vector: &Vector,
    answers: Option<&Answers>,
    demands: &Demands,
    only: &Only,
) -> Result<CaseFound, ExternalError> {
    let compared = vector.evaluated(|evaluation| {
        let is_asked = only.has_case(&vector.id, held_name(evaluation.held));
        let answers = match answers {
            _ if !is_asked && answers.is_none_or(Answers::is_empty) => return Ok(CaseFound::NotAsked),
            None => return Ok(CaseFound::Missing),
            Some(answers) if answers.declined => return Ok(CaseFound::Declined),
            Some(answers) if answers.is_empty() => return Ok(CaseFound::Unanswered),
            Some(answers) => answers,
        };
        let element = vector.element_at(&evaluation)?;
        let (sides, paper) = Sides::new(evaluation, &vector.case.test_beams);
        let converted = Converted::new(vector, &sides, element, &demands.conventions);
        let entries = converted.entries(answers, &demands.conventions)?;
        let mut judged: Vec<_> = entries.into_iter().map(|entry| entry.judged(demands.digits)).collect();
        judged.extend(along_others(vector, answers, demands)?);
        judged.sort_by_key(|judged| place(&judged.comparison));
        let is_wrong = judged.iter().any(|judged| judged.judgement == Judgement::Wrong);
        // If the differences in double-double contradict the reference, the answer is not called wrong.
        let is_doubted = is_wrong && is_doubted(&paper, &sides.reference);
        Ok(CaseFound::Compared(judged, is_doubted))
    });
    let place =
        || answers.map_or_else(|| Place { file: String::new(), line: 0, column: 0 }, |of| of.place.clone());
    match compared {
        Ok(found) => found.map_err(|wrong: String| place().error(format!("case {}: {wrong}", vector.id))),
        Err(outcome) => Ok(CaseFound::Degenerate(outcome)),
    }
}
