//! The limits of the machine, measured with the rest: what no linearization can be faster than.

use super::number::{number, rounded};
use super::{ReportError, Samples, Task, spread};
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

    /// How many of them the Hessians of a task ask for at least, if so many entries of each are stored.
    ///
    /// Multiply-adds: an entry of the Hessian of d is a sum of two products of a shape function's derivative with an entry
    /// of a vector, one of any other of three; all that leads to these vectors comes on top. Bytes: each entry is stored
    /// once.
    pub fn least(self, task: Task, entries: usize) -> Option<usize> {
        let others = match task {
            Task::Distance => 0,
            Task::All => 4,
            _ => return None,
        };
        let of_an_entry = match self {
            Self::MultiplyAdds => 2 + 3 * others,
            Self::Bytes => size_of::<f64>() * (1 + others),
        };
        Some(entries * of_an_entry)
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

    /// How many nanoseconds so many take at best.
    pub(super) fn least(&self, floor: Floor, amount: usize) -> f64 {
        number(amount) / if floor == Floor::Bytes { self.bytes } else { self.multiply_adds }
    }
}

#[cfg(test)]
mod tests {
    use super::{Floor, Floors, Task};

    #[test]
    fn the_least_of_a_task_is_that_of_its_hessians() {
        let [adds, bytes] = Floor::ALL.map(|floor| move |task| floor.least(task, 24 * 24));
        assert_eq!((adds(Task::Distance), bytes(Task::Distance)), (Some(1152), Some(4608)));
        assert_eq!((adds(Task::All), bytes(Task::All)), (Some(8064), Some(23_040)));
        assert_eq!((adds(Task::ClosestPoint), bytes(Task::Directions)), (None, None));
    }

    #[test]
    fn each_amount_is_held_against_its_own_limit() {
        let floors = Floors { multiply_adds: 24.0, bytes: 96.0 };
        assert_eq!(Floor::ALL.map(|floor| floors.least(floor, 480).to_bits()), [20.0, 5.0].map(f64::to_bits));
    }
}
