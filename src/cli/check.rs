//! `beamgap check`: random pairs of beams through both linearizations.

use super::arguments::{Format, families, regimes, seed};
use super::exit::Exit;
use super::output::Output;
use super::{case, human, json};
use anyhow::Context;
use beamgap::check::{Case, Family, Regime, Selection, Summary, compare, run};
use clap::{Args, value_parser};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::Instant;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Check {
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed, allow_negative_numbers = true)]
    seed: u64,
    /// How many cases of each regime, up to a million
    #[arg(long, value_name = "N", default_value = "10000", allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    cases: u64,
    /// Only pairs in which beam or bar beam is of this family
    #[arg(long, value_parser = families())]
    family: Option<Family>,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
    /// Only the case with this number, and everything about it
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    #[arg(conflicts_with_all = ["cases", "family", "regime"])]
    case: Option<u64>,
    /// Tables for people, or one document for programs
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Write the result to this file, and only the verdict to standard output
    #[arg(long, value_name = "PATH")]
    output: Option<PathBuf>,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// What was asked, and what was found.
pub(super) struct Checked {
    pub(super) seed: u64,
    pub(super) selection: Selection,
    pub(super) summary: Summary,
}

impl Check {
    /// Does the comparison and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let output = Output::open(self.output.as_deref())?;
        if let Some(threads) = self.threads {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
            pool.build_global().context("cannot start the threads")?;
        }
        let (document, verdict) = match self.case {
            Some(number) => self.one(number)?,
            None => self.many()?,
        };
        output.write(&document, &format!("{}\n", verdict.words))?;
        Ok(verdict.exit)
    }

    fn one(&self, number: u64) -> anyhow::Result<(String, Verdict)> {
        let case = Case::draw(self.seed, number);
        let points = compare(&case);
        let verdict = verdict(&Summary::of(&case, &points));
        let document = match self.format {
            Format::Human => case::human(self.seed, &case, &points, &verdict),
            Format::Json => case::json(self.seed, &case, &points, &verdict)?,
        };
        Ok((document, verdict))
    }

    fn many(&self) -> anyhow::Result<(String, Verdict)> {
        let asked = |regime: &Regime| self.regime.is_empty() || self.regime.contains(regime);
        let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
        let selection = Selection { regimes, family: self.family, cases: self.cases };
        let summary = with_progress(self.seed, &selection);
        let verdict = verdict(&summary);
        let checked = Checked { seed: self.seed, selection, summary };
        let document = match self.format {
            Format::Human => human::document(&checked, &verdict),
            Format::Json => json::document(&checked, &verdict)?,
        };
        Ok((document, verdict))
    }
}

/// Runs the cases, with a bar on stderr if someone is watching.
fn with_progress(seed: u64, selection: &Selection) -> Summary {
    if !std::io::stderr().is_terminal() {
        return run(seed, selection, || ());
    }
    let start = Instant::now();
    let bar = ProgressBar::new(selection.cases * selection.regimes.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} cases, {eta} left") {
        bar.set_style(style);
    }
    let summary = run(seed, selection, || bar.inc(1));
    bar.finish_and_clear();
    eprintln!("{} cases in {:.1} s", bar.position(), start.elapsed().as_secs_f64());
    summary
}

/// The result of a comparison, for people and for programs.
pub(super) struct Verdict {
    pub(super) exit: Exit,
    pub(super) name: &'static str,
    pub(super) words: String,
}

pub(super) fn verdict(summary: &Summary) -> Verdict {
    let compared = summary.compared();
    let apart: u64 = summary.regimes.values().map(|tally| tally.mismatches).sum();
    let left: u64 =
        summary.regimes.values().flat_map(|tally| tally.inconclusive.values()).map(|&(count, _)| count).sum();
    let points = if compared == 1 { "closest point" } else { "closest points" };
    let (exit, name, words) = match (compared, apart) {
        (0, _) => (Exit::Nothing, "nothing-compared", "NOTHING COMPARED: no closest point could be.".into()),
        (_, 0) => {
            let words = format!("AGREE: at {compared} {points} nothing differs beyond rounding.");
            (Exit::Agree, "agree", words)
        }
        _ => {
            let words = format!("DISAGREE: {apart} of {compared} {points} differ beyond rounding.");
            (Exit::Disagree, "disagree", words)
        }
    };
    let rest = if left == 0 {
        String::new()
    } else {
        format!("\nNot compared, and not counted as agreeing: {left}.")
    };
    Verdict { exit, name, words: words + &rest }
}
