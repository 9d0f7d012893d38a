//! Rows of text that are placed side by side.

/// Rows of text; the middle row is the base line.
#[derive(Clone, Debug, Default)]
pub(super) struct Area {
    pub(super) rows: Vec<String>,
    /// Whether it begins with δ or Δ.
    variation: bool,
    /// Whether it is an operator between two operands.
    operator: bool,
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
    pub(super) fn variation(text: &str) -> Self {
        Self { variation: true, ..Self::text(text) }
    }

    /// An operator with a blank on both sides, or without blanks if nothing precedes it.
    pub(super) fn operator(sign: char) -> Self {
        Self { operator: true, ..Self::text(&sign.to_string()) }
    }

    /// The row, if there is only one.
    pub(super) fn line(&self) -> Result<String, String> {
        match &self.rows[..] {
            [] => Ok(String::new()),
            [row] => Ok(row.clone()),
            _ => Err("a matrix cannot stand here".to_owned()),
        }
    }

    /// Both areas side by side.
    pub(super) fn beside(&self, next: &Self) -> Self {
        if self.rows.is_empty() {
            return next.clone();
        }
        if next.rows.is_empty() {
            return self.clone();
        }
        let end = self.rows[base(self.rows.len())].chars().rev().find(|c| columns(&c.to_string()) > 0);
        let opens = end.is_none_or(|end| ['(', '[', '{', '=', '⇒', ' '].contains(&end));
        let lone_sign = self.operator && self.rows.len() == 1;
        let gap = if next.operator {
            if opens && end != Some(' ') && !['=', '⇒'].contains(&end.unwrap_or(' ')) {
                ["", ""]
            } else {
                [" ", " "]
            }
        } else if next.variation
            && !opens
            && !lone_sign
            && !['δ', 'Δ', 'ᵤ', '·', '−', '√', '/'].contains(&end.unwrap_or(' '))
        {
            [" ", ""]
        } else {
            ["", ""]
        };
        let tall = self.rows.len().max(next.rows.len());
        let wide = |area: &Self| area.rows.iter().map(|row| columns(row)).max().unwrap_or_default();
        let row = |area: &Self, i: usize| {
            let first = base(tall) - base(area.rows.len());
            let text = i.checked_sub(first).and_then(|i| area.rows.get(i)).cloned().unwrap_or_default();
            let blanks = wide(area) - columns(&text);
            text + &" ".repeat(blanks)
        };
        let join = |i: usize| {
            let before = row(self, i);
            // Avoids two blanks where an operator follows a blank.
            let before = if gap[0] == " " && before.ends_with(' ') && tall == 1 {
                before.trim_end().to_owned()
            } else {
                before
            };
            format!("{before}{}{}{}", gap[0], row(next, i), gap[1])
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
    pub(super) fn enclosed(&self, left: [&str; 4], right: Option<[&str; 4]>) -> Self {
        let last = self.rows.len().saturating_sub(1);
        let piece = |[top, middle, bottom, only]: [&str; 4], i: usize| -> String {
            match i {
                _ if last == 0 => only.to_owned(),
                0 => top.to_owned(),
                i if i == last => bottom.to_owned(),
                _ => middle.to_owned(),
            }
        };
        let row = |(i, row): (usize, &String)| {
            format!("{}{row}{}", piece(left, i), right.map_or_else(String::new, |right| piece(right, i)))
        };
        Self::of(self.rows.iter().enumerate().map(row).collect())
    }
}
