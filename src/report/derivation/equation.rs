//! One equation on the page: its statement, its reason, the lines that compute it, its numbers and its verdict.

use super::inline::{escaped, inline};
use super::letters::used;
use super::source::{Snippet, of_equation};
use super::text::{formula, prose};
use crate::equations::{
    Definition, EquationRow, Order, Reading, Symmetry, Verdict, Worked, WorkedPart, WorkedReading, definition,
};
use crate::report::number::count;
use std::fmt::Write;

/// The prose about one equation.
pub(super) struct Note<'a> {
    /// The whole correct equation, if the record has only its differences from the print.
    statement: Option<&'a str>,
    /// The reason why it is true.
    why: &'a str,
    /// What is wrong with the print.
    wrong: Option<&'a str>,
    /// The meaning of the numbers, if they are not both sides of the equation shown.
    numbers: Option<&'a str>,
}

impl<'a> Note<'a> {
    /// The notes by number: `## 40`, then `= LaTeX`, prose, `# what the numbers are` and `! what is wrong`, each in its own
    /// paragraph.
    pub(super) fn all(text: &'a str) -> Result<Vec<(u8, Self)>, String> {
        let mut notes = Vec::new();
        for note in text.split("\n## ").skip(1) {
            let (number, rest) = note.split_once('\n').ok_or("a note is empty")?;
            let number = number.trim().parse().map_err(|_| format!("{number:?} is no number"))?;
            let mut found = Self { statement: None, why: "", wrong: None, numbers: None };
            for part in rest.split("\n\n").map(str::trim).filter(|part| !part.is_empty()) {
                if let Some(latex) = part.strip_prefix("= ") {
                    found.statement = Some(latex);
                } else if let Some(wrong) = part.strip_prefix("! ") {
                    found.wrong = Some(wrong);
                } else if let Some(numbers) = part.strip_prefix("# ") {
                    found.numbers = Some(numbers);
                } else {
                    found.why = part;
                }
            }
            if found.why.is_empty() {
                return Err(format!("({number}) has no explanation"));
            }
            notes.push((number, found));
        }
        Ok(notes)
    }
}

/// The scenes of the page that teaches the geometry, with the equations that each of them links to.
const SCENES: [(&str, &str, &[u8]); 8] = [
    ("valley", "Where are two beams closest?", &[1, 2, 3, 4, 11]),
    ("normal", "Why is the distance normal to both beams?", &[48]),
    ("slide", "What moves when the contact point moves?", &[23, 24, 28]),
    ("lines", "How far does the contact point slide?", &[44, 47, 50, 51, 52]),
    ("envelope", "Which derivatives of the parameters does the gap need?", &[37, 40]),
    ("race", "What does a wrong tangent cost?", &[19]),
    ("detective", "Which check finds which error?", &[42, 54]),
    ("friction", "Why does friction need second variations of the parameters?", &[12, 15, 20, 21, 59]),
];

/// The card of one equation: its number, what it says and the formula; the rest is closed.
pub(super) fn card(row: &EquationRow, note: &Note<'_>, worked: &Worked) -> Result<String, String> {
    let number = row.number;
    let statement = match (note.statement, row.verdict, &row.corrected) {
        (Some(latex), _, _) => latex,
        (None, Verdict::Misprint | Verdict::NotInTheScan, Some(latex)) => latex,
        _ => &row.printed,
    };
    let mut card = format!(
        "<section class=\"equation\" id=\"eq-{number}\">\n<h3>({number}) {} <span class=\"verdict {}\">{}</span></h3>\n",
        inline(&row.says)?,
        if row.verdict == Verdict::Misprint { "bad" } else { "good" },
        row.verdict.words(),
    );
    card += &formula(statement)?;
    let letters = used(statement)?;
    if !letters.is_empty() {
        let _ = writeln!(card, "<p class=\"letters\">Letters: {letters}</p>");
    }
    for (id, title, _) in SCENES.into_iter().filter(|(.., equations)| equations.contains(&number)) {
        let _ = writeln!(
            card,
            "<p class=\"place\">In a picture that moves: <a href=\"learn.html#{id}\">{title}</a></p>"
        );
    }
    let _ = writeln!(
        card,
        "<details><summary>Why it holds, code and numbers</summary>\n<p>{}</p>",
        prose(note.why)?
    );
    if row.verdict == Verdict::ExactIfLinear {
        let _ = writeln!(card, "<p>{}</p>", prose(&dropped(row))?);
    }
    card += &code(&of_equation(number)?, number)?;
    if let Some(what) = note.numbers {
        let _ = writeln!(card, "<p>{}</p>", prose(what)?);
    }
    card += &numbers(worked);
    card += &evidence(row)?;
    if row.verdict == Verdict::Misprint {
        card += &misprint(row, note, worked)?;
    }
    Ok(card + "</details>\n</section>\n")
}

