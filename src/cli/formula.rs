//! LaTeX as lines of UTF-8, for a terminal: the layout of what `pulldown-latex` parses.
//!
//! It supports the syntax of the paper: accents, indices, fractions in a line, matrices, cases and aligned rows.

mod area;
mod letters;

use area::{Area, columns};
use letters::{bold, bracketed, subscript, superscript};
use pulldown_latex::event::{
    Content, EnvironmentFlow, Event, Font, Grouping, ScriptType, StateChange, Visual,
};
use pulldown_latex::{Parser, Storage};

/// The width of a line.
const WIDTH: usize = 76;

/// The lines of a formula; the error names the part that is not supported.
pub(super) fn lines(latex: &str) -> Result<Vec<String>, String> {
    let storage = Storage::new();
    let mut layout = Layout { events: Parser::new(latex, &storage), is_bold: false };
    let area = arranged(&Grouping::Normal, layout.cells()?)?;
    Ok(match &area.rows[..] {
        [row] => wrapped(row.trim(), WIDTH),
        rows => rows.iter().map(|row| row.trim_end().to_owned()).collect(),
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

/// The places of what is parsed.
struct Layout<'a> {
    events: Parser<'a>,
    is_bold: bool,
}

impl Layout<'_> {
    /// The cells of each row, to the end of the group. A group that is no environment has one cell.
    fn cells(&mut self) -> Result<Vec<Vec<Area>>, String> {
        let is_bold = self.is_bold;
        let (mut rows, mut row, mut cell) = (Vec::new(), Vec::new(), Area::default());
        while let Some(event) = self.events.next() {
            match event.map_err(|error| error.to_string())? {
                Event::End => break,
                Event::StateChange(StateChange::Font(font)) => self.is_bold = font == Some(Font::Bold),
                Event::EnvironmentFlow(EnvironmentFlow::Alignment) => row.push(std::mem::take(&mut cell)),
                Event::EnvironmentFlow(_) => {
                    row.push(std::mem::take(&mut cell));
                    rows.push(std::mem::take(&mut row));
                }
                event => cell = cell.beside(&self.element(event)?),
            }
        }
        row.push(cell);
        rows.push(row);
        self.is_bold = is_bold;
        Ok(rows)
    }

    /// The next element: a base, an index or an argument.
    fn next(&mut self) -> Result<Area, String> {
        let event = self.events.next().ok_or("an argument is missing")?;
        self.element(event.map_err(|error| error.to_string())?)
    }

    /// The element that begins with an event.
    fn element(&mut self, event: Event) -> Result<Area, String> {
        match event {
            Event::Content(content) => Ok(self.content(content)),
            Event::Begin(grouping) => arranged(&grouping, self.cells()?),
            Event::Visual(Visual::Fraction(_)) => {
                let [above, below] = [self.next()?.line()?, self.next()?.line()?];
                Ok(Area::text(&format!("{}/{} ", bracketed(&above), bracketed(&below))))
            }
            Event::Visual(Visual::SquareRoot) => Ok(Area::text(&format!("√({})", self.next()?.line()?))),
            Event::Script { ty, .. } => {
                let base = self.next()?;
                // In an index a comma does not separate terms.
                let mut index = || Ok::<_, String>(self.next()?.line()?.replace(", ", ","));
                let [below, above] = match ty {
                    ScriptType::Subscript => [index()?, String::new()],
                    ScriptType::Superscript => [String::new(), index()?],
                    ScriptType::SubSuperscript => [index()?, index()?],
                };
                scripted(&base, &below, &above)
            }
            Event::Space { width, .. } => {
                let blanks = match width.map_or(0., |width| width.value) {
                    ..0.5 => " ",
                    ..1.5 => "   ",
                    _ => "     ",
                };
                Ok(Area::text(blanks))
            }
            other => Err(format!("{other:?} has no text")),
        }
    }

    fn content(&self, content: Content) -> Area {
        match content {
            Content::Ordinary { content: letter @ ('δ' | 'Δ'), .. } => Area::variation(letter),
            Content::Ordinary { content: letter, .. } => {
                Area::text(&if self.is_bold { bold(letter) } else { letter }.to_string())
            }
            // This is how the parser writes `\ `.
            Content::Text("&nbsp;") => Area::text(" "),
            Content::Text(text) | Content::Number(text) => Area::text(text),
            Content::Function(name) => Area::text(&format!("{name} ")),
            Content::BinaryOp { content: '⋅', .. } => Area::text("·"),
            Content::BinaryOp { content, .. } => Area::operator(&content.to_string()),
            Content::Relation { content, .. } => {
                Area::operator(&String::from_utf8_lossy(content.encode_utf8_to_buf(&mut [0; 8])))
            }
            Content::LargeOp { content, .. } | Content::Delimiter { content, .. } => {
                Area::text(&content.to_string())
            }
            Content::Punctuation(mark) => Area::text(&format!("{mark} ")),
        }
    }
}

/// A base with an index below and above, each of which may be empty; or a letter with an accent above.
fn scripted(base: &Area, below: &str, above: &str) -> Result<Area, String> {
    let text = match (base.line()?.as_str(), above) {
        // Terminals draw a precomposed letter with a bar better than a combining bar.
        ("a", "‾") => "ā".to_owned(),
        ("g", "‾") => "ḡ".to_owned(),
        (letter, "‾") => format!("{letter}\u{304}"),
        (letter, "^") => format!("{letter}\u{302}"),
        ("∫", _) => format!("∫[{below} .. {above}] "),
        (letter, _) => format!("{letter}{}{}", subscript(below), superscript(above)?),
    };
    Ok(Area::text(&text))
}

/// The rows of an environment, or the only cell of another group.
fn arranged(grouping: &Grouping, mut rows: Vec<Vec<Area>>) -> Result<Area, String> {
    match grouping {
        Grouping::Matrix { .. } => Area::matrix(&rows),
        Grouping::Aligned => in_lines(&rows),
        Grouping::Cases { left: true } => Ok(in_lines(&rows)?.enclosed(["⎧ ", "⎪ ", "⎩ ", "{ "], [""; 4])),
        Grouping::Normal | Grouping::LeftRight(..) => {
            let cell = rows.pop().and_then(|mut row| row.pop()).unwrap_or_default();
            Ok(match grouping {
                Grouping::LeftRight(Some('['), Some(']')) => {
                    cell.enclosed(["⎡", "⎢", "⎣", "["], ["⎤", "⎥", "⎦", "]"])
                }
                Grouping::LeftRight(left, right) => {
                    let [left, right] = [left, right].map(|side| side.map(String::from).unwrap_or_default());
                    Area::text(&format!("{left}{}{right}", cell.line()?))
                }
                _ => cell,
            })
        }
        other => Err(format!("the environment {other:?} is not known")),
    }
}

/// The rows of an environment as lines.
fn in_lines(rows: &[Vec<Area>]) -> Result<Area, String> {
    let mut lines = Vec::new();
    for row in rows {
        let cells = row.iter().map(|cell| Ok(cell.line()?.trim().to_owned()));
        lines.extend(wrapped(&joined(&cells.collect::<Result<Vec<_>, String>>()?), WIDTH - 4));
    }
    Ok(Area::of(lines))
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
