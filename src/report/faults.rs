//! The record of planted faults, `beamgap-faults/1`.

use super::number::{finite, rounded};
use super::{Environment, Record};
use crate::check::Regime;
use crate::faults::{self, Check, Detection, Limit, Operations, Sampled, Undetected};
use crate::variant::{Kind, Rewrite};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the checks made of planted faults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Faults {
    /// `beamgap-faults/1`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of the cases and of the pairs of faults.
    pub seed: u64,
    /// Whether the gate and the exact check show every fault and reject nothing that is right.
    pub holds: bool,
    /// How many faults there are of each kind.
    pub kinds: Vec<(String, usize)>,
    /// What is written in another way, and is right.
    pub rewrites: Vec<String>,
    /// The checks, in words.
    pub checks: Vec<(String, String)>,
    /// What each does in each regime.
    pub rows: Vec<DetectionRow>,
    /// The faults that a check does not show, by check and by the regimes in which it does not.
    pub undetected: Vec<UndetectedRow>,
    /// What became of single operations, by code and place.
    pub operations: Vec<OperationsRow>,
    /// What became of a sample of operations in `f64`, by regime and code.
    pub sampled: Vec<SampledRow>,
    /// The regimes of `limits`.
    pub regimes: Vec<String>,
    /// The detection limits of each term, in the order of `regimes`; null where nothing moves.
    pub limits: Vec<(String, Vec<Option<f64>>)>,
}

/// What one check does in one regime.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct DetectionRow {
    /// The check.
    pub check: String,
    /// The regime, or `-`.
    pub regime: String,
    /// Closest points.
    pub points: usize,
    /// Of these, those at which what is right is rejected.
    pub rejected: usize,
    /// Faults planted.
    pub planted: usize,
    /// Faults detected.
    pub detected: usize,
    /// Rewrites rejected.
    pub false_positives: Vec<String>,
    /// Pairs of faults planted.
    pub pairs: usize,
    /// Pairs of faults detected.
    pub pairs_detected: usize,
}

/// Faults that one check does not show in the same regimes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct UndetectedRow {
    /// The check.
    pub check: String,
    /// The regimes, or `-`.
    pub regimes: Vec<String>,
    /// The faults: detected in all other regimes.
    pub faults: Vec<String>,
}

/// What became of the operations of one code in one place, each made wrong in several methods.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct OperationsRow {
    /// The code.
    pub code: String,
    /// The form, and which ends hold a parameter.
    pub place: String,
    /// Operations.
    pub operations: usize,
    /// Faults that change the result of one.
    pub faults: usize,
    /// Faults that change a number that comes out.
    pub detected: usize,
    /// What is not detected, gathered by the line of the source.
    pub undetected: Vec<UndetectedOperations>,
}

/// What became of a sample of operations of one code in one regime, each multiplied by -1, 0 and 2.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SampledRow {
    /// The regime.
    pub regime: String,
    /// The code.
    pub code: String,
    /// Operations, at all points.
    pub operations: usize,
    /// Faults that change a number.
    pub faults: usize,
    /// Faults that exceed a tolerance.
    pub detected: usize,
    /// By quantity: operations that it depends on, and the median and the largest of their detection limits.
    pub limits: Vec<(String, usize, [f64; 2])>,
}

impl SampledRow {
    fn new(of: &Sampled) -> Self {
        let limits = of.limits.iter().filter_map(|(quantity, limits)| {
            let (middle, last) = (limits.get(limits.len() / 2)?, limits.last()?);
            Some((quantity.name().to_owned(), limits.len(), [middle, last].map(|&limit| rounded(limit, 2))))
        });
        Self {
            regime: of.regime.name().to_owned(),
            code: of.code.name().to_owned(),
            operations: of.operations,
            faults: of.faults,
            detected: of.detected,
            limits: limits.collect(),
        }
    }
}

/// Operations that no number depends on.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct UndetectedOperations {
    /// The line of the source, and the line that calls it; empty if the build does not know lines.
    pub at: String,
    /// What was wrong.
    pub wrong: String,
    /// Why that is right, if it is known.
    pub reason: Option<String>,
    /// How many operations.
    pub operations: usize,
}

