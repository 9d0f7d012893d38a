//! The record of the gate, `beamgap-crosscheck/1`.

use super::number::finite;
use super::{Environment, Record};
use crate::check::{Cell, Comparison, Summary};
use serde::{Deserialize, Serialize};

/// What a run of the gate found, and where.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crosscheck {
    /// `beamgap-crosscheck/1`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of all cases.
    pub seed: u64,
    /// The cases of each regime.
    pub cases_per_regime: u64,
    /// Closest points that were compared.
    pub points: u64,
    /// The worst of each quantity and order.
    pub quantities: Vec<Worst>,
    /// The counts of each regime.
    pub regimes: Vec<RegimeRow>,
    /// Closest points compared, by family of either beam.
    pub families: Vec<(String, u64)>,
    /// Closest points compared, by families of beam and bar beam.
    pub pairs: Vec<Pair>,
    /// The cases that did not agree.
    pub mismatches: Vec<Mismatch>,
}

/// The worst of one order of one quantity. An error that JSON cannot hold, because it is infinite or not a number, is null.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Worst {
    /// The quantity.
    pub quantity: String,
    /// Which part of it.
    pub order: String,
    /// The largest error over its scale.
    pub scaled_error: Option<f64>,
    /// The case that shows it.
    pub case: u64,
    /// The largest error over its tolerance.
    pub over_tolerance: Option<f64>,
    /// How many entries were compared.
    pub entries: u64,
}

/// The counts of one regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RegimeRow {
    /// The regime.
    pub regime: String,
    /// Cases drawn.
    pub cases: u64,
    /// Closest points compared, inside both beams.
    pub interior: u64,
    /// Closest points compared, at an end.
    pub at_end: u64,
    /// Closest points that did not agree.
    pub mismatches: u64,
    /// The largest error over its scale.
    pub scaled_error: Option<f64>,
    /// The case that shows it.
    pub case: u64,
    /// The largest error over its tolerance.
    pub over_tolerance: Option<f64>,
    /// What was not compared.
    pub not_compared: Vec<NotCompared>,
}

/// Points or cases that were not compared for one reason.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotCompared {
    /// The reason.
    pub reason: String,
    /// How many.
    pub count: u64,
    /// The first case of them.
    pub first_case: u64,
}

/// How often two families met.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// The family of the beam.
    pub beam: String,
    /// The family of the bar beam.
    pub bar: String,
    /// Closest points compared.
    pub points: u64,
}

/// The entry that is furthest off, of a case that did not agree.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mismatch {
    /// The case.
    pub case: u64,
    /// The quantity.
    pub quantity: String,
    /// Which part of it.
    pub order: String,
    /// What it was compared with.
    pub against: String,
    /// The closed form's number.
    pub closed: Option<f64>,
    /// The other number.
    pub other: Option<f64>,
    /// The largest difference that rounding explains.
    pub tolerance: Option<f64>,
}

impl Record for Crosscheck {
    const SCHEMA: &'static str = "beamgap-crosscheck/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Crosscheck {
    /// The record of a run.
    pub fn new(summary: &Summary, seed: u64, cases_per_regime: u64, environment: Environment) -> Self {
        let worst = |(quantity, order, cell): (&str, &str, &Cell)| Worst {
            quantity: quantity.to_owned(),
            order: order.to_owned(),
            scaled_error: finite(cell.scaled_error),
            case: cell.case,
            over_tolerance: finite(cell.over_tolerance),
            entries: cell.entries,
        };
        let cells =
            summary.cells.iter().map(|((quantity, order), cell)| (quantity.name(), order.name(), cell));
        let regimes = summary.regimes.iter().map(|(regime, tally)| RegimeRow {
            regime: regime.name().to_owned(),
            cases: tally.cases,
            interior: tally.interior,
            at_end: tally.at_end,
            mismatches: tally.mismatches,
            scaled_error: finite(tally.worst.scaled_error),
            case: tally.worst.case,
            over_tolerance: finite(tally.worst.over_tolerance),
            not_compared: (tally.inconclusive.iter())
                .map(|(reason, &(count, first_case))| NotCompared {
                    reason: reason.reason().to_owned(),
                    count,
                    first_case,
                })
                .collect(),
        });
        let families = summary.families.iter().map(|(family, &points)| (family.name().to_owned(), points));
        let pairs = summary.pairs.iter().map(|((beam, bar), &points)| Pair {
            beam: beam.name().to_owned(),
            bar: bar.name().to_owned(),
            points,
        });
        Self {
            schema: Self::SCHEMA.to_owned(),
            environment,
            seed,
            cases_per_regime,
            points: summary.compared(),
            quantities: cells.map(worst).collect(),
            regimes: regimes.collect(),
            families: families.collect(),
            pairs: pairs.collect(),
            mismatches: summary.mismatches.iter().map(|(&case, entry)| Mismatch::new(case, entry)).collect(),
        }
    }
}

impl Mismatch {
    fn new(case: u64, entry: &Comparison) -> Self {
        Self {
            case,
            quantity: entry.quantity.name().to_owned(),
            order: entry.order.name().to_owned(),
            against: entry.against.to_owned(),
            closed: finite(entry.closed),
            other: finite(entry.other),
            tolerance: finite(entry.tolerance),
        }
    }
}
