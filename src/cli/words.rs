//! Quantities, errors and cases in words.

use super::arguments::program;
use beamgap::check::Comparison;

/// The quantity with its component.
pub(super) fn name(entry: &Comparison) -> String {
    entry
        .axis
        .map_or_else(|| entry.quantity.name().into(), |axis| format!("{}.{axis}", entry.quantity.name()))
}

/// The command that repeats one case.
pub(super) fn repeat(seed: u64, number: u64) -> String {
    format!("{} check --seed {seed:#x} --case {number}", program())
}

/// An error with two digits.
pub(super) fn error(error: f64) -> String {
    if error == 0.0 { "0".into() } else { format!("{error:.1e}") }
}
