//! Runs all checks on all faults and rewrites.

use super::check::Check;
use super::exact::Exact;
use super::test_points::{Sample, test_points};
use crate::check::Regime;
use crate::check::serialized::by_name;
use crate::parallel;
use crate::variant::{Fault, Kind, Rewrite, Variant, catalogue, terms};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The number of pairs of faults that are injected together, in each regime.
const PAIRS: usize = 200;
/// The minimum number of faults in the catalogue.
const FAULTS: usize = 200;

by_name!(Kind, Rewrite);

/// The results of one check in one regime.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Detection {
    /// The check.
    pub check: Check,
    /// The regime; none for the exact check.
    pub regime: Option<Regime>,
    /// The number of closest points.
    pub points: usize,
    /// Of these, the number at which the check rejects the correct closed form. The results of the check there are not
    /// counted.
    pub rejected: usize,
    /// The number of injected faults. Faults of the matrices are injected only for a check that compares matrices.
    pub planted: usize,
    /// The number of faults that the check detects.
    pub detected: usize,
    /// The correct rewrites that the check rejects.
    pub false_positives: Vec<Rewrite>,
    /// The number of pairs of faults, injected together.
    pub pairs: usize,
    /// The number of pairs that the check detects.
    pub pairs_detected: usize,
}

/// Faults that one check does not detect in the same regimes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Missed {
    /// The check.
    pub check: Check,
    /// The regimes; none for the exact check.
    pub regimes: Vec<Option<Regime>>,
    /// The names of the faults. The check detects them in all other regimes.
    pub faults: Vec<String>,
}

/// The results of all checks.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Injected {
    /// The number of faults of each kind.
    pub kinds: BTreeMap<Kind, usize>,
    /// The detections, by check, then by regime.
    pub detections: Vec<Detection>,
    /// The undetected faults, by check and regimes.
    pub missed: Vec<Missed>,
}

impl Detection {
    /// Whether the check detects every fault and rejects nothing that is correct.
    pub fn is_whole(&self) -> bool {
        self.points > 0
            && self.rejected == 0
            && self.detected == self.planted
            && self.false_positives.is_empty()
            && self.pairs_detected == self.pairs
    }
}

impl Injected {
    /// Whether the gate and the exact check detect all faults, in every regime, and reject nothing that is correct.
    pub fn holds(&self) -> bool {
        let ours = |detection: &&Detection| matches!(detection.check, Check::Gate | Check::Exact);
        self.faults() >= FAULTS && self.detections.iter().filter(ours).all(Detection::is_whole)
    }

    /// The number of faults.
    pub fn faults(&self) -> usize {
        self.kinds.values().sum()
    }

    /// The faults that a check does not detect in a regime.
    pub fn missed_by(&self, check: Check, regime: Option<Regime>) -> impl Iterator<Item = &str> {
        let is_of = move |of: &&Missed| of.check == check && of.regimes.contains(&regime);
        self.missed.iter().filter(is_of).flat_map(|of| of.faults.iter().map(String::as_str))
    }
}

/// Injects all faults and runs all checks, in these regimes.
///
/// The result depends on the seed and the regimes, not on the number of threads.
pub fn inject(seed: u64, regimes: &[Regime]) -> Injected {
    let faults = catalogue();
    let [varied, _] = terms();
    let all = Planted::new(seed, faults.clone());
    let of_variations =
        Planted::new(seed, faults.iter().copied().filter(|fault| varied.contains(&fault.label)).collect());
    let exact = Exact::new();
    let mut found = vec![all.detection(Check::Exact, None, &[()], |variant, ()| exact.rejects(variant))];
    for &regime in regimes {
        let points = test_points(seed, regime);
        let samples: Vec<_> =
            points.iter().flat_map(|(case, point)| Sample::in_all_forms(case, point)).collect();
        for check in Check::ALL.into_iter().filter(|&check| check != Check::Exact) {
            let planted = if check == Check::Gate { &all } else { &of_variations };
            found.push(
                planted.detection(check, Some(regime), &samples, |variant, sample| {
                    check.rejects(variant, sample)
                }),
            );
        }
    }
    found.sort_by_key(|(detection, _)| (detection.check, detection.regime));
    let mut kinds = BTreeMap::new();
    for fault in &faults {
        *kinds.entry(fault.kind).or_default() += 1;
    }
    let missed = Check::ALL.into_iter().flat_map(|check| missed(check, &faults, &found)).collect();
    Injected { kinds, missed, detections: found.into_iter().map(|(detection, _)| detection).collect() }
}

/// The faults that a check does not detect, by regimes, in the order of the catalogue.
fn missed(check: Check, faults: &[Fault], found: &[(Detection, Vec<Fault>)]) -> Vec<Missed> {
    let of_check: Vec<_> = found.iter().filter(|(detection, _)| detection.check == check).collect();
    let mut missed: BTreeMap<Vec<Option<Regime>>, Vec<String>> = BTreeMap::new();
    for fault in faults {
        let is_missed = |(_, undetected): &&&(Detection, Vec<Fault>)| undetected.contains(fault);
        let regimes: Vec<_> =
            of_check.iter().filter(is_missed).map(|(detection, _)| detection.regime).collect();
        if !regimes.is_empty() {
            missed.entry(regimes).or_default().push(fault.to_string());
        }
    }
    missed.into_iter().map(|(regimes, faults)| Missed { check, regimes, faults }).collect()
}

/// Faults, and pairs of them.
struct Planted {
    faults: Vec<Fault>,
    pairs: Vec<[Fault; 2]>,
}

impl Planted {
    /// Adds random pairs of faults of two terms.
    fn new(seed: u64, faults: Vec<Fault>) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut pairs = Vec::with_capacity(PAIRS);
        while pairs.len() < PAIRS && faults.len() > 1 {
            let pair = [0, 1].map(|_| faults[rng.random_range(0..faults.len())]);
            if pair[0].label != pair[1].label {
                pairs.push(pair);
            }
        }
        Self { faults, pairs }
    }

    fn detection<S: Sync>(
        &self,
        check: Check,
        regime: Option<Regime>,
        samples: &[S],
        rejects: impl Fn(&Variant, &S) -> bool + Sync,
    ) -> (Detection, Vec<Fault>) {
        let is_fair = |sample: &&S| !rejects(&Variant::Unmodified, sample);
        let fair: Vec<_> = samples.iter().filter(is_fair).collect();
        let is_undetected = |faults: &[Fault]| {
            let variant = Variant::Faulty(faults.to_vec());
            !fair.iter().any(|sample| rejects(&variant, sample))
        };
        let is_rejected =
            |&rewrite: &Rewrite| samples.iter().any(|sample| rejects(&Variant::Rewritten(rewrite), sample));
        let undetected =
            parallel::filter_map(&self.faults, |&fault| is_undetected(&[fault]).then_some(fault));
        let detection = Detection {
            check,
            regime,
            points: samples.len(),
            rejected: samples.len() - fair.len(),
            planted: self.faults.len(),
            detected: self.faults.len() - undetected.len(),
            false_positives: parallel::filter_map(&Rewrite::ALL, |rewrite| {
                is_rejected(rewrite).then_some(*rewrite)
            }),
            pairs: self.pairs.len(),
            pairs_detected: parallel::filter_map(&self.pairs, |pair| (!is_undetected(pair)).then_some(()))
                .len(),
        };
        (detection, undetected)
    }
}
