//! The figures of the page. The same record always gives the same figures.

mod methods;
mod roofline;
mod sizes;
mod trade;

use beamgap::report::chart::Axis;
use beamgap::report::number::time;

/// An axis of times. Each tick has a suitable unit.
fn times(range: [f64; 2], pixels: [f64; 2], name: &str) -> Axis<'_> {
    let label = |ns: f64| time(ns).replace(".00", "").replace(".0", "");
    Axis { range, pixels, name, room: 8, given: &[], label }
}
