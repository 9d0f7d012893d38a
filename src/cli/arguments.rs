//! Parsers of the arguments that several subcommands share.

use anyhow::Context;
use beamgap::check::{Family, Regime};
use beamgap::variant::{Variant, with_faults};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use std::collections::BTreeSet;
use std::time::Duration;

/// Sets the number of threads; the default is the number of cores.
pub(super) fn work_with(threads: Option<u16>) -> anyhow::Result<()> {
    let Some(threads) = threads else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
    pool.build_global().context("cannot start the threads")
}

/// A seed, decimal or hexadecimal.
pub(super) fn seed(text: &str) -> Result<u64, String> {
    let parsed = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        // `from_str_radix` would accept a sign.
        Some(digits) if digits.starts_with('+') => None,
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    parsed.ok_or_else(|| "expected a decimal or 0x-hexadecimal number below 2^64".into())
}

/// A duration: seconds, with a unit or without.
pub(super) fn seconds(text: &str) -> Result<Duration, String> {
    let units = [("ms", 1e-3), ("s", 1.0), ("m", 60.0), ("min", 60.0), ("h", 3600.0)];
    let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let unit = &text[digits.len()..];
    let unit =
        if unit.is_empty() { Some(1.0) } else { units.iter().find(|(name, _)| *name == unit).map(|of| of.1) };
    let parsed = unit.and_then(|unit| Some(digits.parse::<f64>().ok()? * unit)).filter(|time| *time >= 0.0);
    let duration = parsed.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    // A limit of a year has the same effect as no limit.
    let longest = Duration::from_secs(366 * 24 * 3600);
    duration.map(|time| time.min(longest)).ok_or_else(|| "a time expected, such as 30s, 5m or 1h".into())
}

/// The name of a family.
pub(super) fn families() -> impl TypedValueParser<Value = Family> {
    PossibleValuesParser::new(Family::ALL.map(Family::name))
        .try_map(|name| Family::from_name(&name).ok_or("no such family"))
}

/// The name of a regime.
pub(super) fn regimes() -> impl TypedValueParser<Value = Regime> {
    PossibleValuesParser::new(Regime::ALL.map(Regime::name))
        .try_map(|name| Regime::from_name(&name).ok_or("no such regime"))
}

/// The name of a fault.
pub(super) fn fault(text: &str) -> Result<String, String> {
    let expected =
        "a term and a kind expected, such as `a: d.t,xi = dropped`; `beamgap faults --list` lists all";
    let name = text.to_owned();
    with_faults(std::slice::from_ref(&name)).map(|_| name).map_err(|_| expected.to_owned())
}

/// The closed form with these faults injected.
pub(super) fn variant(plant: &[String]) -> anyhow::Result<Variant> {
    let mut known = BTreeSet::new();
    if let Some(term) = plant.iter().map(|fault| term(fault)).find(|term| !known.insert(*term)) {
        let words = format!("one fault of the term {term:?} expected, found several\n");
        return Err(clap::Error::raw(ErrorKind::ArgumentConflict, words).into());
    }
    with_faults(plant).map_err(|unknown| clap::Error::raw(ErrorKind::InvalidValue, unknown).into())
}

/// The term of a fault.
fn term(fault: &str) -> &str {
    fault.split_once(" = ").map_or(fault, |(term, _)| term)
}

/// The command that runs this program, for printed commands: through cargo, if cargo runs it now.
pub(super) fn program() -> &'static str {
    let by_cargo = std::env::var_os("CARGO_PKG_NAME").is_some_and(|name| name == env!("CARGO_PKG_NAME"));
    if by_cargo { "cargo run --release --" } else { "beamgap" }
}

/// The options that inject these faults again.
pub(super) fn planting(plant: &[String]) -> String {
    plant.iter().flat_map(|fault| [" --plant '", fault, "'"]).collect()
}

/// A line for each injected fault.
pub(super) fn planted(plant: &[String]) -> String {
    plant.iter().flat_map(|fault| ["planted: ", fault, "\n"]).collect()
}
