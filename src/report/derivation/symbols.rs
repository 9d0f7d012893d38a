//! The letters of the page, each explained once and linked from every equation that uses it.

use super::math::{expand, mathml};
use super::text::inline;
use std::fmt::Write;

/// A letter.
struct Symbol {
    id: &'static str,
    latex: &'static str,
    /// What it is, in prose.
    words: &'static str,
    /// Its name in words.
    name: &'static str,
    /// What in the LaTeX of an equation shows that it is used.
    keys: Vec<&'static str>,
}

/// The letters of the text file: lines of id, LaTeX, keys, words and name, with bars between.
fn all() -> Result<Vec<Symbol>, String> {
    include_str!("symbols.txt")
        .lines()
        .filter(|line| !line.is_empty())
        .map(|line| {
            let parts: Vec<&'static str> = line.split(" | ").collect();
            let [id, latex, keys, words, name] = parts[..] else {
                return Err(format!("{line:?} has not five parts"));
            };
            let keys: Vec<&'static str> = keys.split(' ').filter(|key| *key != "-").collect();
            Ok(Symbol { id, latex, words, name, keys })
        })
        .collect()
}

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

/// Links to the letters that an equation uses.
pub(super) fn used(latex: &str) -> Result<String, String> {
    let plain = expand(latex).replace('\n', " ");
    let mut links = Vec::new();
    for Symbol { id, latex, keys, name, .. } in all()? {
        if keys.iter().any(|key| plain.contains(&key.replace('~', " "))) {
            links.push(format!("<a href=\"#sym-{id}\">{} {name}</a>", mathml(latex, false)?));
        }
    }
    Ok(links.join(" "))
}
