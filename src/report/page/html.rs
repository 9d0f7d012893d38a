//! A page as HTML that needs no other file, in light and dark.

use super::{Block, Inline, Page};
use std::fmt::Write;

impl Page {
    /// The page as HTML.
    pub fn to_html(&self) -> String {
        let title = escaped(&self.title);
        let mut page = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta name=\"color-scheme\" content=\"light dark\">\n\
             <title>{title}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n",
            style()
        );
        add(&mut page, &self.blocks);
        page + "</main>\n</body>\n</html>\n"
    }
}

/// Writing to a String never fails.
fn add(page: &mut String, blocks: &[Block]) {
    for block in blocks {
        let _ = match block {
            Block::Heading(text) => writeln!(page, "<h2>{}</h2>", inline(text)),
            Block::Subheading(text) => writeln!(page, "<h3>{}</h3>", inline(text)),
            Block::Text(text) => writeln!(page, "<p>{}</p>", inline(text)),
            Block::List(points) => {
                let points = points.iter().map(|point| inline(point));
                let points: String =
                    points.flat_map(|point| ["<li>".to_owned(), point, "</li>\n".to_owned()]).collect();
                writeln!(page, "<ul>\n{points}</ul>")
            }
            Block::Table { head, rows } => {
                // A cell without words names no column.
                let tag = |name: &str| if name.is_empty() { "td" } else { "th" };
                let names =
                    head.iter().map(|(name, right)| cell(tag(name), *right, name)).collect::<String>();
                // A table that is wider than a narrow window is scrolled by keys too.
                let _ = writeln!(page, "<div class=\"wide\" tabindex=\"0\"><table>\n<tr>{names}</tr>");
                for row in rows {
                    let cells = head.iter().zip(row).map(|((_, right), text)| cell("td", *right, text));
                    let _ = writeln!(page, "<tr>{}</tr>", cells.collect::<String>());
                }
                writeln!(page, "</table></div>")
            }
            Block::Formula(latex) => writeln!(page, "<pre>{}</pre>", escaped(latex)),
            Block::Picture { caption, svg, .. } => {
                writeln!(page, "<figure>\n{svg}<figcaption>{}</figcaption>\n</figure>", inline(caption))
            }
            Block::Details { summary, blocks } => {
                let _ = writeln!(page, "<details><summary>{}</summary>", inline(summary));
                add(page, blocks);
                writeln!(page, "</details>")
            }
        };
    }
}

/// The style of all pages, and what tables and charts need.
const STYLES: [&str; 2] = [include_str!("../derivation/style.css"), include_str!("table.css")];

/// The style without the lines for MathML, which these pages do not use.
fn style() -> String {
    let is_of_formulas =
        |line: &&str| ["@namespace", "@font-face", "m|"].iter().any(|start| line.starts_with(start));
    let lines = STYLES.into_iter().flat_map(str::lines).filter(|line| !is_of_formulas(line));
    lines.flat_map(|line| [line, "\n"]).collect()
}

fn cell(tag: &str, right: bool, text: &str) -> String {
    let class = if right { " class=\"number\"" } else { "" };
    format!("<{tag}{class}>{}</{tag}>", inline(text))
}

/// Text with its marks as elements.
fn inline(text: &str) -> String {
    super::inline(&escaped(text), |mark| match mark {
        Inline::Strong(text) => format!("<strong>{text}</strong>"),
        Inline::Emphasis(text) => format!("<em>{text}</em>"),
        Inline::Code(text) => format!("<code>{text}</code>"),
        Inline::Link(text, to) => format!("<a href=\"{to}\">{text}</a>"),
    })
}

pub(in super::super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
