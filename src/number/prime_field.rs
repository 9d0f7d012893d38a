//! The prime field of 2^61 - 1: arithmetic is exact, so two formulas are either equal or different.
//!
//! The closed form and hyper-dual arithmetic need + - * / and square roots alone. Both therefore run in this field, and
//! `==` compares them without a tolerance. By the lemma of Schwartz and Zippel, two different rational functions of
//! degree n agree at a random point with a probability of n / 2^61 at most.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An element of the field of integers modulo 2^61 - 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PrimeField(u64);

impl PrimeField {
    /// The modulus, 2^61 - 1.
    pub const PRIME: u64 = (1 << 61) - 1;

    /// The residue of an integer.
    #[inline]
    pub const fn new(value: u64) -> Self {
        // 2^61 = 1, so the bits from the 61st on are added to those below.
        let folded = (value & Self::PRIME) + (value >> 61);
        Self(if folded >= Self::PRIME { folded - Self::PRIME } else { folded })
    }

    /// The integer between 0 and the modulus.
    pub const fn value(self) -> u64 {
        self.0
    }

    /// The power with an integer exponent.
    #[must_use]
    pub fn power(self, mut exponent: u64) -> Self {
        let (mut power, mut square) = (Self(1), self);
        while exponent > 0 {
            if exponent % 2 == 1 {
                power *= square;
            }
            square *= square;
            exponent /= 2;
        }
        power
    }

    /// The fraction that equals this element, with numerator and denominator of at most `limit`, if there is one.
    ///
    /// With a limit below 2^30 there is at most one. It is in lowest terms, and the denominator is positive.
    ///
    /// Source: P. Wang, "A p-adic algorithm for univariate partial fractions", 1981, doi:10.1145/800206.806398.
    pub fn fraction(self, limit: u32) -> Option<(i64, u64)> {
        // Euclid's algorithm on (p, a) keeps r = ±s a, with falling remainders r and rising cofactors s.
        let (mut remainders, mut cofactors, mut negative) = ([Self::PRIME, self.0], [0, 1], false);
        while remainders[1] > u64::from(limit) {
            let quotient = remainders[0] / remainders[1];
            remainders = [remainders[1], remainders[0] % remainders[1]];
            cofactors = [cofactors[1], cofactors[0] + quotient * cofactors[1]];
            negative = !negative;
        }
        let numerator = i64::try_from(remainders[1]).ok()?;
        let fraction = (if negative { -numerator } else { numerator }, cofactors[1]);
        (cofactors[1] <= u64::from(limit)).then_some(fraction)
    }

    /// Whether a square root exists (Euler's criterion).
    pub fn is_square(self) -> bool {
        self.power((Self::PRIME - 1) / 2).0 <= 1
    }
}

impl From<f64> for PrimeField {
    /// Exact for every finite number: an `f64` is an integer times a power of two. Other numbers become 0.
    fn from(value: f64) -> Self {
        if !value.is_finite() {
            return Self(0);
        }
        let bits = value.to_bits();
        let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        let mantissa = if exponent == 0 { fraction } else { fraction | (1 << 52) };
        // |value| = mantissa 2^(exponent - 1075), and 2^(-1075) = 2^(61 * 18 - 1075) = 2^23.
        let size = Self(mantissa) * Self(2).power(exponent.max(1) + 23);
        if value.is_sign_negative() { -size } else { size }
    }
}

impl Add for PrimeField {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.0 + other.0)
    }
}

impl Sub for PrimeField {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.0 + (Self::PRIME - other.0))
    }
}

impl Mul for PrimeField {
    type Output = Self;
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "the low 61 bits and the high 61 bits of 122")]
    fn mul(self, other: Self) -> Self {
        let product = u128::from(self.0) * u128::from(other.0);
        Self::new((product as u64 & Self::PRIME) + (product >> 61) as u64)
    }
}

impl Div for PrimeField {
    type Output = Self;
    /// By Fermat, 1 / a = a^(p - 2). A quotient by 0 is 0, because the field has no infinity.
    fn div(self, other: Self) -> Self {
        self * other.power(Self::PRIME - 2)
    }
}

impl Neg for PrimeField {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(Self::PRIME - self.0)
    }
}

field_from_operators!([] PrimeField);

impl Real for PrimeField {
    /// One of the two roots of a square, always the same. If the argument is not a square, the result has no meaning
    /// ([`PrimeField::is_square`]).
    fn sqrt(self) -> Self {
        // p = 3 mod 4: (v^((p + 1)/4))² = v v^((p - 1)/2) = v, or -v if v has no root. Then the result is v itself.
        let root = self.power((Self::PRIME + 1) >> 2);
        if root * root == self { root } else { self }
    }

    /// A point of the unit circle. Differentiation uses only s' = c and c' = -s, which the dual numbers over this field
    /// provide, and s² + c² = 1.
    fn sin_cos(self) -> (Self, Self) {
        let (one, square) = (Self(1), self * self);
        let denominator = one + square;
        ((self + self) / denominator, (one - square) / denominator)
    }
}
