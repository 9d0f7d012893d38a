//! `beamgap bounds`: whether the tolerances are error bounds, and their overestimation factor.

use super::arguments::{families, regimes, seed};
use super::count::count;
use super::exit::Exit;
use super::outcome::{Entry, Outcome, State, Verdict};
use super::output::OutputOptions;
use super::progress::Progress;
use super::terminal;
use beamgap::check::{Family, Order, Regime, Selection, bounds};
use beamgap::report::{BOUNDS_CASES, Bounds, Environment, Record};
use clap::{Args, value_parser};
use std::fmt::Write;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct MeasureBounds {
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// How many cases of each regime; there are ten regimes
    #[arg(long, value_name = "N", default_value_t = BOUNDS_CASES)]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    cases: u64,
    /// Only pairs in which beam, bar beam or both are of this family; may be given once
    #[arg(long, value_parser = families())]
    family: Option<Family>,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
    #[command(flatten)]
    output: OutputOptions,
}

impl MeasureBounds {
    /// Measures and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let mut outputs = self.output.open()?;
        outputs.begin("Bounds\n")?;
        let asked = |regime: &Regime| self.regime.is_empty() || self.regime.contains(regime);
        let regimes = Regime::ALL.into_iter().filter(asked).collect();
        let selection = Selection { regimes, family: self.family, cases: self.cases };
        let progress = Progress::bar("cases", selection.cases * selection.regimes.len() as u64);
        let found = bounds(self.seed, &selection, || progress.step());
        progress.end();
        let mut command = format!("beamgap bounds --seed {:#x} --cases {}", self.seed, self.cases);
        let named = selection
            .regimes
            .iter()
            .filter(|_| !self.regime.is_empty())
            .map(|&regime| ("regime", regime.name()));
        for (option, name) in named.chain(self.family.map(|family| ("family", family.name()))) {
            let _ = write!(command, " --{option} {name}");
        }
        let record = Bounds::new(found, self.seed, self.cases, Environment::here(&command));
        let outcome = outcome(&record);
        let human = || terminal::page(&record.page(), &outcome.verdict.words);
        outputs.write(&outcome, human, || Ok(record.to_json()?))?;
        Ok(outcome.verdict.exit)
    }
}

/// The outcome of a record, with one entry for each order of each side.
fn outcome(record: &Bounds) -> Outcome {
    let found = &record.found;
    let points: u64 = found.points.values().map(|points| points.measured).sum();
    let (exit, name, words) = match (points, found.violations.len()) {
        (0, _) => (
            Exit::Nothing,
            "nothing-measured",
            "NOTHING MEASURED: no closest point could be measured.".to_owned(),
        ),
        (_, 0) => {
            let points = count(points, "closest point");
            let words = format!("BOUNDS HOLD: at {points} no error exceeds its bound.");
            (Exit::Agree, "hold", words)
        }
        (_, n) => {
            let words = format!("BROKEN BOUNDS: in {} an error exceeds its bound.", count(n, "case"));
            (Exit::Untrusted, "broken", words)
        }
    };
    let entries = found.all.iter().map(|(&(side, order), measured)| {
        let wrong =
            found.violations.values().filter(|of| (of.side, order_of(of.part)) == (side, order)).count();
        Entry {
            group: order.name().to_owned(),
            name: side.name().to_owned(),
            state: State::of(measured.entries, wrong as u64),
            message: format!(
                "{} with an error; it exceeds its bound in {}",
                count(measured.entries, "number"),
                count(wrong, "case")
            ),
            source: None,
        }
    });
    Outcome { command: "bounds", verdict: Verdict::new(exit, name, words), entries: entries.collect() }
}

fn order_of(part: &str) -> Order {
    match part {
        "value" => Order::Value,
        "Delta-delta" | "tangent, delta-Delta" | "tangent, Delta-delta" => Order::Second,
        _ => Order::First,
    }
}

#[cfg(test)]
mod tests {
    use super::outcome;
    use crate::cli::exit::Exit;
    use beamgap::check::{Points, Regime, Selection, Side, Violation, bounds};
    use beamgap::linearization::Quantity;
    use beamgap::report::{Bounds, Environment};

    #[test]
    fn a_broken_bound_is_told_with_the_command_that_shows_it() {
        let none = Selection { regimes: Vec::new(), family: None, cases: 1 };
        let mut record = Bounds::new(bounds(1, &none, || ()), 0xabc, 1, Environment::here("none"));
        assert_eq!(outcome(&record).verdict.exit, Exit::Nothing);
        record.found.points.insert(Regime::Generic, Points { measured: 3, ..Points::default() });
        assert_eq!(outcome(&record).verdict.exit, Exit::Agree);
        let (side, quantity) = (Side::Chord, Quantity::Xi);
        let violation = Violation { side, quantity, part: "Delta", bound: 1e-16, error: f64::NAN };
        record.found.violations.insert(17, violation);
        assert_eq!(outcome(&record).verdict.exit, Exit::Untrusted);
        let text = record.page().to_text(80);
        let told = "check --seed 0xabc --case 17";
        assert!(text.contains(told) && text.contains("not a number"), "{text}");
    }
}
