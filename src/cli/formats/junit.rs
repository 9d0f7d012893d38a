//! JUnit XML, as Jenkins and GitLab read it: one test case for the verdict, and one for each entry.
//!
//! The schema is that of Jenkins' xUnit plugin, `junit-10.xsd`.

use crate::cli::exit::Exit;
use crate::cli::outcome::{Entry, Outcome, State};
use std::fmt::Write;

/// The result as a test suite.
pub(in crate::cli) fn junit(outcome: &Outcome) -> String {
    let count = |state| outcome.entries.iter().filter(|entry| entry.state == state).count();
    // The verdict is a test case, so that a suite in which nothing was compared does not pass.
    let tests = outcome.entries.len() + 1;
    let failures = count(State::Differs) + usize::from(outcome.verdict.exit != Exit::Agree);
    let skipped = count(State::NotCompared);
    let suite = format!("beamgap {}", outcome.command);
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <testsuites name=\"{suite}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\">\n  \
         <testsuite name=\"{suite}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" skipped=\"{skipped}\">\n"
    );
    let class = format!("beamgap.{}", outcome.command);
    let words = &outcome.verdict.words;
    let verdict = if outcome.verdict.exit == Exit::Agree {
        format!("\n      <system-out>{}</system-out>\n    ", escaped(words))
    } else {
        failure(outcome.verdict.name, words.lines().next().unwrap_or_default(), words)
    };
    test_case(&mut text, &class, "verdict", &verdict);
    for entry in &outcome.entries {
        let Entry { group, name, state, message, source } = entry;
        let body = match state {
            State::Agrees => String::new(),
            State::NotCompared => format!("\n      <skipped message=\"{}\"/>\n    ", escaped(message)),
            State::Differs => {
                let at = source.as_ref().map_or_else(String::new, |at| format!("\n{}:{}", at.file, at.line));
                failure("differs", message, &format!("{message}{at}"))
            }
        };
        test_case(&mut text, &format!("{class}.{group}"), name, &body);
    }
    text + "  </testsuite>\n</testsuites>\n"
}

fn test_case(text: &mut String, class: &str, name: &str, body: &str) {
    let [class, name] = [class, name].map(escaped);
    let _ = match body {
        "" => writeln!(text, "    <testcase classname=\"{class}\" name=\"{name}\"/>"),
        body => writeln!(text, "    <testcase classname=\"{class}\" name=\"{name}\">{body}</testcase>"),
    };
}

fn failure(kind: &str, message: &str, text: &str) -> String {
    let [kind, message, text] = [kind, message, text].map(escaped);
    format!("\n      <failure type=\"{kind}\" message=\"{message}\">{text}</failure>\n    ")
}

/// Text of an attribute or an element, without the characters that XML does not allow.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\n' => escaped.push('\n'),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn text_is_escaped() {
        assert_eq!(escaped("a < \"b\" & c\u{1}\n"), "a &lt; &quot;b&quot; &amp; c\u{fffd}\n");
    }
}
