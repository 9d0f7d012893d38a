//! A page as a list of blocks, which Markdown and HTML are both made of.

use std::fmt::Write;

/// A piece of a page; texts may hold `**strong**` and `` `code` `` and nothing else.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Block {
    /// A heading below the page's title.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// Points.
    List(Vec<String>),
    /// A table; columns of numbers stand to the right.
    Table {
        /// The names of the columns, each with whether it holds numbers.
        head: Vec<(String, bool)>,
        /// The cells, row by row.
        rows: Vec<Vec<String>>,
    },
    /// A picture, which Markdown refers to and HTML holds.
    Picture {
        /// The name of its file.
        file: String,
        /// What it shows.
        caption: String,
        /// The picture.
        svg: String,
    },
}

impl Block {
    pub(super) fn heading(text: &str) -> Self {
        Self::Heading(text.to_owned())
    }

    pub(super) fn text(text: &str) -> Self {
        Self::Text(text.to_owned())
    }

    /// A table; the names of columns of numbers start with a `#`, which is not shown.
    pub(super) fn table(head: &[&str], rows: Vec<Vec<String>>) -> Self {
        let name = |name: &str| match name.strip_prefix('#') {
            Some(name) => (name.to_owned(), true),
            None => (name.to_owned(), false),
        };
        let head = head.iter().map(|text| name(text)).collect();
        Self::Table { head, rows }
    }
}

/// The page as Markdown.
pub(super) fn markdown(title: &str, blocks: &[Block]) -> String {
    let mut page = format!("# {title}\n");
    for block in blocks {
        page.push('\n');
        // A String never refuses to be written to.
        let _ = match block {
            Block::Heading(text) => writeln!(page, "## {text}"),
            Block::Text(text) => writeln!(page, "{text}"),
            Block::List(points) => points.iter().try_for_each(|point| writeln!(page, "- {point}")),
            Block::Table { head, rows } => {
                let names: Vec<&str> = head.iter().map(|(name, _)| name.as_str()).collect();
                let rule: Vec<&str> =
                    head.iter().map(|&(_, right)| if right { "---:" } else { "---" }).collect();
                let _ = writeln!(page, "| {} |\n|{}|", names.join(" | "), rule.join("|"));
                rows.iter().try_for_each(|row| writeln!(page, "| {} |", row.join(" | ")))
            }
            Block::Picture { file, caption, .. } => writeln!(page, "![{caption}]({file})"),
        };
    }
    page
}

/// The page as HTML that needs no other file.
pub(super) fn html(title: &str, blocks: &[Block]) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    for block in blocks {
        let _ = match block {
            Block::Heading(text) => writeln!(page, "<h2>{}</h2>", inline(text)),
            Block::Text(text) => writeln!(page, "<p>{}</p>", inline(text)),
            Block::List(points) => {
                let _ = writeln!(page, "<ul>");
                let _ = points.iter().try_for_each(|point| writeln!(page, "<li>{}</li>", inline(point)));
                writeln!(page, "</ul>")
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
            Block::Picture { caption, svg, .. } => {
                let _ = writeln!(page, "<figure role=\"img\" aria-label=\"{}\">", escaped(caption));
                writeln!(page, "{}<figcaption>{}</figcaption>\n</figure>", svg, inline(caption))
            }
        };
    }
    page + "</body>\n</html>\n"
}

const STYLE: &str = "
body { font: 16px/1.5 sans-serif; max-width: 78rem; margin: 2rem auto; padding: 0 1rem; color: #111; background: #fff; }
p, ul, figure { max-width: 60rem; }
.wide { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td { text-align: left; padding: 0.15rem 0.7rem; border-bottom: 1px solid #ddd; vertical-align: top; }
th { vertical-align: bottom; }
td:not(:last-child) { white-space: nowrap; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
figure { margin: 1rem 0; }
svg { max-width: 100%; height: auto; }
";

fn cell(tag: &str, right: bool, text: &str) -> String {
    let class = if right { " class=\"number\"" } else { "" };
    format!("<{tag}{class}>{}</{tag}>", inline(text))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Text with its marks as elements: every second part between two marks is marked.
fn inline(text: &str) -> String {
    let marked = |text: &str, mark: &str, tag: &str| -> String {
        let part = |(i, part): (usize, &str)| match i % 2 {
            0 => part.to_owned(),
            _ => format!("<{tag}>{part}</{tag}>"),
        };
        text.split(mark).enumerate().map(part).collect()
    };
    marked(&marked(&escaped(text), "**", "strong"), "`", "code")
}

#[cfg(test)]
mod tests {
    use super::{Block, html, markdown};

    #[test]
    fn both_pages_say_the_same() {
        let blocks = [
            Block::heading("A < B"),
            Block::text("It is **so** by `x & y`."),
            Block::table(&["method", "#time"], vec![vec!["one".into(), "1 ns".into()]]),
        ];
        assert_eq!(
            markdown("T", &blocks),
            "# T\n\n## A < B\n\nIt is **so** by `x & y`.\n\n| method | time |\n|---|---:|\n| one | 1 ns |\n"
        );
        let html = html("T", &blocks);
        assert!(
            html.contains("<h2>A &lt; B</h2>\n<p>It is <strong>so</strong> by <code>x &amp; y</code>.</p>")
        );
        assert!(html.contains("<tr><td>one</td><td class=\"number\">1 ns</td></tr>"));
        assert!(!html.contains("http"), "nothing is fetched");
    }
}
