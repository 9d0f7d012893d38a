//! The detection of faults as a page, from the record alone.

mod other_faults;

use super::faults::Faults;
use super::number::{count, error};
use super::page::{Block, Page};
use crate::check::Regime;
use crate::faults::{Check, Detection, Limit};
use crate::number::Formula;
use crate::variant::{Kind, Rewrite};
use std::collections::BTreeMap;

/// The maximum number of formulas in a cell.
const FORMULAS: usize = 6;

impl Faults {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let verdict = if self.holds { "The check detects every fault" } else { "THE CHECK MISSES SOMETHING" };
        let conclusion = format!(
            "Does the check detect every wrong term? **{verdict}: {} faults in the terms of the closed form, one at a time, in every regime.** It rejects none of {} \
             equivalent formulas. Other checks are measured on the same faults and the same closest points.",
            count(self.terms.faults() as u64),
            Rewrite::ALL.len()
        );
        let of_variations = self.terms.detections.iter().map(|row| row.planted).min().unwrap_or_default();
        let names = format!(
            "*gate* is `beamgap check`, and *exact* is `beamgap prove`. *torch*, *jax*, *scipy* and *taylor* are finite differences \
             by the rules of common tools. {} of the {} faults are in variations. The other checks compare variations only, so only \
             these faults are injected for them. Each row shows the regime with the most detected faults. If several have as many, it \
             shows the one with the fewest rejected points.",
            count(of_variations as u64),
            count(self.terms.faults() as u64)
        );
        let mut blocks = vec![Block::text(&conclusion), Block::text(&names), self.best_regimes()];
        blocks.push(Block::details("What each check does", vec![what_checks_do()]));
        let kinds = self.terms.kinds.iter().map(|(kind, number)| {
            vec![kind.name().to_owned(), what_is_wrong(*kind).to_owned(), count(*number as u64)]
        });
        blocks.extend([
            Block::heading("Faults injected"),
            Block::text(
                "A fault changes one term of one formula in the library's own code. `beamgap faults --list` lists all. \
                 `beamgap check --plant NAME` injects one. [Symbols](symbols.md) explains their names.",
            ),
            Block::details(
                "Faults of each kind",
                vec![Block::table(&["kind", "the term", "#faults"], kinds.collect())],
            ),
        ]);
        blocks.extend(self.missed());
        blocks.extend(self.single_operations());
        blocks.extend(self.faults_of_search());
        blocks.extend(self.of_elements());
        blocks.extend(self.one_sided());
        blocks.extend(self.of_gate());
        blocks.extend(self.detection_limits());
        blocks.extend([
            Block::heading("How it was made"),
            Block::text(
                "This page is made from `faults.json` alone. There are also the results of each check in every regime, the faults \
                 that it does not detect, those of single operations by code and place, and all detection limits.",
            ),
            self.environment.table(vec![("seed", format!("{:#x}", self.seed))]),
        ]);
        Page::new("Faults", blocks)
    }

    /// Each check in the regime with the most detected faults. Of several such regimes, the one with the most accepted points.
    fn best_regimes(&self) -> Block {
        let rows = Check::ALL.into_iter().filter_map(|check| {
            let row = self.best(check)?;
            let cells = [
                check.name().to_owned(),
                regime_of(row),
                format!("{} of {}", count(row.detected as u64), count(row.planted as u64)),
                format!("{} of {}", row.false_positives.len(), Rewrite::ALL.len()),
            ];
            Some(cells.to_vec())
        });
        let head =
            ["check", "regime with the most detected", "#faults detected", "#equivalent formulas rejected"];
        Block::table(&head, rows.collect())
    }

    fn best(&self, check: Check) -> Option<&Detection> {
        let of_check = self.terms.detections.iter().filter(|row| row.check == check);
        of_check.min_by_key(|row| (row.planted - row.detected, row.rejected))
    }

    /// The faults that other checks do not detect, in the best regime of each check.
    fn missed(&self) -> Vec<Block> {
        let rows = Check::ALL.into_iter().filter_map(|check| {
            let row = self.best(check).filter(|row| row.detected < row.planted)?;
            let mut formulas: BTreeMap<&str, usize> = BTreeMap::new();
            for fault in self.terms.missed_by(check, row.regime) {
                *formulas
                    .entry(Formula::of_term(fault).map_or(fault, |(formula, _)| formula.name()))
                    .or_default() += 1;
            }
            let mut formulas: Vec<_> = formulas.into_iter().collect();
            formulas.sort_by_key(|&(name, count)| (usize::MAX - count, name));
            let others: usize = formulas.iter().skip(FORMULAS).map(|(_, count)| count).sum();
            let mut listed: Vec<_> =
                formulas.iter().take(FORMULAS).map(|(name, count)| format!("{count} in `{name}`")).collect();
            listed.extend((others > 0).then(|| format!("{others} in others")));
            let missed = format!("{} of {}", row.planted - row.detected, row.planted);
            Some(vec![check.name().to_owned(), regime_of(row), missed, listed.join(", ")])
        });
        let head = ["check", "regime", "#undetected", "in the formulas"];
        let table = Block::table(&head, rows.collect());
        vec![Block::details("Undetected faults of the other checks, in these regimes", vec![table])]
    }

    /// The results for single operations.
    fn single_operations(&self) -> Vec<Block> {
        let (faults, detected) = self
            .operations
            .iter()
            .fold((0, 0), |(faults, detected), row| (faults + row.faults, detected + row.detected));
        let mut reasons: BTreeMap<&str, u64> = BTreeMap::new();
        for undetected in self.operations.iter().flat_map(|row| &row.undetected) {
            *reasons.entry(undetected.reason.as_deref().unwrap_or("NOT COVERED")).or_default() +=
                undetected.operations as u64;
        }
        let reasons =
            reasons.into_iter().map(|(reason, operations)| vec![reason.to_owned(), count(operations)]);
        let sampled = self.sampled.iter().map(|row| {
            let counts = [row.operations, row.faults, row.detected].map(|number| count(number as u64));
            [row.regime.name(), row.code.name()].map(str::to_owned).into_iter().chain(counts).collect()
        });
        let sampled =
            Block::table(&["regime", "code", "#operations", "#faults", "#detected"], sampled.collect());
        vec![
            Block::heading("Faults of single operations"),
            Block::text(&format!(
                "{} faults of single operations were injected over a prime field; {} are detected. The others change no result, each \
                 for a stated reason. An operation gets the opposite sign, or its result is zero, doubled or \
                 one too large, or it is the result of another run: with directions exchanged, beams exchanged, the beam in \
                 place of the bar beam, or other parameters.",
                count(faults as u64),
                count(detected as u64)
            )),
            Block::details(
                "Why a fault changes no result",
                vec![Block::table(&["reason", "#operations with such a fault"], reasons.collect())],
            ),
            Block::details(
                "A sample in f64",
                vec![
                    Block::text(
                        "The operations are spread evenly over the code and the points of each regime. Their results are multiplied by \
                     -1, 0 and 2. A fault is detected if a number exceeds its tolerance. A fault that is not detected changes all \
                     numbers by less than their tolerance.",
                    ),
                    sampled,
                ],
            ),
        ]
    }

    fn detection_limits(&self) -> Vec<Block> {
        let rows = Regime::ALL.into_iter().filter_map(|regime| {
            let of_term = |(term, limits): (&'_ String, &BTreeMap<Regime, Limit>)| {
                let Limit(limit) = *limits.get(&regime)?;
                limit.is_finite().then(|| (limit, term.clone()))
            };
            let mut limits: Vec<(f64, String)> = self.limits.iter().filter_map(of_term).collect();
            limits.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (middle, (last, term)) = (limits.get(limits.len() / 2)?.0, limits.last()?);
            Some(vec![regime.name().to_owned(), error(Some(middle)), error(Some(*last)), format!("`{term}`")])
        });
        let head = ["regime", "#median of all terms", "#largest", "of the term"];
        vec![
            Block::heading("Detection limits of the check"),
            Block::text(
                "A detection limit is the smallest relative error of a term that the check detects, at the most sensitive point. \
                 [Symbols](symbols.md) explains the names of terms.",
            ),
            Block::details("Detection limits by regime", vec![Block::table(&head, rows.collect())]),
        ]
    }
}

fn what_checks_do() -> Block {
    let rows = Check::ALL.map(|check| [check.name(), check.what()].map(str::to_owned).to_vec());
    Block::table(&["check", "what it does"], rows.to_vec())
}

fn regime_of(row: &Detection) -> String {
    row.regime.map_or("-", Regime::name).to_owned()
}

/// The effect of each kind of fault on a term.
fn what_is_wrong(kind: Kind) -> &'static str {
    match kind {
        Kind::Sign => "has the opposite sign",
        Kind::Dropped => "is missing",
        Kind::Doubled => "is doubled",
        Kind::Halved => "is halved",
        Kind::Transposed => "is transposed: its two directions are exchanged",
        Kind::Swapped => "has the beams exchanged",
        Kind::BarForgotten => "takes the beam where the bar beam belongs",
        Kind::Stale => "is evaluated at the parameters of the step before",
    }
}
