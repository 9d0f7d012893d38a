//! The comparison of the check as Markdown, from the record alone.

use super::crosscheck::{Crosscheck, RegimeRow};
use super::number::{count, error};
use std::collections::BTreeMap;
use std::fmt::Write;

impl Crosscheck {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let mut page = String::from("# Crosscheck\n\n");
        let mismatches: u64 = self.regimes.iter().map(|regime| regime.mismatches).sum();
        let entries: u64 = self.quantities.iter().map(|worst| worst.entries).sum();
        let cases: u64 = self.regimes.iter().map(|regime| regime.cases).sum();
        let not_compared: u64 =
            self.regimes.iter().flat_map(|regime| &regime.not_compared).map(|what| what.count).sum();
        let _ = writeln!(
            page,
            "This report compares the closed form with automatic differentiation. Of {} random pairs of beams, {} closest \
             points were compared in {} numbers: **{}**. Points or cases that could not be compared: {}.\n",
            count(cases),
            count(self.points),
            count(entries),
            match mismatches {
                0 => "no mismatch".to_owned(),
                1 => "1 point does not agree".to_owned(),
                n => format!("{} points do not agree", count(n)),
            },
            count(not_compared),
        );
        page.push_str(&self.mismatches_listed());
        page.push_str(&self.by_quantity());
        page.push_str(&self.by_regime());
        page.push_str(&self.by_reason());
        page.push_str(&self.by_family());
        let _ = write!(
            page,
            "\n## How it was made\n\n{}| seed | {:#x} |\n| cases of each regime | {} |\n\n\
             A case is drawn from the seed and its number alone. All numbers are in `crosscheck.json`, from which alone this \
             page is made.\n",
            self.environment.rows(),
            self.seed,
            count(self.cases_per_regime),
        );
        page.push_str(SILENCE);
        page
    }

    fn mismatches_listed(&self) -> String {
        if self.mismatches.is_empty() {
            return String::new();
        }
        let mut rows = String::from(
            "## Mismatches\n\n| case | quantity | order | against | closed form | other | tolerance |\n\
             |---:|---|---|---|---:|---:|---:|\n",
        );
        let number = |x: Option<f64>| x.map_or_else(|| "not finite".to_owned(), |x| format!("{x:e}"));
        for entry in &self.mismatches {
            let _ = writeln!(
                rows,
                "| {} | {} | {} | {} | {} | {} | {} |",
                entry.case,
                entry.quantity,
                entry.order,
                entry.against,
                number(entry.closed),
                number(entry.other),
                error(entry.tolerance),
            );
        }
        rows + "\n"
    }

    /// Quantities down, orders across.
    fn by_quantity(&self) -> String {
        let (mut quantities, mut orders): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
        for worst in &self.quantities {
            for (known, name) in [(&mut quantities, &worst.quantity), (&mut orders, &worst.order)] {
                if !known.contains(&name.as_str()) {
                    known.push(name);
                }
            }
        }
        let mut rows = String::from(
            "## Worst errors by quantity\n\n\
             The largest |closed form − other| over its scale, the sum of the absolute values of the terms; in brackets the \
             case that shows it. *value*: the quantity; *first*: delta and Delta; *second*: Delta-delta; *symmetry*: \
             Delta-delta with the directions exchanged; *matrix*: gradient and Hessian, contracted with the directions.\n\n",
        );
        let _ =
            writeln!(rows, "| quantity | {} |\n|---|{}", orders.join(" | "), "---:|".repeat(orders.len()));
        for quantity in quantities {
            let _ = write!(rows, "| {quantity} |");
            for order in &orders {
                let at =
                    self.quantities.iter().find(|worst| worst.quantity == quantity && worst.order == *order);
                let text = at.map(|worst| format!("{} ({})", error(worst.scaled_error), worst.case));
                let _ = write!(rows, " {} |", text.unwrap_or_default());
            }
            rows.push('\n');
        }
        rows
    }

    fn by_regime(&self) -> String {
        let mut rows = String::from(
            "\n## Regimes\n\n\
             The tolerance is a bound on the rounding of both sides, entry by entry: above 1 they disagree.\n\n\
             | regime | cases | points inside | points at ends | mismatches | not compared | worst error (case) | \
             worst over tolerance |\n|---|---:|---:|---:|---:|---:|---:|---:|\n",
        );
        for regime in &self.regimes {
            let RegimeRow { regime: name, not_compared, .. } = regime;
            let _ = writeln!(
                rows,
                "| {name} | {} | {} | {} | {} | {} | {} ({}) | {} |",
                count(regime.cases),
                count(regime.interior),
                count(regime.at_end),
                count(regime.mismatches),
                count(not_compared.iter().map(|what| what.count).sum()),
                error(regime.scaled_error),
                regime.case,
                regime.over_tolerance.map_or_else(|| "not finite".to_owned(), |over| format!("{over:.2}")),
            );
        }
        rows
    }

    fn by_reason(&self) -> String {
        let mut rows = String::from("\n## Not compared\n\n");
        if self.regimes.iter().all(|regime| regime.not_compared.is_empty()) {
            return rows + "Nothing was left out.\n";
        }
        rows.push_str(
            "What is here was neither passed nor failed.\n\n| reason | regime | count | first case |\n",
        );
        rows.push_str("|---|---|---:|---:|\n");
        for regime in &self.regimes {
            for what in &regime.not_compared {
                let (name, count) = (&regime.regime, count(what.count));
                let _ = writeln!(rows, "| {} | {name} | {count} | {} |", what.reason, what.first_case);
            }
        }
        rows
    }

    /// Families of the beam down, of the bar beam across.
    fn by_family(&self) -> String {
        let mut rows =
            String::from("\n## Coverage\n\nClosest points compared, by families of beam and bar beam.\n\n");
        let met: BTreeMap<_, _> =
            self.pairs.iter().map(|pair| ((pair.beam.as_str(), pair.bar.as_str()), pair.points)).collect();
        let names: Vec<&str> = self.families.iter().map(|(name, _)| name.as_str()).collect();
        let _ = writeln!(
            rows,
            "| beam \\ bar beam | {} |\n|---|{}",
            names.join(" | "),
            "---:|".repeat(names.len())
        );
        for beam in &names {
            let _ = write!(rows, "| {beam} |");
            for bar in &names {
                let _ = write!(rows, " {} |", count(met.get(&(*beam, *bar)).copied().unwrap_or(0)));
            }
            rows.push('\n');
        }
        rows
    }
}

const SILENCE: &str = "
## What these numbers do not say

- That two methods agree does not prove either right: they share the curves' positions, the closest points and the
  definitions of the quantities. What they do not share is every derivative.
- The errors are relative to the terms that are summed, not to the result. Where terms cancel, the result has fewer
  digits than the table suggests; the tolerance knows of that, the error does not.
- Random pairs, however many, visit no configuration that has probability zero, and the regimes are those that were
  thought of.
- What could not be compared was not compared. Its counts are above, and are no success.
- Nothing is said about families of curves that are not in the coverage table.
";
