//! A page as terminal text: words in lines and tables in columns.

use super::{Block, Inline, Page};
use std::fmt;

impl Page {
    /// The page as text with a width of `columns`, without its pictures.
    pub fn to_text(&self, columns: usize) -> String {
        format!("{}\n{}", self.title, blocks(&self.blocks, columns))
    }
}

fn blocks(all: &[Block], columns: usize) -> String {
    all.iter().map(|block| one(block, columns)).collect()
}

fn one(block: &Block, columns: usize) -> String {
    match block {
        Block::Heading(words) | Block::Subheading(words) => format!("\n{}\n", plain(words)),
        Block::Text(words) => format!("\n{}", wrapped(&plain(words), columns, "", "")),
        Block::List(points) => {
            let points = points.iter().map(|point| wrapped(&plain(point), columns, "- ", "  "));
            format!("\n{}", points.collect::<String>())
        }
        Block::Table { head, rows } => {
            let titles = head.iter().map(|(name, _)| plain(name)).collect();
            let left = (0..head.len()).filter(|&i| !head[i].1).collect();
            let rows = rows.iter().map(|row| row.iter().map(|cell| plain(cell)).collect()).collect();
            format!("\n{}", Table { titles, rows, left, columns })
        }
        Block::Formula(latex) => format!("\n  {}\n", latex.replace('\n', "\n  ")),
        Block::Picture { .. } => String::new(),
        Block::Details { summary, blocks: inner } => {
            format!("\n{}\n{}", plain(summary), blocks(inner, columns))
        }
    }
}

/// A text without its marks.
fn plain(text: &str) -> String {
    super::inline(text, |mark| match mark {
        Inline::Strong(text) | Inline::Emphasis(text) | Inline::Code(text) => text.to_owned(),
        Inline::Link(text, to) => format!("{text} ({to})"),
    })
}

/// Words in lines. The first line starts with `first` and the others with `next`.
pub(in super::super) fn wrapped(text: &str, columns: usize, first: &str, next: &str) -> String {
    let (mut lines, mut line) = (String::new(), first.to_owned());
    let mut is_empty = true;
    for word in text.split_whitespace() {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > columns {
            lines.push_str(&line);
            lines.push('\n');
            next.clone_into(&mut line);
            is_empty = true;
        }
        line += if is_empty { "" } else { " " };
        line += word;
        is_empty = false;
    }
    lines + &line + "\n"
}

/// Text in columns as wide as their contents. If a table is too wide, titles take several lines, then the cells of the widest
/// column of words do, and then the columns of numbers continue below.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    titles: Vec<String>,
    rows: Vec<Vec<String>>,
    /// The columns that are aligned to the left. The others contain numbers.
    left: Vec<usize>,
    columns: usize,
}

/// The width of a terminal, if it is unknown.
const COLUMNS: usize = 80;
/// The minimum width of a column of words.
const NARROWEST: usize = 16;

impl Default for Table {
    fn default() -> Self {
        Self::new(&[])
    }
}

impl Table {
    /// A table of 80 columns with these titles and its first column aligned to the left.
    pub fn new(titles: &[&str]) -> Self {
        let titles = titles.iter().map(ToString::to_string).collect();
        Self { titles, rows: Vec::new(), left: vec![0], columns: COLUMNS }
    }

    /// Aligns further columns to the left.
    #[must_use]
    pub fn left(mut self, columns: &[usize]) -> Self {
        self.left.extend(columns);
        self
    }

    /// Adds a row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The widths of all columns, and the blanks before each.
    fn widths(&self) -> (Vec<usize>, usize) {
        let count = self.rows.iter().map(Vec::len).chain([self.titles.len()]).max().unwrap_or(0);
        let widest = |i: usize| self.rows.iter().filter_map(|row| row.get(i)).map(|cell| length(cell)).max();
        let cells: Vec<usize> = (0..count).map(|i| widest(i).unwrap_or(0)).collect();
        let title = |i: usize| self.titles.get(i).map_or("", String::as_str);
        let sum = |widths: &[usize], gap: usize| widths.iter().map(|width| width + gap).sum::<usize>();
        let mut widths: Vec<usize> = (0..count).map(|i| cells[i].max(length(title(i)))).collect();
        if sum(&widths, 2) > self.columns {
            let word = |i: usize| title(i).split_whitespace().map(length).max().unwrap_or(0);
            widths = (0..count).map(|i| cells[i].max(word(i))).collect();
        }
        while sum(&widths, 1) > self.columns {
            let widest =
                self.left.iter().copied().filter(|&i| widths[i] > NARROWEST).max_by_key(|&i| widths[i]);
            let Some(i) = widest else { break };
            widths[i] = (widths[i] + self.columns).saturating_sub(sum(&widths, 1)).max(NARROWEST);
        }
        let gap = if sum(&widths, 2) > self.columns { 1 } else { 2 };
        (widths, gap)
    }

