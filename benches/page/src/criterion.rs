//! The results of `cargo bench`: the files of criterion, whose format criterion does not guarantee, and our verdicts.
//!
//! Of the files of criterion, only the indispensable parts are read: the name of a benchmark, and for each sample the number
//! of iterations and their time. All other contents of the files and of their directory are ignored.

use crate::task::group;
use crate::{BenchmarkError, Rounds};
use beamgap::report::{Environment, ReportError, write};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The file, next to those of criterion, with the verdicts of the benches.
pub const VERDICTS: &str = "beamgap-verdicts.json";

/// The file with the rounds of the timed methods.
const ROUNDS: &str = "beamgap-rounds.json";

/// The verification by the benches, before any timing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdicts {
    /// The environment of the benches.
    pub environment: Environment,
    /// The scenarios, in the order of display.
    pub scenarios: Vec<Verdict>,
}

/// A scenario and the result of its verification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The task.
    pub task: String,
    /// The family of both beams.
    pub family: String,
    /// The dofs of both beams together.
    pub dofs: usize,
    /// The method: the function in criterion.
    pub method: String,
    /// The number of pairs in a run.
    pub pairs: usize,
    /// The largest error, relative to the largest number of its kind.
    pub error: f64,
    /// The largest error over its tolerance.
    pub share: f64,
}

impl Verdict {
    /// Whether the scenario is correct.
    pub fn is_right(&self) -> bool {
        self.share <= 1.0 && self.error.is_finite()
    }

    /// The group in criterion.
    pub(crate) fn group(&self) -> String {
        group(&self.task, &self.family, self.dofs)
    }
}

/// The samples of one benchmark, in nanoseconds for each iteration, and the time at which they were written.
pub(crate) struct Samples {
    pub(crate) times: Vec<f64>,
    pub(crate) written: SystemTime,
}

/// The directory of criterion, by the rules of criterion: `CRITERION_HOME`, or `criterion` in the target directory.
pub fn criterion_directory() -> PathBuf {
    let variable = |name| std::env::var_os(name).map(PathBuf::from);
    variable("CRITERION_HOME")
        .unwrap_or_else(|| variable("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()).join("criterion"))
}

impl Verdicts {
    /// Writes the verdicts into criterion's directory.
    ///
    /// # Errors
    /// [`ReportError::Write`].
    pub fn write(&self, directory: &Path) -> Result<(), ReportError> {
        let json = serde_json::to_string_pretty(self)
            .map_err(|source| ReportError::Format { what: VERDICTS.to_owned(), source })?;
        write(directory, VERDICTS, &json)
    }

    /// Reads the verdicts, with the time at which they were written.
    pub(crate) fn read(directory: &Path) -> Result<(Self, SystemTime), BenchmarkError> {
        let path = directory.join(VERDICTS);
        let Some((text, written)) = read(&path) else { return Err(BenchmarkError::NoVerdicts { path }) };
        let verdicts = serde_json::from_str(&text)
            .map_err(|source| ReportError::Format { what: path.display().to_string(), source })?;
        Ok((verdicts, written))
    }
}

/// Writes the rounds of methods into the directory of criterion, each with the group and the name of the method.
///
/// # Errors
/// [`ReportError::Write`].
pub fn write_rounds(directory: &Path, rounds: &[(String, String, Rounds)]) -> Result<(), ReportError> {
    let json = serde_json::to_string(rounds)
        .map_err(|source| ReportError::Format { what: ROUNDS.to_owned(), source })?;
    write(directory, ROUNDS, &json)
}

/// The rounds that were measured after `verified`, by group and method.
pub(crate) fn rounds(
    directory: &Path,
    verified: SystemTime,
) -> Result<BTreeMap<(String, String), Vec<Rounds>>, ReportError> {
    let path = directory.join(ROUNDS);
    let Some((text, _)) = read(&path).filter(|(_, written)| *written >= verified) else {
        return Ok(BTreeMap::new());
    };
    let rounds: Vec<(String, String, Rounds)> = serde_json::from_str(&text)
        .map_err(|source| ReportError::Format { what: path.display().to_string(), source })?;
    let mut of_methods = BTreeMap::new();
    for (group, method, rounds) in rounds {
        of_methods.entry((group, method)).or_insert_with(Vec::new).push(rounds);
    }
    Ok(of_methods)
}

/// All measurements of criterion, by group and function.
pub(crate) fn samples(directory: &Path) -> Result<BTreeMap<(String, String), Samples>, BenchmarkError> {
    #[derive(Deserialize)]
    struct Name {
        group_id: String,
        function_id: Option<String>,
    }
    #[derive(Deserialize)]
    struct Sample {
        iters: Vec<f64>,
        times: Vec<f64>,
    }
    let mut found = BTreeMap::new();
    let mut open = vec![directory.to_owned()];
    while let Some(directory) = open.pop() {
        let entries = fs::read_dir(&directory).into_iter().flatten().flatten();
        open.extend(entries.map(|entry| entry.path()).filter(|path| path.is_dir()));
        if !directory.ends_with("new") {
            continue;
        }
        let parts = (read(&directory.join("benchmark.json")), read(&directory.join("sample.json")));
        let (Some((name, _)), Some((sample, written))) = parts else { continue };
        let parsed = (serde_json::from_str::<Name>(&name), serde_json::from_str::<Sample>(&sample));
        let (Ok(name), Ok(sample)) = parsed else { continue };
        let times =
            sample.times.iter().zip(&sample.iters).map(|(time, iterations)| time / iterations).collect();
        found.insert((name.group_id, name.function_id.unwrap_or_default()), Samples { times, written });
    }
    if found.is_empty() {
        return Err(BenchmarkError::NoMeasurements { directory: directory.to_owned() });
    }
    Ok(found)
}

fn read(path: &Path) -> Option<(String, SystemTime)> {
    Some((fs::read_to_string(path).ok()?, fs::metadata(path).ok()?.modified().ok()?))
}
