//! All faults and rewrites through all checks.

use super::check::Check;
use super::exact::Exact;
use super::test_points::{Sample, test_points};
use crate::check::Regime;
use crate::variant::{Fault, Rewrite, Variant, catalogue, terms};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// How many pairs of faults are planted at once, in each regime.
const PAIRS: usize = 200;
/// Less than that is no catalogue.
const FAULTS: usize = 200;

/// What one check does in one regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Detection {
    /// The check.
    pub check: Check,
    /// The regime; none for the exact check.
    pub regime: Option<Regime>,
    /// Closest points.
    pub points: usize,
    /// Of these, those at which the closed form is rejected although it is right. What the check says there counts for
    /// nothing.
    pub rejected: usize,
    /// Faults that were planted: those of the matrices only for a check that looks at them.
    pub planted: usize,
    /// Faults that it does not show.
    pub undetected: Vec<Fault>,
    /// Rewrites that it rejects although they are right.
    pub false_positives: Vec<Rewrite>,
    /// Pairs of faults, planted at once.
    pub pairs: usize,
    /// Those that it does not show.
    pub pairs_undetected: Vec<[Fault; 2]>,
}

/// What all checks do.
#[derive(Clone, Debug, PartialEq)]
pub struct Injected {
    /// All faults.
    pub faults: Vec<Fault>,
    /// By check, then by regime.
    pub detections: Vec<Detection>,
}

impl Detection {
    /// Whether it shows every fault and rejects nothing that is right.
    pub fn is_whole(&self) -> bool {
        self.points > 0
            && self.rejected == 0
            && self.undetected.is_empty()
            && self.false_positives.is_empty()
            && self.pairs_undetected.is_empty()
    }
}

impl Injected {
    /// Whether the gate and the exact check kill all faults, in every regime, and reject nothing that is right.
    pub fn holds(&self) -> bool {
        let ours = |detection: &&Detection| matches!(detection.check, Check::Gate | Check::Exact);
        self.faults.len() >= FAULTS && self.detections.iter().filter(ours).all(Detection::is_whole)
    }
}

/// Puts all checks to the test, in these regimes.
///
/// The result depends on the seed and the regimes, not on the number of threads.
pub fn inject(seed: u64, regimes: &[Regime]) -> Injected {
    let faults = catalogue();
    let [varied, _] = terms();
    let all = Planted::new(seed, faults.clone());
    let of_variations =
        Planted::new(seed, faults.iter().copied().filter(|fault| varied.contains(&fault.label)).collect());
    let exact = Exact::new();
    let mut detections = vec![all.detection(Check::Exact, None, &[()], |variant, ()| exact.rejects(variant))];
    for &regime in regimes {
        let points = test_points(seed, regime);
        let samples: Vec<_> =
            points.iter().flat_map(|(case, point)| Sample::in_all_forms(case, point)).collect();
        for check in Check::ALL.into_iter().filter(|&check| check != Check::Exact) {
            let planted = if check == Check::Gate { &all } else { &of_variations };
            detections.push(
                planted.detection(check, Some(regime), &samples, |variant, sample| {
                    check.rejects(variant, sample)
                }),
            );
        }
    }
    detections.sort_by_key(|detection| (detection.check, detection.regime));
    Injected { faults, detections }
}

/// Faults, and pairs of them.
struct Planted {
    faults: Vec<Fault>,
    pairs: Vec<[Fault; 2]>,
}

impl Planted {
    /// With pairs of faults of two terms, at random.
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
    ) -> Detection {
        let is_fair = |sample: &&S| !rejects(&Variant::Unmodified, sample);
        let fair: Vec<_> = samples.iter().filter(is_fair).collect();
        let is_undetected = |faults: &[Fault]| {
            let variant = Variant::Faulty(faults.to_vec());
            !fair.iter().any(|sample| rejects(&variant, sample))
        };
        let is_accused =
            |&rewrite: &Rewrite| samples.iter().any(|sample| rejects(&Variant::Rewritten(rewrite), sample));
        Detection {
            check,
            regime,
            points: samples.len(),
            rejected: samples.len() - fair.len(),
            planted: self.faults.len(),
            undetected: self.faults.par_iter().copied().filter(|&fault| is_undetected(&[fault])).collect(),
            false_positives: Rewrite::ALL.into_par_iter().filter(is_accused).collect(),
            pairs: self.pairs.len(),
            pairs_undetected: self.pairs.par_iter().copied().filter(|pair| is_undetected(pair)).collect(),
        }
    }
}
