//! The comparison of the check as a page, from the record alone.

use super::crosscheck::Crosscheck;
use super::number::{count, error, finite};
use super::page::{Block, Page};
use crate::check::{
    Cell, ContactSituation, Coverage, ElementCells, Inconclusive, Mismatch, NotCompared, Order, Regime,
    Symmetry, Tally,
};
use crate::linearization::Quantity;
use crate::test_beam::Family;

impl Crosscheck {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let tallies = || self.found.regimes.values();
        let mismatches: u64 = tallies().map(|tally| tally.mismatches).sum();
        let entries: u64 = self.found.quantities.values().map(|cell| cell.entries).sum();
        let cases: u64 = tallies().map(|tally| tally.cases).sum();
        let left = tallies().map(Tally::left_out).sum();
        let found = match mismatches {
            0 => "Closed form and automatic differentiation agree".to_owned(),
            n => format!("Closed form and automatic differentiation differ at {} closest points", count(n)),
        };
        let conclusion = format!(
            "Do closed form and automatic differentiation agree? **{found}: {} closest points of {} random pairs of beams, {} numbers, {} mismatches.** {} points and cases could not \
             be compared; they count neither as agreeing nor as differing. A mismatch is a difference that exceeds a bound on \
             the rounding of both sides.",
            count(self.found.compared()),
            count(cases),
            count(entries),
            count(mismatches),
            count(left),
        );
        let mut blocks = vec![Block::text(&conclusion)];
        blocks.extend(self.mismatches_listed());
        blocks.extend(self.by_regime());
        blocks.extend(self.by_quantity());
        blocks.extend(self.by_symmetry());
        blocks.extend(self.by_situation());
        blocks.push(Block::heading("Details"));
        blocks.extend([self.by_reason(), self.by_family()]);
        let (seed, of_each) = (format!("{:#x}", self.seed), count(self.cases_per_regime));
        blocks.extend([
            Block::heading("What these numbers do not say"),
            Block::list(&SILENCE),
            Block::heading("How it was made"),
            Block::text(
                "A case is drawn from the seed and its number alone. `beamgap check --case N` shows case N. All numbers are in \
                 `crosscheck.json`, from which alone this page is made.",
            ),
            self.environment.table(vec![("seed", seed), ("cases of each regime", of_each)]),
        ]);
        Page::new("Crosscheck", blocks)
    }

    fn mismatches_listed(&self) -> Vec<Block> {
        let mismatches = &self.found.mismatches;
        if mismatches.is_empty() {
            return Vec::new();
        }
        let number = |x: f64| if x.is_finite() { format!("{x:e}") } else { "not finite".to_owned() };
        let row = |(case, Mismatch { worst, .. }): (&u64, &Mismatch)| {
            let names = [worst.quantity.name(), worst.order.name(), worst.against].map(str::to_owned);
            let numbers = [number(worst.closed), number(worst.other), error(finite(worst.tolerance))];
            std::iter::once(case.to_string()).chain(names).chain(numbers).collect()
        };
        let head = ["#case", "quantity", "order", "against", "#closed form", "#other", "#tolerance"];
        vec![Block::heading("Mismatches"), Block::table(&head, mismatches.iter().map(row).collect())]
    }

    fn by_regime(&self) -> Vec<Block> {
        let row = |(regime, tally): (&Regime, &Tally)| {
            let counts = [tally.cases, tally.interior, tally.at_end, tally.mismatches, tally.left_out()];
            let Cell { scaled_error, case, over_tolerance, .. } = tally.worst;
            let share = finite(over_tolerance).map_or_else(|| "not finite".to_owned(), below_one);
            let worst = [error(finite(scaled_error)), case.to_string(), share];
            std::iter::once(regime.name().to_owned()).chain(counts.map(count)).chain(worst).collect()
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
                "A regime is a distribution of random pairs of beams; [symbols](symbols.md) describes each. The error \
                 is |closed form - other| over the sum of the absolute values of \
                 the terms. *Error / tolerance* above 1 is a mismatch.",
            ),
            Block::table(&head, self.found.regimes.iter().map(row).collect()),
            Block::text(
                "The cases of badly-scaled are numbered from 2^40 on, those of the other regimes from 0 on. In badly-scaled the ratio \
                 can be just below 1: the rounding of the parameter of the closest point to `f64` can exceed all other rounding \
                 errors, and its bound is hardly larger than this error.",
            ),
        ]
    }

    /// A table with quantities as rows and orders as columns, with the cases collapsed.
    fn by_quantity(&self) -> [Block; 4] {
        let cells = &self.found.quantities;
        let orders: Vec<Order> =
            Order::ALL.into_iter().filter(|order| cells.keys().any(|(_, of)| of == order)).collect();
        let quantities: Vec<Quantity> =
            Quantity::ALL.into_iter().filter(|quantity| cells.keys().any(|(of, _)| of == quantity)).collect();
        let table = |show: fn(&Cell) -> String| {
            let row = |quantity: &Quantity| {
                let shown =
                    orders.iter().map(|order| cells.get(&(*quantity, *order)).map(show).unwrap_or_default());
                std::iter::once(quantity.name().to_owned()).chain(shown).collect()
            };
            let head: Vec<String> = std::iter::once("quantity".to_owned())
                .chain(orders.iter().map(|order| format!("#{}", order.name())))
                .collect();
            Block::table(&head, quantities.iter().map(row).collect())
        };
        [
            Block::heading("Worst errors by quantity"),
            Block::text(
                "*Value*: the quantity. *First*: its first variations delta and Delta. *Second*: its second variation \
                 Delta-delta. *Symmetry*: Delta-delta against itself with the directions exchanged. *Matrix*: gradient and \
                 Hessian times the directions, against the variations. *Function*: what the library's functions return, \
                 against the variations.",
            ),
            table(|cell| error(finite(cell.scaled_error))),
            Block::details("The cases with these errors", vec![table(|cell| cell.case.to_string())]),
        ]
    }

    /// The contact elements of all regimes, by situation.
    fn by_situation(&self) -> [Block; 3] {
        let row = |situation: ContactSituation| {
            let mut sum = ElementCells::default();
            let tallies = self.found.regimes.values();
            tallies.filter_map(|tally| tally.elements.get(&situation)).for_each(|cells| sum.merge(cells));
            let ElementCells { residual, tangent } = sum;
            let entries = residual.entries + tangent.entries;
            let worst = [residual, tangent].map(|cell| error(finite(cell.scaled_error)));
            std::iter::once(situation.name().to_owned()).chain([count(entries)]).chain(worst).collect()
        };
        let head = ["situation", "#numbers", "#worst error of R", "#of K"];
        [
            Block::heading("Contact elements"),
            Block::text(
                "In one case in eight, residual R and tangent K of contact elements are compared, too. An element is in several \
                 situations. For *d = 0* the bar beam is moved until the centroids cross.",
            ),
            Block::table(&head, ContactSituation::ALL.map(row).to_vec()),
        ]
    }

    fn by_reason(&self) -> Block {
        let row = |regime: Regime, reason: &Inconclusive, what: &NotCompared| {
            let names = [reason.reason(), regime.name()].map(str::to_owned);
            names.into_iter().chain([count(what.count), what.first_case.to_string()]).collect()
        };
        let of_regime = |(&regime, tally): (&Regime, &'_ Tally)| -> Vec<Vec<String>> {
            tally.not_compared.iter().map(|(reason, what)| row(regime, reason, what)).collect()
        };
        let rows: Vec<_> = self.found.regimes.iter().flat_map(of_regime).collect();
        let body = if rows.is_empty() {
            Block::text("Nothing was left out.")
        } else {
            Block::table(&["reason", "regime", "#count", "#first case"], rows)
        };
        Block::details("Points and cases that were not compared", vec![body])
    }

    /// The smaller share of the two sides of each symmetry, by regime and by family.
    fn by_symmetry(&self) -> [Block; 4] {
        let regimes: Vec<(&str, &Coverage)> =
            self.found.regimes.iter().map(|(regime, tally)| (regime.name(), &tally.coverage)).collect();
        let of_family = |family: Family| {
            let mut sum = Coverage::default();
            let tallies = self.found.regimes.values();
            tallies
                .filter_map(|tally| tally.coverage_of_families.get(&family))
                .for_each(|coverage| sum.merge(coverage));
            sum
        };
        let sums: Vec<_> =
            self.found.families.keys().map(|&family| (family.name(), of_family(family))).collect();
        let families: Vec<(&str, &Coverage)> =
            sums.iter().map(|(name, coverage)| (*name, coverage)).collect();
        let table = |rows: &[(&str, &Coverage)]| {
            let row = |symmetry: Symmetry| {
                let share = |(_, coverage): &(&str, &Coverage)| {
                    coverage.share(symmetry).map_or_else(String::new, |share| format!("{:.0}", 100.0 * share))
                };
                std::iter::once(symmetry.sides()[0].to_owned()).chain(rows.iter().map(share)).collect()
            };
            let head: Vec<String> = std::iter::once("sign of".to_owned())
                .chain(rows.iter().map(|(name, _)| format!("#{name}")))
                .collect();
            Block::table(&head, Symmetry::ALL.into_iter().map(row).collect())
        };
        [
            Block::heading("Both sides of every symmetry"),
            Block::text(
                "A mirror image, reversed parameters and exchanged beams change the signs of these quantities. The table has the \
                 smaller share of the two signs among the compared points, in percent. A sign of zero to rounding is not counted.",
            ),
            table(&regimes),
            Block::details("The same by curve family of either beam", vec![table(&families)]),
        ]
    }

    /// A table with families of the beam as rows and of the bar beam as columns.
    fn by_family(&self) -> Block {
        let families: Vec<Family> = self.found.families.keys().copied().collect();
        let row = |beam: &Family| {
            let met = |bar: &Family| count(self.found.pairs.get(&(*beam, *bar)).copied().unwrap_or(0));
            std::iter::once(beam.name().to_owned()).chain(families.iter().map(met)).collect()
        };
        let head: Vec<String> = std::iter::once("beam \\ bar beam".to_owned())
            .chain(families.iter().map(|family| format!("#{}", family.name())))
            .collect();
        let table = Block::table(&head, families.iter().map(row).collect());
        Block::details("Closest points compared, by curve families of beam and bar beam", vec![table])
    }
}

/// A ratio to two decimals, or to as many as distinguish it from 1 if it is below 1.
fn below_one(ratio: f64) -> String {
    let rounded = |decimals: usize| format!("{ratio:.decimals$}");
    (2..16).map(rounded).find(|text| ratio >= 1.0 || !text.starts_with('1')).unwrap_or_else(|| rounded(2))
}

const SILENCE: [&str; 3] = [
    "Agreement of two methods proves neither right. They share the curves' positions, the closest points and the definitions of \
     the quantities. They share no derivative.",
    "The errors are relative to the terms that are summed, not to the result. Where terms cancel, the result has fewer digits \
     than the table suggests.",
    "Random pairs do not contain configurations of probability zero. Regimes and curve families that are not in the tables were \
     not tested.",
];
