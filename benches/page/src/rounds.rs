//! Interleaved rounds: slow drifts of the clock affect all methods of a round alike.

use crate::benchmark::{Measured, Ratio};
use crate::spread;
use beamgap::report::number::{number, rounded};
use serde::{Deserialize, Serialize};

/// The reference of a method in its rounds, and the times of every round in nanoseconds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "with", rename_all = "snake_case")]
pub enum Rounds {
    /// The closed form of the same task on the same beams.
    ClosedForm {
        /// The time of a pair by the method and by the closed form.
        samples: Vec<[f64; 2]>,
    },
    /// Two kernels, one for multiply-adds and one for stores.
    Roofline {
        /// The multiply-adds of a pair.
        multiply_adds: usize,
        /// The time of a pair, of a multiply-add and of a stored byte.
        samples: Vec<[f64; 3]>,
    },
    /// The same method by one thread, and a kernel of multiply-adds alone, by as many threads as the method has and by one.
    OneThread {
        /// The time of a pair by all threads and by one, and of a multiply-add by all and by one.
        samples: Vec<[f64; 4]>,
    },
}

impl Rounds {
    /// Rounds the times to the digits of a time.
    pub(crate) fn rounded(self) -> Self {
        fn all<const K: usize>(samples: Vec<[f64; K]>) -> Vec<[f64; K]> {
            samples.into_iter().map(|round| round.map(|time| rounded(time, 5))).collect()
        }
        match self {
            Self::ClosedForm { samples } => Self::ClosedForm { samples: all(samples) },
            Self::Roofline { multiply_adds, samples } => {
                Self::Roofline { multiply_adds, samples: all(samples) }
            }
            Self::OneThread { samples } => Self::OneThread { samples: all(samples) },
        }
    }
}

impl Measured {
    /// The multiply-adds of a pair, and for each round its time and the times of these multiply-adds and of `bytes` bytes.
    pub(crate) fn with_lower_bounds(&self, bytes: f64) -> Option<(usize, Vec<[f64; 3]>)> {
        self.rounds.iter().find_map(|rounds| {
            let Rounds::Roofline { multiply_adds, samples } = rounds else { return None };
            let amount = number(*multiply_adds);
            let with_lower_bounds =
                samples.iter().map(|&[time, of_one, of_byte]| [time, amount * of_one, bytes * of_byte]);
            Some((*multiply_adds, with_lower_bounds.collect()))
        })
    }

    /// The time over that of the closed form.
    pub(crate) fn over_closed_form(&self) -> Option<Ratio> {
        self.rounds.iter().find_map(|rounds| {
            let Rounds::ClosedForm { samples } = rounds else { return None };
            median(samples, |&[time, of_closed_form]| time / of_closed_form)
        })
    }

    /// The median times of the method and of the closed form, in the rounds in which both ran.
    pub(crate) fn times_of_rounds(&self) -> Option<[f64; 2]> {
        self.rounds.iter().find_map(|rounds| {
            let Rounds::ClosedForm { samples } = rounds else { return None };
            Some([median(samples, |round| round[0])?.value, median(samples, |round| round[1])?.value])
        })
    }

    /// The median times by all threads and by one, in the rounds in which both ran.
    pub(crate) fn times_of_threads(&self) -> Option<[f64; 2]> {
        Some([self.over_one_thread(|round| round[0])?.value, self.over_one_thread(|round| round[1])?.value])
    }

    /// The number of pairs over that of one thread.
    pub(crate) fn speed_up(&self) -> Option<Ratio> {
        self.over_one_thread(|&[by_all, by_one, ..]| by_one / by_all)
    }

    /// The number of multiply-adds over that of one thread, for threads that compute multiply-adds alone.
    pub(crate) fn speed_up_of_arithmetic(&self) -> Option<Ratio> {
        self.over_one_thread(|&[.., by_all, by_one]| by_one / by_all)
    }

    /// The same in each round.
    pub(crate) fn speed_ups_of_arithmetic(&self) -> impl Iterator<Item = f64> {
        let samples = self.rounds.iter().filter_map(|rounds| {
            let Rounds::OneThread { samples } = rounds else { return None };
            Some(samples)
        });
        samples.flatten().map(|[.., by_all, by_one]| by_one / by_all)
    }

    fn over_one_thread(&self, ratio: impl Fn(&[f64; 4]) -> f64) -> Option<Ratio> {
        self.rounds.iter().find_map(|rounds| {
            let Rounds::OneThread { samples } = rounds else { return None };
            median(samples, &ratio)
        })
    }
}

/// The median of the ratios of the rounds.
fn median<const K: usize>(samples: &[[f64; K]], ratio: impl Fn(&[f64; K]) -> f64) -> Option<Ratio> {
    let ratios: Vec<f64> = samples.iter().map(ratio).collect();
    spread(&ratios).map(|spread| Ratio { value: spread.median, interval: spread.interval })
}

#[cfg(test)]
mod tests {
    use super::{Ratio, Rounds};
    use crate::benchmark::tests::measured;

    #[test]
    fn methods_are_compared_with_the_closed_form_round_by_round() {
        let samples = vec![[600.0, 150.0], [1500.0, 300.0], [630.0, 150.0]];
        let of = measured("hyper-dual", vec![Rounds::ClosedForm { samples }]);
        assert_eq!(of.over_closed_form().unwrap().value.to_bits(), 4.2_f64.to_bits());
        assert_eq!(of.times_of_rounds().unwrap().map(f64::to_bits), [630.0_f64, 150.0].map(f64::to_bits));
        assert!(of.speed_up().is_none() && of.with_lower_bounds(1.0).is_none());
    }

    #[test]
    fn threads_are_compared_round_by_round() {
        // The machine is twice as slow in every other round.
        let of_pairs = [[50.0, 95.0], [100.0, 190.0], [50.0, 80.0], [100.0, 195.0], [50.0, 95.0]];
        let samples = of_pairs.map(|[by_all, by_one]| [by_all, by_one, 0.5 * by_all, by_all]).to_vec();
        let of = measured("closed form, 2 threads", vec![Rounds::OneThread { samples }]);
        assert_eq!(of.times_of_threads().unwrap().map(f64::to_bits), [50.0_f64, 95.0].map(f64::to_bits));
        let Ratio { value, interval: [low, high] } = of.speed_up().unwrap();
        assert_eq!([value, low, high].map(f64::to_bits), [1.9, 1.6, 1.95].map(f64::to_bits));
        assert_eq!(
            of.speed_up_of_arithmetic().unwrap().interval.map(f64::to_bits),
            [2.0; 2].map(f64::to_bits)
        );
        assert!(of.with_lower_bounds(1.0).is_none() && of.over_closed_form().is_none());
        assert!(measured("closed form", vec![]).speed_up().is_none());
    }
}
