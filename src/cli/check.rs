//! `beamgap check`: random pairs of beams through both linearizations.

use super::arguments::{Format, families, planting, regimes, seed, variant, work_with};
use super::exit::Exit;
use super::output::Output;
use super::progress::Progress;
use super::{case, case_file, human, json};
use beamgap::check::{
    Arbitration, Case, CaseData, CheckConfig, Compared, Family, Oracles, Regime, Selection, Shrunk, Summary,
    Verdict as Found, run, shrink_mismatches,
};
use clap::{Args, ValueEnum, value_parser};
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
    #[arg(conflicts_with_all = ["cases", "family", "regime"], group = "one")]
    case: Option<u64>,
    /// Only the case in this file, or on standard input if it is -: JSON as --case or a disagreement shows it
    #[arg(long, value_name = "PATH")]
    #[arg(conflicts_with_all = ["cases", "family", "regime", "case", "seed"], group = "one")]
    case_file: Option<PathBuf>,
    /// Of one case, only the numbers that differ beyond rounding
    #[arg(long, conflicts_with_all = ["cases", "family", "regime"], requires = "one")]
    only_wrong: bool,
    /// Inject this fault, to see the check fail; may be repeated (see `beamgap faults --list`)
    #[arg(long, value_name = "FAULT")]
    plant: Vec<String>,
    /// What the closed form is compared with
    #[arg(long, value_enum, default_value_t = Oracle::Ad)]
    oracle: Oracle,
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

/// With what the closed form is compared. Where it disagrees with AD, the differences always arbitrate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Oracle {
    /// Automatic differentiation
    Ad,
    /// Also differences of the value in double-double: in every thirteenth
    /// case, and where the tolerance for AD means nothing
    All,
}

/// Mismatches shown in full, and shrunk; the others are counted.
pub(super) const SHOWN: usize = 5;

/// What was asked, and what was found.
pub(super) struct Checked {
    pub(super) plant: Vec<String>,
    pub(super) seed: u64,
    pub(super) selection: Selection,
    pub(super) summary: Summary,
    pub(super) shrunk: Vec<Shrunk>,
    /// Whether the differences were asked.
    pub(super) differences: bool,
}

impl Checked {
    /// The options with which a command shows a case as this run saw it.
    pub(super) fn options(&self) -> String {
        planting(&self.plant) + if self.differences { " --oracle all" } else { "" }
    }
}

impl Check {
    /// Does the comparison and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let output = Output::open(self.output.as_deref())?;
        work_with(self.threads)?;
        let (document, verdict) = match (&self.case_file, self.case) {
            (Some(path), _) => self.one(&case_file::read(path)?, None)?,
            (None, Some(number)) => {
                let case = Case::draw(self.seed, number);
                self.one(&case.data(), Some((self.seed, number, case.regime)))?
            }
            (None, None) => self.many()?,
        };
        output.write(&document, &format!("{}\n", verdict.words))?;
        Ok(verdict.exit)
    }

    fn one(&self, case: &CaseData, drawn: Option<(u64, u64, Regime)>) -> anyhow::Result<(String, Verdict)> {
        let oracles = match self.oracle {
            Oracle::Ad => Oracles::Ad,
            Oracle::All => Oracles::All,
        };
        let points = case.compare(&CheckConfig { variant: variant(&self.plant)?, oracles })?;
        let verdict = verdict_on(&points);
        let shown =
            case::Shown { case, drawn, points: &points, verdict: &verdict, only_wrong: self.only_wrong };
        let document = match self.format {
            Format::Human => case::human(&shown),
            Format::Json => case::json(&shown)?,
        };
        Ok((document, verdict))
    }

    fn many(&self) -> anyhow::Result<(String, Verdict)> {
        let asked = |regime: &Regime| self.regime.is_empty() || self.regime.contains(regime);
        let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
        let selection = Selection { regimes, family: self.family, cases: self.cases };
        let oracles = match self.oracle {
            Oracle::Ad => Oracles::Ad,
            Oracle::All => Oracles::Sample,
        };
        let config = CheckConfig { variant: variant(&self.plant)?, oracles };
        let summary = with_progress(&config, self.seed, &selection);
        let verdict = verdict(&summary);
        let shrunk = shrink_mismatches(&config.variant, self.seed, &summary, SHOWN);
        let (plant, seed, differences) = (self.plant.clone(), self.seed, self.oracle == Oracle::All);
        let checked = Checked { plant, seed, selection, summary, shrunk, differences };
        let document = match self.format {
            Format::Human => human::document(&checked, &verdict),
            Format::Json => json::document(&checked, &verdict)?,
        };
        Ok((document, verdict))
    }
}

