//! A record: JSON with a versioned schema. Its pages are made from it alone.

use super::ReportError;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Data that is written as JSON and read back from it.
pub trait Record: Serialize + DeserializeOwned {
    /// The name and version of its schema.
    const SCHEMA: &'static str;

    /// The schema that the record states.
    fn schema(&self) -> &str;

    /// The record as JSON.
    ///
    /// # Errors
    /// [`ReportError::Format`].
    fn to_json(&self) -> Result<String, ReportError> {
        Ok(serde_json::to_string_pretty(self).map_err(format::<Self>)? + "\n")
    }

    /// The record from JSON.
    ///
    /// # Errors
    /// [`ReportError::Format`], or [`ReportError::Schema`] if it is of another kind or version.
    fn from_json(json: &str) -> Result<Self, ReportError> {
        let record: Self = serde_json::from_str(json).map_err(format::<Self>)?;
        if record.schema() == Self::SCHEMA {
            Ok(record)
        } else {
            Err(ReportError::Schema { found: record.schema().to_owned(), expected: Self::SCHEMA })
        }
    }
}

/// A failure to read or write this kind of record.
pub(super) fn format<R: Record>(source: serde_json::Error) -> ReportError {
    ReportError::Format { what: R::SCHEMA.to_owned(), source }
}
