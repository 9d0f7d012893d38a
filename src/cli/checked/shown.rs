//! The result of a run with its shrunk mismatches.

use super::Checked;
use crate::cli::outcome::Outcome;
use beamgap::check::{LikelyCause, Shrunk};

/// A result with its shrunk mismatches.
pub(in crate::cli) struct Shown {
    pub(in crate::cli) checked: Checked,
    pub(in crate::cli) outcome: Outcome,
    pub(in crate::cli) shrunk: Vec<Shrunk>,
    /// The likely cause of the mismatches, if it is known.
    pub(in crate::cli) cause: Option<LikelyCause>,
    /// Whether people see all tables even if the run fails.
    pub(in crate::cli) all: bool,
}
