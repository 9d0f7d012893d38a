//! The result of a run of the check, independent of the order of the cases.

mod tally;

use super::arbitration::{Arbitration, DIFFERENCES};
use super::counts::Counts;
use super::diagnosis::Finding;
use super::draw::Case;
use super::evaluation_point::is_of_residual;
use super::independent_search::SearchTally;
use super::regime::Regime;
use super::serialized::{Name, name, nested};
use super::verdict::{Comparison, Order, Verdict, is_decided};
use crate::closest_point::ClosestPoint;
use crate::linearization::Quantity;
use crate::test_beam::Family;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use tally::merge;

pub use tally::{Cell, ElementCells, NotCompared, Tally};

/// The result of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The worst errors, by quantity and order; those with respect to the differences are in `differences`.
    #[serde(with = "nested")]
    pub quantities: BTreeMap<(Quantity, Order), Cell>,
    /// The counts, by regime.
    pub regimes: BTreeMap<Regime, Tally>,
    /// The number of compared closest points, by family of either beam.
    pub families: BTreeMap<Family, u64>,
    /// The number of compared closest points, by pair of families.
    #[serde(with = "nested")]
    pub pairs: BTreeMap<(Family, Family), u64>,
    /// The cases that did not agree, by number.
    pub mismatches: BTreeMap<u64, Mismatch>,
    /// The results of the differences in double-double.
    pub differences: Differences,
    /// The comparison of the search for closest points with an independent search.
    #[serde(default)]
    pub search: SearchTally,
    /// What was compared, by blocks of cases, to be held against a record.
    #[serde(default)]
    pub counts: Counts,
}

/// A case that did not agree.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mismatch {
    /// The first wrong number.
    pub kind: Option<MismatchKind>,
    /// The wrong side.
    pub arbitration: Option<Arbitration>,
    /// The entry with the largest error.
    pub worst: Comparison,
}

/// The first wrong number, in the order of computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct MismatchKind {
    /// The code that computes the number.
    #[serde(deserialize_with = "name")]
    pub candidate: Name,
    /// The order of the number.
    pub order: Order,
    /// Its quantity.
    pub quantity: Quantity,
}

impl MismatchKind {
    /// The kind of a mismatch whose first wrong number is this one.
    pub fn of(&Comparison { order, quantity, against, .. }: &Comparison) -> Self {
        // The matrices and the functions are compared with the equations, the equations with the references.
        let candidate = match order {
            Order::Matrix => "matrices",
            Order::Function => against,
            _ => "equations",
        };
        Self { candidate, order, quantity }
    }
}

/// Closest points at which the differences in double-double were computed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Differences {
    /// Points with a result.
    pub points: u64,
    /// Of these, points where the tolerance for AD is not meaningful, for some number.
    pub unclear: u64,
    /// Of these, points where the differences decided.
    pub decided: u64,
    /// The worst errors with respect to them, by quantity and order.
    #[serde(with = "nested")]
    pub quantities: BTreeMap<(Quantity, Order), Cell>,
}

impl Differences {
    fn add(&mut self, verdict: &Verdict) {
        let entries = verdict.entries();
        if !entries.iter().any(|entry| entry.against == DIFFERENCES) {
            return;
        }
        self.points += 1;
        if !is_decided(entries.iter().filter(|entry| entry.against != DIFFERENCES)) {
            self.unclear += 1;
            self.decided += u64::from(!matches!(verdict, Verdict::Inconclusive(..)));
        }
    }

    fn merge(&mut self, other: &Self) {
        merge(&mut self.quantities, &other.quantities);
        self.points += other.points;
        self.unclear += other.unclear;
        self.decided += other.decided;
    }
}

impl Summary {
    /// The summary of one case.
    pub fn of(case: &Case, verdicts: &[(Option<ClosestPoint>, Verdict)]) -> Self {
        let mut summary = Self::default();
        summary.add(case, verdicts);
        summary
    }

