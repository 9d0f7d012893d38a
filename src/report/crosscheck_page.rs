//! The comparison of the check as a page, from the record alone.

use super::crosscheck::{Crosscheck, NotCompared, RegimeRow};
use super::number::{count, error};
use super::page::{Block, Page};
use std::collections::BTreeMap;

impl Crosscheck {
    /// The page; the same record always makes the same page.
    pub fn page(&self) -> Page {
        let mismatches: u64 = self.regimes.iter().map(|regime| regime.mismatches).sum();
        let entries: u64 = self.quantities.iter().map(|worst| worst.entries).sum();
        let cases: u64 = self.regimes.iter().map(|regime| regime.cases).sum();
        let left: u64 =
            self.regimes.iter().flat_map(|regime| &regime.not_compared).map(|what| what.count).sum();
        let found = match mismatches {
            0 => "Closed form and automatic differentiation agree".to_owned(),
            n => format!("Closed form and automatic differentiation differ at {} closest points", count(n)),
        };
        let conclusion = format!(
            "**{found}: {} closest points of {} random pairs of beams, {} numbers, {} mismatches.** {} points or cases could not \
             be compared; they count neither as agreeing nor as differing. A mismatch is a difference that exceeds a bound on \
             the rounding of both sides.",
            count(self.points),
            count(cases),
            count(entries),
            count(mismatches),
            count(left),
        );
        let mut blocks = vec![Block::text(&conclusion)];
        blocks.extend(self.mismatches_listed());
        blocks.extend(self.by_regime());
        blocks.extend(self.by_quantity());
        blocks.push(Block::heading("Details"));
        blocks.push(self.by_reason());
        blocks.push(self.by_family());
        let (seed, of_each) = (format!("{:#x}", self.seed), count(self.cases_per_regime));
        blocks.extend([
            Block::heading("What these numbers do not say"),
            Block::list(&SILENCE),
            Block::heading("How it was made"),
            Block::text(
                "A case is drawn from the seed and its number alone. `beamgap check --case N` shows case N. All numbers are in \
                 `crosscheck.json`, from which alone this page is made. [Symbols and regimes](symbols.md).",
            ),
            self.environment.table(vec![("seed", seed), ("cases of each regime", of_each)]),
        ]);
        Page::new("Crosscheck", blocks)
    }

    fn mismatches_listed(&self) -> Vec<Block> {
        if self.mismatches.is_empty() {
            return Vec::new();
        }
        let number = |x: Option<f64>| x.map_or_else(|| "not finite".to_owned(), |x| format!("{x:e}"));
        let row = |entry: &super::Mismatch| {
            let names = [&entry.quantity, &entry.order, &entry.against].map(Clone::clone);
            let numbers = [number(entry.closed), number(entry.other), error(entry.tolerance)];
            std::iter::once(entry.case.to_string()).chain(names).chain(numbers).collect()
        };
        let head = ["#case", "quantity", "order", "against", "#closed form", "#other", "#tolerance"];
        vec![Block::heading("Mismatches"), Block::table(&head, self.mismatches.iter().map(row).collect())]
    }

    fn by_regime(&self) -> Vec<Block> {
        let row = |regime: &RegimeRow| {
            let left = regime.not_compared.iter().map(|what| what.count).sum();
            let counts = [regime.cases, regime.interior, regime.at_end, regime.mismatches, left].map(count);
            let share =
                regime.over_tolerance.map_or_else(|| "not finite".to_owned(), |over| format!("{over:.2}"));
            let worst = [error(regime.scaled_error), regime.case.to_string(), share];
            std::iter::once(regime.regime.clone()).chain(counts).chain(worst).collect()
        };
        let head = [
            "regime",
            "#cases",
            "#points inside",
            "#at ends",
            "#mismatches",
            "#not compared",
            "#worst error",
            "#its case",
            "#worst error / tolerance",
        ];
        vec![
            Block::heading("Regimes"),
            Block::text(
                "A regime is a way to draw pairs of beams; [symbols](symbols.md) describes each. A closest point lies inside both \
                 beams, or at an end of one or both. The error is |closed form - other| over the sum of the absolute values of \
                 the terms. *Error / tolerance* above 1 is a mismatch.",
            ),
            Block::table(&head, self.regimes.iter().map(row).collect()),
        ]
    }

