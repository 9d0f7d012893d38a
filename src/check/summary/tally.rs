//! The counts of a regime, and the worst comparisons.

use crate::check::coverage::Coverage;
use crate::check::draw::Case;
use crate::check::element::ContactSituation;
use crate::check::serialized::number;
use crate::check::verdict::{Inconclusive, Order};
use crate::closest_point::ClosestPoint;
use crate::linearization::Quantity;
use crate::test_beam::Family;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// The worst comparison of one order of one quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// The largest error relative to its scale.
    #[serde(with = "number")]
    pub scaled_error: f64,
    /// The case with this error.
    pub case: u64,
    /// The largest error relative to its tolerance.
    #[serde(with = "number")]
    pub over_tolerance: f64,
    /// The number of compared entries.
    pub entries: u64,
}

impl Cell {
    pub(super) fn merge(&mut self, other: &Self) {
        if other.entries == 0 {
            return;
        }
        // Of equal errors the smallest case number is kept, so that the result does not depend on threads.
        if (other.scaled_error, std::cmp::Reverse(other.case))
            > (self.scaled_error, std::cmp::Reverse(self.case))
            || self.entries == 0
        {
            (self.scaled_error, self.case) = (other.scaled_error, other.case);
        }
        self.over_tolerance = self.over_tolerance.max(other.over_tolerance);
        self.entries += other.entries;
    }
}

/// The worst comparisons of contact elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ElementCells {
    /// Those of R.
    pub residual: Cell,
    /// Those of K.
    pub tangent: Cell,
}

impl ElementCells {
    /// Merges the cells of both.
    pub fn merge(&mut self, other: &Self) {
        self.residual.merge(&other.residual);
        self.tangent.merge(&other.tangent);
    }
}

pub(super) fn merge(
    cells: &mut BTreeMap<(Quantity, Order), Cell>,
    others: &BTreeMap<(Quantity, Order), Cell>,
) {
    for (key, cell) in others {
        cells.entry(*key).or_default().merge(cell);
    }
}

/// Points or cases that were not compared for one reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct NotCompared {
    /// The number of points or cases.
    pub count: u64,
    /// The first case of them.
    pub first_case: u64,
}

/// The counts of one regime.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    /// Cases drawn.
    pub cases: u64,
    /// Closest points compared, the ones inside both beams.
    pub interior: u64,
    /// Closest points compared, the ones with an end held.
    pub at_end: u64,
    /// Closest points that did not agree.
    pub mismatches: u64,
    /// The worst scaled error of all.
    pub worst: Cell,
    /// The points or cases that were not compared, by reason.
    pub not_compared: BTreeMap<Inconclusive, NotCompared>,
    /// The comparisons of contact elements, by situation.
    pub elements: BTreeMap<ContactSituation, ElementCells>,
    /// The compared points on both sides of each symmetry.
    pub coverage: Coverage,
    /// The same, by family of either beam.
    pub coverage_of_families: BTreeMap<Family, Coverage>,
}

impl Tally {
    /// The number of points or cases that were not compared.
    pub fn left_out(&self) -> u64 {
        self.not_compared.values().map(|what| what.count).sum()
    }

    pub(super) fn leave_out(&mut self, reason: Inconclusive, what: NotCompared) {
        let sum = self.not_compared.entry(reason).or_insert(NotCompared { count: 0, ..what });
        sum.count += what.count;
        sum.first_case = sum.first_case.min(what.first_case);
    }

    pub(super) fn merge(&mut self, other: &Self) {
        self.cases += other.cases;
        self.interior += other.interior;
        self.at_end += other.at_end;
        self.mismatches += other.mismatches;
        self.worst.merge(&other.worst);
        for (reason, other) in &other.not_compared {
            self.leave_out(*reason, *other);
        }
        for (situation, other) in &other.elements {
            self.elements.entry(*situation).or_default().merge(other);
        }
        self.coverage.merge(&other.coverage);
        for (family, coverage) in &other.coverage_of_families {
            self.coverage_of_families.entry(*family).or_default().merge(coverage);
        }
    }

    /// Counts the sides on which a compared point lies.
    pub(super) fn cover(&mut self, case: &Case, point: &ClosestPoint) {
        let mut coverage = Coverage::default();
        coverage.add(case, point);
        self.coverage.merge(&coverage);
        for family in BTreeSet::from(case.families) {
            self.coverage_of_families.entry(family).or_default().merge(&coverage);
        }
    }
}
