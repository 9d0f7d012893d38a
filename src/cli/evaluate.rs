//! `beamgap evaluate`: the library's own answers.

use super::arguments::{fault, variant};
use super::exit::Exit;
use super::output::distinct;
use super::stream::{Sink, source};
use beamgap::check::external::{Evaluator, Expected, Formulas, VectorReader, VectorWriter};
use clap::{Args, ValueEnum, value_parser};
use std::path::PathBuf;

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
fn positive(text: &str) -> Result<f64, String> {
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
