//! `beamgap adapter`: a small complete program that answers cases, in the language of the user.

use super::exit::Exit;
use super::stream::Sink;
use clap::{Args, ValueEnum};

/// The arguments.
#[derive(Args)]
pub(crate) struct Adapter {
    /// The language
    #[arg(value_enum)]
    language: Language,
    /// Print a contact element with friction, which answers the cases of `export --element`
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
        // The second program is a contact element with friction.
        let [geometry, contact] = match self.language {
            Language::Fortran => [
                include_str!("../../examples/verify/adapter.f90"),
                include_str!("../../examples/verify/contact.f90"),
            ],
            Language::C => [
                include_str!("../../examples/verify/adapter.c"),
                include_str!("../../examples/verify/contact.c"),
            ],
            Language::Cpp => [
                include_str!("../../examples/verify/adapter.cpp"),
                include_str!("../../examples/verify/contact.cpp"),
            ],
            Language::Python => [
                include_str!("../../examples/verify/adapter.py"),
                include_str!("../../examples/verify/contact.py"),
            ],
            Language::Julia => [
                include_str!("../../examples/verify/adapter.jl"),
                include_str!("../../examples/verify/contact.jl"),
            ],
            Language::Matlab => [
                include_str!("../../examples/verify/adapter.m"),
                include_str!("../../examples/verify/contact.m"),
            ],
        };
        let program = if self.contact { contact } else { geometry };
        let mut sink = Sink::open(None)?;
        sink.line(program.trim_end())?;
        sink.finish()?;
        Ok(Exit::Agree)
    }
}
