//! The error in a text from another program, and its place.

use serde::{Deserialize, Serialize};
use std::fmt;
use thiserror::Error;

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The file, or `standard input`.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The column in bytes, from 1; 0 for the whole line.
    pub column: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.file, self.line)?;
        if self.column > 0 { write!(f, ":{}", self.column) } else { Ok(()) }
    }
}

impl Place {
    /// An error at this place.
    pub(super) fn error(self, expected: impl Into<String>) -> ExternalError {
        ExternalError { place: self, expected: expected.into() }
    }
}

/// An error at a place of a text.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{place}: {expected}")]
pub struct ExternalError {
    /// The place.
    pub place: Place,
    /// What was expected there, and what was found.
    pub expected: String,
}
