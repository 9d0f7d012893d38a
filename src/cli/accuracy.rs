//! `beamgap accuracy`: the digits that each formulation keeps, and whether the chosen formulation is the better one.

use super::arguments::seed;
use super::exit::Exit;
use super::outcome::{Outcome, Verdict};
use super::output::OutputOptions;
use super::progress::Progress;
use super::terminal;
use beamgap::check::accuracy;
use beamgap::report::{ACCURACY_PAIRS, Accuracy, Environment, Record};
use clap::{Args, value_parser};

/// The largest accepted ratio of losses. Near the change of formulation, both formulations lose about the same.
const LOSS: f64 = 16.0;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Accurate {
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// How many pairs at each gap and angle
    #[arg(long, value_name = "N", default_value_t = ACCURACY_PAIRS)]
    #[arg(value_parser = value_parser!(u32).range(1..=100_000))]
    pairs: u32,
    #[command(flatten)]
    output: OutputOptions,
}

impl Accurate {
    /// Measures and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let mut outputs = self.output.open()?;
        outputs.begin("Accuracy\n")?;
        let pairs = usize::try_from(self.pairs)?;
        let command = format!("beamgap accuracy --seed {:#x} --pairs {pairs}", self.seed);
        let progress = Progress::of("measuring errors by double-double");
        let found = accuracy(self.seed, pairs);
        progress.end();
        let record = Accuracy::new(found, self.seed, pairs, Environment::here(&command));
        let (exit, words) = verdict(&record);
        let name = if exit == Exit::Agree { "well-chosen" } else { "badly-chosen" };
        let verdict = Verdict::new(exit, name, words);
        let outcome = Outcome { command: "accuracy", verdict, entries: Vec::new() };
        let human = || terminal::page(&record.page(), &outcome.verdict.words);
        outputs.write(&outcome, human, || Ok(record.to_json()?))?;
        Ok(exit)
    }
}

/// The exit code and the verdict of a record.
pub(super) fn verdict(record: &Accuracy) -> (Exit, String) {
    match record.found.worst_choice() {
        ratio if ratio <= LOSS => (
            Exit::Agree,
            format!("WELL CHOSEN: the error is at most {ratio:.1} times that of the better formulation."),
        ),
        ratio => (
            Exit::Disagree,
            format!("BADLY CHOSEN: the error is {ratio:.1e} times that of the better formulation."),
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::{Exit, accuracy, verdict};
    use beamgap::report::{Accuracy, Environment};

    #[test]
    fn a_bad_choice_is_told() {
        let found = accuracy(1, 3);
        let record = || Accuracy::new(found.clone(), 1, 3, Environment::here("none"));
        let mut bad = record();
        bad.found.gaps[3].d.chosen = bad.found.gaps[3].d.paper;
        assert_eq!(verdict(&bad).0, Exit::Disagree);
        let mut none = record();
        none.found.angles[0].xi.chosen = None;
        assert_eq!(verdict(&none).0, Exit::Disagree);
    }
}
