//! The names and the words of terms, faults and summands.

use super::equation::equation;
use super::hypothesis::WrongSummand;
use crate::check::evaluation_point::SummandError;
use crate::number::{Label, Which};
use crate::variant::{Fault, Kind};

/// A term of the closed form.
pub(super) fn of_label(label: &Label) -> String {
    let (formula, term) = label.name.split_once(": ").unwrap_or(("", label.name));
    let of = if label.which == Which::Bar { ", for the bar beam" } else { "" };
    let formula = match formula {
        "" => String::new(),
        formula => format!(" of {formula}"),
    };
    format!("the term {term}{formula}{of}, {},", equation(label))
}

/// A fault of the catalogue.
pub(super) fn of_fault(Fault { label, kind }: &Fault) -> String {
    let term = of_label(label);
    match kind {
        Kind::Sign => format!("{term} has the wrong sign"),
        Kind::Dropped => format!("{term} is missing"),
        Kind::Doubled => format!("{term} counts twice"),
        Kind::Halved => format!("{term} counts half"),
        Kind::Transposed => format!("{term} has delta and Delta exchanged, or is transposed"),
        Kind::Swapped => format!("{term} has the beams exchanged"),
        Kind::BarForgotten => format!("{term} takes the beam where the bar beam belongs"),
        Kind::Stale => format!("{term} is taken at the parameters of the step before"),
    }
}

/// The symbol of the length or determinant that a sum is divided by.
fn base(name: &str) -> &'static str {
    match name.split([':', ' ']).next() {
        Some("H_t") => "|t|",
        Some("grad") if !name.starts_with("grad d") => "|t|",
        Some("H_xi") => "D",
        _ => "|d|",
    }
}

fn power(name: &str, power: i32) -> String {
    match (base(name), power) {
        (base, 1) => base.to_owned(),
        (base, power) => format!("{base}^{power}"),
    }
}

/// What a factor is called in the names of faults.
fn factor_name(factor: f64) -> String {
    let is = |kind: &Kind| kind.factor().is_some_and(|known| (known - factor).abs() < 1e-12);
    let known = Kind::ALL.iter().find(|kind| is(kind)).map(|kind| kind.name().to_owned());
    known.unwrap_or_else(|| format!("times {factor:.6}"))
}

/// What a factor does, after a subject.
fn factor_words(factor: f64, count: u8) -> String {
    let is = |number: f64| (factor - number).abs() < 1e-12;
    let occurrences = (factor * f64::from(count)).round();
    match factor {
        _ if is(0.0) => "is missing".into(),
        _ if is(-1.0) => "has the wrong sign".into(),
        _ if count > 1 && occurrences > 0.0 && is(occurrences / f64::from(count)) => {
            let times = if occurrences < 1.5 { "once".into() } else { format!("{occurrences} times") };
            format!("occurs {times} in the sum, not {count} times")
        }
        _ if is(0.5) => "counts half".into(),
        _ if is(2.0) => "counts twice".into(),
        _ => format!("is multiplied by {factor:.6}"),
    }
}

impl WrongSummand {
    /// The factor on the summand.
    fn factor(&self) -> f64 {
        1.0 + self.coefficient / f64::from(self.summand.count)
    }

    /// Whether the factor is none of common errors, which change the number of occurrences by halves.
    pub(super) fn has_free_factor(&self) -> bool {
        let halves = 2.0 * self.coefficient;
        (halves - halves.round()).abs() > 1e-12
    }

    /// The coefficient in the deviation, if it was fitted.
    pub(super) fn fitted(&self) -> Option<f64> {
        (self.summand.error == SummandError::Factor).then(|| self.factor() - 1.0)
    }

    fn name(&self) -> String {
        let label = &self.summand.label;
        match self.summand.error {
            SummandError::Factor => format!("{label} = {}", factor_name(self.factor())),
            SummandError::Power(of) => format!("{label} = times {}", power(label.name, of)),
            SummandError::System(factor) => format!("{label} = {} in second variations", factor_name(factor)),
        }
    }

    fn words(&self) -> String {
        let label = &self.summand.label;
        match self.summand.error {
            SummandError::Factor => {
                format!("{} {}", of_label(label), factor_words(self.factor(), self.summand.count))
            }
            SummandError::Power(of) => {
                let subject = if label.name.contains(": ") {
                    of_label(label)
                } else {
                    let of = if label.which == Which::Bar { ", for the bar beam," } else { "" };
                    format!("{} as a whole{of}", label.name)
                };
                let division = if of == 1 { ": a division is missing" } else { "" };
                format!("{subject} is multiplied by {}{division}", power(label.name, of))
            }
            SummandError::System(factor) => {
                format!("in the second variations alone, {} {}", of_label(label), factor_words(factor, 1))
            }
        }
    }

    /// Whether the other one is the same error in the other beam.
    fn mirrors(&self, other: &Self) -> bool {
        self.summand.mirror == Some(other.index)
    }
}

/// The number of mistakes that lead to these: the same in both beams is one, and so is a product written as its transpose.
pub(super) fn mistakes(wrong: &[WrongSummand]) -> usize {
    let is_known = |k: usize| {
        let own = &wrong[k];
        wrong[..k].iter().any(|other| own.mirrors(other) || own.summand.transposed == Some(other.index))
    };
    (0..wrong.len()).filter(|k| !is_known(*k)).count()
}

/// The names of wrong summands.
pub(super) fn names(wrong: &[WrongSummand]) -> String {
    wrong.iter().map(WrongSummand::name).collect::<Vec<_>>().join(" and ")
}

/// What is wrong with them. The same error in both beams is said once.
pub(super) fn words(wrong: &[WrongSummand]) -> String {
    let is_repeated = |k: &usize| wrong[..*k].iter().any(|known| known.mirrors(&wrong[*k]));
    let said: Vec<_> = (0..wrong.len()).filter(|k| !is_repeated(k)).map(|k| wrong[k].words()).collect();
    let both = if said.len() < wrong.len() { ", in both beams" } else { "" };
    said.join("; and ") + both
}

#[cfg(test)]
mod tests {
    use super::base;

    #[test]
    fn what_a_term_is_divided_by_is_that_of_its_sum() {
        let names = ["grad d", "grad d: A0'n", "grad t", "grad t: A1't", "H_t: tt'", "H_xi: R", "H_d: A0'A0"];
        assert_eq!(names.map(base), ["|d|", "|d|", "|t|", "|t|", "|t|", "D", "|d|"]);
    }
}
