//! What a way takes next to what the machine takes for its arithmetic and its stores alone.

use super::number::{number, rounded};
use serde::{Deserialize, Serialize};

/// A way and two kernels, one that multiplies and adds and one that stores, in turns: whatever changes the speed of the
/// machine for longer than a turn changes all three.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turns {
    /// The multiply-adds of a pair.
    pub multiply_adds: usize,
    /// The nanoseconds of a pair, of a multiply-add and of a byte stored, in each turn.
    pub samples: Vec<[f64; 3]>,
}

impl Turns {
    /// With so many digits as a time has.
    pub(super) fn rounded(self) -> Self {
        let samples = self.samples.into_iter().map(|turn| turn.map(|time| rounded(time, 5))).collect();
        Self { samples, ..self }
    }

    /// In each turn, the time of a pair, and what its multiply-adds and so many bytes would take.
    pub(super) fn with_floors(&self, bytes: f64) -> impl Iterator<Item = [f64; 3]> {
        let multiply_adds = number(self.multiply_adds);
        self.samples
            .iter()
            .map(move |&[time, of_one, of_byte]| [time, multiply_adds * of_one, bytes * of_byte])
    }
}
