//! Answers that have few digits, although none were stated.

use super::answers::Answers;
use super::compare::{CaseFound, Demands, Judged, Judgement, compare_answers, half_unit};
use super::vectors::Vector;
use crate::check::Answer;
use std::collections::BTreeMap;

/// The number of digits up to which answers are not those of a program in double precision.
const FEW: u8 = 10;
/// The number of decimals up to which small answers are not those of a program in double precision.
const FEW_DECIMALS: i32 = 12;
/// The number of digits that single precision keeps.
const SINGLE: u8 = 6;
/// The rounding of single precision over that of double precision.
const COARSER: f64 = 536_870_912.0;
/// The number of numbers that are needed to tell.
const NUMBERS: usize = 30;

/// The digits of answers that have few of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FewDigits {
    /// The significant digits of the answers, or their decimals.
    pub digits: u8,
    /// What these digits are.
    pub kind: FewKind,
    /// Whether all answers have so few, and not only the wrong ones.
    pub is_all: bool,
    /// Whether the wrong answers agree if only so many digits are required.
    pub agree: bool,
}

/// The kinds of numbers that have few digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FewKind {
    /// Few significant digits.
    Significant,
    /// Few decimals, as `%.6f` prints them, so that small numbers have few digits.
    Decimals,
    /// Numbers of single precision, with the regimes in which they agree to six digits, in which rounding in single
    /// precision explains their differences, and in which it does not.
    Single([Vec<String>; 3]),
}

impl FewDigits {
    /// Whether the digits alone explain the differences, or hide what else is wrong.
    pub fn settles(&self) -> bool {
        match &self.kind {
            FewKind::Significant => self.agree,
            FewKind::Decimals => true,
            FewKind::Single([_, _, unexplained]) => self.agree || unexplained.is_empty(),
        }
    }
}

/// What the numbers of answers have in common.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Precision {
    numbers: usize,
    /// The numbers that single precision does not have.
    not_single: usize,
    /// The most significant digits.
    most: u8,
    /// The most decimals.
    decimals: i32,
    /// For each power of ten, the count of numbers.
    powers: BTreeMap<i32, usize>,
    /// The largest error of a wrong number over its size.
    worst: f64,
    /// Of answers in single precision, by regime: all cases, those that agree to six digits, and those whose differences
    /// rounding in single precision explains.
    singles: BTreeMap<String, [u64; 3]>,
}

impl Precision {
    fn of(all: impl Iterator<Item = f64>) -> Self {
        let mut found = Self::default();
        all.for_each(|number| found.add_number(number));
        found
    }

    fn add_number(&mut self, number: f64) {
        if !number.is_finite() || number == 0.0 {
            return;
        }
        let (digits, power) = significant(number);
        self.numbers += 1;
        self.not_single += usize::from(!is_single(number));
        self.most = self.most.max(digits);
        self.decimals = self.decimals.max(i32::from(digits) - 1 - power);
        *self.powers.entry(power).or_default() += 1;
    }

    /// Whether the numbers are those of a program in double precision, so that no more of them need to be read.
    fn is_double(&self) -> bool {
        self.most > FEW && self.decimals > FEW_DECIMALS && self.not_single > 0
    }

    /// Adds the answers to a case.
    pub(super) fn add(&mut self, regime: &str, answers: &Answers, judged: &[Judged]) {
        for one in judged.iter().filter(|one| one.judgement == Judgement::Wrong) {
            let error = one.comparison.difference().min(one.loss);
            if error > one.attainable {
                self.worst = self.worst.max(error / one.size);
            }
        }
        if self.is_double() {
            return;
        }
        numbers(answers).for_each(|number| self.add_number(number));
        if self.not_single == 0 {
            let is_explained = |one: &Judged| {
                let of_single = COARSER * one.comparison.tolerance.max(one.attainable);
                one.comparison.difference().min(one.loss) <= of_single
            };
            let agrees = |one: &Judged| {
                let asked = half_unit(SINGLE) * one.size;
                one.judgement != Judgement::Wrong || one.loss <= one.attainable.max(asked)
            };
            let [cases, agree, explained] = self.singles.entry(regime.to_owned()).or_default();
            *cases += 1;
            *agree += u64::from(judged.iter().all(agrees));
            *explained += u64::from(judged.iter().all(|one| agrees(one) || is_explained(one)));
        }
    }

    /// The few digits of these numbers.
    fn kind(&self) -> Option<(u8, FewKind)> {
        if self.numbers < NUMBERS {
            return None;
        }
        // Of numbers with so many decimals the small ones have fewer significant digits than the large ones.
        let lowest = self.powers.iter().find(|(_, count)| **count >= 3).map_or(0, |(power, _)| *power);
        let of_lowest = self.decimals + 1 + lowest;
        let is_fixed = self.decimals <= FEW_DECIMALS && lowest < 0 && i32::from(self.most) >= of_lowest + 2;
        if is_fixed {
            return Some((u8::try_from(self.decimals).ok()?, FewKind::Decimals));
        }
        if self.most <= FEW {
            return Some((self.most.min(15), FewKind::Significant));
        }
        let of = |is_in: fn(&[u64; 3]) -> bool| {
            self.singles.iter().filter(|(_, counts)| is_in(counts)).map(|(name, _)| name.clone()).collect()
        };
        // Every number of few digits can be one of single precision by chance, but not all of many digits.
        (self.not_single == 0).then(|| {
            let regimes = [
                of(|[cases, agree, _]| agree == cases),
                of(|[cases, agree, explained]| agree < cases && explained == cases),
                of(|[cases, _, explained]| explained < cases),
            ];
            (SINGLE, FewKind::Single(regimes))
        })
    }
}

