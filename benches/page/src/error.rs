//! The errors of making the page of the benchmark.

use beamgap::report::ReportError;
use std::path::PathBuf;

/// The reasons why the page cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum BenchmarkError {
    /// Criterion has not run, or not in this directory.
    #[error("no measurements in {}: run `cargo bench` first", .directory.display())]
    NoMeasurements {
        /// The directory that was searched.
        directory: PathBuf,
    },
    /// The benches have not written their verdicts.
    #[error("no verdicts in {}: run `cargo bench` first", .path.display())]
    NoVerdicts {
        /// The file that is missing.
        path: PathBuf,
    },
    /// A scenario was verified but not timed afterwards.
    #[error("{scenario} was not timed after it was verified: run `cargo bench` without a filter")]
    NotTimed {
        /// The scenario.
        scenario: String,
    },
    /// The verification of a scenario failed.
    #[error("{scenario} is off by {share:e} times what is allowed, and nothing wrong is timed")]
    Wrong {
        /// The scenario.
        scenario: String,
        /// The largest error over its tolerance.
        share: f64,
    },
    /// A record cannot be read, or a file cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}
