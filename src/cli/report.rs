//! `beamgap report`: the reports, written anew.

use super::accuracy::verdict;
use super::equations::EQUATIONS;
use super::exit::Exit;
use super::faults;
use beamgap::equations;
use beamgap::report::{
    self, BOUNDS_CASES, CASES, SEED, accuracy, benchmark, bounds, criterion_directory, crosscheck,
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
    /// Writes the pages and records of crosscheck, bounds, accuracy, equations and faults, then those of the benchmark.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        if self.benchmark {
            let record = benchmark(&self.to, &criterion_directory())?;
            println!("Wrote benchmark to {}. What the front page is to say of it:", self.to.display());
            record.claims().iter().for_each(|claim| println!("- {claim}"));
            return Ok(Exit::Agree);
        }
        let (command, bounds_cases) = match self.cases {
            CASES => ("cargo run --release -- report".into(), BOUNDS_CASES),
            cases => (format!("cargo run --release -- report --cases {cases}"), cases),
        };
        // What is missing is said first: the rest takes minutes.
        let is_measured = criterion_directory().is_dir();
        if !is_measured {
            eprintln!("Left out: benchmark, as nothing is measured. `cargo bench` measures it.");
        }
        let found = crosscheck(&self.to, SEED, self.cases, &command, || ())?;
        let bounds = bounds(&self.to, SEED, bounds_cases, &command)?;
        let chosen = verdict(&accuracy(&self.to, SEED, &command)?).0 == Exit::Agree;
        let equations = equations::equation_table(SEED, equations::DRAWS, equations::CASES, EQUATIONS);
        report::equations(&self.to, &equations)?;
        report::derivation(&self.to, &equations)?;
        let faults = faults::record(SEED, &[], &command);
        report::faults(&self.to, &faults)?;
        let mut written = vec!["crosscheck", "bounds", "accuracy", "equations", "derivation", "faults"];
        if is_measured {
            benchmark(&self.to, &criterion_directory())?;
            written.push("benchmark");
        }
        println!("Wrote to {}: {}.", self.to.display(), written.join(", "));
        let agrees = found.mismatches.is_empty() && chosen && equations.holds();
        Ok(match (bounds.violations.is_empty() && faults.holds, agrees) {
            (false, _) => Exit::Untrusted,
            (true, false) => Exit::Disagree,
            (true, true) => Exit::Agree,
        })
    }
}
