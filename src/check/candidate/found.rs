//! The result of the check of a linearization, and its text.

use super::AtPoint;
use crate::check::diagnosis::{look_at, place};
use crate::check::draw::Case;
use crate::check::verdict::{Comparison, Order};
use crate::check::{CaseData, Regime};
use crate::linearization::Quantity;
use crate::pair::Contact;
use std::collections::BTreeMap;
use std::fmt;

/// The worst comparison of one order of one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Digits {
    /// The number of compared numbers.
    pub entries: u64,
    /// The number of those that differ beyond rounding.
    pub wrong: u64,
    /// The number that comes closest to its tolerance, or exceeds it most.
    pub worst: Comparison,
}

/// The result of the check of a linearization.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// Closest points at which it was compared.
    pub compared: u64,
    /// Of these, those at which some number differs beyond rounding.
    pub mismatches: u64,
    /// Of these, those at which the oracles disagree among themselves, so that the check itself cannot be trusted.
    pub doubted: u64,
    /// Closest points without an answer.
    pub unanswered: u64,
    /// The error in the shape of an answer, if there is one.
    pub misshapen: Option<String>,
    /// The digits, by quantity and order.
    pub digits: BTreeMap<(Quantity, Order), Digits>,
    /// The mismatches by their first wrong number.
    pub first: BTreeMap<(Order, Quantity), u64>,
    /// The first mismatch, shrunk.
    pub example: Option<Example>,
}

/// A mismatch.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// The number of the case that it comes from.
    pub number: u64,
    /// The regime of that case.
    pub regime: Regime,
    /// A smaller case of the same families with the same first wrong number.
    pub case: CaseData,
    /// The first wrong number.
    pub entry: Comparison,
}

impl Found {
    /// Whether something was compared, and nothing differs beyond rounding.
    pub fn agrees(&self) -> bool {
        self.compared > 0 && self.mismatches == 0 && self.misshapen.is_none()
    }

    /// The result for one case.
    pub(super) fn of(case: &Case, at_points: &[AtPoint]) -> Self {
        let mut found = Self::default();
        for AtPoint { entries, misshapen, doubted } in at_points {
            found.misshapen = found.misshapen.or(misshapen.clone());
            if entries.is_empty() {
                found.unanswered += u64::from(misshapen.is_none());
                continue;
            }
            found.compared += 1;
            for entry in entries.iter().filter(|entry| entry.is_meaningful()) {
                let one = Digits { entries: 1, wrong: u64::from(entry.is_wrong()), worst: *entry };
                found.and_digits((entry.quantity, entry.order), one);
            }
            let wrong = entries.iter().filter(|entry| entry.is_wrong());
            let Some(&entry) = wrong.min_by_key(|entry| place(entry)) else { continue };
            found.mismatches += 1;
            found.doubted += u64::from(*doubted);
            *found.first.entry((entry.order, entry.quantity)).or_default() += 1;
            let (number, regime) = (case.number, case.regime);
            found.example.get_or_insert_with(|| Example { number, regime, case: case.data(), entry });
        }
        found
    }

    fn and_digits(&mut self, key: (Quantity, Order), other: Digits) {
        let digits = self.digits.entry(key).or_insert(Digits { entries: 0, wrong: 0, ..other });
        digits.entries += other.entries;
        digits.wrong += other.wrong;
        if other.worst.over_tolerance() > digits.worst.over_tolerance() {
            digits.worst = other.worst;
        }
    }

    pub(super) fn and(mut self, other: Self) -> Self {
        self.compared += other.compared;
        self.mismatches += other.mismatches;
        self.doubted += other.doubted;
        self.unanswered += other.unanswered;
        self.misshapen = self.misshapen.or(other.misshapen);
        for (key, digits) in other.digits {
            self.and_digits(key, digits);
        }
        for (key, count) in other.first {
            *self.first.entry(key).or_default() += count;
        }
        self.example = self.example.or(other.example);
        self
    }
}

