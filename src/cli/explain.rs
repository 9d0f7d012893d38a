//! `beamgap explain`: the wrong term in the answers of a program, and how often such explanations are right.

use super::answered::{Diagnosed, Verified, head, verdict};
use super::arguments::{seed, work_with};
use super::exit::Exit;
use super::outcome::Verdict;
use super::output::to_stdout;
use super::stream::source;
use beamgap::check::external::{AnswerReader, Demands, Matching, VectorReader};
use beamgap::report;
use clap::{Args, value_parser};
use std::fmt::Write;
use std::path::PathBuf;

/// The default number of measured pairs of faults.
const PAIRS: usize = 20;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Explain {
    /// The cases that `beamgap export` wrote, or - for standard input; required without --catalogue
    #[arg(value_name = "VECTORS", required_unless_present = "catalogue")]
    vectors: Option<PathBuf>,
    /// The answers, as JSON Lines or CSV, or - for standard input; required without --catalogue
    #[arg(value_name = "ANSWERS", required_unless_present = "catalogue")]
    answers: Option<PathBuf>,
    /// The significant digits that the answers have, if these are few
    #[arg(long, value_name = "N", value_parser = value_parser!(u8).range(1..=15))]
    digits: Option<u8>,
    /// Measure how many faults of the catalogue are named, and write explain.json and explain.md
    #[arg(long, conflicts_with_all = ["vectors", "answers", "digits"])]
    catalogue: bool,
    /// The directory that --catalogue writes to
    #[arg(long, value_name = "DIR", default_value = "reports", requires = "catalogue")]
    to: PathBuf,
    /// Measure only every N-th fault of the catalogue
    #[arg(long, value_name = "N", default_value = "1", value_parser = value_parser!(u16).range(1..))]
    #[arg(requires = "catalogue")]
    every: u16,
    /// How many pairs of faults are measured too
    #[arg(long, value_name = "N", default_value = "20", value_parser = value_parser!(u16), requires = "catalogue")]
    pairs: u16,
    /// Seed of the cases of --catalogue, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed, requires = "catalogue")]
    seed: u64,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Explain {
    /// Explains, or measures explanations.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        work_with(self.threads)?;
        let (Some(vectors), Some(answers)) = (&self.vectors, &self.answers) else {
            return self.measure();
        };
        let (from, name) = source(vectors)?;
        let mut vectors = VectorReader::new(from, &name)?;
        let (from, command) = source(answers)?;
        let mut answers = AnswerReader::new(from, &command)?;
        let demands = Demands { conventions: *answers.conventions(), digits: self.digits };
        // The heading is printed first, because an explanation takes seconds.
        to_stdout(&head(&command, self.digits, None))?;
        let mut matching = Matching::new(demands, 4096).of_program(answers.program(), answers.only());
        while let Some(answers) = answers.next_answers()? {
            matching.take(answers, || vectors.next_vector())?;
        }
        let report = matching.finish(|| vectors.next_vector())?;
        let verified = Verified { report, demands, command, reason: None, allow_missing: true };
        let Verdict { exit, words, .. } = verdict(&verified);
        let mut text = String::new();
        if exit == Exit::Disagree {
            text = format!("{}\n", Diagnosed::of(&verified, true).words().trim_start());
        }
        to_stdout(&(text + &words + "\n"))?;
        Ok(exit)
    }

    fn measure(&self) -> anyhow::Result<Exit> {
        let (every, pairs) = (usize::from(self.every), usize::from(self.pairs));
        let mut command = "cargo run --release -- explain --catalogue".to_owned();
        if every > 1 {
            let _ = write!(command, " --every {every}");
        }
        if pairs != PAIRS {
            let _ = write!(command, " --pairs {pairs}");
        }
        to_stdout("Faults of the catalogue, in the answers of programs that have them\n")?;
        let sample = report::ExplainSample { seed: self.seed, every, pairs };
        let record = report::explain(&self.to, sample, &command)?;
        let mut text = String::new();
        for program in &record.programs {
            let counts: Vec<_> =
                program.counts.iter().map(|of| format!("{} {}", of.naming, of.programs)).collect();
            let faults = if program.faults == 1 { "one fault" } else { "two faults" };
            let _ = writeln!(text, "{faults}; {}\n  {}", program.answers, counts.join(", "));
        }
        let holds = record.programs.iter().all(report::ExplainProgram::holds);
        let words = if holds {
            "EXPLAINED: each detectable single fault is named, and no program has only other faults named."
        } else {
            "NOT EXPLAINED: a single fault is not named, or a program has only other faults named."
        };
        to_stdout(&(text + words + "\n"))?;
        Ok(if holds { Exit::Agree } else { Exit::Untrusted })
    }
}
