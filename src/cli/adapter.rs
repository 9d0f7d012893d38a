//! `beamgap adapter`: a small complete program that answers cases, in the language of the user.

use super::exit::Exit;
use super::export::Sink;
use clap::error::ErrorKind;
use clap::{Args, ValueEnum};

/// The arguments.
#[derive(Args)]
pub(crate) struct Adapter {
    /// The language
    #[arg(value_enum)]
    language: Language,
    /// Print a contact element that answers residual and tangent; it uses the other program of the language
    #[arg(long)]
    contact: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Language {
    Fortran,
    C,
    Cpp,
    Python,
    Julia,
    Matlab,
}

impl Adapter {
    /// Prints the program.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        if self.contact && !matches!(self.language, Language::Python) {
            let words = "--contact: python expected, there is no contact element in another language\n";
            return Err(clap::Error::raw(ErrorKind::ArgumentConflict, words).into());
        }
        let program = match self.language {
            Language::Python if self.contact => include_str!("../../examples/verify/contact.py"),
            Language::Fortran => include_str!("../../examples/verify/adapter.f90"),
            Language::C => include_str!("../../examples/verify/adapter.c"),
            Language::Cpp => include_str!("../../examples/verify/adapter.cpp"),
            Language::Python => include_str!("../../examples/verify/adapter.py"),
            Language::Julia => include_str!("../../examples/verify/adapter.jl"),
            Language::Matlab => include_str!("../../examples/verify/adapter.m"),
        };
        let mut sink = Sink::open(None)?;
        sink.line(program.trim_end())?;
        sink.finish()?;
        Ok(Exit::Agree)
    }
}
