//! How arguments are read that several subcommands have.

use beamgap::check::{Family, Regime};
use clap::ValueEnum;
use clap::builder::{PossibleValuesParser, TypedValueParser};

/// For whom the result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Human,
    Json,
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