/// The text for an equation that drops the terms of curves that are not linear in their dofs.
fn dropped(row: &EquationRow) -> String {
    let worst =
        row.as_printed.errors[1].map_or_else(|| "not finite".to_owned(), |error| format!("{error:.1e}"));
    format!(
        "The print drops the terms $\\Delta_u\\delta_u$, which vanish if the curve is linear in its dofs. For other curves \
         the error of the print is up to {worst} of the size of its terms; the code keeps these terms."
    )
}

/// The function that computes the equation, and the lines that do.
fn code(snippet: &Snippet, number: u8) -> Result<String, String> {
    let Snippet { file, item, owner, code } = snippet;
    let definition = definition(number).ok_or_else(|| format!("no function computes ({number})"))?;
    let link = |file, lines: &str, item| {
        let (place, item) = (escaped(&format!("{file}{lines}")), escaped(item));
        format!("<a href=\"../src/{file}\"><code>{place}</code></a>, <code>{item}</code>")
    };
    let Definition { from, to, .. } = definition;
    let mut place = link(definition.file, &format!(":{from}-{to}"), definition.item);
    if *owner != number {
        let _ = write!(place, "; the lines are shown at {}.", inline(&format!("({owner})"))?);
    } else if !code.is_empty() && (definition.file, definition.item) != (*file, item.as_str()) {
        let _ = write!(place, "; lines of it in {}", link(file, "", item));
    }
    let mut text = format!("<p class=\"place\">In the code: {place}</p>\n");
    if *owner == number && !code.is_empty() {
        let _ = writeln!(text, "<pre tabindex=\"0\"><code>{}</code></pre>", escaped(code));
    }
    Ok(text)
}

/// The correct reading: the last of print, correction and completion.
fn right(part: &WorkedPart) -> Option<&WorkedReading> {
    let of = |reading| part.readings.iter().find(|run| run.reading == reading);
    of(Reading::Complete).or_else(|| of(Reading::Corrected)).or_else(|| of(Reading::Printed))
}

/// The largest number of a part. Zeros are compared with it.
const ORDER_ONE: f64 = 1.0;

/// The table of the standard case.
fn numbers(worked: &Worked) -> String {
    let mut rows = String::new();
    for part in &worked.parts {
        let Some(reading) = right(part) else { continue };
        let order = match part.order {
            Order::Value => "value",
            Order::First => "first variation",
            Order::Second => "second variation",
            Order::Finite => "finite increments",
        };
        let name = if part.name.is_empty() { order } else { &part.name };
        let _ = writeln!(
            rows,
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td class=\"digits\">{}</td></tr>",
            escaped(name),
            values(&reading.right),
            values(&reading.left),
            agreement(reading),
        );
    }
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"numbers of ({})\"><table><thead><tr><th scope=\"col\">\
         standard case</th><th scope=\"col\">this formula</th><th scope=\"col\">hyper-dual numbers</th>\
         <th scope=\"col\">digits</th></tr></thead><tbody>\n{rows}</tbody></table></div>\n",
        worked.number
    )
}

/// The number of digits that agree.
fn agreement(reading: &WorkedReading) -> String {
    let digits = reading.digits(ORDER_ONE);
    // Further digits depend on the machine.
    if digits >= 13.0 { "13 or more".to_owned() } else { format!("{digits:.1}") }
}

/// Up to three numbers.
fn values(numbers: &[f64]) -> String {
    let shown = numbers.iter().take(3).map(|&x| number(x)).collect::<Vec<_>>().join(", ");
    if numbers.len() > 3 { shown + ", .." } else { shown }
}

