//! The overestimation of the tolerances as a page, from the record alone.

use super::bounds::Bounds;
use super::number::{count, error, finite, two_digits};
use super::page::{Block, Page};
use crate::check::{Measured, Order, Points, Regime, Side, Violation};

impl Bounds {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let found = &self.found;
        let points: u64 = found.points.values().map(|points| points.measured).sum();
        let entries: u64 = found.all.values().map(|measured| measured.entries).sum();
        let all: Vec<_> = found
            .all
            .iter()
            .map(|((side, order), measured)| ([side.name(), order.name()], measured))
            .collect();
        let conclusion = match found.violations.len() {
            0 => "No error exceeds its bound".to_owned(),
            n => format!("In {n} cases an error exceeds its bound"),
        };
        let conclusion = format!(
            "Does an error ever exceed its bound, and how far above the error is the bound? **{conclusion}: {} closest points, {} \
             numbers with an error. In the median, the bounds of the closed form are {}.** The check compares two numbers within a \
             tolerance, the sum of their bounds on rounding error.",
            count(points),
            count(entries),
            self.medians().join(", "),
        );
        let mut blocks = vec![Block::text(&conclusion)];
        blocks.extend(self.violations_listed());
        blocks.extend([
            Block::heading("Overestimation factor"),
            Block::text(
                "The overestimation factor is the bound over the true error, at least 1 if the bound holds. The check does \
                 not detect a fault below the tolerance, the sum of both bounds. The true error is the difference from the \
                 closed form in double-double, at the closest point refined there. *Kernel*: all its functions. \
                 *Contact element*: residual (first) and tangent (second), also at d = 0. *First*: delta \
                 and Delta; *second*: Delta-delta. The scale of a number is the sum of the absolute values of its terms.",
            ),
            table(["side", "order"], &all),
            counts(&all),
        ]);
        // The regimes of the contact element are in the record: the page is short.
        for side in Side::ALL.into_iter().filter(|&side| side != Side::Element) {
            let of_side = found.regimes.iter().filter(|((of, _), _)| *of == side);
            let rows: Vec<_> = of_side
                .flat_map(|((_, order), regimes)| {
                    regimes.iter().map(|(regime, measured)| ([regime.name(), order.name()], measured))
                })
                .collect();
            let table = table(["regime", "order"], &rows);
            blocks.push(Block::details(&format!("By regime: {}", side.name()), vec![table]));
        }
        blocks.extend(self.by_regime());
        let (seed, cases) = (format!("{:#x}", self.seed), count(self.cases_per_regime));
        blocks.extend([
            Block::heading("How it was made"),
            Block::text(
                "Quantiles have an error of at most 1.2 % before they are rounded to two digits. All numbers are in `bounds.json`.",
            ),
            self.environment.table(vec![("seed", seed), ("cases of each regime", cases)]),
        ]);
        Page::new("Bounds", blocks)
    }

    /// The median overestimation factors of the closed form.
    fn medians(&self) -> Vec<String> {
        let of_closed_form = self.found.all.iter().filter(|((side, _), _)| *side == Side::ALL[0]);
        let median = |((_, order), measured): (&(Side, Order), &Measured)| {
            let factor = two_digits(measured.overestimation?.median);
            Some(match order {
                Order::Value => format!("{factor} times the error for values"),
                _ => format!("{factor} times for {} variations", order.name()),
            })
        };
        of_closed_form.filter_map(median).collect()
    }

    fn violations_listed(&self) -> Vec<Block> {
        let violations = &self.found.violations;
        if violations.is_empty() {
            return Vec::new();
        }
        let row = |(case, violation): (&u64, &Violation)| {
            let &Violation { side, quantity, part, bound, error: of } = violation;
            let command = format!("`beamgap check --seed {:#x} --case {case}`", self.seed);
            [side.name(), quantity.name(), part]
                .map(str::to_owned)
                .into_iter()
                .chain([error(finite(bound)), error(finite(of)), command])
                .collect()
        };
        let head = ["side", "quantity", "part", "#bound", "#error", "shown by"];
        let rows = violations.iter().map(row).collect();
        vec![Block::heading("Broken bounds"), Block::table(&head, rows)]
    }

    fn by_regime(&self) -> Vec<Block> {
        let row = |(regime, points): (&Regime, &Points)| {
            #[expect(clippy::cast_precision_loss, reason = "counts, far below 2^53")]
            let share = 100.0 * points.not_meaningful as f64 / points.measured.max(1) as f64;
            let counts = [points.measured, points.not_meaningful].map(count);
            let rest = [format!("{share:.2} %"), count(points.left_out)];
            std::iter::once(regime.name().to_owned()).chain(counts).chain(rest).collect()
        };
        let head = ["regime", "#closest points", "#tolerance too wide", "#share", "#left out"];
        vec![
            Block::heading("Points whose tolerance is too wide"),
            Block::text(
                "A tolerance is too wide if it exceeds a thousandth of the scale, for some number of the point. The check does \
                 not count such a point as compared. A point is left out if it has no derivatives to compare, or cannot be \
                 refined.",
            ),
            Block::table(&head, self.found.points.iter().map(row).collect()),
        ]
    }
}

fn table(names: [&str; 2], rows: &[([&str; 2], &Measured)]) -> Block {
    let ratio = |x: f64| if x < 1e5 { two_digits(x) } else { error(finite(x)) };
    let row = |(names, measured): &([&str; 2], &Measured)| {
        let none = || "none".to_owned();
        let factors = measured.overestimation.map(|of| [of.low, of.median, of.high, of.max].map(ratio));
        let errors = measured.error.map(|of| [of.median, of.high, of.max].map(|x| error(finite(x))));
        let (factors, errors) = (
            factors.unwrap_or_else(|| [(); 4].map(|()| none())),
            errors.unwrap_or_else(|| [(); 3].map(|()| none())),
        );
        names.map(str::to_owned).into_iter().chain(factors).chain(errors).collect()
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
    Block::table(&head, rows.iter().map(row).collect())
}

fn counts(rows: &[([&str; 2], &Measured)]) -> Block {
    let row = |(names, measured): &([&str; 2], &Measured)| {
        let counts = [measured.entries, measured.exact, measured.unbounded].map(count);
        names.map(str::to_owned).into_iter().chain(counts).collect()
    };
    let head = ["side", "order", "#numbers with an error", "#numbers without an error", "#no finite bound"];
    Block::table(&head, rows.iter().map(row).collect())
}
