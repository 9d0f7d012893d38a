//! The markup of the prose: paragraphs, headings, lists, formulas, and commands that the page executes.

use super::inline::{inline, line};
use super::letters::{Symbol, of_letter, used};
use super::math::mathml;

/// The HTML of a text. `carry_out` returns the HTML for a line that begins with `@`.
///
/// # Errors
/// The text that cannot be parsed.
pub(super) fn html(
    text: &str,
    mut carry_out: impl FnMut(&str, &str) -> Result<String, String>,
) -> Result<String, String> {
    let mut page = String::new();
    for block in text.split("\n\n").map(str::trim).filter(|block| !block.is_empty()) {
        let piece = if let Some(line) = block.strip_prefix('@') {
            let (command, argument) = line.split_once([' ', '\n']).unwrap_or((line, ""));
            carry_out(command, argument)?
        } else if let Some(heading) = block.strip_prefix("### ") {
            heading_html(3, heading)?
        } else if let Some(heading) = block.strip_prefix("## ") {
            heading_html(2, heading)?
        } else if let Some(latex) = block.strip_prefix("$$").and_then(|rest| rest.strip_suffix("$$")) {
            let letters = used(latex)?;
            let none = letters.is_empty();
            formula(latex)?
                + &if none { String::new() } else { format!("<p class=\"letters\">Letters: {letters}</p>\n") }
        } else if block.starts_with("- ") {
            let items = block.replace("\n  ", " ");
            let items =
                items.lines().map(|item| Ok(format!("<li>{}</li>", prose(item.trim_start_matches("- "))?)));
            format!("<ul>{}</ul>\n", items.collect::<Result<String, String>>()?)
        } else {
            format!("<p>{}</p>\n", prose(block)?)
        };
        page += &piece;
    }
    Ok(page)
}

/// A formula on its own line, which scrolls if it is too wide.
pub(super) fn formula(latex: &str) -> Result<String, String> {
    Ok(format!(
        "<div class=\"formula\" tabindex=\"0\" role=\"group\" aria-label=\"formula\">{}</div>\n",
        mathml(latex.trim(), true)?
    ))
}

fn heading_html(level: u8, heading: &str) -> Result<String, String> {
    let (id, title) =
        heading.split_once(" | ").ok_or_else(|| format!("the heading {heading:?} has no id"))?;
    Ok(format!("<h{level} id=\"{id}\">{}</h{level}>\n", inline(title)?))
}

/// The headings of second level: their ids and titles.
pub(super) fn sections(text: &str) -> Vec<(&str, &str)> {
    text.lines().filter_map(|line| line.strip_prefix("## ")?.split_once(" | ")).collect()
}

/// A line of text as of [`inline`], with links from single letters to their explanation.
pub(super) fn prose(text: &str) -> Result<String, String> {
    line(text, &|formula| Ok(of_letter(formula)?.map(|Symbol { id, name, .. }| [id, name])))
}

#[cfg(test)]
mod tests {
    use super::{html, inline, sections};

    #[test]
    fn the_markup_is_carried_out() {
        let text = "## one | The *first*\n\nA **b** `c<d` (40) [e](#one), f(x).\n\n- g\n  h\n- i\n\n@figure pair now";
        let page = html(text, |command, argument| Ok(format!("[{command}:{argument}]"))).unwrap();
        assert_eq!(
            page,
            "<h2 id=\"one\">The *first*</h2>\n<p>A <strong>b</strong> <code>c&lt;d</code> \
             <a href=\"#eq-40\">(40)</a> <a href=\"#one\">e</a>, f(x).</p>\n\
             <ul><li>g h</li><li>i</li></ul>\n[figure:pair now]"
        );
        assert_eq!(sections(text), [("one", "The *first*")]);
        assert!(inline("(60) (x) a$b$").unwrap().starts_with("(60) (x) a<math"));
    }

    #[test]
    fn what_cannot_be_read_is_an_error() {
        assert!(inline("a $b").is_err());
        assert!(html("## no id", |_, _| Ok(String::new())).is_err());
        assert!(html("@x", |command, _| Err(command.to_owned())).is_err());
    }
}