    /// Adds a case.
    pub(super) fn add(&mut self, case: &Case, verdicts: &[(Option<ClosestPoint>, Verdict)]) {
        let tally = self.regimes.entry(case.regime).or_default();
        tally.cases += 1;
        let mut cells = [[[Cell::default(); 2]; Order::ALL.len()]; Quantity::ALL.len()];
        let mut compared = 0;
        for (point, verdict) in verdicts {
            self.differences.add(verdict);
            let entries = match verdict {
                Verdict::Inconclusive(reason, _) => {
                    tally.leave_out(*reason, NotCompared { count: 1, first_case: case.number });
                    continue;
                }
                Verdict::Pass(entries) => entries,
                Verdict::Mismatch(entries) => {
                    tally.mismatches += 1;
                    let earlier = self.mismatches.remove(&case.number);
                    // A comparison with the differences is listed only if no other one is wrong.
                    let rank = |entry: &Comparison| (entry.is_wrong(), entry.against != DIFFERENCES);
                    let meaningful = entries.iter().filter(|entry| entry.is_meaningful()).copied();
                    let worst = meaningful.chain(earlier.map(|earlier| earlier.worst)).max_by(|a, b| {
                        rank(a).cmp(&rank(b)).then(a.over_tolerance().total_cmp(&b.over_tolerance()))
                    });
                    let arbitrated = earlier.and_then(|earlier| earlier.arbitration).into_iter();
                    let arbitration = arbitrated.chain(Arbitration::of(entries)).reduce(Arbitration::and);
                    let mismatch = worst.map(|worst| Mismatch { kind: None, arbitration, worst });
                    self.mismatches.extend(mismatch.map(|mismatch| (case.number, mismatch)));
                    entries
                }
            };
            if point.is_some_and(|point| point.is_interior()) {
                tally.interior += 1;
            } else {
                tally.at_end += 1;
            }
            if let Some(point) = point {
                tally.cover(case, point);
            }
            compared += 1;
            for entry in entries.iter().filter(|entry| entry.is_meaningful()) {
                let by_differences = usize::from(entry.against == DIFFERENCES);
                let cell = Cell {
                    scaled_error: entry.scaled_error(),
                    case: case.number,
                    over_tolerance: entry.over_tolerance(),
                    entries: 1,
                };
                cells[entry.quantity as usize][entry.order as usize][by_differences].merge(&cell);
                for situation in entry.situations.iter() {
                    let ElementCells { residual, tangent } = tally.elements.entry(situation).or_default();
                    if is_of_residual(entry) { residual } else { tangent }.merge(&cell);
                }
            }
        }
        for (quantity, cells) in Quantity::ALL.into_iter().zip(cells) {
            for (order, [cell, by_differences]) in Order::ALL.into_iter().zip(cells) {
                if cell.entries > 0 {
                    self.quantities.entry((quantity, order)).or_default().merge(&cell);
                    tally.worst.merge(&cell);
                }
                if by_differences.entries > 0 {
                    self.differences.quantities.entry((quantity, order)).or_default().merge(&by_differences);
                }
            }
        }
        if let Some(mismatch) = self.mismatches.get_mut(&case.number) {
            mismatch.kind = Finding::of(verdicts).map(|finding| MismatchKind::of(&finding.entry));
        }
        if compared > 0 {
            *self.pairs.entry((case.families[0], case.families[1])).or_default() += compared;
            for family in case.families {
                *self.families.entry(family).or_default() += compared;
            }
        }
    }

    /// The sum of both summaries.
    #[must_use]
    pub fn merge(mut self, other: Self) -> Self {
        merge(&mut self.quantities, &other.quantities);
        for (regime, tally) in &other.regimes {
            self.regimes.entry(*regime).or_default().merge(tally);
        }
        for (family, count) in other.families {
            *self.families.entry(family).or_default() += count;
        }
        for (pair, count) in other.pairs {
            *self.pairs.entry(pair).or_default() += count;
        }
        self.mismatches.extend(other.mismatches);
        self.differences.merge(&other.differences);
        self.search.merge(other.search);
        self.counts.merge(other.counts);
        self
    }

    /// Closest points that were compared.
    pub fn compared(&self) -> u64 {
        self.regimes.values().map(|tally| tally.interior + tally.at_end).sum()
    }
}

#[cfg(test)]
mod tests;
