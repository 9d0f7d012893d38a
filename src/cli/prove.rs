//! `beamgap prove`: both linearizations over a prime field, compared without a tolerance.

use super::arguments::{families, fault, seed, variant, work_with};
use super::count::count;
use super::exit::Exit;
use super::output::OutputOptions;
use super::progress::Progress;
use super::proof;
use super::proved::Proved;
use beamgap::prove::prove;
use beamgap::test_beam::Family;
use clap::{Args, value_parser};
use std::io::Write;
use std::time::Instant;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Prove {
    /// Seed of the random residues, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// How many draws for each ordered pair of families
    #[arg(long, value_name = "N", default_value = "1000")]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    draws: u64,
    /// Only pairs of these families; may be repeated
    #[arg(long, value_parser = families())]
    family: Vec<Family>,
    /// Inject this fault, to see the proof fail; may be repeated (see `beamgap faults --list`)
    #[arg(long, value_name = "FAULT", value_parser = fault)]
    plant: Vec<String>,
    #[command(flatten)]
    output: OutputOptions,
    /// How many threads work; the result is the same [default: all cores]
    #[arg(long, value_name = "N")]
    #[arg(value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Prove {
    /// Runs the proof and writes the result. The time goes to stderr, because it differs from run to run.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let mut outputs = self.output.open()?;
        work_with(self.threads)?;
        let named = |family: &Family| self.family.is_empty() || self.family.contains(family);
        let families: Vec<_> = Family::ALL.into_iter().filter(named).collect();
        let (start, variant) = (Instant::now(), variant(&self.plant)?);
        let (plant, seed, draws) = (self.plant, self.seed, self.draws);
        outputs.begin(&proof::head(&plant, seed, &families, draws))?;
        let progress = Progress::bar("pairs of families", (families.len() * families.len()) as u64);
        let proof = prove(&variant, seed, &families, draws, || progress.step());
        progress.end();
        let all = proof.pairs as u64 * draws;
        // The result is written even if stderr is closed.
        let _ =
            writeln!(std::io::stderr(), "{} in {:.1} s", count(all, "draw"), start.elapsed().as_secs_f64());
        let proved = Proved { plant, seed, families, draws, proof };
        let outcome = proof::outcome(&proved.proof);
        outputs.write(&outcome, || proof::human(&proved), || proof::json(&proved))?;
        Ok(outcome.verdict.exit)
    }
}
