//! The text on the front page of the documentation: prose with formulas as MathML, and the picture.
//!
//! `src/front_page.md` is generated from it. Rustdoc displays HTML in Markdown, and MathML needs no script.

use super::ReportError;
use super::derivation::mathml;
use super::picture::picture;
use std::fmt::Write;

const TEXT: &str = include_str!("front_page.txt");
const WORDS: &str =
    "Two beams, their closest points, the distance d, the tangents t and t_bar, and the gap g_N";

/// The text as Markdown.
///
/// # Errors
/// [`ReportError::Derivation`] if a formula cannot be parsed.
pub fn front_page() -> Result<String, ReportError> {
    page().map_err(|what| ReportError::Derivation { what })
}

fn page() -> Result<String, String> {
    let mut page = String::new();
    let mut is_code = false;
    for line in TEXT.lines() {
        is_code ^= line.starts_with("```");
        if is_code || line.starts_with("```") {
            page += line;
        } else if line == "@picture" {
            let svg = picture().map_err(|error| error.to_string())?;
            let _ = write!(page, "<img alt=\"{WORDS}\" src=\"data:image/svg+xml,{}\">", in_address(&svg));
        } else if let Some(latex) = line.strip_prefix("$$").and_then(|rest| rest.strip_suffix("$$")) {
            let _ = write!(page, "<div style=\"overflow-x:auto\">{}</div>", in_line(&mathml(latex, true)?));
        } else {
            for (i, part) in line.split('$').enumerate() {
                page += &if i % 2 == 1 { in_line(&mathml(part, false)?) } else { part.to_owned() };
            }
        }
        page.push('\n');
    }
    Ok(page)
}

/// Joins the lines, because a blank line would end the HTML.
fn in_line(mathml: &str) -> String {
    mathml.lines().map(str::trim_start).collect()
}

/// An image as a part of a URL.
fn in_address(svg: &str) -> String {
    let escape = |c: char| match c {
        '%' | '#' | '<' | '>' | '"' | '{' | '}' | '`' | '\\' | '^' | '|' => format!("%{:02X}", u32::from(c)),
        c if c.is_ascii_whitespace() => "%20".to_owned(),
        c if c.is_ascii() => c.to_string(),
        c => c.to_string().bytes().fold(String::new(), |all, byte| all + &format!("%{byte:02X}")),
    };
    svg.chars().map(escape).collect()
}

#[cfg(test)]
mod tests {
    use super::front_page;

    #[test]
    fn formulas_are_mathml_on_one_line_each() {
        let page = front_page().unwrap();
        assert!(!page.lines().any(|line| line.matches("<math").count() != line.matches("</math>").count()));
        assert!(page.matches("<math").count() > 20 && !page.contains('$'), "{page}");
    }
}
