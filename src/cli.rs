//! The command line: arguments as input, an exit code as output. Each subcommand is a module.

mod accuracy;
mod adapter;
mod answered;
mod arguments;
mod bounds;
mod case;
mod case_file;
mod check;
mod checked;
mod config;
mod count;
mod disagreements;
mod equations;
mod evaluate;
mod exit;
mod explain;
mod export;
mod faults;
mod formats;
mod formula;
mod human;
mod json;
mod merge;
mod open_regions;
mod outcome;
mod output;
mod panics;
mod progress;
mod proof;
mod prove;
mod proved;
mod report;
mod searched;
mod shell;
mod stream;
mod terminal;
mod verify;
mod words;

use clap::{ColorChoice, CommandFactory, FromArgMatches, Parser, Subcommand};
use exit::Exit;
use std::path::PathBuf;
use std::process::ExitCode;

/// Linearization of beam-to-beam contact geometry, in closed form and by
/// automatic differentiation.
#[derive(Parser)]
#[command(name = "beamgap", version, arg_required_else_help = false, after_help = Exit::help())]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Read the options of check, verify, prove and faults from this file [default: beamgap.toml, if it exists]
    #[arg(long, value_name = "PATH", global = true)]
    config: Option<PathBuf>,
    /// Whether the verdict is coloured
    #[arg(long, value_name = "WHEN", global = true, default_value = "auto")]
    color: ColorChoice,
}

#[derive(Subcommand)]
enum Command {
    /// Compare the closed form with automatic differentiation on random pairs of beams.
    Check(check::Check),
    /// Merge the shards of a check into one result.
    Merge(merge::Merge),
    /// Compare the closed form with automatic differentiation over a prime field, without a tolerance.
    Prove(prove::Prove),
    /// Measure the overestimation factor of the tolerances, by double-double.
    Bounds(bounds::MeasureBounds),
    /// Measure the digits that each formulation keeps, by double-double.
    Accuracy(accuracy::Accurate),
    /// Inject faults into the closed form, and list which checks detect them.
    Faults(faults::InjectFaults),
    /// Evaluate every equation of the paper, as printed and as corrected.
    Equations(equations::ListEquations),
    /// Write cases for a program in any language.
    Export(export::Export),
    /// Print the JSON Schema of the cases or of the answers, or the formulas of a contact element.
    Schema(export::Schema),
    /// Answer cases by the closed form of this library.
    Evaluate(evaluate::Evaluate),
    /// Compare the answers of a program in any language, from a file or from the program.
    Verify(verify::Verify),
    /// Name the term that is wrong in the answers of a program.
    Explain(explain::Explain),
    /// Print a program in your language that answers cases; your element is inserted there.
    Adapter(adapter::Adapter),
    /// Write all reports of the checks, or the report on programs of others.
    Report(report::Report),
    /// Print a script that completes commands and options in your shell.
    Completions(shell::Completions),
    /// Print the manual page of a command.
    Man(shell::ManPage),
}

/// Runs the command given by the arguments of the process.
///
/// # Errors
/// Invalid arguments, files that cannot be written, and panics.
pub(crate) fn run() -> anyhow::Result<Exit> {
    let command = with_negative_numbers(Arguments::command()).term_width(terminal::help_columns());
    let command = config::configured(command)?;
    let parsed = command.clone().try_get_matches().and_then(|found| Arguments::from_arg_matches(&found));
    let arguments = match parsed {
        Ok(arguments) => arguments,
        Err(asked) if !asked.use_stderr() => {
            // For help and version, a closed pipe is not an error.
            let _ = asked.print();
            return Ok(Exit::Agree);
        }
        Err(wrong) => return Err(wrong.into()),
    };
    match arguments.color {
        ColorChoice::Auto => anstream::ColorChoice::Auto,
        ColorChoice::Always => anstream::ColorChoice::Always,
        ColorChoice::Never => anstream::ColorChoice::Never,
    }
    .write_global();
    panics::caught(|| match arguments.command {
        Command::Check(check) => check.run(),
        Command::Merge(merge) => merge.run(),
        Command::Prove(prove) => prove.run(),
        Command::Bounds(sharpen) => sharpen.run(),
        Command::Accuracy(accurate) => accurate.run(),
        Command::Faults(faults) => faults.run(),
        Command::Equations(equations) => equations.run(),
        Command::Export(export) => export.run(),
        Command::Schema(schema) => schema.run(),
        Command::Evaluate(evaluate) => evaluate.run(),
        Command::Verify(verify) => verify.run(),
        Command::Explain(explain) => explain.run(),
        Command::Adapter(adapter) => adapter.run(),
        Command::Report(report) => report.run(),
        Command::Completions(completions) => completions.run(command),
        Command::Man(page) => page.run(command),
    })
}

/// The command line on which a negative number is a value, so that its option says what it expects.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let of_option = |arg: clap::Arg| {
        let is_option = arg.get_long().is_some() && arg.get_action().takes_values();
        if is_option { arg.allow_negative_numbers(true) } else { arg }
    };
    command.mut_subcommands(|sub| sub.mut_args(of_option))
}

/// Prints the error on stderr.
pub(crate) fn tell(error: &anyhow::Error) -> Exit {
    let (line, exit) = if let Some(wrong) = error.downcast_ref::<clap::Error>() {
        (one_line(&wrong.render().to_string()), Exit::Usage)
    } else if error.is::<panics::Panic>() {
        (format!("error: {error}"), Exit::Internal)
    } else {
        (format!("error: {error:#}"), Exit::Input)
    };
    terminal::tell(&line);
    exit
}

/// The message of the argument parser without its usage, on one line.
fn one_line(message: &str) -> String {
    let lines = message.lines().map(str::trim).filter(|line| !line.is_empty());
    let told = lines.take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"));
    format!("{} (see --help)", told.collect::<Vec<_>>().join(" ").replace(" tip:", ", tip:"))
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}
