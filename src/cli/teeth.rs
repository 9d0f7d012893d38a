//! `beamgap teeth`: whether the checks turn red for every planted fault, and for nothing else.

use super::arguments::{Format, regimes, seed, work_with};
use super::exit::Exit;
use super::output::Output;
use super::table::Table;
use beamgap::check::Regime;
use beamgap::report::{self, Environment, Record, Teeth};
use beamgap::teeth::{all_operations, limits, sampled, teeth};
use beamgap::variant::catalogue;
use clap::{Args, value_parser};
use std::fmt::Write;
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Bites {
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
    /// Also write teeth.json and teeth.md into this directory
    #[arg(long, value_name = "DIRECTORY")]
    to: Option<PathBuf>,
    /// Write the result to this file, and only the verdict to standard output
    #[arg(long, value_name = "PATH")]
    output: Option<PathBuf>,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Bites {
    /// Puts the checks to the test and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let output = Output::open(self.output.as_deref())?;
        work_with(self.threads)?;
        if self.list {
            let names: Vec<_> = catalogue().iter().map(ToString::to_string).collect();
            output.write(&(names.join("\n") + "\n"), "")?;
            return Ok(Exit::Agree);
        }
        let record = record(self.seed, &self.regime, &self.command());
        if let Some(to) = &self.to {
            report::teeth(to, &record)?;
        }
        let words = verdict(&record);
        let document = match self.format {
            Format::Human => format!("{}\n{words}\n", human(&record)),
            Format::Json => record.to_json()?,
        };
        output.write(&document, &format!("{words}\n"))?;
        Ok(if record.holds { Exit::Agree } else { Exit::Untrusted })
    }

    fn command(&self) -> String {
        let mut command = String::from("cargo run --release -- teeth");
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
pub(super) fn record(seed: u64, named: &[Regime], command: &str) -> Teeth {
    let asked = |regime: &Regime| named.is_empty() || named.contains(regime);
    let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
    let found = teeth(seed, &regimes);
    // Single operations know no regime.
    let operations = if named.is_empty() { all_operations(seed) } else { Vec::new() };
    let (limits, sampled) = (limits(seed, &regimes), sampled(seed, &regimes));
    Teeth::new(&found, &limits, &operations, &sampled, seed, Environment::here(command))
}

fn verdict(record: &Teeth) -> String {
    let faults: usize = record.kinds.iter().map(|(_, count)| count).sum();
    if record.holds {
        let rewrites = record.rewrites.len();
        let of_terms =
            format!("TEETH: the gate shows all of {faults} faults, and accuses none of {rewrites} rewrites.");
        let count: usize = record.operations.iter().map(|row| row.faults).sum();
        return if count == 0 {
            of_terms
        } else {
            format!(
                "{of_terms}\nOf {count} faults of single operations all are shown, but for those with a reason."
            )
        };
    }
    "NO TEETH: the gate misses a fault, or accuses what is right, or an operation is not covered.".into()
}

/// What became of the operations of each code.
fn operations(record: &Teeth) -> String {
    if record.operations.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["place", "operations", "faults", "shown", "not"]);
    let mut code = "";
    for row in &record.operations {
        if row.code != code {
            code = &row.code;
            table.row(vec![code.to_owned(), String::new(), String::new(), String::new(), String::new()]);
        }
        let counts = [row.operations, row.faults, row.shown, row.faults - row.shown].map(|n| n.to_string());
        table.row([format!("  {}", row.place)].into_iter().chain(counts).collect());
    }
    let mut text = format!(
        "\nSingle operations: each made wrong by its sign, lost, doubled, one too large, and\n\
         with the result that it has in a run with other operands; over the prime field\n\n{table}"
    );
    for row in &record.operations {
        for unseen in row.unseen.iter().filter(|unseen| unseen.reason.is_none()) {
            let _ = write!(
                text,
                "\n  not covered: {} in {}, {}: {}",
                row.code, row.place, unseen.wrong, unseen.at
            );
        }
    }
    text
}

/// What became of a sample of operations in `f64`.
fn sampled_operations(record: &Teeth) -> String {
    let mut table = Table::new(&["regime", "code", "operations", "faults", "detected"]).left(&[1]);
    for row in &record.sampled {
        let counts = [row.operations, row.faults, row.detected].map(|n| n.to_string());
        table.row([row.regime.clone(), row.code.clone()].into_iter().chain(counts).collect());
    }
    format!(
        "\nA sample of operations in f64, each multiplied by -1, 0 and 2: faults that\n\
         change a number, and those that the gate detects by its tolerances\n\n{table}"
    )
}

fn human(record: &Teeth) -> String {
    let mut table =
        Table::new(&["check", "regime", "shown", "of", "pairs", "of", "accused", "of", "alarms"]).left(&[1]);
    for row in &record.rows {
        let counts = [
            row.killed,
            row.planted,
            row.pairs_killed,
            row.pairs,
            row.accused,
            row.points,
            row.false_alarms.len(),
        ];
        table.row(
            [row.check.clone(), row.regime.clone()]
                .into_iter()
                .chain(counts.map(|n| n.to_string()))
                .collect(),
        );
    }
    let mut text = format!(
        "Planted faults: what each check shows\nseed {:#x}\n\n\
         shown: faults; pairs: of faults planted at once; accused: points at which the\n\
         closed form is accused as it is; alarms: correct rewrites accused\n\n{table}",
        record.seed
    );
    text.push_str(&operations(record));
    text.push_str(&sampled_operations(record));
    for row in record.rows.iter().filter(|row| row.check == "exact" || row.check == "gate") {
        for fault in record.unshown_by(row).chain(row.false_alarms.iter().map(String::as_str)) {
            let _ = write!(text, "\n  {} in {}: {fault}", row.check, row.regime);
        }
    }
    text
}
