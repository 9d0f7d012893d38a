//! The tables of the letters: those that formulas link to, and the others.

use super::inline::inline;
use super::letters::{Symbol, all};
use super::math::mathml;
use std::fmt::Write;

/// The table of the letters that formulas link to.
pub(super) fn table() -> Result<String, String> {
    let mut rows = String::new();
    for Symbol { id, latex, words, .. } in all()? {
        let _ = writeln!(
            rows,
            "<tr id=\"sym-{id}\"><td>{}</td><td>{}</td></tr>",
            mathml(latex, false)?,
            inline(words)?
        );
    }
    Ok(wide("symbols", &rows))
}

/// The table of the other letters of the text: lines of LaTeX and words, separated by a bar.
pub(super) fn others() -> Result<String, String> {
    let mut rows = String::new();
    for line in include_str!("letters.txt").lines().filter(|line| !line.is_empty()) {
        let (latex, words) = line.split_once(" | ").ok_or_else(|| format!("{line:?} has not two parts"))?;
        let _ = writeln!(rows, "<tr><td>{}</td><td>{}</td></tr>", mathml(latex, false)?, inline(words)?);
    }
    Ok(wide("other letters", &rows))
}

fn wide(name: &str, rows: &str) -> String {
    format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"{name}\"><table class=\"symbols\"><thead><tr>\
         <th scope=\"col\">symbol</th><th scope=\"col\">meaning</th></tr></thead><tbody>\n{rows}</tbody></table></div>\n"
    )
}
