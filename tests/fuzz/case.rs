//! The body of the fuzz target for the file of `check --case-file`. A test runs it on a fixed corpus.

use super::case_file;
use beamgap::check::CheckConfig;

/// Reads a case. A valid case is written, read again without loss of a bit, and compared.
pub(crate) fn case(text: &str) {
    let Ok(case) = case_file::parse(text, "the case") else { return };
    let written = serde_json::Value::Object(case_file::object(&case)).to_string();
    assert_eq!(case_file::parse(&written, "the case").expect("what was written is read"), case);
    let _ = case.compare(&CheckConfig::default());
}
