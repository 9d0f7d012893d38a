//! Pages on a terminal.

use beamgap::report::Page;
use std::io::{IsTerminal, Write};

/// The page with the verdict below it, as wide as the terminal (80 to 120 columns); 80 columns if there is no terminal.
pub(super) fn page(page: &Page, verdict: &str) -> String {
    format!("{}\n{verdict}\n", page.to_text(columns()))
}

/// The words in lines of at most 80 columns. The first line begins with `first`, the others with `rest`.
pub(super) fn folded(words: &str, first: &str, rest: &str) -> String {
    folded_to(80, words, first, rest)
}

fn folded_to(columns: usize, words: &str, first: &str, rest: &str) -> String {
    let (mut text, mut line) = (String::new(), first.to_owned());
    let mut is_begun = false;
    for word in words.split_whitespace() {
        if is_begun && line.chars().count() + 1 + word.chars().count() > columns {
            text = text + &line + "\n";
            (line, is_begun) = (rest.to_owned(), false);
        }
        line += if is_begun { " " } else { "" };
        line += word;
        is_begun = true;
    }
    text + &line
}

/// Prints an error on standard error. Its first line is folded to the width of the terminal, or to 80 columns without a
/// terminal. The lines after it are those of another program.
pub(super) fn tell(error: &str) {
    let stderr = std::io::stderr();
    let width = if stderr.is_terminal() { terminal_size::terminal_size_of(&stderr) } else { None };
    let columns = width.map_or(80, |(terminal_size::Width(width), _)| usize::from(width));
    let paths: Vec<_> = std::env::args_os().filter_map(|path| path.into_string().ok()).collect();
    // The exit code tells the error if standard error is closed.
    let _ = writeln!(&stderr, "{}", message(error, columns, &paths));
}

/// The error in lines of at most so many columns. The blanks of these paths do not divide a line.
fn message(error: &str, columns: usize, paths: &[String]) -> String {
    /// It stands for a blank of a path; no text has it.
    const BLANK: &str = "\u{e000}";
    let (first, others) = error.split_at(error.find('\n').unwrap_or(error.len()));
    if first.chars().count() <= columns {
        return error.to_owned();
    }
    // An option may have a path after its name.
    let paths = paths.iter().filter_map(|path| path.rsplit('=').next()).filter(|path| path.contains(' '));
    let kept = paths.fold(first.to_owned(), |text, path| text.replace(path, &path.replace(' ', BLANK)));
    folded_to(columns, &kept, "", "  ").replace(BLANK, " ") + others
}

fn columns() -> usize {
    width().map_or(80, |width| width.clamp(80, 120))
}

/// The columns of help: those of the terminal, but at most 100; 80 if there is no terminal.
pub(super) fn help_columns() -> usize {
    width().map_or(80, |width| width.min(100))
}

/// The columns of standard output, if it is a terminal.
fn width() -> Option<usize> {
    let stdout = std::io::stdout();
    let size = if stdout.is_terminal() { terminal_size::terminal_size_of(stdout) } else { None };
    size.map(|(terminal_size::Width(width), _)| usize::from(width))
}

#[cfg(test)]
mod tests {
    use super::message;

    #[test]
    fn an_error_is_folded_between_words() {
        let path = "/a/path/that/is/longer/than/the/line";
        let told = message(&format!("error: cannot read {path}: no such file\nIts  output is kept"), 24, &[]);
        assert_eq!(told, format!("error: cannot read\n  {path}:\n  no such file\nIts  output is kept"));
        assert_eq!(message("error: a  short one", 24, &[]), "error: a  short one");
        let paths = ["verify".to_owned(), "--output=json=a file.json".to_owned()];
        let told = message("error: cannot write a file.json: no such file", 24, &paths);
        assert_eq!(told, "error: cannot write\n  a file.json: no such\n  file");
    }
}
