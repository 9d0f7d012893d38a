//! `beamgap merge`: the parts of a check that several machines ran, merged into one result.

use super::checked::Checked;
use super::exit::Exit;
use super::human;
use super::output::OutputOptions;
use anyhow::Context;
use clap::Args;
use std::path::PathBuf;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Merge {
    /// The results of `beamgap check --shard I/N --format json` of all shards, in any order
    #[arg(value_name = "PART", required = true)]
    parts: Vec<PathBuf>,
    /// Show all tables, mismatches and shrunk cases of a run that fails, and not only a screen of them
    #[arg(long)]
    all: bool,
    #[command(flatten)]
    output: OutputOptions,
}

impl Merge {
    /// Merges and writes the result. It is equal, to the last byte, to that of a run on one machine.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let mut outputs = self.output.open()?;
        let read = |path: &PathBuf| {
            let name = path.display().to_string();
            let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {name}"))?;
            let part = serde_json::from_str(&text)
                .with_context(|| format!("{name} is not a result of `check --format json`"))?;
            Ok((name, part))
        };
        let parts = self.parts.iter().map(read).collect::<anyhow::Result<Vec<(String, Checked)>>>()?;
        let merged = Checked::merge(parts)?;
        // Mismatches are shrunk after this, which takes seconds.
        outputs.begin(&human::head(&merged))?;
        let shown = merged.shown(self.all)?;
        outputs.write(&shown.outcome, || human::document(&shown), || shown.json())?;
        Ok(shown.outcome.verdict.exit)
    }
}
