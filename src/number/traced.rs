//! A residue with a mark that shows whether a certain operation contributed to it.

use super::faulty::Bits;
use super::{PrimeField, Real, field_from_operators};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A residue, and whether the marked operation contributed to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Traced {
    value: PrimeField,
    is_marked: bool,
}

/// The bit of the mark. Residues have 61 bits.
const MARK: u32 = 63;

thread_local! {
    /// Whether a marked number was multiplied by an exact zero.
    static IS_LOST: Cell<bool> = const { Cell::new(false) };
}

impl Traced {
    /// Runs code, and returns whether a marked number was multiplied by an exact zero.
    pub(crate) fn run<R>(run: impl FnOnce() -> R) -> (R, bool) {
        IS_LOST.set(false);
        (run(), IS_LOST.get())
    }

    /// Whether the marked operation contributed to the number with these bits.
    pub(crate) fn is_marked(bits: u64) -> bool {
        bits >> MARK == 1
    }

    /// A number that has no mark if it is zero for every result of the marked operation.
    fn unless_zero(value: PrimeField, is_zero: bool, is_marked: bool) -> Self {
        IS_LOST.set(IS_LOST.get() || is_zero);
        Self { value, is_marked: is_marked && !is_zero }
    }

    fn is_exact_zero(self) -> bool {
        !self.is_marked && self.value.value() == 0
    }
}

impl Bits for Traced {
    fn bits(self) -> u64 {
        self.value.value() | (u64::from(self.is_marked) << MARK)
    }

    fn from_bits(bits: u64) -> Self {
        Self { value: PrimeField::new(bits & !(1 << MARK)), is_marked: Self::is_marked(bits) }
    }

    fn is_finite(self) -> bool {
        true
    }

    fn marked(self) -> Self {
        Self { is_marked: true, ..self }
    }
}

impl From<PrimeField> for Traced {
    fn from(value: PrimeField) -> Self {
        Self { value, is_marked: false }
    }
}

impl From<f64> for Traced {
    fn from(value: f64) -> Self {
        Self::from(PrimeField::from(value))
    }
}

impl Add for Traced {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, is_marked: self.is_marked | other.is_marked }
    }
}

impl Sub for Traced {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, is_marked: self.is_marked | other.is_marked }
    }
}

impl Mul for Traced {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let is_zero = self.is_marked && other.is_exact_zero() || other.is_marked && self.is_exact_zero();
        Self::unless_zero(self.value * other.value, is_zero, self.is_marked | other.is_marked)
    }
}

impl Div for Traced {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let is_zero = other.is_marked && self.is_exact_zero();
        Self::unless_zero(self.value / other.value, is_zero, self.is_marked | other.is_marked)
    }
}

impl Neg for Traced {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

field_from_operators!([] Traced);

impl Real for Traced {
    fn sqrt(self) -> Self {
        Self { value: self.value.sqrt(), ..self }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (Self { value: sin, ..self }, Self { value: cos, ..self })
    }
}
