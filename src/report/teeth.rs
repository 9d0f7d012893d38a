//! The record of planted faults, `beamgap-teeth/2`.

use super::number::{finite, rounded};
use super::{Environment, Record};
use crate::check::Regime;
use crate::subject::{Kind, Rewrite};
use crate::teeth::{self, Bite, Check, Limit, Operations, Sampled, Unseen};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the checks made of planted faults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Teeth {
    /// `beamgap-teeth/2`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of the cases and of the pairs of faults.
    pub seed: u64,
    /// Whether the gate and the exact check show every fault and accuse nothing that is right.
    pub holds: bool,
    /// How many faults there are of each kind.
    pub kinds: Vec<(String, usize)>,
    /// What is written another way, and is right.
    pub rewrites: Vec<String>,
    /// The checks, in words.
    pub checks: Vec<(String, String)>,
    /// What each does in each regime.
    pub rows: Vec<BiteRow>,
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
pub struct BiteRow {
    /// The check.
    pub check: String,
    /// The regime, or `-`.
    pub regime: String,
    /// Closest points.
    pub points: usize,
    /// Of these, those at which what is right is accused.
    pub accused: usize,
    /// Faults planted.
    pub planted: usize,
    /// Faults shown.
    pub killed: usize,
    /// Rewrites accused.
    pub false_alarms: Vec<String>,
    /// Pairs of faults planted.
    pub pairs: usize,
    /// Pairs of faults shown.
    pub pairs_killed: usize,
    /// Faults not shown; only counted but in the regime in which the check misses least.
    pub survivors: Vec<String>,
}

/// What became of the operations of one code in one place, each made wrong in several ways.
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
    pub shown: usize,
    /// What is not shown, gathered by the line of the source.
    pub unseen: Vec<UnseenRow>,
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
pub struct UnseenRow {
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
        for Unseen { wrong, at, reason, .. } in &of.unseen {
            let at = at.iter().take(2).map(String::as_str).collect::<Vec<_>>().join(" from ");
            *counts.entry((at, *wrong, *reason)).or_default() += 1;
        }
        let row = |((at, wrong, reason), operations): ((String, &str, Option<&str>), usize)| UnseenRow {
            at,
            wrong: wrong.to_owned(),
            reason: reason.map(ToOwned::to_owned),
            operations,
        };
        let Operations { code, place, operations, faults, shown, .. } = of.clone();
        Self {
            code,
            place: place.to_owned(),
            operations,
            faults,
            shown,
            unseen: counts.into_iter().map(row).collect(),
        }
    }
}

impl Record for Teeth {
    const SCHEMA: &'static str = "beamgap-teeth/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Teeth {
    /// The record of a run.
    pub fn new(
        found: &teeth::Teeth,
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
            rows: found.bites.iter().map(|bite| BiteRow::new(bite, is_best(bite, &found.bites))).collect(),
            operations: operations.iter().map(OperationsRow::new).collect(),
            sampled: sampled.iter().map(SampledRow::new).collect(),
            regimes: regimes.into_iter().map(ToOwned::to_owned).collect(),
            limits: terms.into_iter().collect(),
        }
    }
}

/// Whether the check misses fewer faults elsewhere in no regime, and as few in no earlier one.
fn is_best(bite: &Bite, all: &[Bite]) -> bool {
    let of_check = all.iter().filter(|other| other.check == bite.check);
    of_check.min_by_key(|other| (other.survivors.len(), other.regime)) == Some(bite)
}

impl BiteRow {
    fn new(bite: &Bite, with_survivors: bool) -> Self {
        let survivors = if with_survivors { bite.survivors.as_slice() } else { &[] };
        Self {
            check: bite.check.name().to_owned(),
            regime: bite.regime.map_or("-", Regime::name).to_owned(),
            points: bite.points,
            accused: bite.accused,
            planted: bite.planted,
            killed: bite.planted - bite.survivors.len(),
            false_alarms: bite.false_alarms.iter().map(|rewrite| rewrite.name().to_owned()).collect(),
            pairs: bite.pairs,
            pairs_killed: bite.pairs - bite.pairs_survived.len(),
            survivors: survivors.iter().map(ToString::to_string).collect(),
        }
    }
}
