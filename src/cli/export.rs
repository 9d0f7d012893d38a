//! `beamgap export` and `beamgap schema`: cases for other programs.

use super::arguments::{families, regimes, seed};
use super::count::count;
use super::exit::Exit;
use super::stream::Sink;
use super::terminal::{folded, tell};
use beamgap::check::external::{ANSWERS, Drawing, Expected, LIST_OF_FORMULAS, VECTORS, VectorWriter};
use beamgap::check::{Coverage, Family, Regime};
use beamgap::contact::{State, Work};
use clap::{Args, ValueEnum, value_parser};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// The JSON Schemas, and the list of formulas, by name.
const SCHEMAS: [(&str, &str); 3] = [
    (VECTORS, include_str!("schema/vectors.json")),
    (ANSWERS, include_str!("schema/answers.json")),
    ("formulas", LIST_OF_FORMULAS),
];
/// The number of cases that are drawn in one batch.
const AT_ONCE: u64 = 32;

/// The arguments of `export`.
#[derive(Args)]
#[command(after_help = Exit::help())]
#[expect(clippy::struct_excessive_bools, reason = "each is an option of its own")]
pub(crate) struct Export {
    /// Seed of the random pairs, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// How many cases of each regime; a note on standard error names what so few do not show, such as obtuse crossings
    #[arg(long, value_name = "N", default_value = "11")]
    #[arg(value_parser = value_parser!(u64).range(1..=10_000_000))]
    cases: u64,
    /// Only pairs of these families; may be repeated
    #[arg(long, value_parser = families())]
    family: Vec<Family>,
    /// Only this regime; may be repeated
    #[arg(long, value_parser = regimes())]
    regime: Vec<Regime>,
    /// The expected answers that each case contains: none, values and variations, or gradients and Hessians too
    #[arg(long, value_enum, default_value_t = Beside::Variations)]
    expected: Beside,
    /// Write numbers as hexadecimal strings, as C's %a prints them
    #[arg(long)]
    hex: bool,
    /// Choose radii so large that the surfaces penetrate in all cases [default: in about half the cases of each regime]
    #[arg(long)]
    penetrating: bool,
    /// Add a contact element with friction to each case: its parameters and its history, in every state
    #[arg(long, conflicts_with = "penetrating")]
    element: bool,
    /// Add two earlier converged steps, which lead to the history, for programs that keep their own history
    #[arg(long, requires = "element")]
    steps: bool,
    /// Only this work of the contact elements [default: both in turn]
    #[arg(long, value_enum, requires = "element")]
    work: Option<Kind>,
    /// Write to this file, and not to standard output
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Beside {
    None,
    Variations,
    All,
}

/// The work of friction.
#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    Rate,
    Paper,
}

impl Export {
    /// Draws and writes the cases.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let named = |family: &Family| self.family.is_empty() || self.family.contains(family);
        let asked = |regime: &Regime| self.regime.is_empty() || self.regime.contains(regime);
        let drawing = Drawing {
            seed: self.seed,
            regimes: Regime::ALL.into_iter().filter(asked).collect(),
            families: Family::ALL.into_iter().filter(named).collect(),
            cases: self.cases,
            penetrating: self.penetrating,
            elements: self.element,
            steps: self.steps,
            work: self.work.map(|kind| match kind {
                Kind::Rate => Work::Rate,
                Kind::Paper => Work::Paper,
            }),
        };
        let expected = match self.expected {
            Beside::None => Expected::None,
            Beside::Variations => Expected::Variations,
            Beside::All => Expected::All,
        };
        let writer = VectorWriter { hex: self.hex, expected };
        let mut sink = Sink::open(self.output.as_deref())?;
        sink.line(&writer.head(&drawing))?;
        let (mut start, mut seen, mut situations) = (0, Coverage::default(), BTreeSet::new());
        while start < drawing.count() && !sink.is_closed {
            let end = drawing.count().min(start + AT_ONCE);
            let numbers: Vec<u64> = (start..end).collect();
            let line = |&number: &u64| {
                let vector = drawing.vector(number);
                (writer.line_and_sides(&vector), vector.state().map(|state| (state, vector.become_held())))
            };
            for ((line, sides), situation) in numbers.par_iter().map(line).collect::<Vec<_>>() {
                sink.line(&line)?;
                seen.merge(&sides);
                situations.extend(situation);
            }
            start = end;
        }
        let is_read = !sink.is_closed;
        sink.finish()?;
        let unseen = drawing.unseen(&seen);
        if is_read && !unseen.is_empty() {
            tell(&words_of_unseen(&drawing, &unseen));
        }
        let others = others(&situations);
        if is_read && self.element && !others.is_empty() {
            let list = folded(&others.join(", "), "  ", "  ");
            tell(&format!(
                "No contact element shows these situations. More cases of all regimes show more.\n{list}"
            ));
        }
        Ok(Exit::Agree)
    }
}

/// The situations that no contact element is in: the states, and those in which xi or xi_bar becomes held.
fn others(seen: &BTreeSet<(State, [bool; 2])>) -> Vec<String> {
    let is_seen = |is_meant: &dyn Fn(State, [bool; 2]) -> bool| {
        seen.iter().any(|(state, held)| is_meant(*state, *held))
    };
    let states = State::ALL.into_iter().filter(|state| !is_seen(&|of, _| of == *state));
    let states = states.map(|state| format!("the state {}", state.name()));
    let held = [State::Stick, State::Slip].into_iter().flat_map(|state| {
        let is_other = move |i: &usize| !is_seen(&|of, held| of == state && held[*i]);
        (0..2).filter(is_other).map(move |i| format!("{} becomes held in {}", ["ξ", "ξ̄"][i], state.name()))
    });
    states.chain(held).collect()
}

/// The sides of the symmetries that no case shows: a fault that acts there alone is not seen.
fn words_of_unseen(drawing: &Drawing, unseen: &[&str]) -> String {
    let (cases, sides) = (count(drawing.count(), "case"), count(unseen.len(), "side"));
    format!(
        "Not seen by {cases}: {sides} of the symmetries. More --cases show more.\n{}",
        folded(&unseen.join(", "), "  ", "  ")
    )
}

/// The arguments of `schema`.
#[derive(Args)]
pub(crate) struct Schema {
    /// The schema of the cases, that of the answers, or the formulas of a contact element in which errors are looked for
    #[arg(value_enum, default_value_t = Of::Vectors)]
    of: Of,
}

#[derive(Clone, Copy, ValueEnum)]
enum Of {
    Vectors,
    Answers,
    Formulas,
}

impl Schema {
    /// Prints the schema.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let mut sink = Sink::open(None)?;
        sink.line(SCHEMAS[self.of as usize].1.trim_end())?;
        sink.finish()?;
        Ok(Exit::Agree)
    }
}
