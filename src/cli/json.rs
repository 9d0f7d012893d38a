//! JSON documents.

use beamgap::check::Comparison;
use serde::Serialize;
use serde_json::{Value, json};

/// One entry, with all digits, and what follows from it.
pub(super) fn compared(entry: &Comparison) -> Value {
    let mut value = json!(entry);
    value["difference"] = json!(entry.difference());
    value["agrees"] = json!(entry.agrees());
    value
}

/// The document as text: indented, with a final newline.
pub(super) fn text(document: &impl Serialize) -> anyhow::Result<String> {
    Ok(serde_json::to_string_pretty(document)? + "\n")
}
