//! The verification of programs that no one wrote for this check: the results of `beamgap verify --format json`, as a record.

use super::{Environment, Record, ReportError};
use crate::check::external::Report;
use serde::{Deserialize, Serialize};
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

/// The results for the answers of a program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VerifyRun {
    /// The command that ran it.
    pub answers: String,
    /// The verdict.
    pub verdict: String,
    /// The digits that were requested, if any.
    pub digits: Option<u8>,
    /// The convention that would explain all wrong numbers, if there is one.
    pub agrees_if: Option<String>,
    /// The results.
    #[serde(flatten)]
    pub report: Report,
}

impl Record for Verify {
    const SCHEMA: &'static str = "beamgap-verified/2";

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
