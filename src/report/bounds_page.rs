//! The overestimation of the tolerances as a page, from the record alone.

use super::bounds::{Bounds, BoundsRow};
use super::number::{count, error, plain};
use super::page::{Block, Page};

impl Bounds {
    /// The page; the same record always makes the same page.
    pub fn page(&self) -> Page {
        let points: u64 = self.regimes.iter().map(|regime| regime.points.measured).sum();
        let entries: u64 = self.rows_of("all").map(|row| row.entries).sum();
        let found = match self.violations.len() {
            0 => "No error exceeds its bound".to_owned(),
            n => format!("In {n} cases an error exceeds its bound"),
        };
        let conclusion = format!(
            "**{found}: {} closest points, {} numbers with an error.** The check compares two numbers within a tolerance, the \
             sum of their bounds on rounding error. This report asks two questions. Does an error ever exceed its bound? How \
             far above the error is the bound?",
            count(points),
            count(entries),
        );
        let mut blocks = vec![Block::text(&conclusion)];
        blocks.extend(self.violations_listed());
        blocks.extend([
            Block::heading("Overestimation factor"),
            Block::text(
                "The overestimation factor is the bound over the true error: at least 1 if the bound holds, and a fault smaller \
                 than this many errors is not seen. The true error is the difference from the closed form in double-double \
                 numbers, at the closest point refined there. *First*: delta and Delta, the first variations; *second*: \
                 Delta-delta. The scale of a number is the sum of the absolute values of its terms.",
            ),
            table(["side", "order"], self.rows_of("all"), |row| [&row.side, &row.order]),
            counts(self.rows_of("all")),
        ]);
        for side in ["closed form", "AD"] {
            let rows = self.rows.iter().filter(|row| row.side == side && row.regime != "all");
            let table = table(["regime", "order"], rows, |row| [&row.regime, &row.order]);
            blocks.push(Block::details(&format!("By regime: {side}"), vec![table]));
        }
        blocks.extend(self.by_regime());
        let (seed, cases) = (format!("{:#x}", self.seed), count(self.cases_per_regime));
        blocks.extend([
            Block::heading("How it was made"),
            Block::text(
                "Quantiles are good to 1.2 %. All numbers are in `bounds.json`, from which alone this page is made. \
                 [Symbols and regimes](symbols.md).",
            ),
            self.environment.table(vec![("seed", seed), ("cases of each regime", cases)]),
        ]);
        Page::new("Bounds", blocks)
    }

    fn rows_of<'a>(&'a self, regime: &'a str) -> impl Iterator<Item = &'a BoundsRow> {
        self.rows.iter().filter(move |row| row.regime == regime)
    }

    fn violations_listed(&self) -> Vec<Block> {
        if self.violations.is_empty() {
            return Vec::new();
        }
        let row = |broken: &super::BrokenBound| {
            let names = [&broken.side, &broken.quantity, &broken.part].map(Clone::clone);
            let numbers = [error(broken.bound), error(broken.error)];
            let command = format!("`beamgap check --seed {:#x} --case {}`", self.seed, broken.case);
            names.into_iter().chain(numbers).chain([command]).collect()
        };
        let head = ["side", "quantity", "part", "#bound", "#error", "shown by"];
        let rows = self.violations.iter().map(row).collect();
        vec![Block::heading("Broken bounds"), Block::table(&head, rows)]
    }

    fn by_regime(&self) -> Vec<Block> {
        let row = |regime: &super::RegimePoints| {
            #[expect(clippy::cast_precision_loss, reason = "counts, far below 2^53")]
            let share = 100.0 * regime.points.not_meaningful as f64 / regime.points.measured.max(1) as f64;
            let counts = [regime.points.measured, regime.points.not_meaningful].map(count);
            let rest = [format!("{share:.2} %"), count(regime.points.left_out)];
            std::iter::once(regime.regime.clone()).chain(counts).chain(rest).collect()
        };
        let head = ["regime", "#closest points", "#tolerance too wide", "#share", "#left out"];
        vec![
            Block::heading("Where the tolerance says nothing"),
            Block::text(
                "A tolerance is too wide if it exceeds a thousandth of the scale, for some number of the point. The check does \
                 not count such a point as compared. A point is left out if it has no derivatives to compare, or cannot be \
                 refined.",
            ),
            Block::table(&head, self.regimes.iter().map(row).collect()),
        ]
    }
}

fn table<'a>(
    names: [&str; 2],
    of: impl Iterator<Item = &'a BoundsRow>,
    name: impl Fn(&BoundsRow) -> [&String; 2],
) -> Block {
    let ratio = |x: Option<f64>| match x {
        None => "none".to_owned(),
        Some(x) if x < 1e5 => plain(x),
        x => error(x),
    };
    let row = |row: &BoundsRow| {
        let (factor, scaled) = (&row.overestimation, &row.error);
        let factors = [factor.low, factor.median, factor.high, factor.max].map(ratio);
        let errors = [scaled.median, scaled.high, scaled.max].map(error);
        name(row).map(Clone::clone).into_iter().chain(factors).chain(errors).collect()
    };
    let head = [
        names[0],
        names[1],
        "#factor: 5 %",
        "#median",
        "#95 %",
        "#max",
        "#error / scale: median",
        "#95 %",
        "#max",
    ];
    Block::table(&head, of.map(row).collect())
}

fn counts<'a>(of: impl Iterator<Item = &'a BoundsRow>) -> Block {
    let row = |row: &BoundsRow| {
        let counts = [row.entries, row.exact, row.unbounded].map(count);
        [&row.side, &row.order].map(Clone::clone).into_iter().chain(counts).collect()
    };
    let head = ["side", "order", "#numbers with an error", "#without an error", "#without a finite bound"];
    Block::table(&head, of.map(row).collect())
}
