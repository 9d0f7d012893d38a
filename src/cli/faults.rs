//! `beamgap faults`: fault injection, and which checks detect which faults.

use super::arguments::{Format, regimes, seed, work_with};
use super::exit::Exit;
use super::output::Output;
use super::table::Table;
use beamgap::check::Regime;
use beamgap::faults::{all_operations, inject, limits, sampled};
use beamgap::report::{self, Environment, Faults, Record};
use beamgap::variant::catalogue;
use clap::{Args, value_parser};
use std::fmt::Write;
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct InjectFaults {
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
    /// Also write faults.json and faults.md into this directory
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

impl InjectFaults {
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
            report::faults(to, &record)?;
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
        let mut command = String::from("cargo run --release -- faults");
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
pub(super) fn record(seed: u64, named: &[Regime], command: &str) -> Faults {
    let asked = |regime: &Regime| named.is_empty() || named.contains(regime);
    let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
    let found = inject(seed, &regimes);
    // Single operations know no regime.
    let operations = if named.is_empty() { all_operations(seed) } else { Vec::new() };
    let (limits, sampled) = (limits(seed, &regimes), sampled(seed, &regimes));
    Faults::new(&found, &limits, &operations, &sampled, seed, Environment::here(command))
}

fn verdict(record: &Faults) -> String {
    let faults: usize = record.kinds.iter().map(|(_, count)| count).sum();
    if !record.holds {
        return "NOT DETECTED: the check misses a fault, rejects an equivalent formula, or does not cover\n\
                an operation."
            .into();
    }
    let rewrites = record.rewrites.len();
    let of_terms = format!(
        "DETECTED: all {faults} faults of terms; none of {rewrites} equivalent formulas is rejected."
    );
    let count: usize = record.operations.iter().map(|row| row.faults).sum();
    if count == 0 {
        return of_terms;
    }
    format!("{of_terms}\nOf {count} faults of single operations, each is detected or has a reason.")
}

/// What became of the operations of each code.
fn operations(record: &Faults) -> String {
    if record.operations.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&["place", "operations", "faults", "detected", "not"]);
    let mut code = "";
    for row in &record.operations {
        if row.code != code {
            code = &row.code;
            table.row(vec![code.to_owned(), String::new(), String::new(), String::new(), String::new()]);
        }
        let counts =
            [row.operations, row.faults, row.detected, row.faults - row.detected].map(|n| n.to_string());
        table.row([format!("  {}", row.place)].into_iter().chain(counts).collect());
    }
    let mut text = format!(
        "\nSingle operations over a prime field: the sign changed, zero, doubled, one too\n\
         large, or the result of a run with other operands\n\n{table}"
    );
    for row in &record.operations {
        for undetected in row.undetected.iter().filter(|undetected| undetected.reason.is_none()) {
            let _ = write!(
                text,
                "\n  not covered: {} in {}, {}: {}",
                row.code, row.place, undetected.wrong, undetected.at
            );
        }
    }
    text
}

/// What became of a sample of operations in `f64`.
fn sampled_operations(record: &Faults) -> String {
    let mut table = Table::new(&["regime", "code", "operations", "faults", "detected"]).left(&[1]);
    for row in &record.sampled {
        let counts = [row.operations, row.faults, row.detected].map(|n| n.to_string());
        table.row([row.regime.clone(), row.code.clone()].into_iter().chain(counts).collect());
    }
    format!(
        "\nA sample of operations in f64, each multiplied by -1, 0 and 2: faults that\n\
         change a number, and faults that exceed a tolerance\n\n{table}"
    )
}

fn human(record: &Faults) -> String {
    let mut table =
        Table::new(&["check", "regime", "detected", "of", "pairs", "of", "rejected", "of", "false"])
            .left(&[1]);
    for row in &record.rows {
        let counts = [
            row.detected,
            row.planted,
            row.pairs_detected,
            row.pairs,
            row.rejected,
            row.points,
            row.false_positives.len(),
        ];
        table.row(
            [row.check.clone(), row.regime.clone()]
                .into_iter()
                .chain(counts.map(|n| n.to_string()))
                .collect(),
        );
    }
    let mut text = format!(
        "Fault injection: which faults each check detects\nseed {:#x}\n\n\
         pairs: two faults at once; rejected: points at which the check rejects the\n\
         unmodified closed form; false: equivalent formulas that it rejects\n\n{table}",
        record.seed
    );
    text.push_str(&operations(record));
    text.push_str(&sampled_operations(record));
    for row in record.rows.iter().filter(|row| row.check == "exact" || row.check == "gate") {
        for fault in record.undetected_by(row).chain(row.false_positives.iter().map(String::as_str)) {
            let _ = write!(text, "\n  {} in {}: {fault}", row.check, row.regime);
        }
    }
    text
}
