//! The words of terms and faults.

use crate::number::{Label, Which};
use crate::variant::{Fault, Kind};

/// A term of the closed form.
fn of_label(label: &Label) -> String {
    let Label { formula, term, which } = label;
    let of = if *which == Which::Bar { ", for the bar beam" } else { "" };
    format!("the term {term} of {}{of}, {},", formula.name(), formula.equation())
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
