//! Answers that have few digits, although none were stated.

use super::answers::Answers;
use super::compare::{CaseFound, Demands, Judgement, compare_answers};
use super::vectors::Vector;
use crate::check::Answer;

/// The number of digits up to which answers are not those of a program in double precision.
const FEW: u8 = 10;
/// The number of digits that single precision keeps.
const SINGLE: u8 = 6;
/// The number of numbers that are needed to tell.
const NUMBERS: usize = 30;

/// The digits of answers that have few of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FewDigits {
    /// The significant digits of the answers.
    pub digits: u8,
    /// Whether all numbers are those of single precision.
    pub is_single: bool,
    /// Whether these answers agree if only so many digits are required.
    pub agree: bool,
}

/// The digits of these answers, if they are few.
pub fn few_digits(cases: &[(Vector, Answers)], demands: &Demands) -> Option<FewDigits> {
    if demands.digits.is_some() {
        return None;
    }
    let numbers: Vec<f64> = cases.iter().flat_map(|(_, answers)| numbers(answers)).collect();
    let is_telling = |number: &&f64| number.is_finite() && **number != 0.0;
    let telling: Vec<f64> = numbers.iter().filter(is_telling).copied().collect();
    if telling.len() < NUMBERS {
        return None;
    }
    #[expect(
        clippy::cast_possible_truncation,
        reason = "tests whether the number is one of single precision"
    )]
    let is_single = telling.iter().all(|&number| f64::from(number as f32).to_bits() == number.to_bits());
    let most = telling.iter().map(|number| significant(*number)).max().unwrap_or(u8::MAX);
    // Every number of few digits can be one of single precision by chance, but not all of many digits.
    let (digits, is_single) = if most <= FEW { (most.min(15), false) } else { (SINGLE, is_single) };
    if most > FEW && !is_single {
        return None;
    }
    let asked = Demands { digits: Some(digits), ..*demands };
    let is_right = |(vector, answers): &(Vector, Answers)| match compare_answers(vector, answers, &asked) {
        Ok(CaseFound::Compared(judged, _)) => judged.iter().all(|of| of.judgement != Judgement::Wrong),
        Ok(_) => true,
        Err(_) => false,
    };
    Some(FewDigits { digits, is_single, agree: cases.iter().all(is_right) })
}

/// The significant digits of a number: those of the shortest text that is read back as this number.
fn significant(number: f64) -> u8 {
    let text = format!("{number:e}");
    let mantissa = text.split('e').next().unwrap_or_default();
    u8::try_from(mantissa.bytes().filter(u8::is_ascii_digit).count()).unwrap_or(u8::MAX)
}

fn numbers(answers: &Answers) -> Vec<f64> {
    let arrays = |answer: &Answer| [answer.gradient.clone(), answer.hessian.clone()];
    let single = |answer: &Answer| {
        let [delta, linear, second] = answer.variations;
        [answer.value, delta, linear, second]
    };
    let all = answers.answers.iter();
    let arrays = all.clone().flat_map(arrays).chain([answers.residual.clone(), answers.tangent.clone()]);
    all.flat_map(single).flatten().chain(arrays.flatten().flatten()).collect()
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn significant_digits_are_counted() {
        let all = [1.0, -0.125, 1.5e-300, 1e22, 0.1 + 0.2, 123.456];
        assert_eq!(all.map(significant), [1, 3, 2, 1, 17, 6]);
    }
}