    /// Quantities down, orders across, with the cases folded away.
    fn by_quantity(&self) -> [Block; 4] {
        let mut orders: Vec<&str> = Vec::new();
        let mut quantities: Vec<&str> = Vec::new();
        for worst in &self.quantities {
            for (known, name) in [(&mut quantities, &worst.quantity), (&mut orders, &worst.order)] {
                if !known.contains(&name.as_str()) {
                    known.push(name);
                }
            }
        }
        let table = |cell: fn(&super::Worst) -> String| {
            let row = |quantity: &&str| {
                let cells = orders.iter().map(|order| {
                    let is_it = |of: &&super::Worst| of.quantity == *quantity && of.order == *order;
                    self.quantities.iter().find(is_it).map(cell).unwrap_or_default()
                });
                std::iter::once((*quantity).to_owned()).chain(cells).collect()
            };
            let head: Vec<String> = std::iter::once("quantity".to_owned())
                .chain(orders.iter().map(|order| format!("#{order}")))
                .collect();
            Block::table(&head, quantities.iter().map(row).collect())
        };
        [
            Block::heading("Worst errors by quantity"),
            Block::text(
                "*Value*: the quantity itself. *First*: its first variations delta and Delta. *Second*: its second variation \
                 Delta-delta. *Symmetry*: Delta-delta against itself with the directions exchanged. *Matrix*: gradient and \
                 Hessian times the directions, against the variations.",
            ),
            table(|worst| error(worst.scaled_error)),
            Block::details("The cases with these errors", vec![table(|worst| worst.case.to_string())]),
        ]
    }

    fn by_reason(&self) -> Block {
        let row = |regime: &RegimeRow, what: &NotCompared| {
            vec![what.reason.clone(), regime.regime.clone(), count(what.count), what.first_case.to_string()]
        };
        let of_regime = |regime| move |what| row(regime, what);
        let rows: Vec<_> = self
            .regimes
            .iter()
            .flat_map(|regime| regime.not_compared.iter().map(of_regime(regime)))
            .collect();
        let body = if rows.is_empty() {
            Block::text("Nothing was left out.")
        } else {
            Block::table(&["reason", "regime", "#count", "#first case"], rows)
        };
        Block::details("Points and cases that were not compared", vec![body])
    }

    /// Families of the beam down, of the bar beam across.
    fn by_family(&self) -> Block {
        let met: BTreeMap<_, _> =
            self.pairs.iter().map(|pair| ((pair.beam.as_str(), pair.bar.as_str()), pair.points)).collect();
        let names: Vec<&str> = self.families.iter().map(|(name, _)| name.as_str()).collect();
        let row = |beam: &&str| {
            let counts = names.iter().map(|bar| count(met.get(&(*beam, *bar)).copied().unwrap_or(0)));
            std::iter::once((*beam).to_owned()).chain(counts).collect()
        };
        let head: Vec<String> = std::iter::once("beam \\ bar beam".to_owned())
            .chain(names.iter().map(|name| format!("#{name}")))
            .collect();
        let table = Block::table(&head, names.iter().map(row).collect());
        Block::details("Closest points compared, by curve families of beam and bar beam", vec![table])
    }
}

const SILENCE: [&str; 5] = [
    "Agreement of two methods proves neither right. They share the curves' positions, the closest points and the definitions of \
     the quantities. They share no derivative.",
    "The errors are relative to the terms that are summed, not to the result. Where terms cancel, the result has fewer digits \
     than the table suggests. The tolerance accounts for that, the error does not.",
    "Random pairs visit no configuration that has probability zero. The regimes are those that were thought of.",
    "What could not be compared is no success.",
    "Curve families that are not in the table of families were not tested.",
];