/// A number with ten decimals. Rounding errors of zero are written as zero.
pub(super) fn number(x: f64) -> String {
    let text = format!("{x:.10}");
    let text = if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') { "0" } else { &text };
    text.replace('-', "−")
}

/// The results of the runs over all pairs.
fn evidence(row: &EquationRow) -> Result<String, String> {
    let total = row.as_corrected.linear.total() + row.as_corrected.nonlinear.total();
    if total == 0 {
        return Ok(format!(
            "<p class=\"evidence\">Verdict: {}. {}</p>\n",
            row.verdict.words(),
            inline(&row.remark)?
        ));
    }
    let equal = row.as_corrected.linear.equal + row.as_corrected.nonlinear.equal;
    let is_completed =
        row.parts.iter().flat_map(|part| &part.runs).any(|run| run.reading == Reading::Complete);
    let what = match (row.verdict, is_completed) {
        (Verdict::ExactIfLinear, _) => "As completed, both sides",
        (Verdict::Misprint, true) => "As corrected and completed, both sides",
        (Verdict::Misprint, false) => "As corrected, both sides",
        (Verdict::Approximation, _) => "As a definition, both sides",
        _ => "Both sides",
    };
    let symmetric = row.parts.iter().filter_map(|part| part.corrected()?.symmetry()).next_back();
    let symmetry = symmetric.map_or_else(String::new, |symmetry| {
        let (is, why) = match symmetry {
            Symmetry::ByForm => ("symmetric", " by its form"),
            Symmetry::ByRelations => ("symmetric", " by relations between its operands"),
            Symmetry::Not => ("not symmetric", ""),
        };
        format!(" The formula is {is} in $\\delta$ and $\\Delta${why}.")
    });
    Ok(format!(
        "<p class=\"evidence\">Verdict: {}. {what}, one of them by hyper-dual numbers, are equal in {} of {} draws over a prime \
         field, where nothing is rounded.{}{}</p>\n",
        row.verdict.words(),
        count(equal),
        count(total),
        inline(&symmetry)?,
        inline(&approximated(row))?,
    ))
}

/// The difference of a slip from the arc length, if the equation approximates it.
fn approximated(row: &EquationRow) -> String {
    let worst = row.arcs.iter().max_by(|one, other| one.error.total_cmp(&other.error));
    worst.map_or_else(String::new, |arc| {
        format!(
            " From the arc length (12) it differs by up to {:.1} % for $\\xi_C-\\xi_{{C_0}}={}$, over all families of curves.",
            100.0 * arc.error,
            arc.slip
        )
    })
}

/// The printed equation, and the numbers that refute it.
fn misprint(row: &EquationRow, note: &Note<'_>, worked: &Worked) -> Result<String, String> {
    let wrong = note.wrong.ok_or_else(|| format!("nothing is said of the misprint of ({})", row.number))?;
    let mut text = format!(
        "<div class=\"misprint\">\n<h4>What is printed</h4>\n{}<p>{}</p>\n",
        formula(&row.printed)?,
        prose(wrong)?
    );
    let mut rows = String::new();
    for (part, run_part) in worked.parts.iter().zip(&row.parts) {
        let refuted = run_part
            .runs
            .iter()
            .zip(&part.readings)
            .filter(|(run, reading)| reading.reading == Reading::Printed && run.score.linear.refuted > 0);
        for (run, reading) in refuted {
            let words = [part.name.as_str(), reading.words.as_str()];
            let words: Vec<&str> = words.into_iter().filter(|words| !words.is_empty()).collect();
            let _ = writeln!(
                rows,
                "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{} of {}</td></tr>",
                escaped(if words.is_empty() { "as printed".to_owned() } else { words.join(": ") }.as_str()),
                values(&reading.right),
                values(&reading.left),
                count(run.score.linear.refuted),
                count(run.score.linear.total()),
            );
        }
    }
    if !rows.is_empty() {
        let _ = writeln!(
            text,
            "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"refutation of ({})\"><table><thead><tr><th scope=\"col\">\
             the print, read as</th><th scope=\"col\">gives</th><th scope=\"col\">hyper-dual numbers</th><th scope=\"col\">refuted \
             in draws</th></tr></thead><tbody>\n{rows}</tbody></table></div>",
            row.number
        );
    }
    Ok(text + "</div>\n")
}
