//! SARIF 2.1.0, as GitHub code scanning reads it: one result for each entry that differs.

use crate::cli::exit::Exit;
use crate::cli::json;
use crate::cli::outcome::{Entry, Outcome, Source};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fmt::Write;

const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

/// The result as a log of one run.
pub(in crate::cli) fn sarif(outcome: &Outcome) -> anyhow::Result<String> {
    let Outcome { command, verdict, .. } = outcome;
    let id = |group: &str| format!("beamgap/{command}/{group}");
    let mut results: Vec<Value> = outcome.wrong().map(|entry| result(&id(&entry.group), entry)).collect();
    let mut rules: BTreeSet<(String, String)> = outcome
        .wrong()
        .map(|entry| (id(&entry.group), format!("beamgap {command}, {}: a number differs.", entry.group)))
        .collect();
    // The first alert shows the verdict too, which names the cause.
    if let Some(first) = results.first_mut() {
        let text = first["message"]["text"].as_str().unwrap_or_default();
        first["message"]["text"] = format!("{text}\n{}", verdict.words).into();
    }
    // An error of the whole result has no line in the source, and a warning has none.
    if outcome.is_wrong_as_a_whole() || verdict.is_warning {
        results.push(json!({
            "ruleId": id("verdict"),
            "level": verdict.level(),
            "message": { "text": verdict.words },
        }));
        rules.insert((id("verdict"), format!("beamgap {command}: the verdict.")));
    }
    let rules: Vec<Value> = rules
        .into_iter()
        .map(|(id, text)| json!({ "id": id, "shortDescription": { "text": text } }))
        .collect();
    json::text(&json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "beamgap",
                "version": env!("CARGO_PKG_VERSION"),
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": rules,
            } },
            "invocations": [{
                "executionSuccessful": matches!(verdict.exit, Exit::Agree | Exit::Disagree),
                "exitCode": verdict.exit as u8,
                "exitCodeDescription": verdict.exit.meaning(),
            }],
            "results": results,
        }],
    }))
}

fn result(rule: &str, entry: &Entry) -> Value {
    let text = format!("{} ({}): {}", entry.name, entry.group, entry.message);
    let mut result = json!({
        "ruleId": rule,
        "level": "error",
        "message": { "text": text },
        // The fingerprint identifies the alert in the next run, even if the worst case differs.
        "partialFingerprints": { "entry/v1": format!("{rule}/{}", entry.name) },
    });
    if let Some(source) = &entry.source {
        result["locations"] = json!([location(source)]);
    }
    result
}

fn location(Source { file, line }: &Source) -> Value {
    json!({ "physicalLocation": {
        "artifactLocation": { "uri": uri(file) },
        "region": { "startLine": line },
    } })
}

/// A path as a URI reference: characters that are not allowed in a reference are escaped.
fn uri(path: &str) -> String {
    let mut uri = String::new();
    for byte in path.replace('\\', "/").bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'.' | b'-' | b'_' | b'~' => {
                uri.push(byte.into());
            }
            _ => drop(write!(uri, "%{byte:02X}")),
        }
    }
    // An absolute path is valid on this machine only. The scheme `file:` marks it.
    if uri.starts_with('/') { format!("file://{uri}") } else { uri }
}

#[cfg(test)]
mod tests {
    use super::uri;

    #[test]
    fn a_path_becomes_a_reference() {
        assert_eq!(uri("src/a b.rs"), "src/a%20b.rs");
        assert_eq!(uri("/tmp/ä.csv"), "file:///tmp/%C3%A4.csv");
        assert_eq!(uri("..\\a:b"), "../a%3Ab");
    }
}
