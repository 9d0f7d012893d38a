//! The overestimation of the tolerances as Markdown, from the record alone.

use super::bounds::{Bounds, BoundsRow};
use super::number::{count, error, plain};
use std::fmt::Write;

impl Bounds {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let mut page = String::from("# Bounds\n\n");
        let points: u64 = self.regimes.iter().map(|regime| regime.measured).sum();
        let entries: u64 = self.rows_of("all").map(|row| row.entries).sum();
        let _ = writeln!(
            page,
            "The tolerances of the check are bounds on rounding error. This report measures whether errors exceed them, and \
             their overestimation factor. At {} closest points it compares every number of the closed form and of automatic \
             differentiation with the closed form in double-double, at the closest point refined there. Of {} numbers with \
             an error, **{}**.\n",
            count(points),
            count(entries),
            match self.violations.len() {
                0 => "none has an error beyond its bound".to_owned(),
                n => format!("some, in {n} cases, have an error beyond their bound"),
            }
        );
        page.push_str(&self.violations_listed());
        page.push_str("## Overestimation factor (bound / error), and error / scale\n\nOver all regimes.\n\n");
        page.push_str(&table(self.rows_of("all"), |row| format!("{} | {}", row.side, row.order)));
        for side in ["closed form", "AD"] {
            let _ = write!(page, "\n## By regime: {side}\n\n");
            let rows = self.rows.iter().filter(|row| row.side == side && row.regime != "all");
            page.push_str(&table(rows, |row| format!("{} | {}", row.regime, row.order)));
        }
        page.push_str(&self.by_regime());
        let _ = write!(
            page,
            "\n## How it was made\n\n{}| seed | {:#x} |\n| cases of each regime | {} |\n\n\
             Quantiles are good to 1.2 %. All numbers are in `bounds.json`, from which alone this page is made.\n",
            self.environment.rows(),
            self.seed,
            count(self.cases_per_regime),
        );
        page
    }

    fn rows_of<'a>(&'a self, regime: &'a str) -> impl Iterator<Item = &'a BoundsRow> {
        self.rows.iter().filter(move |row| row.regime == regime)
    }

    fn violations_listed(&self) -> String {
        if self.violations.is_empty() {
            return String::new();
        }
        let mut rows = String::from(
            "## Broken bounds\n\n| case | side | quantity | part | bound | error |\n|---:|---|---|---|---:|---:|\n",
        );
        for broken in &self.violations {
            let _ = writeln!(
                rows,
                "| {} | {} | {} | {} | {} | {} |",
                broken.case,
                broken.side,
                broken.quantity,
                broken.part,
                error(broken.bound),
                error(broken.error),
            );
        }
        rows + "\n"
    }

    fn by_regime(&self) -> String {
        let mut rows = String::from(
            "\n## What the tolerance cannot judge\n\n\
             Points where the sum of both bounds exceeds a thousandth of a scale, for some number: the gate does not count \
             them as compared.\n\n| regime | points | beyond a thousandth | share | left out |\n|---|---:|---:|---:|---:|\n",
        );
        for regime in &self.regimes {
            #[expect(clippy::cast_precision_loss, reason = "counts, far below 2^53")]
            let share = 100.0 * regime.not_meaningful as f64 / regime.measured.max(1) as f64;
            let _ = writeln!(
                rows,
                "| {} | {} | {} | {share:.2} % | {} |",
                regime.regime,
                count(regime.measured),
                count(regime.not_meaningful),
                count(regime.left_out),
            );
        }
        rows
    }
}

fn table<'a>(of: impl Iterator<Item = &'a BoundsRow>, name: impl Fn(&BoundsRow) -> String) -> String {
    let mut rows = String::from(
        "| | order | numbers | without error | bound/error: 5 % | median | 95 % | max | error/scale: median | 95 % | max |\n\
         |---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    let ratio = |x: Option<f64>| match x {
        None => "none".to_owned(),
        Some(x) if x < 1e5 => plain(x),
        x => error(x),
    };
    for row in of {
        let (overestimation, scaled) = (&row.overestimation, &row.error);
        let _ = writeln!(
            rows,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            name(row),
            count(row.entries),
            count(row.exact),
            ratio(overestimation.low),
            ratio(overestimation.median),
            ratio(overestimation.high),
            ratio(overestimation.max),
            error(scaled.median),
            error(scaled.high),
            error(scaled.max),
        );
    }
    rows
}
