//! Programs that no one wrote for this check, verified: what `beamgap verify --format json` says of each, as a record.

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
    /// Where it was made.
    pub environment: Environment,
    /// By program.
    pub runs: Vec<VerifyRun>,
}

/// What was found of the answers of a program; what else the result of `verify` has is left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyRun {
    /// What its answers say of it.
    pub program: VerifyProgram,
    /// The command that ran it.
    pub answers: String,
    /// The verdict.
    pub verdict: String,
    /// The digits that were asked for, if some were.
    pub digits: Option<u8>,
    /// How many cases it was given.
    pub cases: u64,
    /// How many closest points were compared.
    pub compared: u64,
    /// At how many of them a number is wrong.
    pub wrong: u64,
    /// How many cases it did not answer.
    pub missing: u64,
    /// To how many its answer holds no number.
    pub unanswered: u64,
    /// How many could not be compared, by reason.
    pub not_compared: BTreeMap<String, u64>,
    /// By quantity and order.
    pub parts: Vec<VerifyPart>,
    /// By regime.
    pub regimes: Vec<VerifyRegime>,
    /// What would explain all that is wrong, if it is a convention.
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

/// What was found of an order of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyPart {
    /// The quantity.
    pub quantity: String,
    /// The order.
    pub order: String,
    /// How many numbers were compared.
    pub numbers: u64,
    /// How many of them are wrong.
    pub wrong: u64,
    /// How many are right, but with fewer digits than can be attained.
    pub losing_digits: u64,
}

/// What was found in a regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyRegime {
    /// The regime.
    pub regime: String,
    /// How many closest points were compared.
    pub compared: u64,
    /// At how many of them a number is wrong.
    pub wrong: u64,
    /// At how many of them a number is right, but with fewer digits than can be attained.
    pub losing_digits: u64,
    /// The number with the largest error over its size.
    pub largest_error: Option<VerifyError>,
    /// The number that is right and has lost the most digits.
    pub largest_loss: Option<VerifyLoss>,
}

/// An error, and the case that shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyError {
    /// The error over the size of the number; none if it is not finite.
    pub error: Option<f64>,
    /// The error that the best formulas make there at most.
    pub attainable: Option<f64>,
    /// The case.
    pub case: String,
    /// The number.
    pub comparison: VerifyNumber,
}

/// A loss of digits, and the case that shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyLoss {
    /// How many digits.
    pub digits: Option<f64>,
    /// The case.
    pub case: String,
    /// The number.
    pub comparison: VerifyNumber,
}

/// Which number of a case.
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

/// Reads what `beamgap verify --format json` wrote of each program, and writes `verify.json` and `verify.md` into the
/// directory `to`.
///
/// # Errors
/// [`ReportError::Read`] or [`ReportError::Format`] if a file is none of these, [`ReportError::Write`] if a file cannot be
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