impl OperationsRow {
    fn new(of: &Operations) -> Self {
        let mut counts: BTreeMap<_, usize> = BTreeMap::new();
        for Undetected { wrong, at, reason, .. } in &of.undetected {
            let at = at.iter().take(2).map(String::as_str).collect::<Vec<_>>().join(" from ");
            *counts.entry((at, *wrong, *reason)).or_default() += 1;
        }
        let row =
            |((at, wrong, reason), operations): ((String, &str, Option<&str>), usize)| UndetectedOperations {
                at,
                wrong: wrong.to_owned(),
                reason: reason.map(ToOwned::to_owned),
                operations,
            };
        let Operations { code, place, operations, faults, detected, .. } = of.clone();
        Self {
            code,
            place: place.to_owned(),
            operations,
            faults,
            detected,
            undetected: counts.into_iter().map(row).collect(),
        }
    }
}

impl Record for Faults {
    const SCHEMA: &'static str = "beamgap-faults/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Faults {
    /// The faults that a check does not show in a regime.
    pub fn undetected_by(&self, row: &DetectionRow) -> impl Iterator<Item = &str> {
        let is_of = |of: &&UndetectedRow| of.check == row.check && of.regimes.contains(&row.regime);
        self.undetected.iter().filter(is_of).flat_map(|of| of.faults.iter().map(String::as_str))
    }

    /// The record of a run.
    pub fn new(
        found: &faults::Injected,
        limits: &[Limit],
        operations: &[Operations],
        sampled: &[Sampled],
        seed: u64,
        environment: Environment,
    ) -> Self {
        let count = |kind: Kind| found.faults.iter().filter(|fault| fault.kind == kind).count();
        let mut regimes: Vec<&str> = Vec::new();
        let mut terms: BTreeMap<String, Vec<Option<f64>>> = BTreeMap::new();
        for &Limit { regime, label, limit } in limits {
            if !regimes.contains(&regime.name()) {
                regimes.push(regime.name());
            }
            terms.entry(label.to_string()).or_default().push(finite(limit).map(|limit| rounded(limit, 2)));
        }
        Self {
            schema: Self::SCHEMA.to_owned(),
            environment,
            seed,
            holds: found.holds() && operations.iter().all(Operations::is_whole),
            kinds: Kind::ALL.map(|kind| (kind.name().to_owned(), count(kind))).to_vec(),
            rewrites: Rewrite::ALL.map(|rewrite| rewrite.name().to_owned()).to_vec(),
            checks: Check::ALL.map(|check| (check.name().to_owned(), check.what().to_owned())).to_vec(),
            rows: found.detections.iter().map(DetectionRow::new).collect(),
            undetected: undetected(found),
            operations: operations.iter().map(OperationsRow::new).collect(),
            sampled: sampled.iter().map(SampledRow::new).collect(),
            regimes: regimes.into_iter().map(ToOwned::to_owned).collect(),
            limits: terms.into_iter().collect(),
        }
    }
}

/// The faults that survive, by check and regimes, in the order of the catalogue.
fn undetected(found: &faults::Injected) -> Vec<UndetectedRow> {
    let mut rows = Vec::new();
    for check in Check::ALL {
        let detections: Vec<&Detection> =
            found.detections.iter().filter(|detection| detection.check == check).collect();
        let mut faults: BTreeMap<Vec<usize>, Vec<String>> = BTreeMap::new();
        for fault in &found.faults {
            let is_undetected = |&i: &usize| detections[i].undetected.contains(fault);
            let regimes: Vec<usize> = (0..detections.len()).filter(is_undetected).collect();
            if !regimes.is_empty() {
                faults.entry(regimes).or_default().push(fault.to_string());
            }
        }
        rows.extend(faults.into_iter().map(|(regimes, faults)| UndetectedRow {
            check: check.name().to_owned(),
            regimes: regimes.into_iter().map(|i| regime_name(detections[i].regime).to_owned()).collect(),
            faults,
        }));
    }
    rows
}

fn regime_name(regime: Option<Regime>) -> &'static str {
    regime.map_or("-", Regime::name)
}

impl DetectionRow {
    fn new(detection: &Detection) -> Self {
        Self {
            check: detection.check.name().to_owned(),
            regime: regime_name(detection.regime).to_owned(),
            points: detection.points,
            rejected: detection.rejected,
            planted: detection.planted,
            detected: detection.planted - detection.undetected.len(),
            false_positives: detection
                .false_positives
                .iter()
                .map(|rewrite| rewrite.name().to_owned())
                .collect(),
            pairs: detection.pairs,
            pairs_detected: detection.pairs - detection.pairs_undetected.len(),
        }
    }
}
