//! Double-double: about 32 digits, the oracle against which the accuracy of `f64` is measured.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};
use twofloat::TwoFloat;

/// An unevaluated sum of two `f64`, about 106 bits; arithmetic by [`twofloat`].
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble(TwoFloat);

impl DoubleDouble {
    /// The nearest `f64`.
    pub fn value(self) -> f64 {
        self.0.hi()
    }

    /// The low word: the exact value is `value() + low()`.
    pub fn low(self) -> f64 {
        self.0.lo()
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(self) -> Self {
        Self(self.0.abs())
    }
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self(TwoFloat::from_f64(value))
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // One correction: the quotient of twofloat 0.8 alone is good to about 2^-98 only.
        let quotient = self.0 / other.0;
        Self(quotient + (self.0 - quotient * other.0) / other.0)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

field_from_operators!([] DoubleDouble);

impl Real for DoubleDouble {
    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        if root.hi() == 0.0 {
            return Self(root);
        }
        // Newton's correction, with the residual in double-double.
        Self(root + (self.0 - root * root) / (2.0 * root))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }
}
