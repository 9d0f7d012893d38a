//! `beamgap report`: writes the reports again.

use super::accuracy::verdict;
use super::count::count;
use super::exit::Exit;
use super::faults;
use super::output::to_stdout;
use super::progress::Progress;
use beamgap::check::Regime;
use beamgap::equations;
use beamgap::report::{
    self, BOUNDS_CASES, CASES, Environment, Equations, SEED, accuracy, bounds, crosscheck,
};
use clap::{Args, value_parser};
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Report {
    /// How many cases of each regime are compared; the bounds on rounding are
    /// measured with 11112 if this is not given
    #[arg(long, value_name = "N", default_value_t = CASES)]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    cases: u64,
    /// Write only the report on programs of others, from the results of `verify --format json`
    #[arg(long, value_name = "PATH", num_args = 1.., conflicts_with = "cases")]
    verified: Vec<PathBuf>,
    /// Write only the reports on the contact element: the beam problems, and published elements
    #[arg(long, conflicts_with_all = ["cases", "verified"])]
    elements: bool,
    /// The directory to write to
    #[arg(long, value_name = "DIR", default_value = "reports")]
    to: PathBuf,
    /// Write the reports although the source has changes that are not committed
    #[arg(long)]
    allow_dirty: bool,
}

impl Report {
    /// Writes the reports of the checks, which take minutes, or that on programs of others.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        Environment::is_clean(self.allow_dirty)?;
        if !self.verified.is_empty() {
            let record = report::verify(&self.to, &self.verified, "examples/verify/public/run")?;
            let programs = count(record.runs.len(), "program");
            println!("Wrote verify to {}: {programs}.", self.to.display());
            return Ok(Exit::Agree);
        }
        if self.elements {
            self.contact_element("cargo run --release -- report --elements")?;
            println!("Wrote to {}: beam-problems, elements.", self.to.display());
            return Ok(Exit::Agree);
        }
        to_stdout("Reports\n")?;
        let exit = self.checks()?;
        let written = [
            "crosscheck",
            "bounds",
            "accuracy",
            "equations",
            "derivation",
            "beam-problems",
            "elements",
            "faults",
            "symbols",
        ];
        println!("Wrote to {}: {}.", self.to.display(), written.join(", "));
        Ok(exit)
    }

    fn contact_element(&self, command: &str) -> anyhow::Result<()> {
        let progress = Progress::of("solving beam problems");
        report::beam_problems(&self.to, command)?;
        report::elements(&self.to, SEED, command)?;
        progress.end();
        Ok(())
    }

    fn checks(&self) -> anyhow::Result<Exit> {
        let (command, bounds_cases) = match self.cases {
            CASES => ("cargo run --release -- report".into(), BOUNDS_CASES),
            cases => (format!("cargo run --release -- report --cases {cases}"), cases),
        };
        report::write_symbols(&self.to)?;
        let regimes = Regime::ALL.len() as u64;
        let progress = Progress::bar("cases compared", self.cases * regimes);
        let found = crosscheck(&self.to, SEED, self.cases, &command, || progress.step())?;
        progress.end();
        let progress = Progress::bar("cases with bounds", bounds_cases * regimes);
        let bounds = bounds(&self.to, SEED, bounds_cases, &command, || progress.step())?;
        progress.end();
        let progress = Progress::of("measuring errors by double-double");
        let chosen = verdict(&accuracy(&self.to, SEED, &command)?).0 == Exit::Agree;
        progress.end();
        let progress = Progress::of("evaluating equations");
        let table = equations::equation_table(SEED, equations::DRAWS, equations::CASES);
        let equations = Equations::new(table, Environment::here(&command));
        report::equations(&self.to, &equations)?;
        report::derivation(&self.to, &equations)?;
        progress.end();
        self.contact_element(&command)?;
        let faults = faults::record(SEED, &[], &command);
        report::faults(&self.to, &faults)?;
        let agrees = found.found.mismatches.is_empty() && chosen && equations.table.holds();
        Ok(match (bounds.found.violations.is_empty() && faults.holds, agrees) {
            (false, _) => Exit::Untrusted,
            (true, false) => Exit::Disagree,
            (true, true) => Exit::Agree,
        })
    }
}
