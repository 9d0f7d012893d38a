//! The first wrong number in words, and where to look.

use crate::cli::answered::verified::Verified;
use crate::cli::count::count as counted;
use crate::cli::terminal::folded;
use crate::cli::words::{error, name as name_of};
use beamgap::check::external::{Judged, Location, is_of_element, locate};
use beamgap::check::{Comparison, Order, look_at};
use beamgap::contact::State;
use beamgap::linearization::Quantity;
use std::fmt::Write;

pub(super) const ANTISYMMETRIC: &str = "The matrix of differences is antisymmetric: a term is transposed.\n";

/// The first wrong number, and where to look.
pub(in crate::cli) fn first_wrong(verified: &Verified) -> String {
    let Verified { report, demands, .. } = verified;
    let mut text = String::new();
    let Some((vector, answers, judged)) = &report.first else { return text };
    let location = locate(vector, answers, judged, &demands.conventions);
    let location = location.as_ref().map(|location| (location, demands.conventions.first_index));
    text += &first(judged, &vector.id, &answers.place.to_string(), location);
    if let Some(((order, quantity, part), count)) = report.beginning() {
        let _ = writeln!(
            text,
            "In {count} of {} the first wrong number is {}:\nlook at {}",
            counted(report.wrong, "wrong case"),
            if is_of_element(part) { (*part).to_owned() } else { format!("{part} of {}", quantity.name()) },
            if is_of_element(part) { OF_ELEMENT } else { at(order, quantity) }
        );
    }
    text + "\n"
}

/// Where the formulas of a contact element are.
const OF_ELEMENT: &str = "the formulas of the contact element, docs/contact-element.md";

fn at(order: Order, quantity: Quantity) -> &'static str {
    match (order, quantity) {
        (Order::Value, Quantity::Xi | Quantity::XiBar) => {
            "the closest point: another minimum, or an iteration that has not converged"
        }
        _ => look_at(order, quantity),
    }
}

/// An array in words, such as Hessian of d.
pub(super) fn matrix_name(location: &Location, comparison: &Comparison) -> String {
    match location.what {
        "residual" | "tangent" => location.what.to_owned(),
        what => format!("{what} of {}", name_of(comparison)),
    }
}

/// The name of a state by its index.
fn state(index: f64) -> &'static str {
    State::ALL
        .into_iter()
        .find(|state| (f64::from(*state as u8) - index).abs() < 0.5)
        .map_or("none", State::name)
}

/// Why a contact element is zero.
const OPEN: &str = "The gap is open at this point: residual and tangent are exactly zero there.\n";

/// The wrong number itself: for a gradient or a Hessian, the entry that differs most.
fn first(judged: &Judged, case: &str, place: &str, location: Option<(&Location, usize)>) -> String {
    let comparison = &judged.comparison;
    let name = name_of(comparison);
    let [difference, tolerance, scaled] =
        [comparison.difference(), comparison.tolerance, comparison.scaled_error()].map(error);
    let pair = |answered: &str, expected: &str| {
        format!("  in {place}\n  answered {answered}\n  expected {expected}\n")
    };
    let numbers = |answered: f64, expected: f64| pair(&format!("{answered:e}"), &format!("{expected:e}"));
    if comparison.part == "state" {
        let [answered, expected] = [comparison.closed, comparison.other].map(state);
        return format!("First wrong number: the state, case {case}\n{}", pair(answered, expected));
    }
    let Some((location, first_index)) = location else {
        let what = if is_of_element(comparison.part) { String::new() } else { format!(" of {name}") };
        return format!(
            "First wrong number: {}{what}, case {case}\n{}  difference {difference}, tolerance {tolerance}, \
             scaled error {scaled}\n",
            comparison.part,
            numbers(comparison.closed, comparison.other)
        );
    };
    let indices: Vec<_> = location.indices.iter().map(|i| (i + first_index).to_string()).collect();
    let differing = if location.differing > 1 {
        let which = location.which.as_ref().map_or_else(String::new, |which| format!(": {which}"));
        folded(&format!("{} entries differ, this one most{which}", location.differing), "  ", "    ") + "\n"
    } else {
        String::new()
    };
    let matrix = matrix_name(location, comparison);
    let shape = location.shape.map_or_else(String::new, |shape| format!("The {matrix} {}.\n", shape.words()));
    let antisymmetric = if location.is_antisymmetric { ANTISYMMETRIC } else { "" };
    let is_of_element = matches!(location.what, "residual" | "tangent");
    let open = if is_of_element && comparison.other == 0.0 && location.expected == 0.0 { OPEN } else { "" };
    format!(
        "First wrong number: entry [{}] of the {matrix}, case {case}\n{}  in the block {}, scaled error {}\n{differing}  \
         along two directions: difference {difference}, tolerance {tolerance}\n{antisymmetric}{open}{shape}",
        indices.join(","),
        numbers(location.answered, location.expected),
        location.block.join(" x "),
        error(location.scaled_error)
    )
}
