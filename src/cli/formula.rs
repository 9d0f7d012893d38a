//! LaTeX as lines of UTF-8, for a terminal.
//!
//! It supports the syntax of the paper: accents, indices, fractions in a line, matrices, cases and aligned rows.

mod area;
mod letters;

use area::{Area, columns};
use letters::{bold, bracketed, subscript, superscript};

/// The width of a line.
const WIDTH: usize = 76;

/// The lines of a formula; the error names the part that is not supported.
pub(super) fn lines(latex: &str) -> Result<Vec<String>, String> {
    let mut parser = Parser { rest: latex };
    let area = parser.sequence()?;
    if !parser.rest.trim().is_empty() {
        return Err(format!("`{}` was not expected", parser.rest));
    }
    let trimmed = |row: &String| row.trim_end().to_owned();
    Ok(match &area.rows[..] {
        [row] => wrapped(row.trim(), WIDTH),
        rows => rows.iter().map(trimmed).collect(),
    })
}

/// A row in lines of this width, with line breaks before operators; later lines are indented.
fn wrapped(row: &str, width: usize) -> Vec<String> {
    let (mut lines, mut line, mut rest) = (Vec::new(), String::new(), row);
    while let Some(first) = rest.chars().next().map(char::len_utf8) {
        let next = [" + ", " − ", " = ", " ⇒ ", "   ", ", "]
            .iter()
            .filter_map(|mark| Some(rest[first..].find(mark)? + first))
            .min();
        let cut = next.unwrap_or(rest.len());
        let (piece, after) = rest.split_at(cut);
        if !line.is_empty() && columns(&line) + columns(piece) > width {
            lines.push(line);
            line = format!("    {}", piece.trim_start());
        } else {
            line += piece;
        }
        rest = after;
    }
    lines.push(line);
    lines
}

struct Parser<'a> {
    rest: &'a str,
}

impl<'a> Parser<'a> {
    /// Everything to the end of the group, the cell or the environment.
    fn sequence(&mut self) -> Result<Area, String> {
        let mut area = Area::default();
        loop {
            self.rest = self.rest.trim_start_matches([' ', '\n']);
            let ends = ["}", "&", r"\\", r"\end"];
            if self.rest.is_empty() || ends.iter().any(|end| self.rest.starts_with(end)) {
                return Ok(area);
            }
            let next = self.atom()?;
            area = area.beside(&next);
        }
    }

    /// One letter, command or group, with its indices.
    fn atom(&mut self) -> Result<Area, String> {
        let Some(first) = self.rest.chars().next() else { return Err("something is missing".to_owned()) };
        let after = &self.rest[first.len_utf8()..];
        let area = match first {
            '\\' => self.command()?,
            '{' => self.group()?,
            '+' | '=' => {
                self.rest = after;
                Area::operator(first)
            }
            '-' => {
                self.rest = after;
                Area::operator('−')
            }
            ',' => {
                self.rest = after;
                Area::text(", ")
            }
            _ => {
                self.rest = after;
                Area::text(&first.to_string())
            }
        };
        self.with_indices(area)
    }

    fn with_indices(&mut self, mut area: Area) -> Result<Area, String> {
        while let Some(mark) = self.rest.chars().next().filter(|&c| c == '_' || c == '^') {
            self.rest = &self.rest[1..];
            // In an index a comma does not separate terms.
            let index = self.argument()?.line()?.replace(", ", ",");
            area =
                area.beside(&Area::text(&if mark == '_' { subscript(&index) } else { superscript(&index)? }));
        }
        Ok(area)
    }

    /// The argument of a command: a group, a command or a letter, without indices.
    fn argument(&mut self) -> Result<Area, String> {
        self.rest = self.rest.trim_start();
        match self.rest.chars().next() {
            Some('{') => self.group(),
            Some('\\') => self.command(),
            Some(letter) => {
                self.rest = &self.rest[letter.len_utf8()..];
                Ok(Area::text(&letter.to_string()))
            }
            None => Err("an argument is missing".to_owned()),
        }
    }

    fn group(&mut self) -> Result<Area, String> {
        self.rest = &self.rest[1..];
        let area = self.sequence()?;
        self.rest = self.rest.strip_prefix('}').ok_or("a `}` is missing")?;
        Ok(area)
    }

