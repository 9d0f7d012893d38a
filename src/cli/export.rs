//! `beamgap export`, `beamgap schema`, `beamgap evaluate`: cases for other programs, and the library's own answers.

use super::arguments::{families, fault, regimes, seed, variant};
use super::count::count;
use super::exit::Exit;
use super::output::distinct;
use super::terminal::{folded, tell};
use anyhow::Context;
use beamgap::check::external::{
    ANSWERS, Drawing, Evaluator, Expected, Formulas, LIST_OF_FORMULAS, VECTORS, VectorReader, VectorWriter,
};
use beamgap::check::{Coverage, Family, Regime};
use beamgap::contact::{State, Work};
use clap::{Args, ValueEnum, value_parser};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

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
        let (mut start, mut seen, mut states) = (0, Coverage::default(), BTreeSet::new());
        while start < drawing.count() && !sink.is_closed {
            let end = drawing.count().min(start + AT_ONCE);
            let numbers: Vec<u64> = (start..end).collect();
            let line = |&number: &u64| {
                let vector = drawing.vector(number);
                (writer.line_and_sides(&vector), vector.state())
            };
            for ((line, sides), state) in numbers.par_iter().map(line).collect::<Vec<_>>() {
                sink.line(&line)?;
                seen.merge(&sides);
                states.extend(state);
            }
            start = end;
        }
        let is_read = !sink.is_closed;
        sink.finish()?;
        let unseen = drawing.unseen(&seen);
        if is_read && !unseen.is_empty() {
            tell(&words_of_unseen(&drawing, &unseen));
        }
        let others = State::ALL.into_iter().filter(|state| !states.contains(state)).map(State::name);
        let others: Vec<_> = others.collect();
        if is_read && self.element && !others.is_empty() {
            tell(&format!(
                "No contact element is in the state {}. More --cases show more.\n",
                others.join(", ")
            ));
        }
        Ok(Exit::Agree)
    }
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

/// The arguments of `evaluate`.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct Evaluate {
    /// The cases, or - for standard input
    #[arg(value_name = "VECTORS", default_value = "-")]
    vectors: PathBuf,
    /// Inject this fault; may be repeated (see `beamgap faults --list`)
    #[arg(long, value_name = "FAULT", value_parser = fault)]
    plant: Vec<String>,
    /// By which formulas: those that keep the most digits, the paper's, or the normal and the cross products
    #[arg(long, value_enum, default_value_t = By::Chosen)]
    formulas: By,
    /// Also answer residual and tangent of a contact element with this penalty stiffness
    #[arg(long, value_name = "STIFFNESS", value_parser = positive)]
    penalty: Option<f64>,
    /// Write numbers as hexadecimal strings, as C's %a prints them
    #[arg(long, conflicts_with = "digits")]
    hex: bool,
    /// Write N significant digits, instead of all
    #[arg(long, value_name = "N", value_parser = value_parser!(u8).range(1..=17))]
    digits: Option<u8>,
    /// Write to this file, and not to standard output
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum By {
    Chosen,
    Paper,
    Robust,
}

/// A positive number.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    let number = beamgap::check::external::parse(text).ok().filter(|x| x.is_finite() && *x > 0.0);
    number.ok_or_else(|| "expected a positive number".into())
}

impl Evaluate {
    /// Answers one case after the other; each answer is written before the next case is read.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let evaluator = Evaluator {
            variant: variant(&self.plant)?,
            formulas: match self.formulas {
                By::Chosen => Formulas::Chosen,
                By::Paper => Formulas::Paper,
                By::Robust => Formulas::Robust,
            },
            penalty: self.penalty,
            writer: VectorWriter { hex: self.hex, expected: Expected::None },
            digits: self.digits.map(usize::from),
        };
        if let Some(output) = &self.output {
            distinct(output, &[&self.vectors])?;
        }
        let (from, name) = source(&self.vectors)?;
        let mut vectors = VectorReader::new(from, &name)?;
        let mut sink = Sink::open(self.output.as_deref())?;
        sink.line(&evaluator.head())?;
        sink.flush()?;
        while let Some(vector) = vectors.next_vector()? {
            if sink.is_closed {
                break;
            }
            sink.line(&evaluator.line(&vector))?;
            if self.output.is_none() {
                sink.flush()?;
            }
        }
        sink.finish()?;
        Ok(Exit::Agree)
    }
}

/// A file, or standard input for `-`, with its name for messages.
pub(super) fn source(path: &Path) -> anyhow::Result<(Box<dyn BufRead + Send>, String)> {
    if path == Path::new("-") {
        return Ok((Box::new(BufReader::new(io::stdin())), "standard input".into()));
    }
    let name = path.display().to_string();
    let file = File::open(path).with_context(|| format!("cannot read {name}"))?;
    Ok((Box::new(BufReader::with_capacity(1 << 16, file)), name))
}

/// Standard output or a file, line by line. A reader that closes the pipe early is not an error.
pub(super) struct Sink {
    to: Box<dyn Write>,
    name: String,
    is_closed: bool,
}

impl Sink {
    pub(super) fn open(path: Option<&Path>) -> anyhow::Result<Self> {
        let (to, name): (Box<dyn Write>, _) = match path {
            None => (Box::new(BufWriter::new(io::stdout())), "standard output".into()),
            Some(path) => {
                let name = path.display().to_string();
                let file = File::create(path).with_context(|| format!("cannot write {name}"))?;
                (Box::new(BufWriter::new(file)), name)
            }
        };
        Ok(Self { to, name, is_closed: false })
    }

    pub(super) fn line(&mut self, line: &str) -> anyhow::Result<()> {
        let written = self.to.write_all(line.as_bytes()).and_then(|()| self.to.write_all(b"\n"));
        self.told(written)
    }

    fn flush(&mut self) -> anyhow::Result<()> {
        let written = self.to.flush();
        self.told(written)
    }

    pub(super) fn finish(mut self) -> anyhow::Result<()> {
        self.flush()
    }

    fn told(&mut self, written: io::Result<()>) -> anyhow::Result<()> {
        match written {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                self.is_closed = true;
                Ok(())
            }
            Err(error) => Err(error).with_context(|| format!("cannot write {}", self.name)),
            Ok(()) => Ok(()),
        }
    }
}
