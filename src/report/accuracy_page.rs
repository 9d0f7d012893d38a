//! The digits that each formulation keeps, as Markdown, from the record alone.

use super::accuracy::{Accuracy, AccuracyRow, Losses};
use super::number::{count, error, plain};
use std::fmt::Write;

impl Accuracy {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let mut page = String::from("# Accuracy\n\n");
        let at = |rows: &[AccuracyRow], at: f64, of: fn(&AccuracyRow) -> Losses| {
            let row = rows.iter().find(|row| (row.at / at - 1.0).abs() < 1e-6).map(of);
            row.map_or_else(
                || "nothing".to_owned(),
                |losses| format!("{} instead of {}", error(losses.chosen), error(losses.paper)),
            )
        };
        let _ = writeln!(
            page,
            "Two formulas of the closed form exist in two formulations that are equal in exact arithmetic: the paper's, and a \
             robust one that keeps its digits where the paper's terms cancel. The library chooses one of them at each closest \
             point. At a gap of 1e-6 lengths the median error of Delta-delta d is {}; at an angle of 1e-5 that of Delta-delta \
             xi is {}. The error of the choice is at most {} times that of the better formulation.\n",
            at(&self.gaps, 1e-6, |row| row.d),
            at(&self.angles, 1e-5, |row| row.xi),
            plain(self.worst_choice()),
        );
        page.push_str(
            "Relative errors in `f64`, at the closest point rounded to it, against double-double at the closest point \
             refined there: medians over random pairs and directions.\n",
        );
        page.push_str(&table(
            "Over the gap",
            "Beams of all families, bent moderately, that cross at a wide angle. The gap is in lengths of a beam.",
            "accuracy-gap.svg",
            "gap",
            &self.gaps,
        ));
        page.push_str(&table(
            "Over the angle",
            "Straight beams, at a gap of a few hundredths to tenths of the length. The angle is in radians.",
            "accuracy-angle.svg",
            "angle",
            &self.angles,
        ));
        let _ = write!(
            page,
            "\n## What the numbers do not say\n\n\
             The curvature of nearly parallel curved beams is known to rounding only. All formulations lose the digits that \
             depend on it. The closest point is rounded to `f64`. Where it is ill-conditioned, all formulations are \
             evaluated at a wrong point.\n\
             \n## How it was made\n\n{}| seed | {:#x} |\n| pairs at each gap and angle | {} |\n\n\
             All numbers are in `accuracy.json`, from which alone this page and its pictures are made.\n",
            self.environment.rows(),
            self.seed,
            count(self.pairs as u64),
        );
        page
    }
}

fn table(title: &str, what: &str, picture: &str, at: &str, rows: &[AccuracyRow]) -> String {
    let mut text = format!(
        "\n## {title}\n\n{what}\n\n![{title}]({picture})\n\n\
         | {at} | Delta-delta d: paper | along the normal | chosen | Delta-delta xi: paper | by cross products | chosen \
         | normal chosen | cross products chosen |\n\
         |---:|---:|---:|---:|---:|---:|---:|---:|---:|\n"
    );
    for row in rows {
        let AccuracyRow { at, pairs, normal, cross_products, d, xi } = row;
        let _ = write!(text, "| {at:e} |");
        for losses in [d, xi] {
            let [paper, robust, chosen] = [losses.paper, losses.robust, losses.chosen].map(error);
            let _ = write!(text, " {paper} | {robust} | {chosen} |");
        }
        let _ = writeln!(text, " {normal} of {pairs} | {cross_products} of {pairs} |");
    }
    text
}
