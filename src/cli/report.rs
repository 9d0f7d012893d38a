//! `beamgap report`: the reports, written anew.

use super::accuracy::verdict;
use super::exit::Exit;
use super::ledger::LEDGER;
use super::teeth;
use beamgap::ledger;
use beamgap::report::{
    self, CASES, SEED, SHARPNESS_CASES, accuracy, benchmark, criterion_directory, crosscheck, sharpness,
};
use clap::{Args, value_parser};
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Report {
    /// How many cases of each regime are compared; the bounds on rounding are
    /// measured with 11112 if this is not given
    #[arg(long, value_name = "N", default_value_t = CASES, allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    cases: u64,
    /// Write the benchmark alone
    #[arg(long, conflicts_with = "cases")]
    benchmark: bool,
    /// The directory to write to
    #[arg(long, value_name = "DIR", default_value = "reports")]
    to: PathBuf,
}

impl Report {
    /// Writes the pages and records of crosscheck, sharpness, accuracy, ledger and teeth, then those of the benchmark.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        if self.benchmark {
            let record = benchmark(&self.to, &criterion_directory())?;
            println!("Wrote benchmark to {}. What the front page is to say of it:", self.to.display());
            record.claims().iter().for_each(|claim| println!("- {claim}"));
            return Ok(Exit::Agree);
        }
        let (command, sharpness_cases) = match self.cases {
            CASES => ("cargo run --release -- report".into(), SHARPNESS_CASES),
            cases => (format!("cargo run --release -- report --cases {cases}"), cases),
        };
        let found = crosscheck(&self.to, SEED, self.cases, &command, || ())?;
        let sharp = sharpness(&self.to, SEED, sharpness_cases, &command)?;
        let chosen = verdict(&accuracy(&self.to, SEED, &command)?).0 == Exit::Agree;
        let equations = ledger::ledger(SEED, ledger::DRAWS, ledger::CASES, LEDGER);
        report::ledger(&self.to, &equations)?;
        let teeth = teeth::record(SEED, &[], &command);
        report::teeth(&self.to, &teeth)?;
        benchmark(&self.to, &criterion_directory())?;
        println!(
            "Wrote crosscheck, sharpness, accuracy, ledger, teeth and benchmark to {}.",
            self.to.display()
        );
        let agrees = found.mismatches.is_empty() && chosen && equations.holds();
        Ok(match (sharp.violations.is_empty() && teeth.holds, agrees) {
            (false, _) => Exit::Untrusted,
            (true, false) => Exit::Disagree,
            (true, true) => Exit::Agree,
        })
    }
}
