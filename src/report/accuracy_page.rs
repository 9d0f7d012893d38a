//! The digits that each formulation keeps, as a page, from the record alone.

use super::Accuracy;
use super::number::{count, error, plain};
use super::page::{Block, Page};
use crate::check::{Errors, Level};

impl Accuracy {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let at = |rows: &[Level], at: f64, of: fn(&Level) -> Errors| {
            let row = rows.iter().find(|row| (row.at / at - 1.0).abs() < 1e-6).map(of);
            row.map_or_else(
                || "nothing".to_owned(),
                |losses| format!("{} (paper: {})", error(losses.chosen), error(losses.paper)),
            )
        };
        let conclusion = format!(
            "How many digits are kept at small distances and angles? **At a distance d of 1e-6 beam lengths the median relative error of Delta-delta d, the second variation of the \
             distance, is {}. At an angle of 1e-5 rad between straight beams the median relative error of Delta-delta xi, the \
             second variation of the parameter, is {}.** At each closest point the library chooses between two formulations that \
             are equal in exact arithmetic. In every row of the tables below the median error of its choice is at most {} times the smaller of the two medians.",
            at(&self.found.gaps, 1e-6, |row| row.d),
            at(&self.found.angles, 1e-5, |row| row.xi),
            plain(self.found.worst_choice()),
        );
        let formulations = Block::table(
            &["formulation", "Delta-delta d", "Delta-delta xi"],
            [
                [
                    "paper",
                    "divides by d, equation (40)",
                    "solves the 2x2 system by determinants, equation (59)",
                ],
                [
                    "robust",
                    "along the common normal, no division by d",
                    "solves it by cross products of the tangents",
                ],
            ]
            .map(|row| row.map(str::to_owned).to_vec())
            .to_vec(),
        );
        let picture = |file: &str, caption: &str, svg| Block::Picture {
            file: file.to_owned(),
            caption: caption.to_owned(),
            svg,
        };
        let distances = "Pairs of all curve families, moderately bent, that cross at a wide angle. d/L is the distance of the \
                         centroids over the length of a beam. Of two beams in contact d is the sum of the radii.";
        let angles = "Straight beams at a distance d of a few hundredths to tenths of their length.";
        let (seed, pairs) = (format!("{:#x}", self.seed), count(self.pairs as u64));
        let blocks = vec![
            Block::text(&conclusion),
            formulations,
            Block::text(
                "In the tables below *d* is the error of Delta-delta d, and *xi* is the error of Delta-delta xi. *Chosen* is the \
                 formulation that the library chooses. The last two columns count the pairs for which it chooses the robust \
                 formulation.",
            ),
            Block::heading("Over the distance"),
            picture("accuracy-gap.svg", distances, self.gap_to_svg()),
            Block::details("The numbers of this figure", vec![table("d/L", &self.found.gaps)]),
            Block::heading("Over the angle"),
            picture("accuracy-angle.svg", angles, self.angle_to_svg()),
            Block::details("The numbers of this figure", vec![table("angle in rad", &self.found.angles)]),
            Block::heading("What the numbers do not say"),
            Block::list(&[
                "The curvature of nearly parallel curved beams is known to rounding only. All formulations lose the digits that \
                 depend on it.",
                "The closest point is rounded to `f64`. Where it is ill-conditioned, all formulations are evaluated at a wrong \
                 point.",
            ]),
            Block::heading("How it was made"),
            Block::text(
                "An error is relative, in `f64`, at the closest point rounded to `f64`. It is measured against double-double \
                 numbers at the closest point refined there. Each number is a median over random pairs and directions. All \
                 numbers are in `accuracy.json`, from which alone this page and its figures are made.",
            ),
            self.environment.table(vec![("seed", seed), ("pairs at each distance and angle", pairs)]),
        ];
        Page::new("Accuracy", blocks)
    }
}

/// Both quantities at every distance or angle, from small to large.
fn table(at: &str, rows: &[Level]) -> Block {
    let head = [
        at,
        "#d: paper",
        "#d: robust",
        "#d: chosen",
        "#xi: paper",
        "#xi: robust",
        "#xi: chosen",
        "#pairs",
        "#robust chosen for d",
        "#robust chosen for xi",
    ];
    let row = |row: &Level| {
        let Level { at, pairs, normal, cross_products, d, xi } = row;
        let errors = [d, xi].into_iter().flat_map(|of: &Errors| [of.paper, of.robust, of.chosen].map(error));
        let counts = [*pairs, *normal, *cross_products].map(|number| count(number as u64));
        std::iter::once(format!("{at:e}")).chain(errors).chain(counts).collect()
    };
    let mut rows: Vec<&Level> = rows.iter().collect();
    rows.sort_by(|a, b| a.at.total_cmp(&b.at));
    Block::table(&head, rows.into_iter().map(row).collect())
}