/// Runs the cases; stderr has the time that they took, if someone is watching.
fn with_progress(config: &CheckConfig, seed: u64, selection: &Selection) -> Summary {
    let (start, count) = (Instant::now(), selection.cases * selection.regimes.len() as u64);
    let progress = Progress::bar("cases", count);
    let summary = run(config, seed, selection, || progress.step());
    progress.end();
    if std::io::stderr().is_terminal() {
        eprintln!("{count} cases in {:.1} s", start.elapsed().as_secs_f64());
    }
    summary
}

/// The result of a comparison, for people and for programs.
pub(super) struct Verdict {
    pub(super) exit: Exit,
    pub(super) name: &'static str,
    pub(super) words: String,
}

pub(super) fn verdict(summary: &Summary) -> Verdict {
    let tallies = || summary.regimes.values();
    let left = tallies().flat_map(|tally| tally.inconclusive.values()).map(|&(count, _)| count).sum();
    let untrusted = summary.arbitrations.values().filter(|who| who.is_untrusted()).count();
    in_words(summary.compared(), tallies().map(|tally| tally.mismatches).sum(), left, untrusted)
}

/// The same for one case.
fn verdict_on(points: &Compared) -> Verdict {
    let count = |wanted: fn(&Found) -> bool| points.iter().filter(|(_, found)| wanted(found)).count() as u64;
    let left = count(|found| matches!(found, Found::Inconclusive(..)));
    let arbitrated = points.iter().filter_map(|(_, found)| Arbitration::of(found.entries()));
    let untrusted = arbitrated.filter(|who| who.is_untrusted()).count();
    in_words(points.len() as u64 - left, count(|found| matches!(found, Found::Mismatch(_))), left, untrusted)
}

fn in_words(compared: u64, wrong: u64, left: u64, untrusted: usize) -> Verdict {
    let points = if compared == 1 { "closest point" } else { "closest points" };
    let (exit, name, words) = match (compared, wrong) {
        _ if untrusted > 0 => {
            let cases = if untrusted == 1 { "case" } else { "cases" };
            let words = format!(
                "UNTRUSTED: in {untrusted} {cases} the oracles disagree among themselves.\n\
                 The check itself cannot be trusted, and says nothing of the closed form."
            );
            (Exit::Untrusted, "untrusted", words)
        }
        (0, _) => (Exit::Nothing, "nothing-compared", "NOTHING COMPARED: no closest point could be.".into()),
        (_, 0) => {
            let words = format!("AGREE: at {compared} {points} nothing differs beyond rounding.");
            (Exit::Agree, "agree", words)
        }
        _ => {
            let words = format!("DISAGREE: {wrong} of {compared} {points} differ beyond rounding.");
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

#[cfg(test)]
mod tests {
    use super::{Exit, in_words};

    #[test]
    fn one_is_not_said_as_many() {
        let said = |compared, wrong, left, untrusted| {
            let verdict = in_words(compared, wrong, left, untrusted);
            (verdict.exit, verdict.words.lines().next().unwrap_or_default().to_owned())
        };
        for (numbers, exit, words) in [
            ((1, 0, 0, 0), Exit::Agree, "AGREE: at 1 closest point nothing differs beyond rounding."),
            ((2, 0, 1, 0), Exit::Agree, "AGREE: at 2 closest points nothing differs beyond rounding."),
            ((2, 1, 0, 0), Exit::Disagree, "DISAGREE: 1 of 2 closest points differ beyond rounding."),
            ((0, 0, 1, 0), Exit::Nothing, "NOTHING COMPARED: no closest point could be."),
            ((2, 1, 0, 1), Exit::Untrusted, "UNTRUSTED: in 1 case the oracles disagree among themselves."),
            ((2, 2, 0, 2), Exit::Untrusted, "UNTRUSTED: in 2 cases the oracles disagree among themselves."),
        ] {
            let (compared, wrong, left, untrusted) = numbers;
            assert_eq!(said(compared, wrong, left, untrusted), (exit, words.to_owned()));
        }
        assert!(in_words(2, 0, 3, 0).words.ends_with("\nNot compared, and not counted as agreeing: 3."));
        assert!(!in_words(2, 0, 0, 0).words.contains("Not compared"));
    }
}
