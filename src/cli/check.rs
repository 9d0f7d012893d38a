//! `beamgap check`: both linearizations, compared on random pairs of beams.

use super::arguments::{families, fault, regimes, seconds, seed, variant, work_with};
use super::case;
use super::case_file;
use super::checked::{Checked, MOST_CASES, Oracle};
use super::count::count;
use super::exit::Exit;
use super::human;
use super::outcome::{Entry, Outcome, Source, State, Verdict};
use super::output::{OutputOptions, Outputs};
use super::progress::Progress;
use super::searched;
use beamgap::check::{
    Arbitration, Case, CaseData, CheckConfig, Compared, Family, Oracles, Regime, Selection, Shard,
    Verdict as Found, run_part,
};
use clap::{Args, value_parser};
use std::collections::BTreeMap;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Check {
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// How many cases of each regime, up to a million
    #[arg(long, value_name = "N", default_value = "10000")]
    #[arg(value_parser = value_parser!(u64).range(1..=MOST_CASES))]
    cases: u64,
    /// Only pairs in which beam, bar beam or both are of this family; may be given once
    #[arg(long, value_parser = families())]
    family: Option<Family>,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
    /// Only the case with this number, and everything about it
    #[arg(long, value_name = "N")]
    #[arg(conflicts_with_all = ["cases", "family", "regime"], group = "one")]
    case: Option<u64>,
    /// Only the case in this file, or on standard input if it is -: JSON as --case or a disagreement shows it
    #[arg(long, value_name = "PATH")]
    #[arg(conflicts_with_all = ["cases", "family", "regime", "case", "seed"], group = "one")]
    case_file: Option<PathBuf>,
    /// Of one case, only the numbers that differ beyond rounding
    #[arg(long, conflicts_with_all = ["cases", "family", "regime"], requires = "one")]
    only_wrong: bool,
    /// Show all tables, mismatches and shrunk cases of a run that fails, and not only a screen of them
    #[arg(long, conflicts_with = "one")]
    all: bool,
    /// Inject this fault, to see the check fail; may be repeated (see `beamgap faults --list`)
    #[arg(long, value_name = "FAULT", value_parser = fault)]
    plant: Vec<String>,
    /// What the closed form is compared with
    #[arg(long, value_enum, default_value_t = Oracle::Ad)]
    oracle: Oracle,
    /// Only the i-th of n parts of the cases; `beamgap merge` puts the parts together
    #[arg(long, value_name = "I/N", default_value_t = Shard::WHOLE, hide_default_value = true)]
    #[arg(conflicts_with = "one", allow_hyphen_values = true)]
    shard: Shard,
    /// Start no case after this time, as 30s or 5m; the result says how many were not reached
    #[arg(long, value_name = "TIME", value_parser = seconds, conflicts_with = "one", allow_hyphen_values = true)]
    time_budget: Option<Duration>,
    /// Write the counts of compared points to this file, as the record that later runs are held against; the record of
    /// this program is src/check/counts.json
    #[arg(long, value_name = "PATH", conflicts_with_all = ["one", "family", "shard", "time_budget", "plant"])]
    write_counts: Option<PathBuf>,
    #[command(flatten)]
    output: OutputOptions,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N")]
    #[arg(value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Check {
    /// Runs the comparison and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let outputs = self.output.open()?;
        work_with(self.threads)?;
        match (&self.case_file, self.case) {
            (Some(path), _) => self.one(outputs, &case_file::read(path)?, None),
            (None, Some(number)) => {
                let case = Case::draw(self.seed, number);
                self.one(outputs, &case.data(), Some((self.seed, number, case.regime)))
            }
            (None, None) => self.many(outputs),
        }
    }

    fn one(
        &self,
        outputs: Outputs,
        case: &CaseData,
        drawn: Option<(u64, u64, Regime)>,
    ) -> anyhow::Result<Exit> {
        let oracles = match self.oracle {
            Oracle::Ad => Oracles::Ad,
            Oracle::All => Oracles::All,
        };
        let config = CheckConfig { variant: variant(&self.plant)?, oracles };
        let points = case.compare(&config)?;
        let search = case.searched()?;
        let mut outcome = outcome_of(&points);
        outcome.verdict = outcome.verdict.and_search(searched::of_case(&search));
        let differs = u64::from(!search.findings.is_empty());
        outcome.entries.push(searched::entry(u64::from(search.is_compared), differs));
        let (verdict, only_wrong) = (&outcome.verdict, self.only_wrong);
        let shown = case::Shown { case, drawn, points: &points, search: &search, verdict, only_wrong };
        outputs.write(&outcome, || case::human(&shown), || case::json(&shown))?;
        Ok(outcome.verdict.exit)
    }

    fn many(&self, mut outputs: Outputs) -> anyhow::Result<Exit> {
        let asked = |regime: &Regime| self.regime.is_empty() || self.regime.contains(regime);
        let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
        let selection = Selection { regimes, family: self.family, cases: self.cases };
        let mut checked = Checked::new(self.seed, self.plant.clone(), self.oracle, selection, self.shard);
        if self.write_counts.is_some() {
            checked.can_be_recorded()?;
        }
        let config = checked.config()?;
        outputs.begin(&human::head(&checked))?;
        let numbers = checked.selection.part(checked.shard);
        let start = Instant::now();
        let deadline = self.time_budget.map(|budget| start + budget);
        let progress = Progress::bar("cases", numbers.len() as u64);
        checked.found = run_part(&config, self.seed, &numbers, deadline, || progress.step());
        progress.end();
        if std::io::stderr().is_terminal() {
            let cases = count(numbers.len(), "case");
            eprintln!("{cases} in {:.1} s", start.elapsed().as_secs_f64());
        }
        if let Some(path) = &self.write_counts {
            checked.write_counts(path)?;
        }
        let shown = checked.shown(self.all)?;
        outputs.write(&shown.outcome, || human::document(&shown), || shown.json())?;
        Ok(shown.outcome.verdict.exit)
    }
}

