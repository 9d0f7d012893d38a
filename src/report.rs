//! The reports: records as JSON with a versioned schema, and pages made from the records alone.
//!
//! [`Crosscheck`], [`Bounds`], [`Accuracy`], [`Faults`], [`Equations`] and [`Derivation`] are the records: the results of the
//! check, the overestimation of the tolerances, the digits that each formulation keeps, the results of fault injection, and
//! the verdict on each equation. Markdown, HTML and SVG are pure functions of the data read back from the JSON. The same JSON
//! therefore always gives the same pages, byte for byte.

// The means by which pages are made, public for the benches, which publish a page of their own.
#[doc(hidden)]
pub mod chart;
#[doc(hidden)]
pub mod number;
#[doc(hidden)]
pub mod page;

mod accuracy;
mod accuracy_figure;
mod accuracy_page;
mod beam_pictures;
mod beam_problems;
mod beam_problems_page;
mod bounds;
mod bounds_page;
mod crosscheck;
mod crosscheck_page;
mod derivation;
mod elements;
mod elements_page;
mod environment;
mod equations;
mod equations_page;
mod error;
mod explain;
mod explain_page;
mod faults;
mod faults_page;
mod front_page;
mod newton;
mod picture;
mod record;
mod symbols;
mod verify;
mod verify_page;

pub use accuracy::Accuracy;
pub use beam_problems::{BeamProblem, BeamProblems, BeamStep, Convergence, Shape, beam_problems};
pub use bounds::Bounds;
pub use crosscheck::Crosscheck;
pub use derivation::{ByHand, Derivation, DifferenceRow, NewtonRun};
pub use elements::{ElementErrors, ElementRuns, Elements, PublishedElement, elements};
pub use environment::Environment;
pub use equations::Equations;
pub use error::ReportError;
pub use explain::{Explain, ExplainProgram, ExplainSample, KindCount, NamingCount, NotFirst, explain};
pub use faults::Faults;
pub use front_page::front_page;
pub use newton::Iterations;
pub use page::{Page, Table};
pub use picture::picture;
pub use record::Record;
pub use symbols::symbols;
pub use verify::{Verify, VerifyRun, verify};

use crate::check::{self, CheckConfig, Regime, Selection};
use std::fs;
use std::path::Path;

/// The seed of a report.
pub const SEED: u64 = 0x5eed;
/// The cases of each regime in a report.
pub const CASES: u64 = 10_000;
/// The cases of each regime for the measurement of the bounds on rounding.
pub const BOUNDS_CASES: u64 = 11_112;
/// The pairs at each gap and angle for the measurement of the accuracy: all pairs of families, eight times.
pub const ACCURACY_PAIRS: u32 = 968;

/// Runs the check over `cases` cases of each regime and writes `crosscheck.json` and `crosscheck.md` into the directory
/// `to`. Calls `done` after each case.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn crosscheck(
    to: &Path,
    seed: u64,
    cases: u64,
    command: &str,
    done: impl Fn() + Sync,
) -> Result<Crosscheck, ReportError> {
    let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases };
    let summary = check::run(&CheckConfig::default(), seed, &selection, done);
    let json = Crosscheck::new(summary, seed, cases, Environment::here(command)).to_json()?;
    let record = Crosscheck::from_json(&json)?;
    write(to, "crosscheck.json", &json)?;
    write(to, "crosscheck.md", &record.page().to_markdown())?;
    Ok(record)
}

/// Measures the overestimation of the tolerances over `cases` cases of each regime, and writes `bounds.json` and
/// `bounds.md` into the directory `to`. Calls `done` after each case.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn bounds(
    to: &Path,
    seed: u64,
    cases: u64,
    command: &str,
    done: impl Fn() + Sync,
) -> Result<Bounds, ReportError> {
    let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases };
    let found = check::bounds(seed, &selection, done);
    let json = Bounds::new(found, seed, cases, Environment::here(command)).to_json()?;
    let record = Bounds::from_json(&json)?;
    write(to, "bounds.json", &json)?;
    write(to, "bounds.md", &record.page().to_markdown())?;
    Ok(record)
}

/// Measures the digits that each formulation keeps. Writes `accuracy.json`, `accuracy.md` and two pictures into the
/// directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn accuracy(to: &Path, seed: u64, command: &str) -> Result<Accuracy, ReportError> {
    let pairs = ACCURACY_PAIRS as usize;
    let found = check::accuracy(seed, pairs);
    let json = Accuracy::new(found, seed, pairs, Environment::here(command)).to_json()?;
    let record = Accuracy::from_json(&json)?;
    write(to, "accuracy.json", &json)?;
    write(to, "accuracy.md", &record.page().to_markdown())?;
    write(to, "accuracy-gap.svg", &record.gap_to_svg())?;
    write(to, "accuracy-angle.svg", &record.angle_to_svg())?;
    Ok(record)
}

/// Writes `symbols.md` into the directory `to`. The other pages refer to it.
///
/// # Errors
/// [`ReportError::Write`] if the file cannot be written.
pub fn write_symbols(to: &Path) -> Result<(), ReportError> {
    write(to, "symbols.md", &symbols().to_markdown())
}

/// Writes `faults.json` and `faults.md` into the directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn faults(to: &Path, record: &Faults) -> Result<(), ReportError> {
    let json = record.to_json()?;
    write(to, "faults.json", &json)?;
    write(to, "faults.md", &Faults::from_json(&json)?.page().to_markdown())
}

/// Writes `equations.json` and `equations.md` into the directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn equations(to: &Path, record: &Equations) -> Result<(), ReportError> {
    let json = record.to_json()?;
    write(to, "equations.json", &json)?;
    write(to, "equations.md", &Equations::from_json(&json)?.page().to_markdown())
}

/// Writes `derivation.json` and `derivation.html` into the directory `to`. The page shows the digits lost at small gaps if
/// `accuracy.json` exists.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written, [`ReportError::Derivation`] if the page cannot be composed.
pub fn derivation(to: &Path, equations: &Equations) -> Result<(), ReportError> {
    let record = Derivation::compute(&equations.environment.command)
        .map_err(|error| ReportError::Derivation { what: error.to_string() })?;
    let json = record.to_json()?;
    let accuracy = fs::read_to_string(to.join("accuracy.json")).ok();
    let accuracy = accuracy.map(|json| Accuracy::from_json(&json)).transpose()?;
    write(to, "derivation.json", &json)?;
    write(to, "derivation.html", &Derivation::from_json(&json)?.to_html(&equations.table, accuracy.as_ref())?)
}

/// Writes a file into a directory, which is made if there is none.
///
/// # Errors
/// [`ReportError::Write`] if the file cannot be written.
#[doc(hidden)]
pub fn write(to: &Path, name: &str, text: &str) -> Result<(), ReportError> {
    let path = to.join(name);
    fs::create_dir_all(to)
        .and_then(|()| fs::write(&path, text))
        .map_err(|source| ReportError::Write { path, source })
}
