//! Markdown, for the summary of a job or a comment.

use crate::cli::exit::Exit;
use crate::cli::outcome::{Entry, Outcome};

/// The verdict, what differs, and a table of all entries folded away.
pub(in crate::cli) fn markdown(outcome: &Outcome) -> String {
    let sign = if outcome.verdict.exit == Exit::Agree { "✅" } else { "❌" };
    let mut text = format!("## {sign} beamgap {}\n\n", outcome.command);
    for line in outcome.verdict.words.lines() {
        text += &format!("{}  \n", escaped(line));
    }
    let wrong: Vec<&Entry> = outcome.wrong().collect();
    if !wrong.is_empty() {
        text += &format!("\n{}", table(&wrong));
    }
    let all: Vec<&Entry> = outcome.entries.iter().collect();
    if !all.is_empty() {
        let count = all.len();
        text +=
            &format!("\n<details><summary>All {count} entries</summary>\n\n{}\n</details>\n", table(&all));
    }
    text
}

fn table(entries: &[&Entry]) -> String {
    let mut text = "| | | | |\n|---|---|---|---|\n".to_owned();
    for Entry { group, name, state, message, .. } in entries {
        let cells = [name, group, state.name(), message].map(escaped);
        text += &format!("| {} |\n", cells.join(" | "));
    }
    text
}

/// Text that stays text: the marks of Markdown and of HTML are escaped.
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