/// The outcome of the comparison of one case, with one entry for each order of each quantity.
fn outcome_of(points: &Compared) -> Outcome {
    let points_with =
        |wanted: fn(&Found) -> bool| points.iter().filter(|(_, found)| wanted(found)).count() as u64;
    let left = points_with(|found| matches!(found, Found::Inconclusive(..)));
    let arbitrated = points.iter().filter_map(|(_, found)| Arbitration::of_mismatch(found));
    let untrusted = arbitrated.filter(|who| who.is_untrusted()).count();
    let wrong = points_with(|found| matches!(found, Found::Mismatch(_)));
    let verdict = in_words(points.len() as u64 - left, wrong, left, untrusted);
    let mut counts: BTreeMap<_, (u64, u64)> = BTreeMap::new();
    for entry in points.iter().flat_map(|(_, found)| found.entries()).filter(|entry| entry.is_meaningful()) {
        let (numbers, wrong) = counts.entry((entry.quantity, entry.order)).or_default();
        (*numbers, *wrong) = (*numbers + 1, *wrong + u64::from(entry.is_wrong()));
    }
    let entries = counts.into_iter().map(|((quantity, order), (numbers, wrong))| Entry {
        group: order.name().to_owned(),
        name: quantity.name().to_owned(),
        state: State::of(numbers, wrong),
        message: format!("{wrong} of {} {} beyond rounding", count(numbers, "number"), differ(wrong)),
        source: Some(Source::of_formula(order, quantity)),
    });
    Outcome { command: "check", verdict, entries: entries.collect() }
}

/// The verb for this count.
fn differ(count: u64) -> &'static str {
    if count == 1 { "differs" } else { "differ" }
}

/// The verdict, from the counts of closest points.
pub(super) fn in_words(compared: u64, wrong: u64, left: u64, untrusted: usize) -> Verdict {
    let points = count(compared, "closest point");
    let (exit, name, words) = match (compared, wrong) {
        _ if untrusted > 0 => {
            let cases = count(untrusted, "case");
            let words = format!(
                "UNTRUSTED: in {cases} the oracles disagree among themselves.\n\
                 The check itself cannot be trusted, and says nothing of the closed form."
            );
            (Exit::Untrusted, "untrusted", words)
        }
        (0, _) => (
            Exit::Nothing,
            "nothing-compared",
            "NOTHING COMPARED: no closest point could be compared.".into(),
        ),
        (_, 0) => {
            let words = format!("AGREE: at {points} nothing differs beyond rounding.");
            (Exit::Agree, "agree", words)
        }
        _ => {
            let words = format!("DISAGREE: {wrong} of {points} {} beyond rounding.", differ(wrong));
            (Exit::Disagree, "disagree", words)
        }
    };
    let rest = if left == 0 {
        String::new()
    } else {
        format!("\nNot compared, and not counted as agreeing: {left}.")
    };
    Verdict::new(exit, name, words + &rest)
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
            ((2, 1, 0, 0), Exit::Disagree, "DISAGREE: 1 of 2 closest points differs beyond rounding."),
            ((0, 0, 1, 0), Exit::Nothing, "NOTHING COMPARED: no closest point could be compared."),
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
