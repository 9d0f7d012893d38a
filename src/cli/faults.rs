//! `beamgap faults`: fault injection, and which checks detect which faults.

mod entries;

use super::arguments::{regimes, seed, work_with};
use super::exit::Exit;
use super::output::{OutputOptions, to_stdout};
use super::progress::Progress;
use super::terminal;
use beamgap::check::Regime;
use beamgap::faults::{
    all_operations, element_faults, gate, inject, limits, one_sided, sampled, search_faults,
};
use beamgap::report::{self, Environment, Faults, Record};
use beamgap::variant::catalogue_in_parts;
use clap::{Args, value_parser};
use entries::outcome;
use std::fmt::Write;
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct InjectFaults {
    /// Only name the faults, as `check --plant` and `prove --plant` take them
    #[arg(long, conflicts_with_all = ["seed", "regime", "format", "output", "to"])]
    list: bool,
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
    /// Also write faults.json and faults.md into this directory
    #[arg(long, value_name = "DIRECTORY")]
    to: Option<PathBuf>,
    /// Write the report although the source has changes that are not committed
    #[arg(long, requires = "to")]
    allow_dirty: bool,
    #[command(flatten)]
    output: OutputOptions,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N")]
    #[arg(value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl InjectFaults {
    /// Injects the faults and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        work_with(self.threads)?;
        if self.list {
            for faults in catalogue_in_parts() {
                let names =
                    faults.iter().fold(String::new(), |names, fault| names + &fault.to_string() + "\n");
                to_stdout(&names)?;
            }
            return Ok(Exit::Agree);
        }
        let mut outputs = self.output.open()?;
        if self.to.is_some() {
            Environment::is_clean(self.allow_dirty)?;
        }
        outputs.begin("Faults\n")?;
        let record = record(self.seed, &self.regime, &self.command());
        if let Some(to) = &self.to {
            report::faults(to, &record)?;
        }
        let outcome = outcome(&record);
        let human = || terminal::page(&record.page(), &outcome.verdict.words);
        outputs.write(&outcome, human, || Ok(record.to_json()?))?;
        Ok(outcome.verdict.exit)
    }

    fn command(&self) -> String {
        let mut command = String::from("cargo run --release -- faults");
        if self.seed != report::SEED {
            let _ = write!(command, " --seed {:#x}", self.seed);
        }
        for regime in &self.regime {
            let _ = write!(command, " --regime {}", regime.name());
        }
        if let Some(to) = &self.to {
            let _ = write!(command, " --to {}", to.display());
        }
        command
    }
}

/// The record of these regimes, or of all if none is named; `command` is the command that makes it.
pub(super) fn record(seed: u64, named: &[Regime], command: &str) -> Faults {
    let asked = |regime: &Regime| named.is_empty() || named.contains(regime);
    let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
    let progress = Progress::stages(5 + 3 * regimes.len());
    let found = progress.stage("faults in terms", || inject(seed, &regimes));
    // Faults in single operations do not depend on the regime.
    let of_field = || if named.is_empty() { all_operations(seed) } else { Vec::new() };
    let operations = progress.stage("operations over a prime field", of_field);
    let limits = progress.stage("detection limits", || limits(seed, &regimes));
    let sampled = progress.stage("operations in f64", || sampled(seed, &regimes));
    let of_search = |regime: &Regime| progress.stage("the search", || search_faults(seed, &[*regime]));
    let search = regimes.iter().flat_map(of_search).collect();
    let of_elements =
        |regime: &Regime| progress.stage("the contact element", || element_faults(seed, &[*regime]));
    let elements = regimes.iter().flat_map(of_elements).collect();
    let one_sided = Some(progress.stage("one side of each symmetry", || one_sided(seed, &regimes)));
    let gate =
        regimes.iter().flat_map(|regime| progress.stage("the gate", || gate(seed, &[*regime]))).collect();
    progress.end();
    Faults {
        schema: Faults::SCHEMA.to_owned(),
        environment: Environment::here(command),
        seed,
        holds: false,
        terms: found,
        operations,
        sampled,
        limits,
        search,
        elements,
        one_sided,
        gate,
    }
    .judged()
}

#[cfg(test)]
mod tests {
    use super::entries::words;
    use super::{Exit, Faults, Record, outcome, terminal};
    use crate::cli::formats::{junit, sarif};
    use beamgap::faults::Check;
    use std::path::Path;

    fn committed() -> Faults {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/faults.json");
        Faults::from_json(&std::fs::read_to_string(path).unwrap()).unwrap()
    }

    #[test]
    fn a_fault_that_is_missed_is_an_entry() {
        let right = committed();
        assert_eq!(outcome(&right).wrong().count(), 0);
        let mut wrong = right.clone();
        wrong.holds = false;
        let undetected = wrong.operations.iter_mut().flat_map(|row| &mut row.undetected).next();
        undetected.unwrap().reason = None;
        let outcome = outcome(&wrong);
        assert_eq!((outcome.verdict.exit, outcome.wrong().count()), (Exit::Untrusted, 1));
        // One failure of the entry, one of the verdict.
        assert_eq!(junit(&outcome).matches("<failure ").count(), 2);
        let log: serde_json::Value = serde_json::from_str(&sarif(&outcome).unwrap()).unwrap();
        assert_eq!(log["runs"][0]["results"].as_array().unwrap().len(), 1);
    }

    #[test]
    fn the_committed_record_is_shown_in_80_columns() {
        let record = committed();
        let text = terminal::page(&record.page(), &words(&record));
        assert!(text.contains("\nDETECTED: all "), "{text}");
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
        for check in Check::ALL {
            assert!(text.contains(&format!("\n  {} ", check.name())), "{}", check.name());
        }
    }
}
