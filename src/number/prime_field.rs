//! The prime field of 2^61 - 1: arithmetic is exact, so two formulas are either equal or different.
//!
//! The closed form and hyper-dual arithmetic need + - * / and square roots alone. Both therefore run in this field, and
//! `==` compares them without a tolerance. By the lemma of Schwartz and Zippel, two different rational functions of
//! degree n agree at a random point with a probability of n / 2^61 at most.

use super::polynomial_degree::PolynomialDegree;
use super::{Real, field_from_operators};
use std::hash::{Hash, Hasher};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An element of the field of integers modulo 2^61 - 1, with the degree of the formula that it results from.
///
/// The degree has no part in comparisons.
#[derive(Clone, Copy, Debug)]
pub struct PrimeField {
    residue: u64,
    degree: PolynomialDegree,
}

impl PrimeField {
    /// The modulus, 2^61 - 1.
    pub const PRIME: u64 = (1 << 61) - 1;

    /// The residue of an integer, as a constant.
    #[inline]
    pub const fn new(value: u64) -> Self {
        Self { residue: reduced(value), degree: PolynomialDegree::CONSTANT }
    }

    /// The same number as a variable, whose degree counts.
    #[must_use]
    pub const fn variable(self) -> Self {
        Self { degree: PolynomialDegree::VARIABLE, ..self }
    }

    /// The integer between 0 and the modulus.
    pub const fn value(self) -> u64 {
        self.residue
    }

    /// The degree in the variables.
    pub const fn degree(self) -> PolynomialDegree {
        self.degree
    }

    /// The fraction that equals this element, with numerator and denominator of at most `limit`, if there is one.
    ///
    /// With a limit below 2^30 there is at most one. It is in lowest terms, and the denominator is positive.
    ///
    /// Source: P. Wang, "A p-adic algorithm for univariate partial fractions", 1981, doi:10.1145/800206.806398.
    pub fn fraction(self, limit: u32) -> Option<(i64, u64)> {
        // Euclid's algorithm on (p, a) keeps r = ±s a, with falling remainders r and rising cofactors s.
        let (mut remainders, mut cofactors, mut negative) = ([Self::PRIME, self.residue], [0, 1], false);
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
        power(self.residue, (Self::PRIME - 1) / 2) <= 1
    }
}

/// The residue of an integer.
#[inline]
const fn reduced(value: u64) -> u64 {
    // 2^61 = 1, so the bits from the 61st on are added to those below.
    let folded = (value & PrimeField::PRIME) + (value >> 61);
    if folded >= PrimeField::PRIME { folded - PrimeField::PRIME } else { folded }
}

/// The product of two residues.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "the low 61 bits and the high 61 bits of 122")]
fn product(one: u64, other: u64) -> u64 {
    let product = u128::from(one) * u128::from(other);
    reduced((product as u64 & PrimeField::PRIME) + (product >> 61) as u64)
}

/// The power of a residue.
fn power(residue: u64, mut exponent: u64) -> u64 {
    let (mut power, mut square) = (1, residue);
    while exponent > 0 {
        if exponent % 2 == 1 {
            power = product(power, square);
        }
        square = product(square, square);
        exponent /= 2;
    }
    power
}

/// By Fermat, 1 / a = a^(p - 2).
fn inverse(residue: u64) -> u64 {
    power(residue, PrimeField::PRIME - 2)
}

impl PartialEq for PrimeField {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.residue == other.residue
    }
}

impl Eq for PrimeField {}

impl Hash for PrimeField {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.residue.hash(state);
    }
}

impl From<f64> for PrimeField {
    /// Exact for every finite number: an `f64` is an integer times a power of two. Other numbers become 0.
    fn from(value: f64) -> Self {
        if !value.is_finite() {
            return Self::new(0);
        }
        let bits = value.to_bits();
        let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        let mantissa = if exponent == 0 { fraction } else { fraction | (1 << 52) };
        // |value| = mantissa 2^(exponent - 1075), and 2^(-1075) = 2^(61 * 18 - 1075) = 2^23.
        let size = Self::new(product(mantissa, power(2, exponent.max(1) + 23)));
        if value.is_sign_negative() { -size } else { size }
    }
}

// In a build for tests these operations are calls, so that the formulas over them compile in less time.
impl Add for PrimeField {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn add(self, other: Self) -> Self {
        Self { residue: reduced(self.residue + other.residue), degree: self.degree.sum(other.degree) }
    }
}

impl Sub for PrimeField {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn sub(self, other: Self) -> Self {
        let residue = reduced(self.residue + (Self::PRIME - other.residue));
        Self { residue, degree: self.degree.sum(other.degree) }
    }
}

impl Mul for PrimeField {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn mul(self, other: Self) -> Self {
        Self { residue: product(self.residue, other.residue), degree: self.degree.product(other.degree) }
    }
}

impl Div for PrimeField {
    type Output = Self;
    /// A quotient by 0 is 0, because the field has no infinity.
    fn div(self, other: Self) -> Self {
        let residue = product(self.residue, inverse(other.residue));
        Self { residue, degree: self.degree.quotient(other.degree) }
    }
}

impl Neg for PrimeField {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline)]
    fn neg(self) -> Self {
        Self { residue: reduced(Self::PRIME - self.residue), ..self }
    }
}

field_from_operators!([] PrimeField);

impl Real for PrimeField {
    /// One of the two roots of a square, always the same. If the argument is not a square, the result has no meaning
    /// ([`PrimeField::is_square`]).
    fn sqrt(self) -> Self {
        // p = 3 mod 4: (v^((p + 1)/4))² = v v^((p - 1)/2) = v, or -v if v has no root. Then the result is v itself.
        let root = power(self.residue, (Self::PRIME + 1) >> 2);
        let residue = if product(root, root) == self.residue { root } else { self.residue };
        Self { residue, degree: self.degree.root() }
    }

    /// A point of the unit circle. Differentiation uses only s' = c and c' = -s, which the dual numbers over this field
    /// provide, and s² + c² = 1.
    fn sin_cos(self) -> (Self, Self) {
        let (one, constant) = (Self::new(1), Self::new(self.residue));
        let square = constant * constant;
        let denominator = one + square;
        let degree = self.degree.on_circle();
        let [sine, cosine] =
            [constant + constant, one - square].map(|of| Self { degree, ..of / denominator });
        (sine, cosine)
    }
}
