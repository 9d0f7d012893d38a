//! `beamgap prove`: both linearizations over a prime field, compared without a tolerance.

use super::arguments::{families, seed};
use super::exit::Exit;
use super::output::Output;
use super::table::Table;
use beamgap::linearization::Quantity;
use beamgap::prove::{Layer, Proof, Refutation, Row, prove};
use beamgap::specimen::Family;
use clap::{Args, value_parser};
use std::fmt::Write;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::Instant;

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Prove {
    /// Seed of the random residues, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed, allow_negative_numbers = true)]
    seed: u64,
    /// How many draws for each ordered pair of families
    #[arg(long, value_name = "N", default_value = "1000", allow_negative_numbers = true)]
    #[arg(value_parser = value_parser!(u64).range(1..=1_000_000))]
    draws: u64,
    /// Only this family; may be repeated, and then all pairs of those named
    #[arg(long, value_parser = families())]
    family: Vec<Family>,
    /// Write the result to this file, and only the verdict to standard output
    #[arg(long, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl Prove {
    /// Does the proof and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let output = Output::open(self.output.as_deref())?;
        let families: Vec<_> =
            Family::ALL.into_iter().filter(|f| self.family.is_empty() || self.family.contains(f)).collect();
        let start = Instant::now();
        let proof = prove(self.seed, &families, self.draws);
        if std::io::stderr().is_terminal() {
            eprintln!("{} draws in {:.1} s", proof.pairs as u64 * self.draws, start.elapsed().as_secs_f64());
        }
        let verdict = verdict(&proof);
        let document = format!("{}\n{verdict}\n", document(&self, &proof));
        output.write(&document, &format!("{verdict}\n"))?;
        Ok(if proof.holds() { Exit::Agree } else { Exit::Disagree })
    }
}

fn verdict(proof: &Proof) -> String {
    if proof.holds() {
        return "PROVED: closed form and automatic differentiation are equal in every draw.".into();
    }
    let pairs = proof.refutations.len();
    format!("REFUTED: in {pairs} of {} pairs of families they are not equal.", proof.pairs)
}

fn document(asked: &Prove, proof: &Proof) -> String {
    let mut text = format!(
        "Contact geometry of two beams: closed form against automatic differentiation,\n\
         over the field of 2^61 - 1 elements, compared by ==\n\
         seed {:#x}, {} ordered pairs of families, {} draws each\n\n\
         The chance that a wrong formula passes one draw is at most 10^bound, from the\n\
         degree of the two sides (Schwartz and Zippel); independent draws multiply.\n\n",
        asked.seed, proof.pairs, asked.draws
    );
    let mut table = Table::new(&["quantity", "layer", "equal", "unequal", "degree <", "bound"]).left(&[1]);
    for row in &proof.rows {
        let Row { quantity, layer, equal, refuted, degree } = row;
        table.row(vec![
            quantity.name().into(),
            layer.name().into(),
            equal.to_string(),
            refuted.to_string(),
            format!("{degree:.1e}"),
            format!("{:.1}", row.log_probability()),
        ]);
    }
    let _ = write!(text, "{table}");
    for refutation in proof.refutations.iter().take(5) {
        let _ = write!(text, "\n{}", told(asked.seed, refutation));
    }
    text
}

/// One inequality and the command that shows it again.
fn told(seed: u64, refutation: &Refutation) -> String {
    let Refutation { families: [one, other], draw, active, quantity: (quantity, component, layer), residues } =
        refutation;
    let axis = if *component < 15 { ["[x]", "[y]", "[z]"][component % 3] } else { "" };
    let order = match layer {
        Layer::Value => "",
        Layer::First => "delta ",
        Layer::Second => "Delta-delta ",
        Layer::Matrix => "contracted matrix of ",
    };
    let name = Quantity::name(*quantity);
    let ends = match (active.xi, active.xi_bar) {
        (false, false) => "inside both beams",
        (true, false) => "at an end of the beam",
        (false, true) => "at an end of the bar beam",
        (true, true) => "at ends of both beams",
    };
    let repeat = if one == other {
        format!("--family {}", one.name())
    } else {
        format!("--family {} --family {}", one.name(), other.name())
    };
    format!(
        "{} and {}, draw {draw}, {ends}: {order}{name}{axis} is {}, and by AD {}\n  \
         beamgap prove --seed {seed:#x} --draws {} {repeat}\n",
        one.name(),
        other.name(),
        residues[0],
        residues[1],
        draw + 1
    )
}
