//! `beamgap faults`: fault injection, and which checks detect which faults.

use super::arguments::{Format, regimes, seed, work_with};
use super::exit::Exit;
use super::output::Output;
use super::progress::Progress;
use super::terminal;
use beamgap::check::Regime;
use beamgap::faults::{all_operations, inject, limits, sampled};
use beamgap::report::{self, Environment, Faults, Record};
use beamgap::variant::catalogue;
use clap::{Args, value_parser};
use std::fmt::Write;
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct InjectFaults {
    /// Only name the faults, as `check --plant` and `prove --plant` take them
    #[arg(long, conflicts_with_all = ["seed", "regime", "format", "to"])]
    list: bool,
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed, allow_negative_numbers = true)]
    seed: u64,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
    /// Tables for people, or one document for programs
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Also write faults.json and faults.md into this directory
    #[arg(long, value_name = "DIRECTORY")]
    to: Option<PathBuf>,
    /// Write the report although the source has changes that are not committed
    #[arg(long, requires = "to")]
    allow_dirty: bool,
    /// Write the result to this file, and only the verdict to standard output
    #[arg(long, value_name = "PATH")]
    output: Option<PathBuf>,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl InjectFaults {
    /// Puts the checks to the test and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let output = Output::open(self.output.as_deref())?;
        work_with(self.threads)?;
        if self.list {
            let names: Vec<_> = catalogue().iter().map(ToString::to_string).collect();
            output.write(&(names.join("\n") + "\n"), "")?;
            return Ok(Exit::Agree);
        }
        if self.to.is_some() {
            Environment::is_clean(self.allow_dirty)?;
        }
        let record = record(self.seed, &self.regime, &self.command());
        if let Some(to) = &self.to {
            report::faults(to, &record)?;
        }
        let words = verdict(&record);
        let document = match self.format {
            Format::Human => terminal::page(&record.page(), &words),
            Format::Json => record.to_json()?,
        };
        output.write(&document, &format!("{words}\n"))?;
        Ok(if record.holds { Exit::Agree } else { Exit::Untrusted })
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

/// The record of these regimes, or of all if none is named, as `command` made it.
pub(super) fn record(seed: u64, named: &[Regime], command: &str) -> Faults {
    let asked = |regime: &Regime| named.is_empty() || named.contains(regime);
    let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
    let progress = Progress::of("injecting faults into terms");
    let found = inject(seed, &regimes);
    progress.now("injecting faults into single operations over a prime field");
    // Single operations know no regime.
    let operations = if named.is_empty() { all_operations(seed) } else { Vec::new() };
    progress.now("injecting faults into single operations in f64");
    let (limits, sampled) = (limits(seed, &regimes), sampled(seed, &regimes));
    progress.end();
    Faults::new(&found, &limits, &operations, &sampled, seed, Environment::here(command))
}

fn verdict(record: &Faults) -> String {
    let faults: usize = record.kinds.iter().map(|(_, count)| count).sum();
    if !record.holds {
        return "NOT DETECTED: the check misses a fault, rejects an equivalent formula, or does not cover\n\
                an operation."
            .into();
    }
    let rewrites = record.rewrites.len();
    let of_terms = format!(
        "DETECTED: all {faults} faults of terms; none of {rewrites} equivalent formulas is rejected."
    );
    let count: usize = record.operations.iter().map(|row| row.faults).sum();
    if count == 0 {
        return of_terms;
    }
    format!("{of_terms}\nOf {count} faults of single operations, each is detected or has a reason.")
}
