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
             <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
        );
        add(&mut page, &self.blocks);
        page + "</body>\n</html>\n"
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
                let names = head.iter().map(|(name, right)| cell("th", *right, name)).collect::<String>();
                let _ = writeln!(page, "<div class=\"wide\"><table>\n<tr>{names}</tr>");
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

const STYLE: &str = "
:root { --text: #1a1a1a; --page: #fff; --rule: #d8d8d8; --quiet: #595959; --link: #005a9c; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e8e8e8; --page: #161616; --rule: #444; --quiet: #a8a8a8; --link: #6cb6ff; }
}
body { font: 16px/1.5 sans-serif; max-width: 78rem; margin: 1rem auto 4rem; padding: 0 1rem;
  color: var(--text); background: var(--page); }
p, ul, summary { max-width: 44rem; }
ul { padding-left: 1.2rem; }
h2 { margin-top: 2.2rem; }
summary { cursor: pointer; padding: 0.35rem 0; }
.wide { overflow-x: auto; margin: 1rem 0; }
a { color: var(--link); }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td { text-align: left; padding: 0.2rem 0.9rem 0.2rem 0; border-bottom: 1px solid var(--rule); vertical-align: top; }
th { vertical-align: bottom; }
td { min-width: 3rem; }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
th.number { white-space: normal; }
figure { margin: 1.2rem 0; max-width: 44rem; }
figcaption { color: var(--quiet); font-size: 0.9rem; }
figure svg { display: block; width: 100%; height: auto; }
pre { overflow-x: auto; }
";

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
