//! The table as Markdown, from the record alone.

use super::number::{count, error};
use crate::equations::{Counts, EquationRow, EquationTable, Reading, Run, Symmetry, Verdict};
use std::fmt::Write;

impl EquationTable {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let mut page = String::from("# Equations\n\n");
        let of = |verdict| self.equations.iter().filter(|entry| entry.verdict == verdict).count();
        let [linear, nonlinear] = self.pairs.map(|pairs| pairs * self.draws);
        let _ = writeln!(
            page,
            "This report evaluates every numbered equation of the paper, as printed and as corrected, and compares it with \
             hyper-dual numbers. Over the field of 2^61 - 1 elements two sides are equal or not: {} draws have curves that are \
             linear in their dofs, {} have one that is not. In `f64` the equations are evaluated at {} closest points. Of {} \
             equations **{} are misprinted**; {} as corrected.\n",
            count(linear),
            count(nonlinear),
            count(self.points.iter().sum()),
            self.equations.len(),
            of(Verdict::Misprint),
            match of(Verdict::Refuted) {
                0 => "none is refuted".to_owned(),
                n => format!("**{n} are refuted**"),
            },
        );
        page.push_str("| verdict | equations |\n|---|---|\n");
        for (verdict, meaning) in VERDICTS {
            let numbers: Vec<String> = (self.equations.iter().filter(|entry| entry.verdict == verdict))
                .map(|entry| format!("({})", entry.number))
                .collect();
            if !numbers.is_empty() {
                let _ = writeln!(page, "| **{}**: {meaning} | {} |", verdict.words(), numbers.join(", "));
            }
        }
        page.push_str(&self.all());
        page.push_str(&self.misprints());
        page.push_str(&self.dropped());
        page.push_str(&self.slip());
        page.push_str(&self.symmetry());
        let _ = write!(
            page,
            "\n## How it was made\n\n| | |\n|---|---|\n| command | `{}` |\n| seed | {:#x} |\n| draws for each ordered pair \
             of families | {} |\n| pairs linear in their dofs, and others | {}, {} |\n| closest points in `f64`, likewise \
             | {}, {} |\n\nAll numbers are in `equations.json`, from which alone this page is made; `beamgap equations --equation \
             N` shows one equation whole.\n",
            self.command,
            self.seed,
            self.draws,
            self.pairs[0],
            self.pairs[1],
            count(self.points[0]),
            count(self.points[1]),
        );
        page.push_str(SILENCE);
        page
    }

    /// One row for each equation.
    fn all(&self) -> String {
        let mut rows = String::from(
            "\n## All equations\n\n\
             *Refuted*: draws in which a part of the equation is not equal in any reading of the print, for pairs linear in \
             their dofs and others. *Error*: of the print in `f64`, the difference of both sides over the larger sum of the \
             absolute values of their terms; of (14), over the arc length. *Where*: below `src`, when this was made.\n\n\
             | eq | what | as printed | verdict | refuted as printed | as corrected | error | where |\n\
             |---:|---|---|---|---:|---:|---:|---|\n",
        );
        for entry in &self.equations {
            let latex =
                if entry.printed.is_empty() { "not there".to_owned() } else { inline(&entry.printed) };
            let place = entry.places.first();
            let place = place.map(|place| format!("`{}`, {}:{}", place.item, place.file, place.line));
            let run = entry.as_printed.linear.total() + entry.as_printed.nonlinear.total() > 0;
            let _ = writeln!(
                rows,
                "| {} | {} | {latex} | {} | {} | {} | {} | {} |",
                entry.number,
                entry.says,
                entry.verdict.words(),
                refuted([entry.as_printed.linear, entry.as_printed.nonlinear]),
                refuted([entry.as_corrected.linear, entry.as_corrected.nonlinear]),
                if run { error(entry.error()) } else { String::new() },
                place.unwrap_or_default(),
            );
        }
        rows
    }

    fn misprints(&self) -> String {
        let mut text = String::from("\n## Misprints\n");
        for entry in self.equations.iter().filter(|entry| entry.verdict >= Verdict::Misprint) {
            let _ = write!(
                text,
                "\n### ({}) {}\n\nAs printed:\n\n{}",
                entry.number,
                entry.says,
                fenced(&entry.printed)
            );
            if let Some(corrected) = &entry.corrected {
                let _ = write!(text, "\nAs corrected:\n\n{}", fenced(corrected));
            }
            if !entry.remark.is_empty() {
                let _ = writeln!(text, "\n{}", entry.remark);
            }
            if !entry.omitted.is_empty() {
                let left_out: Vec<String> = entry.omitted.iter().map(|term| inline(term)).collect();
                let _ = writeln!(text, "\nLeft out: {}.", left_out.join(", "));
            }
            if !entry.parts.is_empty() {
                let _ = write!(text, "\n{READINGS}{}", readings(entry, |_| true));
            }
        }
        text
    }

    /// What is exact for curves that are linear in their dofs only.
    fn dropped(&self) -> String {
        let mut text = format!(
            "\n## Terms dropped\n\nThe paper drops {} as of higher order. It is of the order of what is kept: zero for curves \
             that are linear in their dofs, and missing for all others.\n",
            inline(r"\Delta_u\delta_u\mathbf{u}")
        );
        for entry in self.equations.iter().filter(|entry| entry.verdict == Verdict::ExactIfLinear) {
            let remark =
                if entry.remark.is_empty() { String::new() } else { format!("{}\n\n", entry.remark) };
            let several = |run: &Run| run.reading != Reading::Other;
            let _ = write!(
                text,
                "\n### ({}) {}\n\n{remark}{READINGS}{}",
                entry.number,
                entry.says,
                readings(entry, several)
            );
        }
        text
    }

    fn slip(&self) -> String {
        let mut text = String::from(
            "\n## Slip along the tangent\n\n\
             The slip (14) against the arc length (12), by quadrature, at closest points of the gate. Where the length of \
             the tangent is constant along the curve the two are the same; elsewhere they differ by a term that is quadratic \
             in the slip, so that half the slip leaves about a quarter of it.\n\n\
             | family | slip in the parameter | largest difference over arc length | less for half the slip, median |\n\
             |---|---:|---:|---:|\n",
        );
        for arc in self.equations.iter().flat_map(|entry| &entry.arcs) {
            let ratio = arc.ratio.map_or_else(|| "rounding".to_owned(), |ratio| format!("{ratio:.1} times"));
            let _ =
                writeln!(text, "| {} | {} | {} | {ratio} |", arc.family, arc.slip, error(Some(arc.error)));
        }
        text
    }

    fn symmetry(&self) -> String {
        let mut text = String::from(
            "\n## Symmetry\n\n\
             Formulas of second order, run once more with δ and Δ exchanged: *by form*, the same with random numbers for \
             all operands; *by orthogonality*, the same at stationary points; *not*.\n\n\
             | the paper says, or implies | where | by form | by orthogonality | not | so it |\n|---|---|---:|---:|---:|---|\n",
        );
        for claim in &self.claims {
            let broken: Vec<String> = claim.broken_by.iter().map(|number| format!("({number})")).collect();
            let so = if claim.holds() { "holds".to_owned() } else { format!("fails: {}", broken.join(", ")) };
            let [form, orthogonality, not] = claim.found;
            let _ = writeln!(
                text,
                "| {} | {} | {form} | {orthogonality} | {not} | {so} |",
                claim.says, claim.made
            );
        }
        let by_orthogonality = self.equations.iter().filter(|entry| {
            entry
                .parts
                .iter()
                .any(|part| part.corrected().and_then(Run::symmetry) == Some(Symmetry::ByOrthogonality))
        });
        let numbers: Vec<String> = by_orthogonality.map(|entry| format!("({})", entry.number)).collect();
        let _ = writeln!(text, "\nSymmetric as corrected, though not by form: {}.", numbers.join(", "));
        text
    }
}

