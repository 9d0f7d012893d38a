//! The limits of the machine, measured with the rest: what no linearization can be faster than.

use super::number::{number, rounded};
use super::{ReportError, Samples, spread};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Criterion's group of the limits.
pub const FLOORS: &str = "floors of the machine";

/// One of the two limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Floor {
    /// Multiplications with an addition.
    MultiplyAdds,
    /// Bytes stored in memory that is in the first cache.
    Bytes,
}

impl Floor {
    /// Both limits.
    pub const ALL: [Self; 2] = [Self::MultiplyAdds, Self::Bytes];

    /// The name, which is the way of its measurement.
    pub fn name(self) -> &'static str {
        match self {
            Self::MultiplyAdds => "multiply-adds",
            Self::Bytes => "bytes stored",
        }
    }
}

/// What one core does in a nanosecond at best.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Floors {
    /// Multiplications with an addition.
    pub multiply_adds: f64,
    /// Bytes stored into the first cache.
    pub bytes: f64,
}

impl Floors {
    /// From the samples of the two kernels and what each does in a run.
    pub(super) fn read(
        found: &BTreeMap<(String, String), Samples>,
        amounts: [usize; 2],
    ) -> Result<Self, ReportError> {
        let rate = |floor: Floor, amount: usize| {
            let missing = || ReportError::NotTimed { scenario: format!("{FLOORS}, {}", floor.name()) };
            let samples = found.get(&(FLOORS.to_owned(), floor.name().to_owned())).ok_or_else(missing)?;
            let median = spread(&samples.times).ok_or_else(missing)?.median;
            Ok(rounded(number(amount) / median, 4))
        };
        let [adds, bytes] = amounts;
        Ok(Self { multiply_adds: rate(Floor::MultiplyAdds, adds)?, bytes: rate(Floor::Bytes, bytes)? })
    }

    /// How many nanoseconds so many multiply-adds, and so many bytes, take at best.
    pub(super) fn least(&self, multiply_adds: f64, bytes: f64) -> [f64; 2] {
        [multiply_adds / self.multiply_adds, bytes / self.bytes]
    }
}

#[cfg(test)]
mod tests {
    use super::Floors;

    #[test]
    fn each_amount_is_held_against_its_own_limit() {
        let floors = Floors { multiply_adds: 24.0, bytes: 96.0 };
        assert_eq!(floors.least(480.0, 480.0).map(f64::to_bits), [20.0, 5.0].map(f64::to_bits));
    }
}
