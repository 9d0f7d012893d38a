//! The counts of compared points, held against a record, so that a loss of points is not silent.
//!
//! A search that misses points compares fewer of them, and everything that is left agrees. So the counts of a run with the
//! default seed are compared with `counts.json`. They are kept for blocks of cases of each regime: the first 121, those
//! up to 1000, those up to 10,000. A run of 1000 cases is compared in the first two blocks.
//!
//! # Other machines
//! The draws use sine, cosine and powers of the platform. Where they differ in the last bit, all beams differ in the last
//! bit, and a point at a threshold may fall on its other side. [`Moved::TOLERANCE`] allows for that: it is more than what
//! was measured when all drawn numbers were changed in the last bit, and less than what any fault of the search loses.

use super::draw::{Case, place_in_regime};
use super::regime::Regime;
use super::verdict::{Inconclusive, Verdict};
use crate::closest_point::ClosestPoint;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// The ends of the blocks of cases of a regime.
const BLOCKS: [u64; 3] = [121, 1000, 10_000];

/// The record: the counts of a run of 10,000 cases of every regime, with the default seed.
const RECORD: &str = include_str!("counts.json");

/// What was compared and what was not, by regime and block.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Counts(BTreeMap<Regime, [Count; BLOCKS.len()]>);

/// The counts of a block of cases.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Count {
    /// Points compared inside both beams.
    pub inside: u64,
    /// Points compared with an end held.
    pub at_ends: u64,
    /// Points or cases that were not compared.
    pub not_compared: BTreeMap<Inconclusive, u64>,
}

/// A count that is not the recorded one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Moved {
    /// The regime.
    pub regime: Regime,
    /// The first case of the block, and the first one after it, counted in the regime.
    pub block: [u64; 2],
    /// The points that were counted.
    pub what: String,
    /// The recorded count.
    pub recorded: u64,
    /// The count that was found.
    pub found: u64,
}

impl Counts {
    /// The record.
    ///
    /// # Errors
    /// If `counts.json` is no record.
    pub fn recorded() -> Result<Self, serde_json::Error> {
        serde_json::from_str(RECORD)
    }

    /// Adds a case.
    pub(super) fn add(&mut self, case: &Case, verdicts: &[(Option<ClosestPoint>, Verdict)]) {
        let place = place_in_regime(case.number);
        let Some(block) = BLOCKS.into_iter().position(|end| place < end) else { return };
        let count = &mut self.0.entry(case.regime).or_default()[block];
        for (point, verdict) in verdicts {
            match verdict {
                Verdict::Inconclusive(reason, _) => *count.not_compared.entry(*reason).or_default() += 1,
                _ if point.is_some_and(|point| point.is_interior()) => count.inside += 1,
                _ => count.at_ends += 1,
            }
        }
    }

    pub(super) fn merge(&mut self, other: Self) {
        for (regime, counts) in other.0 {
            for (count, other) in self.0.entry(regime).or_default().iter_mut().zip(counts) {
                count.inside += other.inside;
                count.at_ends += other.at_ends;
                for (reason, number) in other.not_compared {
                    *count.not_compared.entry(reason).or_default() += number;
                }
            }
        }
    }

    /// The counts that are not the recorded ones, in the blocks that a run of so many cases of these regimes contains.
    pub fn moved(&self, recorded: &Self, regimes: &[Regime], cases: u64) -> Vec<Moved> {
        let none = <[Count; BLOCKS.len()]>::default();
        let mut all = Vec::new();
        for &regime in regimes {
            let [found, recorded] = [self, recorded].map(|counts| counts.0.get(&regime).unwrap_or(&none));
            let mut start = 0;
            for (end, (found, recorded)) in BLOCKS.into_iter().zip(found.iter().zip(recorded)) {
                if end <= cases {
                    let block = [start, end];
                    let moved = |what: String, recorded: u64, found: u64| {
                        let moved = Moved { regime, block, what, recorded, found };
                        moved.is_beyond_tolerance().then_some(moved)
                    };
                    all.extend(moved("compared inside both beams".into(), recorded.inside, found.inside));
                    all.extend(moved("compared at ends".into(), recorded.at_ends, found.at_ends));
                    let reasons = found.not_compared.keys().chain(recorded.not_compared.keys());
                    let reasons: std::collections::BTreeSet<_> = reasons.collect();
                    for reason in reasons {
                        let of = |count: &Count| count.not_compared.get(reason).copied().unwrap_or(0);
                        let what = format!("not compared ({})", reason.reason());
                        all.extend(moved(what, of(recorded), of(found)));
                    }
                }
                start = end;
            }
        }
        all
    }

