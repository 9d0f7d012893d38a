//! A number with a bound on its rounding error: running error analysis.
//!
//! Each operation passes on the errors of its operands to first and second order and adds half an ulp of its own
//! (J. H. Wilkinson, "Error analysis revisited", 1986; N. Higham, *Accuracy and Stability*, section 3.3). Running a
//! formula over `RunningError` therefore yields its `f64` value, bit by bit, together with a bound on the distance from
//! the exact value. The check compares with these bounds, so no tolerance is tuned.

use super::{Real, field_from_operators};
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A factor that compensates for the rounding of the bound itself.
///
/// A bound is a sum of products of the half ulps of operations and of the bounds of inputs, which this factor enlarges.
/// An operation on bounds loses half an ulp of the bound at most. 2^28 operations in a row lose less than this factor
/// adds, even in nested roots. The only difference, the distance of a divisor from zero, becomes smaller by it.
///
/// A bound may be attained up to this factor. The rounding of a closest point's parameter is known from double-double. If
/// it has a larger effect than all other rounding, and a linear one, the error of a result is the bound over this factor.
/// So error / tolerance comes near 1/(1 + 2^-20) = 0.999999046, and stays below 1 by the derivation above.
const INFLATION: f64 = 1.0 + 1.0 / (1 << 20) as f64;

/// Unit roundoff of `f64`, 2^-53, inflated.
const UNIT: f64 = f64::EPSILON / 2.0 * INFLATION;

/// One or several bounds. Several bounds belong to several assumptions on the inputs, and cost about as much as
/// one.
pub trait Bound: Copy + PartialEq + Debug + Send + Sync + 'static {
    /// No error.
    const NONE: Self;

    /// Applies `f` to each bound.
    #[must_use]
    fn map(self, f: impl Fn(f64) -> f64) -> Self;

    /// Applies `f` to each bound and its counterpart.
    #[must_use]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self;
}

impl Bound for f64 {
    const NONE: Self = 0.0;

    #[inline]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }

    #[inline]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        f(self, other)
    }
}

impl Bound for [f64; 2] {
    const NONE: Self = [0.0; 2];

    #[inline]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        [f(self[0]), f(self[1])]
    }

    #[inline]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        [f(self[0], other[0]), f(self[1], other[1])]
    }
}

/// A value with an absolute bound on its error.
pub type RunningError = RunningErrorBy<f64>;

/// A value with one or several absolute bounds on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunningErrorBy<B> {
    /// The value: the same bits that plain `f64` would have.
    pub value: f64,
    /// At least |value - exact value|; infinite if nothing is known.
    pub bound: B,
}

impl<B: Bound> RunningErrorBy<B> {
    /// A value with this error bound.
    pub fn new(value: f64, bound: B) -> Self {
        Self { value, bound: bound.map(|bound| bound * INFLATION) }
    }

    /// The result of one rounded operation whose operands contribute `inherited`.
    #[inline]
    fn rounded(value: f64, inherited: B) -> Self {
        let rounding = UNIT * value.abs();
        Self { value, bound: inherited.map(|inherited| inherited + rounding) }
    }

    /// The error that a sum or a difference inherits.
    #[inline]
    fn of_sum(self, other: Self) -> B {
        self.bound.zip(other.bound, |e, other| e + other)
    }

    /// The error that a product inherits: |v| e' + e |v'| + e e'.
    #[inline]
    fn of_product(self, other: Self) -> B {
        let (size, other_size) = (self.value.abs(), other.value.abs());
        self.bound.zip(other.bound, |e, other| size * other + e * (other_size + other))
    }

    /// The error that a quotient inherits: (e + |v/v'| e')/(|v'| - e').
    #[inline]
    fn of_quotient(self, other: Self, quotient: f64) -> B {
        let (size, other_size) = (quotient.abs(), other.value.abs());
        self.bound.zip(other.bound, |e, other| {
            let nearest = other_size - other;
            if nearest > 0.0 { (e + size * other) / nearest } else { f64::INFINITY }
        })
    }
}

impl<B: Bound> From<f64> for RunningErrorBy<B> {
    #[inline]
    fn from(value: f64) -> Self {
        Self { value, bound: B::NONE }
    }
}

impl<B: Bound> Add for RunningErrorBy<B> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::rounded(self.value + other.value, self.of_sum(other))
    }
}

impl<B: Bound> Sub for RunningErrorBy<B> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::rounded(self.value - other.value, self.of_sum(other))
    }
}

impl<B: Bound> Mul for RunningErrorBy<B> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::rounded(self.value * other.value, self.of_product(other))
    }
}

impl<B: Bound> Div for RunningErrorBy<B> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::rounded(value, self.of_quotient(other, value))
    }
}

impl<B: Bound> Neg for RunningErrorBy<B> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, bound: self.bound }
    }
}

field_from_operators!([B: Bound] RunningErrorBy<B>);

impl<B: Bound> Real for RunningErrorBy<B> {
    fn sqrt(self) -> Self {
        // |√v - √e| = |v - e| / (√v + √e), and e may be 0; so may v, and the root of -0.0 is -0.0.
        let value = self.value.sqrt();
        let size = value.abs();
        Self::rounded(value, self.bound.map(|e| if e == 0.0 { 0.0 } else { (e / size).min(e.sqrt()) }))
    }

    fn sin_cos(self) -> (Self, Self) {
        // The library functions are accurate to one ulp, twice the half ulp that `rounded` adds.
        let (sin, cos) = self.value.sin_cos();
        let part = |value: f64| Self::rounded(value, self.bound.map(|e| e + UNIT * value.abs()));
        (part(sin), part(cos))
    }
}
