//! The page, put together.

use super::equation::{Note, card, number};
use super::figures::{Axis, Plot, Series, before_and_after, blocks, two_lines, varied_pair};
use super::record::Derivation;
use super::source::marked;
use super::symbols;
use super::text::{escaped, html, inline, sections};
use crate::check;
use crate::equations::EquationTable;
use crate::report::{Accuracy, ReportError};
use std::fmt::Write;

const STORY: &str = include_str!("story.txt");
const NOTES: &str = include_str!("equations.txt");
const STYLE: &str = include_str!("style.css");
/// The letters of the page out of Latin Modern Math, and the pieces of brackets, in base 64.
const FONT: &str = include_str!("math.woff2.base64");
const TITLE: &str = "The linearization of contact between two beams";

/// The files that marks are looked for in.
const MARKED: [(&str, &str); 2] = [
    ("teaching/contact.rs", include_str!("../../teaching/contact.rs")),
    ("teaching/solve.rs", include_str!("../../teaching/solve.rs")),
];

impl Derivation {
    /// The page: one file that needs no other, and no program to read it.
    ///
    /// Without `accuracy` the figure of the digits that are lost at small gaps is left out.
    ///
    /// # Errors
    /// [`ReportError::Derivation`] if the text, a formula or the source is not as expected, with what is wrong.
    pub fn to_html(&self, table: &EquationTable, accuracy: Option<&Accuracy>) -> Result<String, ReportError> {
        self.page(table, accuracy).map_err(|what| ReportError::Derivation { what })
    }

