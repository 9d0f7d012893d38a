//! The composition of the page.

use super::equation::{Note, card};
use super::figures::{Axis, Plot, Series, before_and_after, blocks, two_lines, varied_pair};
use super::inline::{escaped, inline};
use super::record::Derivation;
use super::source::marked;
use super::tables::tangent;
use super::text::{html, sections};
use crate::check;
use crate::equations::{EquationTable, Verdict};
use crate::report::{Accuracy, ReportError};
use std::fmt::Write;

const STORY: &str = include_str!("story.txt");
const NOTES: &str = include_str!("equations.txt");
const STYLE: &str = include_str!("style.css");
/// The letters of the page from Latin Modern Math, and the parts of brackets, in base 64.
const FONT: &str = include_str!("math.woff2.base64");
const TITLE: &str = "The linearization of contact between two beams";

/// The files with marks.
const MARKED: [(&str, &str); 2] = [
    ("teaching/contact.rs", include_str!("../../teaching/contact.rs")),
    ("teaching/solve.rs", include_str!("../../teaching/solve.rs")),
];

impl Derivation {
    /// The page: one file that needs no other file and no script.
    ///
    /// Without `accuracy` the page has no figure of the digits lost at small distances.
    ///
    /// # Errors
    /// [`ReportError::Derivation`] if the text, a formula or the source is not as expected, with the reason.
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
        let misprints = table.equations.iter().filter(|row| row.verdict == Verdict::Misprint);
        let misprints: Vec<String> = misprints.map(|row| format!("({})", row.number)).collect();
        let _ = writeln!(page, "</ol>\n<p>Misprints: {}</p></nav>", inline(&misprints.join(", "))?);
        let _ = write!(page, "\n<main id=\"main\">\n{body}</main>\n</body>\n</html>\n");
        Ok(page)
    }

    fn card(&self, number: u8, notes: &[(u8, Note<'_>)], table: &EquationTable) -> Result<String, String> {
        let row = table.equation(number).ok_or_else(|| format!("({number}) is not in the record"))?;
        let (_, note) =
            notes.iter().find(|(of, _)| *of == number).ok_or_else(|| format!("({number}) has no note"))?;
        let worked = self.worked.iter().find(|worked| worked.number == number);
        card(row, note, worked.ok_or_else(|| format!("({number}) is not worked out"))?)
    }

    /// A figure by its name. The caption follows after a bar.
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
                None => format!("{}: {} iterations", escaped(tangent(&run.tangent)), run.residuals.len() - 1),
                Some(_) => format!("{}: does not converge", escaped(tangent(&run.tangent))),
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
}

/// The digits lost at small distances.
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
    let x = (Axis::Powers(-10, 0, 2), "distance of the centroids over the length of a beam");
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
