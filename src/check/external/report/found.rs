//! The results for a part of a quantity and for a regime.

use crate::check::external::compare::Judged;
use crate::check::external::error::Place;
use serde::{Deserialize, Serialize};

/// The result for one part of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartFound {
    /// The number of compared numbers.
    pub numbers: u64,
    /// The number of these that are correct, but have fewer digits than are attainable.
    #[serde(rename = "losing_digits")]
    pub losing: u64,
    /// The number of wrong numbers.
    pub wrong: u64,
    /// The count of numbers that are not meaningful, because rounding explains more than a thousandth of their scale.
    pub unclear: u64,
    /// The number that comes closest to its tolerance, or exceeds it most.
    pub worst: Judged,
    /// Its case.
    pub case: String,
    /// The place of its answer.
    pub place: Place,
    /// The number with the largest error over its size.
    pub largest_error: Loss,
}

/// The largest error, or the largest loss of digits, in a regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Loss {
    /// The number.
    pub judged: Judged,
    /// Its case.
    pub case: String,
}

impl Loss {
    /// The error over the size of the number; infinite if it is not a number.
    pub fn error(&self) -> f64 {
        let Judged { loss, size, .. } = self.judged;
        // A number without any error has all digits.
        let error = if loss == 0.0 { 0.0 } else { loss / size };
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// The number of attainable digits that are lost.
    pub fn digits(&self) -> f64 {
        (self.judged.loss / self.judged.attainable).log10()
    }
}

/// The result in a regime.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RegimeFound {
    /// Cases that were compared.
    pub compared: u64,
    /// Cases that could not be compared, or at which some number could not be compared.
    #[serde(default)]
    pub not_compared: u64,
    /// Of these, those without a reference.
    #[serde(default)]
    pub without_reference: u64,
    /// Of these, those with a wrong number.
    pub wrong: u64,
    /// Of these, those with a number that is correct but loses digits.
    #[serde(rename = "losing_digits")]
    pub losing: u64,
    /// The largest loss among the correct numbers.
    pub loss: Option<Loss>,
    /// The largest error over the size of the number, whether correct or wrong.
    pub worst: Option<Loss>,
}
