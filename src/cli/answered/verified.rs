//! The answers of a program, compared.

use beamgap::check::external::{Demands, Report};

/// The result and the request.
pub(in crate::cli) struct Verified {
    pub(in crate::cli) report: Report,
    pub(in crate::cli) demands: Demands,
    pub(in crate::cli) command: String,
    /// The reason for the requested number of digits.
    pub(in crate::cli) reason: Option<String>,
    /// Whether cases and quantities may be left out.
    pub(in crate::cli) allow_missing: bool,
}
