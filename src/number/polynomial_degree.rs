//! The degree of a formula. It bounds the probability that exact arithmetic at random points misses a fault.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Upper bounds on the degrees of the numerator and the denominator of a rational function that a formula computes.
///
/// No cancellation is assumed, so the bounds are not sharp, and need not be. A square root counts as a variable of
/// half the degree of its argument. Sine and cosine count as rational functions of degree 2: they are coordinates of
/// random points of the circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolynomialDegree {
    /// The degree of the numerator.
    pub numerator: f64,
    /// The degree of the denominator.
    pub denominator: f64,
}

impl PolynomialDegree {
    /// A variable.
    pub const VARIABLE: Self = Self { numerator: 1.0, denominator: 0.0 };

    /// The degree of the difference of two such functions, multiplied out.
    pub fn of_difference(self, other: Self) -> f64 {
        let difference = self - other;
        difference.numerator.max(difference.denominator)
    }
}

impl From<f64> for PolynomialDegree {
    fn from(_: f64) -> Self {
        Self { numerator: 0.0, denominator: 0.0 }
    }
}

impl Add for PolynomialDegree {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            numerator: (self.numerator + other.denominator).max(other.numerator + self.denominator),
            denominator: self.denominator + other.denominator,
        }
    }
}

impl Sub for PolynomialDegree {
    type Output = Self;
    #[expect(clippy::suspicious_arithmetic_impl, reason = "a difference has the degree of a sum")]
    fn sub(self, other: Self) -> Self {
        self + other
    }
}

impl Mul for PolynomialDegree {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            numerator: self.numerator + other.numerator,
            denominator: self.denominator + other.denominator,
        }
    }
}

impl Div for PolynomialDegree {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        Self {
            numerator: self.numerator + other.denominator,
            denominator: self.denominator + other.numerator,
        }
    }
}

impl Neg for PolynomialDegree {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self
    }
}

field_from_operators!([] PolynomialDegree);

impl Real for PolynomialDegree {
    fn sqrt(self) -> Self {
        Self { numerator: 0.5 * self.numerator, denominator: 0.5 * self.denominator }
    }

    fn sin_cos(self) -> (Self, Self) {
        let degree = 2.0 * self.numerator.max(self.denominator);
        let both = Self { numerator: degree, denominator: degree };
        (both, both)
    }
}