/// The case with its number and all numbers of both beams, 80 columns wide.
fn in_words(Example { number, regime, case, .. }: &Example) -> String {
    let [beam, bar] = &case.test_beams;
    let families = [beam, bar].map(|test_beam| test_beam.family.name());
    format!("case {number}, {}, shrunk: {} and {}", regime.name(), families[0], families[1])
        + &contact_in_words(&case.contact)
        + &[
            ("curve", &beam.parameters),
            ("curve_bar", &bar.parameters),
            ("q", &beam.q),
            ("q_bar", &bar.q),
            ("dq", &beam.dq),
            ("dq_bar", &bar.dq),
            ("Dq", &beam.linear_dq),
            ("Dq_bar", &bar.linear_dq),
        ]
        .map(|(name, numbers)| list(name, numbers))
        .concat()
}

/// Radii and reference parameters on a separate line, if some are not zero.
pub(in crate::check) fn contact_in_words(contact: &Contact) -> String {
    let Contact { radius, radius_bar, xi_0, xi_bar_0 } = *contact;
    let numbers = [radius, radius_bar, xi_0, xi_bar_0];
    list("radius, radius_bar, xi_0, xi_bar_0", if *contact == Contact::default() { &[] } else { &numbers })
}

/// Numbers with their name on separate lines; nothing if there are none.
pub(in crate::check) fn list(name: &str, numbers: &[f64]) -> String {
    if numbers.is_empty() {
        return String::new();
    }
    let (mut text, mut line) = (String::new(), format!("  {name} ="));
    for number in numbers {
        let word = format!(" {number:e}");
        if line.len() + word.len() > 80 {
            text = text + "\n" + &line;
            line = "   ".into();
        }
        line += &word;
    }
    text + "\n" + &line
}

/// The decimal digits of a relative error.
fn digits(error: f64) -> f64 {
    (-error.log10()).clamp(0.0, 16.0)
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(misshapen) = &self.misshapen {
            return write!(f, "DISAGREE: {misshapen}");
        }
        writeln!(
            f,
            "{:<8} {:<7} {:>8} {:>8} {:>15} {:>18}",
            "quantity", "order", "numbers", "wrong", "digits reached", "digits attainable"
        )?;
        for ((quantity, order), Digits { entries, wrong, worst }) in &self.digits {
            let (reached, attainable) = (digits(worst.scaled_error()), digits(worst.tolerance / worst.scale));
            let (name, order) = (quantity.name(), order.name());
            let mark = if *wrong > 0 { "  WRONG" } else { "" };
            writeln!(
                f,
                "{name:<8} {order:<7} {entries:>8} {wrong:>8} {reached:>15.1} {attainable:>18.1}{mark}"
            )?;
        }
        if let Some(example) = &self.example {
            let Comparison { part, quantity, closed, other, tolerance, .. } = example.entry;
            writeln!(
                f,
                "{}\n  {part} of {}: {closed:e},\n  not {other:e}; tolerance {tolerance:.1e}",
                in_words(example),
                quantity.name()
            )?;
        }
        if let Some((&(order, quantity), &count)) = self.first.iter().max_by_key(|(_, count)| **count) {
            writeln!(
                f,
                "{count} of {} mismatches begin with {} of {}:\nlook at {}",
                self.mismatches,
                order.name(),
                quantity.name(),
                look_at(order, quantity)
            )?;
        }
        if self.doubted > 0 {
            writeln!(
                f,
                "at {} of them the oracles disagree: the check itself cannot be trusted",
                self.doubted
            )?;
        }
        if self.mismatches > 0 {
            return write!(f, "DISAGREE: at {} of {} closest points.", self.mismatches, self.compared);
        }
        if self.compared == 0 {
            return write!(f, "NOTHING COMPARED: {} closest points without an answer.", self.unanswered);
        }
        write!(f, "AGREE: at {} closest points nothing differs beyond rounding.", self.compared)
    }
}
