//! Annotations of GitHub Actions, and the summary of a step.

use super::markdown;
use crate::cli::outcome::Outcome;
use std::fmt::Write as _;
use std::fs::OpenOptions;
use std::io::Write as _;

/// One annotation for each entry that differs, and one for the verdict.
pub(in crate::cli) fn github(outcome: &Outcome) -> String {
    let title = format!("beamgap {}", outcome.command);
    let mut text = String::new();
    for entry in outcome.wrong() {
        let at = entry.source.as_ref().map_or_else(String::new, |source| {
            format!("file={},line={},", property(&source.file), source.line)
        });
        let of = property(&format!("{title}: {} ({})", entry.name, entry.group));
        let _ = writeln!(text, "::error {at}title={of}::{}", message(&entry.message));
    }
    let level = outcome.verdict.level();
    let _ = writeln!(text, "::{level} title={}::{}", property(&title), message(&outcome.verdict.words));
    text
}

/// Appends the result as Markdown to the file that `GITHUB_STEP_SUMMARY` names, if it names one.
///
/// If the summary cannot be written, the error is printed on stderr and the verdict does not change.
pub(in crate::cli) fn write_step_summary(outcome: &Outcome) {
    let Some(path) = std::env::var_os("GITHUB_STEP_SUMMARY").filter(|path| !path.is_empty()) else { return };
    let file = OpenOptions::new().append(true).create(true).open(&path);
    if let Err(error) = file.and_then(|mut file| file.write_all(markdown(outcome).as_bytes())) {
        let _ =
            writeln!(std::io::stderr(), "warning: cannot write the step summary {}: {error}", path.display());
    }
}

/// Escapes the characters that a message must not contain.
fn message(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Escapes the characters that a property must not contain.
fn property(text: &str) -> String {
    message(text).replace(':', "%3A").replace(',', "%2C")
}
