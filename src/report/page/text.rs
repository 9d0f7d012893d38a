//! A page as the text of a terminal: words in lines, tables in columns, and nothing of what is folded away.

use super::{Block, Inline, Page};
use std::fmt;

impl Page {
    /// The page as text that is `columns` wide, but for tables that need more.
    pub fn to_text(&self, columns: usize) -> String {
        let mut text = format!("{}\n", self.title);
        for block in &self.blocks {
            match block {
                Block::Heading(words) | Block::Subheading(words) => text += &format!("\n{}\n", plain(words)),
                Block::Text(words) => text += &format!("\n{}", wrapped(&plain(words), columns, "", "")),
                Block::List(points) => {
                    text.push('\n');
                    for point in points {
                        text += &wrapped(&plain(point), columns, "- ", "  ");
                    }
                }
                Block::Table { head, rows } => {
                    let titles: Vec<_> = head.iter().map(|(name, _)| plain(name)).collect();
                    let left = (0..head.len()).filter(|&i| !head[i].1).collect();
                    let rows: Vec<Vec<_>> =
                        rows.iter().map(|row| row.iter().map(|cell| plain(cell)).collect()).collect();
                    text += &format!("\n{}", Table { titles, rows, left, columns });
                }
                Block::Formula(latex) => text += &format!("\n  {}\n", latex.replace('\n', "\n  ")),
                Block::Picture { .. } | Block::Details { .. } => {}
            }
        }
        text
    }
}

/// A text without its marks.
fn plain(text: &str) -> String {
    super::inline(text, |mark| match mark {
        Inline::Strong(text) | Inline::Emphasis(text) | Inline::Code(text) | Inline::Link(text, _) => {
            text.to_owned()
        }
    })
}

/// Words in lines, of which the first starts with `first` and the others with `next`.
pub(in super::super) fn wrapped(text: &str, columns: usize, first: &str, next: &str) -> String {
    let (mut lines, mut line) = (String::new(), first.to_owned());
    let mut is_empty = true;
    for word in text.split_whitespace() {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > columns {
            lines += &(line + "\n");
            line = next.to_owned();
            is_empty = true;
        }
        line += if is_empty { "" } else { " " };
        line += word;
        is_empty = false;
    }
    lines + &line + "\n"
}

/// Text in columns as wide as what they hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    titles: Vec<String>,
    rows: Vec<Vec<String>>,
    /// The columns that stand to the left; the others are numbers.
    left: Vec<usize>,
    columns: usize,
}

impl Table {
    /// A table with these words on top and its first column to the left.
    pub fn new(titles: &[&str], columns: usize) -> Self {
        let titles = titles.iter().map(ToString::to_string).collect();
        Self { titles, rows: Vec::new(), left: vec![0], columns }
    }

    /// Sets further columns to the left.
    #[must_use]
    pub fn left(mut self, columns: &[usize]) -> Self {
        self.left.extend(columns);
        self
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The words of the titles in lines, so that no title is wider than its column has to be.
    fn head(&self, widths: &[usize]) -> Vec<Vec<String>> {
        let of_column = |(title, &width): (&String, &usize)| -> Vec<String> {
            wrapped(title, width, "", "").lines().map(str::to_owned).collect()
        };
        let titles: Vec<Vec<String>> = self.titles.iter().zip(widths).map(of_column).collect();
        let lines = titles.iter().map(Vec::len).max().unwrap_or(0);
        let line = |i: usize| {
            let cell = |title: &Vec<String>| (i + title.len()).checked_sub(lines).map(|k| title[k].clone());
            titles.iter().map(|title| cell(title).unwrap_or_default()).collect()
        };
        (0..lines).map(line).collect()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.rows.iter().map(Vec::len).chain([self.titles.len()]).max().unwrap_or(0);
        let length = |text: &str| text.chars().count();
        let widest = |i: usize| self.rows.iter().filter_map(|row| row.get(i)).map(|cell| length(cell)).max();
        let cells: Vec<usize> = (0..count).map(|i| widest(i).unwrap_or(0)).collect();
        let title = |i: usize| self.titles.get(i).map_or("", String::as_str);
        let sum = |widths: &[usize], gap: usize| widths.iter().map(|width| width + gap).sum::<usize>();
        // Titles stay in one line if there is room.
        let mut widths: Vec<usize> = (0..count).map(|i| cells[i].max(length(title(i)))).collect();
        if sum(&widths, 2) > self.columns {
            let word = |i: usize| title(i).split_whitespace().map(length).max().unwrap_or(0);
            widths = (0..count).map(|i| cells[i].max(word(i))).collect();
        }
        let gap = if sum(&widths, 2) > self.columns { " " } else { "  " };
        for row in self.head(&widths).iter().chain(&self.rows) {
            let mut line = String::new();
            for (i, (cell, width)) in row.iter().zip(&widths).enumerate() {
                let cell = if self.left.contains(&i) {
                    format!("{cell:<width$}")
                } else {
                    format!("{cell:>width$}")
                };
                line.push_str(gap);
                line.push_str(&cell);
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Table, wrapped};

    #[test]
    fn columns_are_two_apart_as_long_as_the_terminal_holds_them() {
        let lines = |length: usize| {
            let mut table = Table::new(&["a", "name"], 80).left(&[1]);
            table.row(vec!["1".into(), "x".repeat(length)]);
            table.to_string().lines().map(str::to_owned).collect::<Vec<_>>()
        };
        let widest = 75;
        assert_eq!(lines(widest), ["  a  name".to_owned(), format!("  1  {}", "x".repeat(widest))]);
        assert_eq!(lines(widest + 1), [" a name".to_owned(), format!(" 1 {}", "x".repeat(widest + 1))]);
        assert_eq!(lines(2), ["  a  name", "  1  xx"]);
    }

    #[test]
    fn long_titles_take_lines_before_a_table_grows_too_wide() {
        let mut table = Table::new(&["regime", "points not compared"], 20);
        table.row(vec!["generic".into(), "12".into()]);
        let text = table.to_string();
        assert_eq!(
            text,
            "             points\n                not\n  regime   compared\n  generic        12\n"
        );
    }

    #[test]
    fn words_break_into_lines_and_no_line_is_too_long() {
        assert_eq!(wrapped("one two three", 9, "- ", "  "), "- one two\n  three\n");
        assert_eq!(wrapped("unbreakable", 3, "", ""), "unbreakable\n");
    }
}