/// The digits of these wrong answers, if they are few. `precision` is that of all answers.
pub fn few_digits(
    cases: &[(Vector, Answers)],
    precision: &Precision,
    demands: &Demands,
) -> Option<FewDigits> {
    if demands.digits.is_some() {
        return None;
    }
    let (digits, kind) = Precision::of(cases.iter().flat_map(|(_, answers)| numbers(answers))).kind()?;
    let of_all = precision.kind();
    let is_all = of_all.as_ref().is_some_and(|(most, all)| {
        std::mem::discriminant(all) == std::mem::discriminant(&kind) && *most <= digits
    });
    // The regimes are those of all answers.
    let kind = match (kind, of_all) {
        (FewKind::Single(_), Some((_, all @ FewKind::Single(_)))) => all,
        (FewKind::Single(_), _) => FewKind::Single(Default::default()),
        (kind, _) => kind,
    };
    let is_fixed = kind == FewKind::Decimals;
    let asked = Demands { digits: (!is_fixed).then_some(digits), ..*demands };
    let printed = 0.5 * 10.0_f64.powi(-i32::from(digits));
    let agrees = |of: &Judged| {
        let by_print = if is_fixed { printed * of.sensitivity } else { 0.0 };
        of.judgement != Judgement::Wrong || of.loss <= of.attainable + by_print
    };
    let is_right = |(vector, answers): &(Vector, Answers)| match compare_answers(vector, answers, &asked) {
        Ok(CaseFound::Compared(judged, _)) => judged.iter().all(agrees),
        Ok(_) => true,
        Err(_) => false,
    };
    // Not all wrong cases are kept.
    let is_near = is_fixed || precision.worst <= half_unit(digits);
    Some(FewDigits { digits, kind, is_all, agree: is_near && cases.iter().all(is_right) })
}

#[expect(clippy::cast_possible_truncation, reason = "tests whether the number is one of single precision")]
fn is_single(number: f64) -> bool {
    f64::from(number as f32).to_bits() == number.to_bits()
}

/// The significant digits of a number, and its power of ten: those of the shortest text that is read back as this number.
fn significant(number: f64) -> (u8, i32) {
    let text = format!("{number:e}");
    let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    (u8::try_from(digits).unwrap_or(u8::MAX), power.parse().unwrap_or(0))
}

fn numbers(answers: &Answers) -> impl Iterator<Item = f64> + '_ {
    let arrays = |answer: &Answer| [answer.gradient.clone(), answer.hessian.clone()];
    let single = |answer: &Answer| {
        let [delta, linear, second] = answer.variations;
        [answer.value, delta, linear, second]
    };
    let all = answers.answers.iter();
    let arrays = all.clone().flat_map(arrays).chain([answers.residual.clone(), answers.tangent.clone()]);
    all.flat_map(single).flatten().chain(arrays.flatten().flatten())
}

#[cfg(test)]
mod tests {
    use super::{FewKind, Precision, significant};

    #[test]
    fn significant_digits_are_counted() {
        let all = [1.0, -0.125, 1.5e-300, 1e22, 0.1 + 0.2, 123.456];
        assert_eq!(all.map(|number| significant(number).0), [1, 3, 2, 1, 17, 6]);
        assert_eq!(all.map(|number| significant(number).1), [0, -1, -300, 22, -1, 2]);
    }

    /// Numbers of many powers of ten, printed by each of the formats.
    #[test]
    fn decimals_and_digits_are_told_apart() {
        let numbers = |f: &dyn Fn(f64) -> String| {
            let all = (0..200).map(|k| (f64::from(k) * 0.7).sin() * 10.0_f64.powi(k % 5 - 3));
            Precision::of(all.map(|x| f(x).parse().unwrap())).kind()
        };
        for n in [4_u8, 6, 9, 12] {
            let digits = usize::from(n);
            assert_eq!(numbers(&|x| format!("{x:.digits$}")), Some((n, FewKind::Decimals)));
        }
        for n in [4_u8, 6, 10] {
            let digits = usize::from(n - 1);
            assert_eq!(numbers(&|x| format!("{x:.digits$e}")), Some((n, FewKind::Significant)));
        }
        assert_eq!(numbers(&|x| format!("{x:e}")), None);
        assert!(matches!(
            numbers(&|x| f64::from(x.to_string().parse::<f32>().unwrap()).to_string()),
            Some((6, FewKind::Single(_)))
        ));
    }
}
