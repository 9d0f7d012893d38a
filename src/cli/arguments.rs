//! How arguments are read that several subcommands have.

use anyhow::Context;
use beamgap::check::{Family, Regime};
use beamgap::variant::{Variant, with_faults};
use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;

/// For whom a result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Human,
    Json,
}

/// Has so many threads work, or as many as there are cores.
pub(super) fn work_with(threads: Option<u16>) -> anyhow::Result<()> {
    let Some(threads) = threads else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
    pool.build_global().context("cannot start the threads")
}

/// A seed, decimal or hexadecimal.
pub(super) fn seed(text: &str) -> Result<u64, String> {
    let parsed = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        // from_str_radix would take a sign.
        Some(digits) if digits.starts_with('+') => None,
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    parsed.ok_or_else(|| "expected a decimal or 0x-hexadecimal number below 2^64".into())
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

/// The closed form with these faults planted.
pub(super) fn variant(plant: &[String]) -> anyhow::Result<Variant> {
    with_faults(plant).map_err(|unknown| clap::Error::raw(ErrorKind::InvalidValue, unknown).into())
}

/// The program, as whoever reads a printed command can run it: through cargo, if cargo runs it now.
pub(super) fn program() -> &'static str {
    let by_cargo = std::env::var_os("CARGO_PKG_NAME").is_some_and(|name| name == env!("CARGO_PKG_NAME"));
    if by_cargo { "cargo run --release --" } else { "beamgap" }
}

/// The options that plant these faults again.
pub(super) fn planting(plant: &[String]) -> String {
    plant.iter().flat_map(|fault| [" --plant '", fault, "'"]).collect()
}

/// A line for each planted fault.
pub(super) fn planted(plant: &[String]) -> String {
    plant.iter().flat_map(|fault| ["planted: ", fault, "\n"]).collect()
}
