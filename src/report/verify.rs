//! The verification of programs that no one wrote for this check: the results of `beamgap verify --format json`, as a record.

use super::{Environment, Record, ReportError};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verify {
    /// The schema.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The results, by program.
    pub runs: Vec<VerifyRun>,
}

/// The results for the answers of a program. Other parts of the result of `verify` are omitted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyRun {
    /// The program that its answers name.
    pub program: VerifyProgram,
    /// The command that ran it.
    pub answers: String,
    /// The verdict.
    pub verdict: String,
    /// The digits that were requested, if any.
    pub digits: Option<u8>,
    /// The number of cases that the program was given.
    pub cases: u64,
    /// The number of compared closest points.
    pub compared: u64,
    /// The number of these at which a number is wrong.
    pub wrong: u64,
    /// The number of cases without an answer.
    pub missing: u64,
    /// The number of cases whose answer contains no number.
    pub unanswered: u64,
    /// The number of cases that could not be compared, by reason.
    pub not_compared: BTreeMap<String, u64>,
    /// The results by quantity and order.
    pub parts: Vec<VerifyPart>,
    /// The results by regime.
    pub regimes: Vec<VerifyRegime>,
    /// The convention that would explain all wrong numbers, if there is one.
    pub agrees_if: Option<String>,
}

/// A program and its version.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct VerifyProgram {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
}

/// The results for an order of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyPart {
    /// The quantity.
    pub quantity: String,
    /// The order.
    pub order: String,
    /// The number of compared numbers.
    pub numbers: u64,
    /// The number of wrong ones.
    pub wrong: u64,
    /// The number of correct ones with fewer digits than are attainable.
    pub losing_digits: u64,
}

/// The results in a regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyRegime {
    /// The regime.
    pub regime: String,
    /// The number of compared closest points.
    pub compared: u64,
    /// The number of these at which a number is wrong.
    pub wrong: u64,
    /// The number of these at which a number is correct, but with fewer digits than are attainable.
    pub losing_digits: u64,
    /// The number with the largest error over its size.
    pub largest_error: Option<VerifyError>,
    /// The correct number that has lost the most digits.
    pub largest_loss: Option<VerifyLoss>,
}

/// An error, and the case in which it occurs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyError {
    /// The error over the size of the number; none if it is not finite.
    pub error: Option<f64>,
    /// The maximum error of the best formulas there.
    pub attainable: Option<f64>,
    /// The case.
    pub case: String,
    /// The number.
    pub comparison: VerifyNumber,
}

/// A loss of digits, and the case in which it occurs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyLoss {
    /// The number of digits.
    pub digits: Option<f64>,
    /// The case.
    pub case: String,
    /// The number.
    pub comparison: VerifyNumber,
}

/// The identification of a number of a case.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct VerifyNumber {
    /// The quantity.
    pub quantity: String,
    /// Its part.
    pub part: String,
}

impl Record for Verify {
    const SCHEMA: &'static str = "beamgap-verified/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

/// Reads the results of `beamgap verify --format json` for each program, and writes `verify.json` and `verify.md` into the
/// directory `to`.
///
/// # Errors
/// [`ReportError::Read`] or [`ReportError::Format`] if a file is no such result, [`ReportError::Write`] if a file cannot be
/// written.
pub fn verify(to: &Path, results: &[PathBuf], command: &str) -> Result<Verify, ReportError> {
    let run = |path: &PathBuf| {
        let text =
            fs::read_to_string(path).map_err(|source| ReportError::Read { path: path.clone(), source })?;
        let what = path.display().to_string();
        serde_json::from_str(&text).map_err(|source| ReportError::Format { what, source })
    };
    let runs = results.iter().map(run).collect::<Result<Vec<VerifyRun>, _>>()?;
    let environment = Environment::here(command);
    let json = Verify { schema: Verify::SCHEMA.to_owned(), environment, runs }.to_json()?;
    let record = Verify::from_json(&json)?;
    super::write(to, "verify.json", &json)?;
    super::write(to, "verify.md", &record.page().to_markdown())?;
    Ok(record)
}
