//! The ledger as JSON, `beamgap-ledger/1`.

use super::ReportError;
use crate::ledger::Ledger;

impl Ledger {
    /// The record as JSON.
    ///
    /// # Errors
    /// [`ReportError::Format`].
    pub fn to_json(&self) -> Result<String, ReportError> {
        Ok(serde_json::to_string_pretty(self).map_err(format)? + "\n")
    }

    /// The record from JSON.
    ///
    /// # Errors
    /// [`ReportError::Format`], or [`ReportError::Schema`] if it is of another kind or version.
    pub fn from_json(json: &str) -> Result<Self, ReportError> {
        let record: Self = serde_json::from_str(json).map_err(format)?;
        if record.schema == Self::SCHEMA {
            Ok(record)
        } else {
            Err(ReportError::Schema { found: record.schema, expected: Self::SCHEMA })
        }
    }
}

fn format(source: serde_json::Error) -> ReportError {
    ReportError::Format { what: Ledger::SCHEMA.to_owned(), source }
}