    /// The columns in parts, each of which is narrow enough. The columns of words before the numbers begin each part.
    fn parts(&self, widths: &[usize], gap: usize) -> Vec<Vec<usize>> {
        let names = (0..widths.len()).take_while(|i| self.left.contains(i)).count();
        let of_names: usize = widths[..names].iter().map(|width| width + gap).sum();
        let mut parts: Vec<Vec<usize>> = vec![(0..names).collect()];
        let mut used = of_names;
        for (i, width) in widths.iter().enumerate().skip(names) {
            if used + gap + width > self.columns && used > of_names {
                parts.push((0..names).collect());
                used = of_names;
            }
            used += gap + width;
            parts.last_mut().expect("there is one from the start").push(i);
        }
        parts
    }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// The lines of some cells next to each other. Titles end in the same line, and other cells begin in the same line.
fn lines(cells: &[(&str, usize, bool)], gap: usize, is_title: bool) -> String {
    let cells: Vec<(Vec<String>, usize, bool)> = cells
        .iter()
        .map(|&(cell, width, left)| match length(cell) {
            fits if fits <= width => (vec![cell.to_owned()], width, left),
            _ => (wrapped(cell, width, "", "").lines().map(str::to_owned).collect(), width, left),
        })
        .collect();
    let height = cells.iter().map(|(lines, ..)| lines.len()).max().unwrap_or(0);
    let line = |k: usize| {
        let mut line = String::new();
        for (lines, width, left) in &cells {
            let k = if is_title { (k + lines.len()).checked_sub(height) } else { Some(k) };
            let cell = k.and_then(|k| lines.get(k)).map_or("", String::as_str);
            line += &" ".repeat(gap);
            let padded = if *left { format!("{cell:<width$}") } else { format!("{cell:>width$}") };
            line.push_str(&padded);
        }
        format!("{}\n", line.trim_end())
    };
    (0..height).map(line).collect()
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (widths, gap) = self.widths();
        for (k, part) in self.parts(&widths, gap).into_iter().enumerate() {
            if k > 0 {
                writeln!(f)?;
            }
            let cell = |row: &'_ Vec<String>, i: usize| row.get(i).map_or(String::new(), Clone::clone);
            let shown = |row: &Vec<String>, is_title: bool| {
                let cells: Vec<_> =
                    part.iter().map(|&i| (cell(row, i), widths[i], self.left.contains(&i))).collect();
                let cells: Vec<_> =
                    cells.iter().map(|(cell, width, left)| (cell.as_str(), *width, *left)).collect();
                lines(&cells, gap, is_title)
            };
            if self.titles.iter().any(|title| !title.is_empty()) {
                write!(f, "{}", shown(&self.titles, true))?;
            }
            for row in &self.rows {
                write!(f, "{}", shown(row, false))?;
            }
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
            let mut table = Table::new(&["a", "name"]).left(&[1]);
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
        let mut table = Table { columns: 20, ..Table::new(&["regime", "points not compared"]) };
        table.row(vec!["generic".into(), "12".into()]);
        let text = table.to_string();
        assert_eq!(
            text,
            "             points\n                not\n  regime   compared\n  generic        12\n"
        );
    }

    #[test]
    fn long_words_wrap_and_numbers_continue_below() {
        let mut table = Table { columns: 30, ..Table::new(&["code", "why"]).left(&[1]) };
        table.row(vec!["full".into(), "two systems are computed and one is taken".into()]);
        assert_eq!(table.to_string(), " code why\n full two systems are computed\n      and one is taken\n");
        let mut table = Table { columns: 12, ..Table::new(&["a", "b", "c"]) };
        table.row(vec!["x".into(), "12345".into(), "12345678".into()]);
        assert_eq!(table.to_string(), " a     b\n x 12345\n\n a        c\n x 12345678\n");
    }

    #[test]
    fn words_break_into_lines_and_no_line_is_too_long() {
        assert_eq!(wrapped("one two three", 9, "- ", "  "), "- one two\n  three\n");
        assert_eq!(wrapped("unbreakable", 3, "", ""), "unbreakable\n");
    }
}