/// Every verdict with its meaning.
const VERDICTS: [(Verdict, &str); 10] = [
    (Verdict::Definition, "true by its words"),
    (Verdict::List, "of terms, complete"),
    (Verdict::Assumption, "what is supposed"),
    (Verdict::NotInTheScan, "lost, and reconstructed"),
    (Verdict::Exact, "equal in every draw"),
    (Verdict::ExactIfFinite, "equal for finite increments, with a remainder for variations"),
    (Verdict::ExactIfLinear, "equal for curves linear in their dofs, refuted for others"),
    (Verdict::Approximation, "measurably not what it stands for"),
    (Verdict::Misprint, "refuted as printed, equal as corrected"),
    (Verdict::Refuted, "refuted as corrected, too"),
];

const READINGS: &str = "| part | reading | equal, refuted: dofs linear | nonlinear | error: dofs linear | nonlinear | symmetric |\n\
                        |---|---|---:|---:|---:|---:|---|\n";

/// The rows of an equation's readings.
fn readings(entry: &EquationRow, shown: impl Fn(&Run) -> bool) -> String {
    let mut rows = String::new();
    for part in &entry.parts {
        for run in part.runs.iter().filter(|run| shown(run)) {
            let reading = match run.reading {
                Reading::Printed => "as printed",
                Reading::Other => "read otherwise",
                Reading::Corrected => "corrected",
                Reading::Complete => "complete",
            };
            let words = if run.words.is_empty() { String::new() } else { format!(": {}", run.words) };
            let counts = |counts: Counts| format!("{}, {}", count(counts.equal), count(counts.refuted));
            let [linear, nonlinear] = run.score.errors.map(error);
            let _ = writeln!(
                rows,
                "| {} | {reading}{words} | {} | {} | {linear} | {nonlinear} | {} |",
                part.name,
                counts(run.score.linear),
                counts(run.score.nonlinear),
                run.symmetry().map_or("", Symmetry::words),
            );
        }
    }
    rows
}

/// Refuted draws of all draws.
fn refuted(counts: [Counts; 2]) -> String {
    if counts.iter().all(|counts| counts.total() == 0) {
        return String::new();
    }
    counts.map(|counts| count(counts.refuted)).join(", ")
}

/// LaTeX in a line, fenced so that Markdown leaves it alone.
fn inline(latex: &str) -> String {
    format!("$`{}`$", latex.replace('\n', " "))
}

fn fenced(latex: &str) -> String {
    format!("```math\n{latex}\n```\n")
}

const SILENCE: &str = "
## What this does not say

- A draw overlooks a wrong formula with a small probability, as `beamgap prove` explains; a refuted one is refuted.
- The print is read from a scan: what is called a misprint may be the scan's.
- Truth is what hyper-dual numbers make of the definitions and of the curves' positions. A wrong definition would make
  both sides wrong.
- Closest points lie inside both beams, as in the paper; what holds at ends is for `beamgap prove`.
- The errors in `f64` are the largest of those that were drawn, not bounds.
";
