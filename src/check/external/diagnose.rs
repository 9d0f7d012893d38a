//! Tests whether wrong answers are correct in other conventions, or come nearer in them.

use super::answers::Answers;
use super::compare::{Converted, Demands, Judgement};
use super::conventions::Conventions;
use super::vectors::Vector;
use crate::check::candidate::Sides;
use crate::check::evaluation_point::EvaluationPoint;

/// The number of cases that are tried.
const TRIED: usize = 6;
/// The maximum number of steps from conventions to better ones.
const STEPS: usize = 4;

/// Conventions in which fewer numbers of the answers are wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherConventions {
    /// The conventions.
    pub conventions: Conventions,
    /// The changes, in words.
    pub words: String,
    /// The count of wrong numbers in them.
    pub wrong: usize,
    /// The count of wrong numbers in the stated conventions, at the same cases.
    pub wrong_before: usize,
}

impl OtherConventions {
    /// Whether all answers agree in these conventions.
    pub fn agree(&self) -> bool {
        self.wrong == 0
    }
}

/// The conventions in which the fewest numbers of these answers are wrong; nothing if the stated ones are the best.
pub fn other_conventions(cases: &[(Vector, Answers)], demands: &Demands) -> Option<OtherConventions> {
    let sides = |(vector, answers): &(Vector, Answers)| {
        let of = |evaluation: EvaluationPoint<'_>| {
            let element = vector.element_at(&evaluation).ok()?;
            Some((Sides::new(evaluation, &vector.case.test_beams).0, element))
        };
        Some((vector.clone(), answers.clone(), vector.evaluated(of).ok()??))
    };
    let cases: Vec<_> = cases.iter().take(TRIED).filter_map(sides).collect();
    // The count of wrong numbers; nothing if no number can be judged.
    let wrong = |conventions: &Conventions| {
        let mut judged = Vec::new();
        for (vector, answers, (sides, element)) in &cases {
            let converted = Converted::new(vector, sides, element.clone(), conventions);
            let entries = converted.entries(answers, conventions).ok()?;
            judged.extend(entries.into_iter().map(|entry| entry.judged(demands.digits).judgement));
        }
        judged.retain(|judgement| *judgement != Judgement::Unclear);
        let wrong = judged.iter().filter(|judgement| **judgement == Judgement::Wrong).count();
        (!judged.is_empty()).then_some(wrong)
    };
    let has_element =
        demands.conventions.penalty.is_some() || cases.iter().any(|(vector, ..)| vector.element.is_some());
    let wrong_before = wrong(&demands.conventions)?;
    let (mut best, mut words, mut fewest) = (demands.conventions, Vec::new(), wrong_before);
    for _ in 0..STEPS {
        let tried = best.others(has_element).into_iter();
        let tried = tried.filter_map(|(other, words)| Some((wrong(&other)?, other, words)));
        // Of several, the first has the fewest changes.
        let Some((count, other, change)) = tried.min_by_key(|(count, ..)| *count) else { break };
        if count >= fewest {
            break;
        }
        (best, fewest) = (other, count);
        words.push(change);
        if fewest == 0 {
            break;
        }
    }
    // A few numbers fewer are chance: answers with a wrong term may be nearer in a wrong convention.
    // A sign of residual or tangent must be clearer: a term with a wrong sign is as good as the others with wrong signs.
    let signs = |of: &Conventions| (of.residual_is_negative, of.tangent_is_negative);
    let share = if signs(&best) == signs(&demands.conventions) { 8 } else { 5 };
    let is_clear = 10 * fewest <= share * wrong_before;
    let found =
        OtherConventions { conventions: best, words: words.join(" and "), wrong: fewest, wrong_before };
    (!words.is_empty() && is_clear).then_some(found)
}
