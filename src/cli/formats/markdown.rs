//! Markdown, for the summary of a job or a comment.

use crate::cli::outcome::{Entry, Outcome};
use std::fmt::Write;

/// The verdict, the entries that differ, and a collapsed table of all entries.
pub(in crate::cli) fn markdown(outcome: &Outcome) -> String {
    let sign = match outcome.verdict.level() {
        "notice" => "✅",
        "warning" => "⚠️",
        _ => "❌",
    };
    let mut text = format!("## {sign} beamgap {}\n\n", outcome.command);
    for line in outcome.verdict.words.lines() {
        let _ = writeln!(text, "{}  ", escaped(line));
    }
    let wrong: Vec<&Entry> = outcome.wrong().collect();
    if !wrong.is_empty() {
        let _ = write!(text, "\n{}", table(&wrong));
    }
    let all: Vec<&Entry> = outcome.entries.iter().collect();
    if !all.is_empty() {
        let entries =
            if all.len() == 1 { "The entry".to_owned() } else { format!("All {} entries", all.len()) };
        let table = table(&all);
        let _ = write!(text, "\n<details><summary>{entries}</summary>\n\n{table}\n</details>\n");
    }
    text
}

fn table(entries: &[&Entry]) -> String {
    let mut text = "| | | | |\n|---|---|---|---|\n".to_owned();
    for Entry { group, name, state, message, .. } in entries {
        let cells = [name, group, state.name(), message].map(escaped);
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text
}

/// Escapes the markup of Markdown and of HTML.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '#' | '~' | '$' => escaped.extend(['\\', c]),
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '&' => escaped += "&amp;",
            '\n' => escaped += "<br>",
            c => escaped.push(c),
        }
    }
    escaped
}