    /// The name after a backslash.
    fn name(&mut self) -> &'a str {
        let rest = &self.rest[1..];
        let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let length = if letters == 0 { rest.chars().next().map_or(0, char::len_utf8) } else { letters };
        let (name, after) = rest.split_at(length);
        self.rest = after;
        name
    }

    fn command(&mut self) -> Result<Area, String> {
        let name = self.name();
        Ok(match name {
            "mathbf" => Area::text(&self.argument()?.line()?.chars().map(bold).collect::<String>()),
            "mathrm" => self.argument()?,
            "bar" => Area::text(&match self.argument()?.line()?.as_str() {
                // Terminals draw a precomposed letter with a bar better than a combining bar.
                "a" => "ā".to_owned(),
                "g" => "ḡ".to_owned(),
                letter => format!("{letter}\u{304}"),
            }),
            "hat" => Area::text(&format!("{}\u{302}", self.argument()?.line()?)),
            "frac" => {
                let [above, below] =
                    [self.argument()?.line()?, self.argument()?.line()?].map(|part| bracketed(&part));
                Area::text(&format!("{above}/{below}")).beside(&Area::text(" "))
            }
            "sqrt" => Area::text(&format!("√({})", self.argument()?.line()?)),
            "int" => {
                let mut limits = [String::new(), String::new()];
                for (limit, mark) in limits.iter_mut().zip(['_', '^']) {
                    self.rest = self.rest.strip_prefix(mark).ok_or("an integral has two limits")?;
                    *limit = self.argument()?.line()?;
                }
                Area::text(&format!("∫[{} .. {}] ", limits[0], limits[1]))
            }
            "begin" => self.environment()?,
            "left" | "right" => Area::default(),
            "xi" => Area::text("ξ"),
            "delta" => Area::variation("δ"),
            "Delta" => Area::variation("Δ"),
            "cdot" => Area::text("·"),
            "lVert" | "rVert" => Area::text("‖"),
            "ldots" => Area::text("…"),
            "min" => Area::text("min "),
            "approx" => Area::operator('≈'),
            "Rightarrow" => Area::operator('⇒'),
            "," | ";" | " " | "\n" => Area::text(" "),
            "quad" => Area::text("   "),
            "qquad" => Area::text("     "),
            _ => return Err(format!("`\\{name}` is not known")),
        })
    }

    fn environment(&mut self) -> Result<Area, String> {
        let rest = self.rest.strip_prefix('{').ok_or("`\\begin` has no name")?;
        let (name, rest) = rest.split_once('}').ok_or("`\\begin` has no name")?;
        self.rest = rest;
        let end = format!("\\end{{{name}}}");
        let mut rows = vec![Vec::new()];
        loop {
            let cell = self.sequence()?;
            if let Some(row) = rows.last_mut() {
                row.push(cell);
            }
            if let Some(rest) = self.rest.strip_prefix('&') {
                self.rest = rest;
            } else if let Some(rest) = self.rest.strip_prefix(r"\\") {
                self.rest = rest;
                rows.push(Vec::new());
            } else {
                self.rest =
                    self.rest.strip_prefix(end.as_str()).ok_or_else(|| format!("`{end}` is missing"))?;
                return arranged(name, &rows);
            }
        }
    }
}

/// The rows of an environment.
fn arranged(name: &str, rows: &[Vec<Area>]) -> Result<Area, String> {
    if name == "bmatrix" {
        return Ok(Area::matrix(rows)?.enclosed(["⎡", "⎢", "⎣", "["], Some(["⎤", "⎥", "⎦", "]"])));
    }
    let mut lines = Vec::new();
    for row in rows {
        let cells =
            row.iter().map(|cell| Ok(cell.line()?.trim().to_owned())).collect::<Result<Vec<_>, String>>()?;
        lines.extend(wrapped(&joined(&cells), WIDTH - 4));
    }
    let area = Area::of(lines);
    match name {
        "aligned" => Ok(area),
        "cases" => Ok(area.enclosed(["⎧ ", "⎪ ", "⎩ ", "{ "], None)),
        _ => Err(format!("the environment {name} is not known")),
    }
}

/// The cells of a row. A cell that begins with an operator is joined to the cell before.
fn joined(cells: &[String]) -> String {
    let mut line = String::new();
    for cell in cells.iter().filter(|cell| !cell.is_empty()) {
        match (cell.chars().next().filter(|first| "=+−".contains(*first)), line.is_empty()) {
            (Some(sign), empty) => {
                line += if empty { "    " } else { " " };
                line.push(sign);
                line.push(' ');
                line += cell[sign.len_utf8()..].trim_start();
            }
            (None, true) => line.clone_from(cell),
            (None, false) => {
                line += if line.ends_with('=') { " " } else { "     " };
                line += cell;
            }
        }
    }
    line
}

#[cfg(test)]
mod tests {
    use super::area::columns;
    use super::lines;
    use beamgap::equations::{DRAWS, equation_table};

    #[test]
    fn formulas_are_lines_of_letters() {
        let line = |latex: &str| lines(latex).unwrap().join("\n");
        assert_eq!(line(r"\delta\xi = \frac{\bar a R_\delta + b\bar R_\delta}{D}"), "δξ = (āR_δ + bR̄_δ)/D");
        assert_eq!(line(r"\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}"), "δᵤ𝐮̂_C·𝐝");
        assert_eq!(line(r"-\frac{1}{d^3}\mathbf{x}_{C,\xi}"), "−1/d³ 𝐱_C,ξ");
        assert_eq!(line(r"\mathbf{t}\Delta\delta\xi - \bar{\mathbf{t}}_{,\bar\xi}"), "𝐭 Δδξ − 𝐭̄,ξ̄");
        let matrix = r"\begin{bmatrix}a & -b \\ b & \bar a\end{bmatrix} = 0";
        assert_eq!(line(matrix), "⎡a  −b⎤ = 0\n⎣b   ā⎦");
        assert!(lines(r"\nonsense").is_err() && lines(r"a}").is_err() && lines(r"\frac{a}").is_err());
    }

    #[test]
    fn every_equation_of_the_paper_fits_the_terminal() {
        let table = equation_table(1, DRAWS.min(1), 1);
        assert_eq!(table.equations.len(), 59);
        for row in &table.equations {
            for latex in [Some(&row.printed), row.corrected.as_ref()].into_iter().flatten() {
                let lines = lines(latex).unwrap_or_else(|error| panic!("({}): {error}", row.number));
                for line in lines {
                    assert!(columns(&line) <= 78 && !line.contains('\\'), "({}): {line}", row.number);
                }
            }
        }
    }
}
