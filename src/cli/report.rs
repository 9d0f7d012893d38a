//! `beamgap report`: the reports, written anew.

use super::exit::Exit;
use super::ledger::LEDGER;
use beamgap::ledger;
use beamgap::report::{self, CASES, SEED, benchmark, criterion_directory, crosscheck};
use clap::{Args, value_parser};
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Report {
    /// How many cases of each regime the crosscheck compares
    #[arg(long, value_name = "N", default_value_t = CASES, allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    cases: u64,
    /// The directory to write to
    #[arg(long, value_name = "DIR", default_value = "reports")]
    to: PathBuf,
}

impl Report {
    /// Writes crosscheck.json and .md, ledger.json and .md, then benchmark.json, .md and .svg.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let command = match self.cases {
            CASES => "cargo run --release -- report".into(),
            cases => format!("cargo run --release -- report --cases {cases}"),
        };
        let found = crosscheck(&self.to, SEED, self.cases, &command, || ())?;
        let equations = ledger::ledger(SEED, ledger::DRAWS, ledger::CASES, LEDGER);
        report::ledger(&self.to, &equations)?;
        benchmark(&self.to, &criterion_directory())?;
        println!("Wrote crosscheck, ledger and benchmark to {}.", self.to.display());
        Ok(if found.mismatches.is_empty() && equations.holds() { Exit::Agree } else { Exit::Disagree })
    }
}
