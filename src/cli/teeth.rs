//! `beamgap teeth`: whether the checks turn red for every planted fault, and for nothing else.

use super::arguments::{Format, regimes, seed, work_with};
use super::exit::Exit;
use super::output::Output;
use super::table::Table;
use beamgap::check::Regime;
use beamgap::subject::{Rewrite, catalogue};
use beamgap::teeth::{Bite, Check, Teeth, teeth};
use clap::{Args, value_parser};
use std::fmt::Write;
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Bites {
    /// Only name the faults, as `check --plant` and `prove --plant` take them
    #[arg(long)]
    list: bool,
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed, allow_negative_numbers = true)]
    seed: u64,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
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
            let names: String = catalogue().iter().map(|fault| format!("{fault}\n")).collect();
            output.write(&names, "")?;
            return Ok(Exit::Agree);
        }
        let asked = |regime: &Regime| self.regime.is_empty() || self.regime.contains(regime);
        let regimes: Vec<_> = Regime::ALL.into_iter().filter(asked).collect();
        let found = teeth(self.seed, &regimes);
        let mut text = String::new();
        for bite in &found.bites {
            let _ = writeln!(
                text,
                "{:12} {:18} points {:3} killed {:4} of {} false {:2} pairs {} of {}",
                bite.check.name(),
                bite.regime.map_or("-", Regime::name),
                bite.points,
                bite.killed,
                found.faults.len(),
                bite.false_alarms.len(),
                bite.pairs_killed,
                bite.pairs_killed + bite.pairs_survived.len()
            );
            if matches!(bite.check, Check::Gate | Check::Exact) {
                for fault in &bite.survivors {
                    let _ = writeln!(text, "   {fault}");
                }
                for right in &bite.false_alarms {
                    let _ = writeln!(text, "   {:?}", right.map(Rewrite::name));
                }
            }
        }
        output.write(&text, "")?;
        Ok(if found.holds() { Exit::Agree } else { Exit::Untrusted })
    }
}
