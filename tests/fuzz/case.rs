//! What the fuzz target does with the file of `check --case-file`, and the tests with a fixed corpus.

use super::case_file;
use beamgap::check::CheckConfig;

/// Reads a case; what is read is written, and read again to the last bit. Then it is compared.
pub(crate) fn case(text: &str) {
    let Ok(case) = case_file::parse(text, "the case") else { return };
    let written = serde_json::Value::Object(case_file::object(&case)).to_string();
    assert_eq!(case_file::parse(&written, "the case").expect("what was written is read"), case);
    let _ = case.compare(&CheckConfig::default());
}