    fn page(&self, table: &EquationTable, accuracy: Option<&Accuracy>) -> Result<String, String> {
        let notes = Note::all(NOTES)?;
        let mut shown = Vec::new();
        let mut figures = 0;
        let body = html(STORY, |command, argument| match command {
            "equation" => {
                let mut cards = String::new();
                for number in argument.split_whitespace() {
                    let number: u8 = number.parse().map_err(|_| format!("{number:?} is no number"))?;
                    shown.push(number);
                    cards += &self.card(number, &notes, table)?;
                }
                Ok(cards)
            }
            "figure" => {
                figures += 1;
                self.figure(argument, figures, accuracy)
            }
            "table" => self.table(argument),
            "code" => code(argument),
            "open" => Ok(format!("<div class=\"{argument}\">\n")),
            "close" => Ok("</div>\n".to_owned()),
            "check" => self.check(argument),
            _ => Err(format!("no command is called {command:?}")),
        })?;
        if !shown.iter().copied().eq(1..=59) {
            return Err(format!("the page shows the equations {shown:?}"));
        }
        let style = STYLE.replace("FONT", &FONT.replace('\n', ""));
        let mut page = format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" \
             content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n\
             <title>{TITLE}</title>\n<style>{style}</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#main\">Skip to the text</a>\n\
             <header><h1>{TITLE}</h1></header>\n<nav aria-label=\"contents\"><ol>\n"
        );
        for (id, title) in sections(STORY) {
            let _ = writeln!(page, "<li><a href=\"#{id}\">{}</a></li>", inline(title)?);
        }
        let _ = write!(page, "</ol></nav>\n<main id=\"main\">\n{body}</main>\n</body>\n</html>\n");
        Ok(page)
    }

    fn card(&self, number: u8, notes: &[(u8, Note<'_>)], table: &EquationTable) -> Result<String, String> {
        let row = table.equation(number).ok_or_else(|| format!("({number}) is not in the record"))?;
        let (_, note) =
            notes.iter().find(|(of, _)| *of == number).ok_or_else(|| format!("({number}) has no note"))?;
        let worked = self.worked.iter().find(|worked| worked.number == number);
        card(row, note, worked.ok_or_else(|| format!("({number}) is not worked out"))?)
    }

    /// A figure by its name; its caption follows after a bar.
    fn figure(&self, argument: &str, count: usize, accuracy: Option<&Accuracy>) -> Result<String, String> {
        let (name, caption) =
            argument.split_once(" | ").ok_or_else(|| format!("{argument:?} has no caption"))?;
        let svg = match name {
            "pair" => varied_pair(0.25).map_err(|error| error.to_string())?,
            "beams" => before_and_after(),
            "newton" => self.newton_figure(),
            "system" => two_lines().map_err(|error| error.to_string())?,
            "blocks" => blocks().map_err(|error| error.to_string())?,
            "differences" => self.differences_figure(),
            "digits" => match accuracy {
                Some(accuracy) => digits_figure(accuracy),
                None => "<p>Left out: the record of the accuracy is not there.</p>\n".to_owned(),
            },
            _ => return Err(format!("no figure is called {name:?}")),
        };
        Ok(format!(
            "<figure>\n{svg}<figcaption>Figure {count}. {}</figcaption>\n</figure>\n",
            inline(caption)?
        ))
    }

    /// The residuals of Newton's method.
    fn newton_figure(&self) -> String {
        let classes = ["black solid", "b dash", "d dots", "r dashdot"];
        let count = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
        let series = self.newton.iter().zip(classes).map(|(run, class)| Series {
            name: match &run.stopped {
                None => format!("{}: {} iterations", escaped(&run.tangent), run.residuals.len() - 1),
                Some(_) => format!("{}: does not converge", escaped(&run.tangent)),
            },
            class,
            points: run
                .residuals
                .iter()
                .enumerate()
                .map(|(i, &residual)| (count(i), residual))
                .take(26)
                .collect(),
        });
        let x = (Axis::Count(25.0, 5), "iteration");
        let y = (Axis::Powers(-14, 2, 2), "residual over the first");
        Plot {
            title: "Residual of Newton's method over the iteration, for four tangents",
            x,
            y,
            series: series.collect(),
        }
        .draw()
    }

    /// The errors of central differences.
    fn differences_figure(&self) -> String {
        let rows = || self.differences.iter();
        let level = |value: f64| vec![(1e-8, value.max(1e-17)), (1.0, value.max(1e-17))];
        let series = vec![
            Series {
                name: "δd by central differences".into(),
                class: "b dash",
                points: rows().map(|row| (row.step, row.first)).collect(),
            },
            Series {
                name: "Δδd by central differences".into(),
                class: "d dots",
                points: rows().map(|row| (row.step, row.second)).collect(),
            },
            Series {
                name: "Δδd: closed form against hyper-dual numbers".into(),
                class: "black solid",
                points: level(self.floors[1]),
            },
        ];
        let x = (Axis::Powers(-8, 0, 2), "step");
        let y = (Axis::Powers(-17, 1, 3), "relative error");
        Plot { title: "Error of central differences over the step", x, y, series }.draw()
    }

    /// A table by its name.
    fn table(&self, name: &str) -> Result<String, String> {
        match name {
            "symbols" => symbols::table(),
            "newton" => Ok(self.newton_table()),
            "by-hand" => self.by_hand_table(),
            _ => Err(format!("no table is called {name:?}")),
        }
    }

    fn newton_table(&self) -> String {
        let mut head = String::new();
        for run in &self.newton {
            let _ = write!(head, "<th scope=\"col\">{}</th>", escaped(&run.tangent));
        }
        let mut rows = String::new();
        for i in 0..=8 {
            let cell = |residuals: &[f64]| residuals.get(i).map_or_else(String::new, |r| format!("{r:.1e}"));
            let mut cells = String::new();
            for run in &self.newton {
                let _ = write!(cells, "<td>{}</td>", cell(&run.residuals).replace('-', "−"));
            }
            let _ = writeln!(rows, "<tr><th scope=\"row\">{i}</th>{cells}</tr>");
        }
        wide("residuals", &format!("<th scope=\"col\">iteration</th>{head}"), &rows)
    }

    fn by_hand_table(&self) -> Result<String, String> {
        let of = &self.by_hand;
        let [a, b, a_bar, det] = of.system;
        let rows = [
            (r"\xi_C", of.at[0], "1/2"),
            (r"\xb_{\bar C}", of.at[1], "0"),
            ("d", of.d, "1/4"),
            ("a", a, "1"),
            ("b", b, "3/5"),
            (r"\bar a", a_bar, "−1"),
            ("D", det, "−16/25"),
            (r"\xi_{,z}", of.gradients[0], "25/128"),
            (r"\xb_{,z}", of.gradients[1], "15/128"),
            ("d_{,z}", of.derivatives[0], "−3/4"),
            ("d_{,zz}", of.derivatives[1], "−25/256"),
            (r"d_{,zz}\text{, hyper-dual}", of.by_ad[1], "−25/256"),
        ];
        let mut lines = String::new();
        for (latex, value, by_hand) in rows {
            let latex = super::math::mathml(latex, false)?;
            let _ = writeln!(lines, "<tr><td>{latex}</td><td>{by_hand}</td><td>{}</td></tr>", number(value));
        }
        let head = "<th scope=\"col\">quantity</th><th scope=\"col\">by hand</th><th scope=\"col\">by the program</th>";
        Ok(wide("numbers of the pair that is worked by hand", head, &lines))
    }

    /// A self-check: the number of the effect, then the question, the answer after a bar.
    fn check(&self, argument: &str) -> Result<String, String> {
        let parts: Vec<&str> = argument.splitn(3, " | ").collect();
        let [index, question, answer] = parts[..] else {
            return Err(format!("{argument:?} has not three parts"));
        };
        let effect = index.parse().ok().and_then(|index: usize| self.effects.get(index));
        let effect = effect.ok_or_else(|| format!("there is no effect {index}"))?;
        let names = ["Δδd", "Δδξ", "Δδt", "Δδg_T"];
        let mut rows = String::new();
        for (name, deviation) in names.iter().zip(effect.deviations) {
            let deviation =
                if deviation < 1e-12 { "none".to_owned() } else { format!("{:.1} %", 100.0 * deviation) };
            let _ = writeln!(rows, "<tr><th scope=\"row\">{name}</th><td>{deviation}</td></tr>");
        }
        let symmetry = if effect.is_symmetric {
            "passes: it does not see the fault"
        } else {
            "fails: it sees the fault"
        };
        let exact = self.newton.first().map_or(0, |run| run.residuals.len().saturating_sub(1));
        let newton = match (effect.in_hessian, effect.iterations) {
            (false, _) => "this term has no counterpart in the matrix form of the example".to_owned(),
            (true, Some(n)) => format!("Newton's method takes {n} iterations instead of {exact}"),
            (true, None) => format!(
                "Newton's method does not converge: {}",
                effect.stopped.as_deref().unwrap_or_default()
            ),
        };
        let table = wide(
            "deviations",
            "<th scope=\"col\">quantity</th><th scope=\"col\">relative deviation</th>",
            &rows,
        );
        Ok(format!(
            "<details class=\"check\">\n<summary>{}</summary>\n<p>{}</p>\n<p>Injected fault: <code>{}</code>, equation {}. In the \
             standard case:</p>\n{table}<p>A test of symmetry {symmetry}. In the example, {newton}.</p>\n</details>\n",
            inline(question)?,
            inline(answer)?,
            escaped(&effect.fault),
            inline(&format!("({})", effect.equation))?,
        ))
    }
}

/// The digits that are lost at small gaps.
fn digits_figure(accuracy: &Accuracy) -> String {
    let of = |pick: fn(&check::Errors) -> Option<f64>| {
        accuracy.found.gaps.iter().filter_map(|row| Some((row.at, pick(&row.d)?))).collect()
    };
    let series = vec![
        Series { name: "the form with 1/d, (40)".into(), class: "d dots", points: of(|losses| losses.paper) },
        Series {
            name: "the form along the common normal".into(),
            class: "black solid",
            points: of(|losses| losses.robust),
        },
    ];
    let x = (Axis::Powers(-10, 0, 2), "distance of the centroids, in lengths of a beam");
    let y = (Axis::Powers(-16, 2, 3), "median relative error of Δδd");
    Plot { title: "Error of the second variation of d over the distance, for two forms", x, y, series }.draw()
}

/// The lines between two marks of the source.
fn code(name: &str) -> Result<String, String> {
    let found = MARKED.iter().find_map(|(file, text)| Some((file, marked(text, name).ok()?)));
    let (file, code) = found.ok_or_else(|| format!("no source has the marks of {name:?}"))?;
    Ok(format!(
        "<p class=\"place\">In the code: <a href=\"../src/{file}\"><code>{file}</code></a></p>\n<pre tabindex=\"0\"><code>{}</code></pre>\n",
        escaped(&code)
    ))
}

/// A table that is scrolled where it is too wide.
fn wide(name: &str, head: &str, rows: &str) -> String {
    format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"{name}\"><table><thead><tr>{head}</tr></thead><tbody>\n\
         {rows}</tbody></table></div>\n"
    )
}
