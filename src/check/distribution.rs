//! The distribution of positive numbers over many powers of ten, independent of the order of counting.

use super::serialized::short;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Bins per factor of ten. The error of a quantile is at most 1.2 %.
const BINS: f64 = 100.0;

/// A distribution in five numbers, which are written with two digits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantiles {
    /// The smallest.
    #[serde(with = "short")]
    pub min: f64,
    /// 5 % are below.
    #[serde(with = "short")]
    pub low: f64,
    /// Half are below.
    #[serde(with = "short")]
    pub median: f64,
    /// 95 % are below.
    #[serde(with = "short")]
    pub high: f64,
    /// The largest.
    #[serde(with = "short")]
    pub max: f64,
}

/// Counts of positive numbers in bins of equal ratio.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Distribution {
    bins: BTreeMap<i32, u64>,
    count: u64,
    max: f64,
}

impl Distribution {
    /// Counts a number, which must be positive and finite.
    pub(super) fn add(&mut self, number: f64) {
        *self.bins.entry(bin(number)).or_default() += 1;
        self.count += 1;
        self.max = self.max.max(number);
    }

    pub(super) fn merge(&mut self, other: &Self) {
        for (bin, count) in &other.bins {
            *self.bins.entry(*bin).or_default() += count;
        }
        self.count += other.count;
        self.max = self.max.max(other.max);
    }

    /// The number of counted numbers.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// The distribution in five numbers; nothing if there is no number.
    pub(super) fn quantiles(&self) -> Option<Quantiles> {
        let [min, low, median, high] = [0.0, 0.05, 0.5, 0.95].map(|p| self.quantile(p));
        Some(Quantiles { min: min?, low: low?, median: median?, high: high?, max: self.max })
    }

    /// The number below which the share `p` of all lies, from the middle of its bin; nothing if there is no number.
    fn quantile(&self, p: f64) -> Option<f64> {
        #[expect(clippy::cast_precision_loss, reason = "counts, far below 2^53")]
        let wanted = p * self.count as f64;
        let mut below = 0;
        self.bins.iter().find_map(|(&bin, &count)| {
            below += count;
            #[expect(clippy::cast_precision_loss, reason = "counts, far below 2^53")]
            let reached = below as f64 >= wanted;
            reached.then(|| 10_f64.powf((f64::from(bin) + 0.5) / BINS).min(self.max))
        })
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a hundred times the exponent of an f64")]
fn bin(number: f64) -> i32 {
    (BINS * number.log10()).floor() as i32
}

#[cfg(test)]
mod tests {
    use super::Distribution;

    #[test]
    fn quantiles_of_what_was_counted_in_any_order() {
        let (mut all, mut part, mut rest) =
            (Distribution::default(), Distribution::default(), Distribution::default());
        for i in (1..=1000).rev() {
            all.add(f64::from(i));
            if i % 3 == 0 { part.add(f64::from(i)) } else { rest.add(f64::from(i)) }
        }
        rest.merge(&part);
        assert_eq!(all, rest);
        let found = all.quantiles().unwrap();
        assert_eq!((all.count(), found.max), (1000, 1000.0));
        assert!(
            found.min < 1.012
                && found.min < found.low
                && found.low < found.median
                && found.median < found.high
        );
        for (p, expected) in [(0.05, 50.0), (0.5, 500.0), (0.95, 950.0), (1.0, 1000.0)] {
            let found = all.quantile(p).unwrap();
            assert!((found / expected - 1.0).abs() <= 0.024, "{p}: {found}, not {expected}");
        }
        assert_eq!(Distribution::default().quantiles(), None);
    }
}
