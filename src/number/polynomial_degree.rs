//! The degree of a formula. It bounds the probability that exact arithmetic at random points misses a fault.

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
    /// A constant.
    pub const CONSTANT: Self = Self { numerator: 0.0, denominator: 0.0 };

    /// A variable.
    pub const VARIABLE: Self = Self { numerator: 1.0, denominator: 0.0 };

    /// The degree of the difference of two such functions, multiplied out.
    pub const fn of_difference(self, other: Self) -> f64 {
        let difference = self.sum(other);
        difference.numerator.max(difference.denominator)
    }

    /// Of a sum or a difference.
    #[inline]
    pub(super) const fn sum(self, other: Self) -> Self {
        Self {
            numerator: (self.numerator + other.denominator).max(other.numerator + self.denominator),
            denominator: self.denominator + other.denominator,
        }
    }

    #[inline]
    pub(super) const fn product(self, other: Self) -> Self {
        Self {
            numerator: self.numerator + other.numerator,
            denominator: self.denominator + other.denominator,
        }
    }

    #[inline]
    pub(super) const fn quotient(self, other: Self) -> Self {
        self.product(Self { numerator: other.denominator, denominator: other.numerator })
    }

    pub(super) const fn root(self) -> Self {
        Self { numerator: 0.5 * self.numerator, denominator: 0.5 * self.denominator }
    }

    pub(super) const fn on_circle(self) -> Self {
        let degree = 2.0 * self.numerator.max(self.denominator);
        Self { numerator: degree, denominator: degree }
    }
}
