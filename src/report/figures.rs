//! The figures of the reports. The same record always gives the same figures.

mod accuracy;
mod methods;
mod roofline;
mod sizes;
mod trade;

use super::chart::Axis;
use super::number::{error, time};

/// An axis of times. Each tick has a suitable unit.
fn times(range: [f64; 2], pixels: [f64; 2], name: &str) -> Axis<'_> {
    let label = |ns: f64| time(ns).replace(".00", "").replace(".0", "");
    Axis { range, pixels, name, room: 8, given: &[], label }
}

/// An axis of relative errors.
fn errors(range: [f64; 2], pixels: [f64; 2], name: &str, room: usize) -> Axis<'_> {
    let label = |value: f64| error(Some(value)).replace(".0e", "e");
    Axis { range, pixels, name, room, given: &[], label }
}
