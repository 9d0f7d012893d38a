//! Tests whether wrong answers are correct in other conventions.

use super::answers::Answers;
use super::compare::{Converted, Demands, Judgement};
use super::vectors::Vector;
use crate::check::candidate::Sides;

/// The number of cases that are tried.
const TRIED: usize = 6;

/// The conventions in which all these answers agree, in words; nothing if no conventions do.
pub fn other_conventions(cases: &[(Vector, Answers)], demands: &Demands) -> Option<String> {
    let sides = |(vector, answers): &(Vector, Answers)| {
        let sides = vector.evaluated(|evaluation| Sides::new(evaluation, &vector.case.test_beams).0).ok()?;
        Some((vector.clone(), answers.clone(), sides))
    };
    let cases: Vec<_> = cases.iter().take(TRIED).filter_map(sides).collect();
    if cases.is_empty() {
        return None;
    }
    let agree = |conventions: &super::Conventions| {
        cases.iter().all(|(vector, answers, sides)| {
            let converted = Converted::new(vector, sides, conventions);
            let Ok(entries) = converted.entries(answers, conventions) else { return false };
            let judged = entries.into_iter().map(|entry| entry.judged(demands.digits).judgement);
            let mut judged = judged.filter(|judgement| *judgement != Judgement::Unclear).peekable();
            judged.peek().is_some() && judged.all(|judgement| judgement != Judgement::Wrong)
        })
    };
    // Along these directions nothing is wrong.
    if agree(&demands.conventions) {
        return None;
    }
    let others = demands.conventions.others();
    others.into_iter().find(|(conventions, _)| agree(conventions)).map(|(_, words)| words)
}
