//! All faults and rewrites through all checks.

use super::check::Check;
use super::exact::Exact;
use super::panel::{Sample, panel};
use crate::check::Regime;
use crate::subject::{Fault, Rewrite, Subject, catalogue};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// How many pairs of faults are planted at once, in each regime.
const PAIRS: usize = 200;

/// What one check does in one regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Bite {
    /// The check.
    pub check: Check,
    /// The regime; none for the exact check.
    pub regime: Option<Regime>,
    /// Closest points.
    pub points: usize,
    /// Faults that it shows.
    pub killed: usize,
    /// Faults that it does not show.
    pub survivors: Vec<Fault>,
    /// What is right and is accused: a rewrite, or nothing for the closed form as it is.
    pub false_alarms: Vec<Option<Rewrite>>,
    /// Pairs of faults, planted at once, that it shows.
    pub pairs_killed: usize,
    /// Those that it does not show.
    pub pairs_survived: Vec<[Fault; 2]>,
}

/// What all checks do.
#[derive(Clone, Debug, PartialEq)]
pub struct Teeth {
    /// All faults.
    pub faults: Vec<Fault>,
    /// By check, then by regime.
    pub bites: Vec<Bite>,
}

impl Teeth {
    /// Whether the gate and the exact check kill all faults and accuse nothing that is right.
    pub fn holds(&self) -> bool {
        let ours = |bite: &&Bite| matches!(bite.check, Check::Gate | Check::Exact);
        let is_whole = |bite: &Bite| {
            bite.points > 0
                && bite.survivors.is_empty()
                && bite.false_alarms.is_empty()
                && bite.pairs_survived.is_empty()
        };
        self.faults.len() >= 200 && self.bites.iter().filter(ours).all(is_whole)
    }
}

/// Puts all checks to the test, in these regimes.
///
/// The result depends on the seed and the regimes, not on the number of threads.
pub fn teeth(seed: u64, regimes: &[Regime]) -> Teeth {
    let faults = catalogue();
    let pairs = pairs(seed, &faults);
    let exact = Exact::new();
    let mut bites = vec![bite(&faults, &pairs, Check::Exact, None, 4, |subject| exact.accuses(subject))];
    for &regime in regimes {
        let points = panel(seed, regime);
        let samples: Vec<_> = points.iter().filter_map(|(case, point)| Sample::new(case, point)).collect();
        for check in Check::ALL.into_iter().filter(|&check| check != Check::Exact) {
            let accuses = |subject: &Subject| samples.iter().any(|sample| check.accuses(subject, sample));
            bites.push(bite(&faults, &pairs, check, Some(regime), samples.len(), accuses));
        }
    }
    bites.sort_by_key(|bite| (bite.check, bite.regime));
    Teeth { faults, bites }
}

fn bite(
    faults: &[Fault],
    pairs: &[[Fault; 2]],
    check: Check,
    regime: Option<Regime>,
    points: usize,
    accuses: impl Fn(&Subject) -> bool + Sync,
) -> Bite {
    let survives = |faults: Vec<Fault>| !accuses(&Subject::Faulty(faults));
    let survivors: Vec<_> = faults.par_iter().copied().filter(|&fault| survives(vec![fault])).collect();
    let pairs_survived: Vec<_> = pairs.par_iter().copied().filter(|pair| survives(pair.to_vec())).collect();
    let right = [None].into_iter().chain(Rewrite::ALL.map(Some)).collect::<Vec<_>>();
    let false_alarms = right
        .into_par_iter()
        .filter(|right| accuses(&right.map_or(Subject::Sound, Subject::Rewritten)))
        .collect();
    Bite {
        check,
        regime,
        points,
        killed: faults.len() - survivors.len(),
        survivors,
        false_alarms,
        pairs_killed: pairs.len() - pairs_survived.len(),
        pairs_survived,
    }
}

/// Pairs of faults of two terms, at random.
fn pairs(seed: u64, faults: &[Fault]) -> Vec<[Fault; 2]> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut pairs = Vec::with_capacity(PAIRS);
    while pairs.len() < PAIRS && faults.len() > 1 {
        let pair = [0, 1].map(|_| faults[rng.random_range(0..faults.len())]);
        if pair[0].label != pair[1].label {
            pairs.push(pair);
        }
    }
    pairs
}
