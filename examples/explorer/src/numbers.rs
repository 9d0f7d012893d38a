//! The table of all quantities: the closed form, hyper-dual numbers, and the results of the checks.

use crate::html::{Outcome, digits, linked, number, table};
use beamgap::check::{Comparison, Order, look_at};
use beamgap::linearization::{Quantity, Varied};
use std::fmt::Write;

/// The outcome of comparisons.
pub(crate) fn outcome<'a>(entries: impl Iterator<Item = &'a Comparison>) -> Outcome {
    let of = |entry: &Comparison| match (entry.is_wrong(), entry.is_meaningful()) {
        (true, _) => Outcome::Wrong,
        (false, false) => Outcome::Unclear,
        (false, true) => Outcome::Agrees,
    };
    entries.map(of).max().unwrap_or(Outcome::NotCompared)
}

/// Whether an entry is the comparison with automatic differentiation.
pub(crate) fn is_ad(entry: &Comparison) -> bool {
    entry.against.contains("hyper-dual")
}

/// A row for each part of each quantity. For a vector it shows the component with the largest error.
pub(crate) fn numbers(entries: &[Comparison]) -> String {
    let mut rows = String::new();
    for quantity in Quantity::ALL {
        for part in Varied::<f64>::PARTS {
            let of_part =
                || entries.iter().filter(move |entry| entry.quantity == quantity && entry.part == part);
            let by_ad = || of_part().filter(|entry| is_ad(entry));
            let worst = by_ad().max_by(|x, y| x.over_tolerance().total_cmp(&y.over_tolerance()));
            let Some(worst) = worst else { continue };
            let by_order = |order: Order| outcome(of_part().filter(|entry| entry.order == order));
            let symmetry = if part == "Delta-delta" { by_order(Order::Symmetry).html() } else { "" };
            let matrix = match by_order(Order::Matrix) {
                Outcome::NotCompared => "",
                outcome => outcome.html(),
            };
            let head = if part == "value" {
                format!("<th scope=\"rowgroup\" rowspan=\"4\">{}</th>", name(quantity))
            } else {
                String::new()
            };
            let axis = worst.axis.map(|axis| format!("<sub>{axis}</sub>")).unwrap_or_default();
            let _ = writeln!(
                rows,
                "<tr>{head}<td>{}{axis}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{symmetry}</td>\
                 <td>{matrix}</td></tr>",
                letter(part),
                linked(look_at(worst.order, quantity)),
                number(worst.closed),
                number(worst.other),
                digits(worst.scaled_error()),
                outcome(by_ad()).html(),
            );
        }
    }
    let heads = [
        "quantity",
        "part",
        "equations",
        "closed form",
        "hyper-dual",
        "digits",
        "AD",
        "symmetry",
        "matrices",
    ];
    table("quantities", &heads, &rows)
}

/// The symbol of a quantity.
pub(crate) fn name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::X => "<b>x</b><sub>C</sub>",
        Quantity::XBar => "<b>x̄</b><sub>C̄</sub>",
        Quantity::DVector => "<b>d</b>",
        Quantity::TVector => "<b>t</b>",
        Quantity::TBarVector => "<b>t̄</b>",
        Quantity::D => "d",
        Quantity::T => "t",
        Quantity::TBar => "t̄",
        Quantity::Xi => "ξ<sub>C</sub>",
        Quantity::XiBar => "ξ̄<sub>C̄</sub>",
        Quantity::GN => "g<sub>N</sub>",
        Quantity::GT => "g<sub>T</sub>",
        Quantity::GTBar => "ḡ<sub>T</sub>",
        _ => "other",
    }
}

/// The symbol of a part.
pub(crate) fn letter(part: &str) -> &'static str {
    match part {
        "value" => "value",
        "delta" => "δ",
        "Delta" => "Δ",
        _ => "Δδ",
    }
}
