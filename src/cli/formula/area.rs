//! Rows of text that are placed side by side.

/// Rows of text; the middle row is the base line.
#[derive(Clone, Debug, Default)]
pub(super) struct Area {
    pub(super) rows: Vec<String>,
    kind: Kind,
}

/// What decides about the blanks before and after.
#[derive(Clone, Copy, Debug, Default)]
enum Kind {
    #[default]
    Plain,
    /// δ or Δ.
    Variation,
    /// An operator between two operands.
    Operator,
}

/// The base line: the middle row, or the upper one of two middle rows.
fn base(rows: usize) -> usize {
    rows.saturating_sub(1) / 2
}

/// The number of columns of a text. Combining accents have no width.
pub(super) fn columns(text: &str) -> usize {
    text.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count()
}

impl Area {
    pub(super) fn text(text: &str) -> Self {
        Self::of(vec![text.to_owned()])
    }

    pub(super) fn of(rows: Vec<String>) -> Self {
        Self { rows, ..Self::default() }
    }

    /// δ or Δ, which is separated by a blank from the factor before.
    pub(super) fn variation(letter: char) -> Self {
        Self { kind: Kind::Variation, ..Self::text(&letter.to_string()) }
    }

    /// An operator with a blank on both sides, or without blanks if nothing precedes it.
    pub(super) fn operator(sign: &str) -> Self {
        Self { kind: Kind::Operator, ..Self::text(sign) }
    }

    /// The row, if there is only one.
    pub(super) fn line(&self) -> Result<String, String> {
        match &self.rows[..] {
            [] => Ok(String::new()),
            [row] => Ok(row.clone()),
            _ => Err("a matrix cannot stand here".to_owned()),
        }
    }

    /// Both areas side by side, with blanks around an operator and before a variation.
    pub(super) fn beside(&self, next: &Self) -> Self {
        if self.rows.is_empty() {
            return next.clone();
        }
        if next.rows.is_empty() {
            return self.clone();
        }
        let end = self.rows[base(self.rows.len())].chars().rev().find(|c| columns(&c.to_string()) > 0);
        let follows = |marks: &str| end.is_none_or(|end| marks.contains(end));
        let [left, right] = match next.kind {
            Kind::Operator if !follows("([{") => [" ", " "],
            Kind::Variation if !follows("([{=⇒≈+− δΔᵤ·√/") => [" ", ""],
            _ => ["", ""],
        };
        let tall = self.rows.len().max(next.rows.len());
        let row = |area: &Self, i: usize| {
            let first = base(tall) - base(area.rows.len());
            let text = i.checked_sub(first).and_then(|i| area.rows.get(i)).cloned().unwrap_or_default();
            let wide = area.rows.iter().map(|row| columns(row)).max().unwrap_or_default();
            let blanks = wide - columns(&text);
            text + &" ".repeat(blanks)
        };
        let join = |i: usize| {
            let mut before = row(self, i);
            // Avoids two blanks where an operator follows a blank.
            if tall == 1 && !left.is_empty() {
                before.truncate(before.trim_end().len());
            }
            before + left + &row(next, i) + right
        };
        Self::of((0..tall).map(join).collect())
    }

    /// Cells in columns. Each cell must have one line.
    pub(super) fn matrix(rows: &[Vec<Self>]) -> Result<Self, String> {
        let cells: Vec<Vec<String>> = rows
            .iter()
            .map(|row| row.iter().map(|cell| Ok(cell.line()?.trim().to_owned())).collect())
            .collect::<Result<_, String>>()?;
        let count = cells.iter().map(Vec::len).max().unwrap_or_default();
        let width = |j: usize| {
            cells.iter().filter_map(|row| row.get(j)).map(|cell| columns(cell)).max().unwrap_or_default()
        };
        let widths: Vec<usize> = (0..count).map(width).collect();
        let line = |row: &Vec<String>| {
            let cells = row.iter().zip(&widths).map(|(cell, width)| " ".repeat(width - columns(cell)) + cell);
            cells.collect::<Vec<_>>().join("  ")
        };
        Ok(Self::of(cells.iter().map(line).collect()))
    }

    /// The area in brackets of its height: pieces for the top, the middle and the bottom, and for a single row.
    pub(super) fn enclosed(&self, left: [&str; 4], right: [&str; 4]) -> Self {
        let last = self.rows.len().saturating_sub(1);
        let piece = |i: usize| match i {
            _ if last == 0 => 3,
            0 => 0,
            _ if i == last => 2,
            _ => 1,
        };
        let row = |(i, row): (usize, &String)| format!("{}{row}{}", left[piece(i)], right[piece(i)]);
        Self::of(self.rows.iter().enumerate().map(row).collect())
    }
}
