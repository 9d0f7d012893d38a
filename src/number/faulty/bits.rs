//! Scalars that fit into 64 bits.

use crate::number::{PrimeField, Real};

/// A scalar that fits into 64 bits.
pub(crate) trait Bits: Real {
    fn bits(self) -> u64;
    fn from_bits(bits: u64) -> Self;
    /// Whether the number is finite, so that wrong code may continue with it unnoticed.
    fn is_finite(self) -> bool;
    /// The same number, marked if the scalar has a mark.
    #[must_use]
    fn marked(self) -> Self {
        self
    }
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }

    fn from_bits(bits: u64) -> Self {
        Self::from_bits(bits)
    }

    fn is_finite(self) -> bool {
        Self::is_finite(self)
    }
}

impl Bits for PrimeField {
    fn bits(self) -> u64 {
        self.value()
    }

    fn from_bits(bits: u64) -> Self {
        Self::new(bits)
    }

    fn is_finite(self) -> bool {
        true
    }
}
