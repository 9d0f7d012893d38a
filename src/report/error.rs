//! Why a report could not be made.

use std::path::PathBuf;

/// Why a report could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// Criterion has not run, or not here.
    #[error("no measurements in {}: run `cargo bench` first", .directory.display())]
    NoMeasurements {
        /// Where they were looked for.
        directory: PathBuf,
    },
    /// The benches have not left their verdicts.
    #[error("no verdicts in {}: run `cargo bench` first", .path.display())]
    NoVerdicts {
        /// The file that is missing.
        path: PathBuf,
    },
    /// A scenario was verified but not timed since.
    #[error("{scenario} was not timed after it was verified: run `cargo bench` without a filter")]
    NotTimed {
        /// The scenario.
        scenario: String,
    },
    /// A scenario was verified and found wrong.
    #[error("{scenario} is off by {share:e} times what is allowed, and nothing wrong is timed")]
    Wrong {
        /// The scenario.
        scenario: String,
        /// The largest error over what is allowed.
        share: f64,
    },
    /// The source is not that of a commit.
    #[error(
        "the source has changes that are not committed: commit them, as a report names its commit, or pass --allow-dirty"
    )]
    Dirty,
    /// The text, a formula or the source of the page of the derivation is not as expected.
    #[error("the page of the derivation cannot be put together: {what}")]
    Derivation {
        /// What is wrong.
        what: String,
    },
    /// A file is not what it should be.
    #[error("{what} cannot be read")]
    Format {
        /// The file, or the kind of file.
        what: String,
        /// What serde has to say.
        source: serde_json::Error,
    },
    /// A record has another schema.
    #[error("the schema is {found}, not {expected}")]
    Schema {
        /// What the record says.
        found: String,
        /// What was expected.
        expected: &'static str,
    },
    /// A file cannot be read.
    #[error("{} cannot be read", .path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file cannot be written.
    #[error("{} cannot be written", .path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}
