//! A page as a list of blocks. Markdown, HTML and terminal text are made from it.

mod html;
mod markdown;
mod text;

pub(super) use html::escaped;
pub use text::Table;

/// A page: a title and its contents.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    pub title: String,
    pub blocks: Vec<Block>,
}

/// A block of a page. Texts may contain `**strong**`, `*emphasis*`, `` `code` `` and `[links](file)` and nothing else.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A heading below the page's title.
    Heading(String),
    /// A heading below a heading.
    Subheading(String),
    /// A paragraph.
    Text(String),
    /// A list of items.
    List(Vec<String>),
    /// A table. Columns of numbers are aligned to the right.
    Table {
        /// The names of the columns, each with whether it contains numbers.
        head: Vec<(String, bool)>,
        /// The cells, row by row.
        rows: Vec<Vec<String>>,
    },
    /// A formula in LaTeX.
    Formula(String),
    /// A picture with its caption below. Markdown refers to it and HTML contains it.
    Picture {
        /// The name of its file.
        file: String,
        /// The caption.
        caption: String,
        /// The picture.
        svg: String,
    },
    /// Blocks that are collapsed until the reader opens them. A terminal shows them.
    Details {
        /// The summary of the collapsed blocks.
        summary: String,
        /// The blocks.
        blocks: Vec<Block>,
    },
}

impl Block {
    pub fn heading(text: &str) -> Self {
        Self::Heading(text.to_owned())
    }

    pub fn text(text: &str) -> Self {
        Self::Text(text.to_owned())
    }

    pub fn list(points: &[&str]) -> Self {
        Self::List(points.iter().map(ToString::to_string).collect())
    }

    pub fn details(summary: &str, blocks: Vec<Self>) -> Self {
        Self::Details { summary: summary.to_owned(), blocks }
    }

    /// A table. The names of columns of numbers start with a `#`, which is not displayed.
    pub fn table<S: AsRef<str>>(head: &[S], rows: Vec<Vec<String>>) -> Self {
        let name = |name: &str| match name.strip_prefix('#') {
            Some(name) => (name.to_owned(), true),
            None => (name.to_owned(), false),
        };
        let head = head.iter().map(|text| name(text.as_ref())).collect();
        Self::Table { head, rows }
    }

    /// The pictures among these blocks, by file name.
    fn pictures(blocks: Vec<Self>) -> Vec<(String, String)> {
        let of_one = |block| match block {
            Self::Picture { file, svg, .. } => vec![(file, svg)],
            Self::Details { blocks, .. } => Self::pictures(blocks),
            _ => Vec::new(),
        };
        blocks.into_iter().flat_map(of_one).collect()
    }
}

impl Page {
    pub fn new(title: &str, blocks: Vec<Block>) -> Self {
        Self { title: title.to_owned(), blocks }
    }

    /// The pictures by file name.
    pub fn pictures(self) -> Vec<(String, String)> {
        Block::pictures(self.blocks)
    }
}

/// A text with its marked parts converted by `of_marked`, and the other parts unchanged.
fn inline(text: &str, of_marked: impl Fn(Inline) -> String) -> String {
    let (mut rest, mut made) = (text, String::new());
    while let Some(at) = rest.find(['*', '`', '[']) {
        made += &rest[..at];
        rest = &rest[at..];
        let marked = |open: &'static str, close: &'static str| {
            let inner = rest.strip_prefix(open)?;
            let end = inner.find(close)?;
            (end > 0).then(|| (&inner[..end], &inner[end + close.len()..]))
        };
        let found = (marked("**", "**").map(|(text, rest)| (Inline::Strong(text), rest)))
            .or_else(|| {
                let (text, rest) = marked("*", "*").filter(|(text, _)| text.trim() == *text)?;
                Some((Inline::Emphasis(text), rest))
            })
            .or_else(|| marked("`", "`").map(|(text, rest)| (Inline::Code(text), rest)))
            .or_else(|| {
                let (text, rest) = marked("[", "](")?;
                let (to, rest) = rest.split_once(')')?;
                Some((Inline::Link(text, to), rest))
            });
        if let Some((mark, after)) = found {
            made += &of_marked(mark);
            rest = after;
        } else {
            made += &rest[..1];
            rest = &rest[1..];
        }
    }
    made + rest
}

/// A marked part of a text.
enum Inline<'a> {
    Strong(&'a str),
    Emphasis(&'a str),
    Code(&'a str),
    /// The words, and the target.
    Link(&'a str, &'a str),
}

#[cfg(test)]
mod tests {
    use super::{Block, Page};

    fn page() -> Page {
        let table = Block::table(&["method", "#time"], vec![vec!["one".into(), "1 ns".into()]]);
        let blocks = vec![
            Block::heading("A < B"),
            Block::text("It is **so** by `x & y`, 2 * 3; *see* [there](t.md)."),
            table.clone(),
            Block::details("More", vec![Block::list(&["point"]), table]),
        ];
        Page::new("T", blocks)
    }

    #[test]
    fn all_pages_say_the_same() {
        assert_eq!(
            page().to_markdown(),
            "# T\n\n## A < B\n\nIt is **so** by `x & y`, 2 * 3; *see* [there](t.md).\n\n| method | time |\n|---|---:|\n| one | 1 ns |\n\n\
             <details><summary>More</summary>\n\n- point\n\n| method | time |\n|---|---:|\n| one | 1 ns |\n\n</details>\n\n\
             [README](../README.md) · [symbols, names and regimes](symbols.md)\n"
        );
        let html = page().to_html();
        assert!(html.contains(
            "<h2>A &lt; B</h2>\n<p>It is <strong>so</strong> by <code>x &amp; y</code>, 2 * 3; <em>see</em> \
                 <a href=\"t.md\">there</a>.</p>"
        ));
        assert_eq!(html.matches("<tr><td>one</td><td class=\"number\">1 ns</td></tr>").count(), 2);
        assert!(html.contains("<details><summary>More</summary>\n<ul>\n<li>point</li>\n</ul>"));
        assert!(!html.contains("http"), "nothing is fetched");
        assert_eq!(
            page().to_text(80),
            "T\n\nA < B\n\nIt is so by x & y, 2 * 3; see there (t.md).\n\n  method  time\n  one     1 ns\n\nMore\n\n- point\n\n  method  time\n  one     1 ns\n"
        );
    }
}
