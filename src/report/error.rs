//! The errors of making a report.

use std::path::PathBuf;

/// The reasons why a report cannot be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The source has uncommitted changes.
    #[error(
        "the source has changes that are not committed: commit them, as a report names its commit, or pass --allow-dirty"
    )]
    Dirty,
    /// The text, a formula or the source of the page of the derivation is not as expected.
    #[error("the page of the derivation cannot be put together: {what}")]
    Derivation {
        /// The problem.
        what: String,
    },
    /// A beam problem has no solution.
    #[error("the beam problem \"{problem}\" is not solved: {what}")]
    Unsolved {
        /// The problem.
        problem: String,
        /// The reason.
        what: String,
    },
    /// A file has unexpected contents.
    #[error("{what} cannot be read")]
    Format {
        /// The file, or the kind of file.
        what: String,
        /// The error of serde.
        source: serde_json::Error,
    },
    /// A record has another schema.
    #[error("the schema is {found}, not {expected}")]
    Schema {
        /// The schema in the record.
        found: String,
        /// The expected schema.
        expected: &'static str,
    },
    /// A file cannot be read.
    #[error("{} cannot be read", .path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
    /// A file cannot be written.
    #[error("{} cannot be written", .path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
}
