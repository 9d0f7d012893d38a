//! Plain text in columns as wide as what they hold.

use std::fmt;

/// The width of a terminal.
const COLUMNS: usize = 80;

/// Rows of cells: the first column to the left, the others to the right.
#[derive(Default)]
pub(crate) struct Table {
    rows: Vec<Vec<String>>,
    left: Vec<usize>,
}

impl Table {
    /// A table with these words on top.
    pub(crate) fn new(titles: &[&str]) -> Self {
        Self { rows: vec![titles.iter().map(ToString::to_string).collect()], left: vec![0] }
    }

    /// Sets further columns to the left.
    pub(crate) fn left(mut self, columns: &[usize]) -> Self {
        self.left.extend(columns);
        self
    }

    /// Adds a row.
    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width =
            |i: usize| self.rows.iter().filter_map(|row| row.get(i)).map(|cell| cell.chars().count()).max();
        let widths: Vec<_> = (0..columns).map(|i| width(i).unwrap_or(0)).collect();
        // Two blanks apart, or one where the terminal is too narrow for that.
        let gap = if widths.iter().map(|width| width + 2).sum::<usize>() > COLUMNS { " " } else { "  " };
        for row in &self.rows {
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
    use super::{COLUMNS, Table};

    #[test]
    fn columns_are_two_apart_as_long_as_the_terminal_holds_them() {
        let lines = |length: usize| {
            let mut table = Table::new(&["a", "name"]).left(&[1]);
            table.row(vec!["1".into(), "x".repeat(length)]);
            table.to_string().lines().map(str::to_owned).collect::<Vec<_>>()
        };
        let widest = COLUMNS - 5;
        assert_eq!(lines(widest), ["  a  name".to_owned(), format!("  1  {}", "x".repeat(widest))]);
        assert_eq!(lines(widest + 1), [" a name".to_owned(), format!(" 1 {}", "x".repeat(widest + 1))]);
        assert_eq!(lines(2), ["  a  name", "  1  xx"]);
    }
}
