//! Pages on a terminal.

use beamgap::report::Page;
use std::io::IsTerminal;

/// The page with the verdict below it, as wide as the terminal (80 to 120 columns); 80 columns if there is no terminal.
pub(super) fn page(page: &Page, verdict: &str) -> String {
    format!("{}\n{verdict}\n", page.to_text(columns()))
}

/// The words in lines of at most 80 columns. The first line begins with `first`, the others with `rest`.
pub(super) fn folded(words: &str, first: &str, rest: &str) -> String {
    let (mut text, mut line) = (String::new(), first.to_owned());
    let mut is_begun = false;
    for word in words.split_whitespace() {
        if is_begun && line.chars().count() + 1 + word.chars().count() > 80 {
            text = text + &line + "\n";
            (line, is_begun) = (rest.to_owned(), false);
        }
        line += if is_begun { " " } else { "" };
        line += word;
        is_begun = true;
    }
    text + &line
}

fn columns() -> usize {
    let stdout = std::io::stdout();
    let width = if stdout.is_terminal() { terminal_size::terminal_size_of(stdout) } else { None };
    width.map_or(80, |(terminal_size::Width(width), _)| usize::from(width).clamp(80, 120))
}