    /// The number of cases of each regime of the record.
    pub const CASES: u64 = BLOCKS[BLOCKS.len() - 1];
}

impl Moved {
    /// The difference that is allowed for other machines.
    pub const TOLERANCE: u64 = 2;

    fn is_beyond_tolerance(&self) -> bool {
        self.found.abs_diff(self.recorded) > Self::TOLERANCE
    }
}

impl fmt::Display for Moved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { regime, block: [start, end], what, recorded, found } = self;
        let last = end - 1;
        write!(f, "{found} points {what}, not {recorded}: cases {start} to {last} of {}", regime.name())
    }
}

#[cfg(test)]
mod tests {
    use super::{BLOCKS, Count, Counts, Moved};
    use crate::check::{Case, CheckConfig, Inconclusive, Regime, Selection, compare};

    fn of(cases: u64) -> Counts {
        let mut counts = Counts::default();
        let selection = Selection { regimes: vec![Regime::Generic], family: None, cases };
        for number in selection.numbers() {
            let case = Case::draw(0x5eed, number);
            counts.add(&case, &compare(&CheckConfig::default(), &case));
        }
        counts
    }

    #[test]
    fn the_first_block_is_that_of_the_record() {
        let recorded = Counts::recorded().unwrap();
        assert_eq!(of(121).moved(&recorded, &[Regime::Generic], 121), []);
    }

    #[test]
    fn a_lost_point_is_told_and_the_last_bit_is_not() {
        let count = |inside, singular| Count {
            inside,
            at_ends: 20,
            not_compared: [(Inconclusive::Singular, singular)].into(),
        };
        let counts = |blocks: [Count; 3]| Counts([(Regime::Metres, blocks)].into());
        let recorded = counts([count(100, 5), count(700, 0), count(8000, 9)]);
        let regimes = [Regime::Metres];
        let moved = |found: &Counts, cases| found.moved(&recorded, &regimes, cases);
        assert_eq!(moved(&counts([count(102, 3), count(698, 2), count(7998, 7)]), 10_000), []);
        let found = counts([count(97, 5), count(700, 3), count(8003, 9)]);
        let words: Vec<_> = moved(&found, 10_000).iter().map(ToString::to_string).collect();
        assert_eq!(
            words,
            [
                "97 points compared inside both beams, not 100: cases 0 to 120 of metres",
                "3 points not compared (singular: D = 0 to rounding), not 0: cases 121 to 999 of metres",
                "8003 points compared inside both beams, not 8000: cases 1000 to 9999 of metres"
            ]
        );
        // Only blocks that were run.
        assert_eq!(moved(&found, 999).len(), 1);
        assert_eq!(moved(&found, 120), []);
        assert_eq!(Counts::default().moved(&recorded, &regimes, 121).len(), 3);
        assert_eq!((BLOCKS[2], Moved::TOLERANCE), (Counts::CASES, 2));
    }

    #[test]
    fn parts_are_added() {
        let (mut some, whole) = (of(10), of(30));
        let mut rest = Counts::default();
        let selection = Selection { regimes: vec![Regime::Generic], family: None, cases: 30 };
        for number in selection.numbers().into_iter().skip(10) {
            let case = Case::draw(0x5eed, number);
            rest.add(&case, &compare(&CheckConfig::default(), &case));
        }
        some.merge(rest);
        assert_eq!(some, whole);
    }
}
