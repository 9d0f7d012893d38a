//! A run that is timed.

use crate::scenario::Runner;
use std::time::{Duration, Instant};

/// A run with a known amount of work, repeated several times in a round.
pub(crate) struct Timed {
    run: Runner,
    amount: usize,
    runs: u32,
}

impl Timed {
    /// Chooses the number of runs so that they fill a round.
    pub(crate) fn new(run: Runner, amount: usize, round: Duration) -> Self {
        let mut timed = Self { run, amount, runs: 1 };
        while timed.elapsed() < round {
            timed.runs *= 2;
        }
        timed
    }

    fn elapsed(&mut self) -> Duration {
        let start = Instant::now();
        for _ in 0..self.runs {
            (self.run)();
        }
        start.elapsed()
    }

    /// The time of a unit of work in nanoseconds.
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    pub(crate) fn round(&mut self) -> f64 {
        self.elapsed().as_nanos() as f64 / f64::from(self.runs) / self.amount as f64
    }
}
