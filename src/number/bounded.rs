//! A number that knows how wrong it can be: running error analysis.
//!
//! Each operation passes on the errors of its operands to first and second order and adds half an ulp of its own
//! (J. H. Wilkinson, "Error analysis revisited", 1986; N. Higham, *Accuracy and Stability*, section 3.3). Running a
//! formula over `Bounded` therefore yields its `f64` value, bit by bit, together with a bound on the distance from
//! the value that exact arithmetic would have given. This is what the gate compares with: no tolerance is tuned.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Unit roundoff of `f64`, 2^-53.
const UNIT: f64 = f64::EPSILON / 2.0;

/// The bound itself is computed in `f64`, by at most eight operations each; this factor covers their rounding.
const INFLATION: f64 = 1.0 + 16.0 * UNIT;

/// A value with an absolute bound on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// The value: the same bits that plain `f64` would have.
    pub value: f64,
    /// No less than |value - exact value|; infinite where nothing is known.
    pub bound: f64,
}

impl Bounded {
    /// A value known up to `bound`.
    pub fn new(value: f64, bound: f64) -> Self {
        Self { value, bound }
    }

    /// The result of one rounded operation whose operands contribute `inherited`.
    #[inline]
    fn rounded(value: f64, inherited: f64) -> Self {
        Self { value, bound: (inherited + UNIT * value.abs()) * INFLATION }
    }
}

impl From<f64> for Bounded {
    #[inline]
    fn from(value: f64) -> Self {
        Self { value, bound: 0.0 }
    }
}

impl Add for Bounded {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.bound + other.bound)
    }
}

impl Sub for Bounded {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.bound + other.bound)
    }
}

impl Mul for Bounded {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let inherited =
            self.value.abs() * other.bound + self.bound * other.value.abs() + self.bound * other.bound;
        Self::rounded(self.value * other.value, inherited)
    }
}

impl Div for Bounded {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let nearest = other.value.abs() - other.bound;
        if nearest > 0.0 {
            Self::rounded(value, (self.bound + value.abs() * other.bound) / nearest)
        } else {
            Self { value, bound: f64::INFINITY }
        }
    }
}

impl Neg for Bounded {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, bound: self.bound }
    }
}

field_from_operators!([] Bounded);

impl Real for Bounded {
    fn sqrt(self) -> Self {
        // |√v - √e| = |v - e| / (√v + √e), and e may be 0; so may v, and the root of -0.0 is -0.0.
        let value = self.value.sqrt();
        let inherited =
            if self.bound == 0.0 { 0.0 } else { (self.bound / value.abs()).min(self.bound.sqrt()) };
        Self::rounded(value, inherited)
    }

    fn sin_cos(self) -> (Self, Self) {
        // The library functions are good to one ulp, twice the half that `rounded` adds.
        let (sin, cos) = self.value.sin_cos();
        let part = |value: f64| Self::rounded(value, self.bound + UNIT * value.abs());
        (part(sin), part(cos))
    }
}
