//! What was found of a linearization, and how it is told.

use crate::check::diagnosis::{look_at, place};
use crate::check::draw::Case;
use crate::check::verdict::{Comparison, Order};
use crate::linearization::Quantity;
use std::collections::BTreeMap;
use std::fmt;

/// The worst of one order of one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Digits {
    /// How many numbers were compared.
    pub entries: u64,
    /// How many differ beyond rounding.
    pub wrong: u64,
    /// The number that comes closest to its tolerance, or exceeds it most.
    pub worst: Comparison,
}

/// What was found of a linearization.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// Closest points at which it was compared.
    pub compared: u64,
    /// Of these, those at which some number differs beyond rounding.
    pub mismatches: u64,
    /// Of these, those at which the oracles disagree among themselves, so that the check itself cannot be trusted.
    pub doubted: u64,
    /// Closest points at which it gave no answer.
    pub unanswered: u64,
    /// What is wrong with the shape of an answer, if something is.
    pub misshapen: Option<String>,
    /// By quantity and order.
    pub digits: BTreeMap<(Quantity, Order), Digits>,
    /// The mismatches by their first wrong number.
    pub first: BTreeMap<(Order, Quantity), u64>,
    /// The first mismatch: the case in words, and its first wrong number.
    pub example: Option<(String, Comparison)>,
}

impl Found {
    /// Whether something was compared, and nothing differs beyond rounding.
    pub fn agrees(&self) -> bool {
        self.compared > 0 && self.mismatches == 0 && self.misshapen.is_none()
    }

    pub(super) fn add(&mut self, case: &Case, entries: &[Comparison], doubted: bool) {
        self.compared += 1;
        for entry in entries.iter().filter(|entry| entry.is_meaningful()) {
            let one = Digits { entries: 1, wrong: u64::from(entry.is_wrong()), worst: *entry };
            self.and_digits((entry.quantity, entry.order), one);
        }
        let Some(first) = entries.iter().filter(|entry| entry.is_wrong()).min_by_key(|entry| place(entry))
        else {
            return;
        };
        self.mismatches += 1;
        self.doubted += u64::from(doubted);
        *self.first.entry((first.order, first.quantity)).or_default() += 1;
        let [q, q_bar] = case.specimens.each_ref().map(|specimen| &specimen.q);
        let words = || format!("{}: q = {q:?}, q_bar = {q_bar:?}", case.regime.name());
        self.example.get_or_insert_with(|| (words(), *first));
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

/// Decimal digits of a relative error.
fn digits(error: f64) -> f64 {
    (-error.log10()).clamp(0.0, 16.0)
}

impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(misshapen) = &self.misshapen {
            return write!(f, "DISAGREES: {misshapen}");
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
        if let Some((case, entry)) = &self.example {
            let Comparison { part, quantity, closed, other, tolerance, .. } = entry;
            writeln!(
                f,
                "first of them, {case}\n  {part} of {}: {closed:e}, not {other:e}; rounding explains {tolerance:.1e}",
                quantity.name()
            )?;
        }
        if let Some((&(order, quantity), &count)) = self.first.iter().max_by_key(|(_, count)| **count) {
            writeln!(
                f,
                "{count} of {} mismatches begin with {} of {}: look at {}",
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
            return write!(f, "DISAGREES: at {} of {} closest points.", self.mismatches, self.compared);
        }
        if self.compared == 0 {
            return write!(f, "NOTHING COMPARED: {} closest points without an answer.", self.unanswered);
        }
        write!(f, "AGREES: at {} closest points nothing differs beyond rounding.", self.compared)
    }
}
