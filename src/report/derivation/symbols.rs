//! The table of all letters.

use super::letters::{Symbol, all};
use super::math::mathml;
use super::text::inline;
use std::fmt::Write;

/// The table of all letters.
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
    Ok(format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"symbols\"><table class=\"symbols\"><thead><tr>\
         <th scope=\"col\">symbol</th><th scope=\"col\">meaning</th></tr></thead><tbody>\n{rows}</tbody></table></div>\n"
    ))
}
