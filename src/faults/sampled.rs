//! Faults in single operations in `f64`, checked by the gate with its tolerances: a sample of operations in every regime.
//!
//! The prime field shows which operations a result depends on. Here the size of the fault matters: the detection
//! limit is the smallest relative error of an operation that exceeds a tolerance.

use super::limit::{Limit, NUDGE, sensitivity};
use super::test_points::{Sample, test_points};
use crate::check::serialized::by_name;
use crate::check::{Comparison, Regime};
use crate::linearization::Quantity;
use crate::number::counted;
use crate::parallel;
use crate::variant::{Code, Variant};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The minimum number of operations with faults in each regime.
const OPERATIONS: usize = 2000;
/// The factors of the result of an operation: a wrong sign, a lost result, a doubled result.
const FACTORS: [f64; 3] = [-1.0, 0.0, 2.0];

by_name!(Code);

/// The results for a sample of operations in a regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sampled {
    /// The regime.
    pub regime: Regime,
    /// The code that the operations belong to.
    pub code: Code,
    /// The number of operations with faults, at all points.
    pub operations: usize,
    /// The number of their faults that change a number.
    pub faults: usize,
    /// The number of these that exceed a tolerance.
    pub detected: usize,
    /// The detection limits of the operations that a quantity depends on.
    pub limits: BTreeMap<Quantity, Limits>,
}

/// The detection limits of several operations.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// The number of operations.
    pub operations: usize,
    /// The smallest.
    pub smallest: Limit,
    /// The median.
    pub median: Limit,
    /// The largest.
    pub largest: Limit,
}

impl Limits {
    fn new(mut limits: Vec<f64>) -> Option<Self> {
        limits.sort_by(f64::total_cmp);
        let (smallest, largest) = (Limit(*limits.first()?), Limit(*limits.last()?));
        Some(Self { operations: limits.len(), smallest, median: Limit(limits[limits.len() / 2]), largest })
    }
}

/// Injects faults into operations in these regimes. The number of operations is the same for equations and matrices.
pub fn sampled(seed: u64, regimes: &[Regime]) -> Vec<Sampled> {
    let of_regime = |&regime: &Regime| {
        let points = test_points(seed, regime);
        let samples: Vec<_> =
            points.iter().flat_map(|(case, point)| Sample::in_all_forms(case, point)).collect();
        let each = OPERATIONS.div_ceil(Code::ALL.len() * samples.len().max(1));
        Code::ALL.map(|code| {
            let of_sample = |i: usize| {
                let mut rng = ChaCha8Rng::seed_from_u64(seed);
                rng.set_stream(i as u64);
                Counts::of(code, &samples[i], each, &mut rng)
            };
            let all = parallel::indices(samples.len(), of_sample);
            let Counts { operations, faults, detected, limits } =
                all.into_iter().fold(Counts::default(), Counts::and);
            let limits =
                limits.into_iter().filter_map(|(of, limits)| Some((of, Limits::new(limits)?))).collect();
            Sampled { regime, code, operations, faults, detected, limits }
        })
    };
    regimes.iter().flat_map(of_regime).collect()
}

/// The counts.
#[derive(Default)]
struct Counts {
    operations: usize,
    faults: usize,
    detected: usize,
    limits: BTreeMap<Quantity, Vec<f64>>,
}

impl Counts {
    fn of(code: Code, sample: &Sample, each: usize, rng: &mut ChaCha8Rng) -> Self {
        let mut found = Self::default();
        let unmodified = sample.compared(&Variant::Unmodified);
        // The number of no operation: all operations are counted, and none is changed.
        let with = |number, factor| sample.compared(&Variant::Operation(code, number, factor));
        let (_, count) = counted(|| with(usize::MAX, 1.0));
        for i in 0..each {
            // One operation in each of as many parts of the code.
            let number = (i * count + rng.random_range(0..count.max(1))) / each;
            found.operations += 1;
            for factor in FACTORS {
                let wrong = with(number, factor);
                let is_changed = wrong
                    .iter()
                    .zip(&unmodified)
                    .any(|(wrong, unmodified)| sides(wrong) != sides(unmodified));
                let is_detected = wrong.iter().any(|entry| entry.is_meaningful() && !entry.agrees());
                found.faults += usize::from(is_changed);
                found.detected += usize::from(is_detected);
            }
            let mut limits: BTreeMap<Quantity, f64> = BTreeMap::new();
            for (unmodified, nudged) in unmodified.iter().zip(&with(number, 1.0 + NUDGE)) {
                let limit = sensitivity(unmodified, nudged);
                let smallest = limits.entry(unmodified.quantity).or_insert(f64::INFINITY);
                *smallest = smallest.min(limit);
            }
            for (quantity, limit) in limits.into_iter().filter(|(_, limit)| limit.is_finite()) {
                found.limits.entry(quantity).or_default().push(limit);
            }
        }
        found
    }

    fn and(mut self, other: Self) -> Self {
        self.operations += other.operations;
        self.faults += other.faults;
        self.detected += other.detected;
        for (quantity, limits) in other.limits {
            self.limits.entry(quantity).or_default().extend(limits);
        }
        self
    }
}

fn sides(entry: &Comparison) -> [u64; 2] {
    [entry.closed.to_bits(), entry.other.to_bits()]
}

#[cfg(test)]
mod tests {
    use super::{OPERATIONS, sampled};
    use crate::check::Regime;
    use crate::linearization::Quantity;
    use crate::variant::Code;

    #[test]
    fn wrong_operations_exceed_tolerances_in_a_generic_regime() {
        let found = sampled(1, &[Regime::ALL[0]]);
        assert!(found.iter().map(|of| of.operations).sum::<usize>() >= OPERATIONS);
        for of in &found {
            assert!(of.faults > of.operations && of.detected <= of.faults, "{of:?}");
            // An entry of a matrix may have a small weight in the contraction that is compared.
            let least = if of.code == Code::Equations { 98 } else { 92 };
            let (name, detected, faults) = (of.code.name(), of.detected, of.faults);
            assert!(100 * detected > least * faults, "{name}: {detected} of {faults}");
            let of_d = &of.limits[&Quantity::D];
            // A relative error of a millionth of an operation that d depends on is detected, in the median.
            assert!(of_d.median.0 < 1e-6 && of_d.smallest.0 > 1e-17, "{of_d:?}");
        }
    }
}
