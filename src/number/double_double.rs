//! Double-double: about 32 digits, the oracle against which the accuracy of `f64` is measured.

use super::{Real, field_from_operators};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use std::ops::{Add, Div, Mul, Neg, Sub};
use twofloat::TwoFloat;

/// An unevaluated sum of two `f64`, about 106 bits; arithmetic by the crate `twofloat`.
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
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        // One correction, because the quotient of twofloat 0.8 alone is accurate to about 2^-98 only.
        let quotient = self.0 / other.0;
        Self(quotient + (self.0 - quotient * other.0) / other.0)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
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

    /// Accurate to about 1e-32 (1 + |x|), in absolute terms. The functions of twofloat 0.8 are accurate to 3e-21 only.
    fn sin_cos(self) -> (Self, Self) {
        let quarters = (self.value() * FRAC_2_PI).round();
        let turn = |part: f64| Self::from(quarters) * Self::from(part);
        let x = QUARTER_TURN.into_iter().fold(self, |x, part| x - turn(part));
        let square = x * x;
        // (π/4)^28 / 28! = 4e-33
        let (sin, cos) = (x * series(square, 27), series(square, 28));
        match quarters.rem_euclid(4.0) {
            ..0.5 => (sin, cos),
            0.5..1.5 => (cos, -sin),
            1.5..2.5 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

/// pi / 2 in three parts, whose sum is accurate to 159 bits.
const QUARTER_TURN: [f64; 3] = [FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

/// 1 - x^2 / (n (n - 1)) (1 - x^2 / ((n - 2) (n - 3)) (..)), built from `last` down to n = 2 or 3: the series of sin x / x
/// for an odd `last`, of cos x for an even one.
fn series(square: DoubleDouble, last: u32) -> DoubleDouble {
    let one = DoubleDouble::from(1.0);
    (2..=last)
        .rev()
        .step_by(2)
        .fold(one, |sum, n| one - square * sum / DoubleDouble::from(f64::from(n * (n - 1))))
}
