//! A number that counts its operations: a lower bound of the arithmetic of a formula.

use super::{Real, field_from_operators};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

/// The origin of a number, as far as it decides the cost of the next operation.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Origin {
    /// It is known before the computation.
    Constant,
    /// It is a product, which can still be fused with a sum.
    Product,
    /// It is an input, or any other result.
    Other,
}

/// An `f64` whose operations are counted, separately on each thread.
///
/// A product and the sum that it enters count as one, because processors have such an operation. A quotient, a root, a
/// sine and a cosine count as one each, although they take longer. A change of sign, an operation on constants alone, a
/// sum with zero, and a product with zero or one count as nothing. The count is therefore a lower bound.
#[derive(Clone, Copy, Debug)]
pub struct OperationCount {
    value: f64,
    origin: Origin,
}

impl OperationCount {
    /// A number that is not known in advance. [`From`] makes constants.
    pub fn given(value: f64) -> Self {
        Self { value, origin: Origin::Other }
    }

    /// The number of operations of `work`.
    pub fn count(work: impl FnOnce()) -> usize {
        let before = COUNT.get();
        work();
        COUNT.get() - before
    }

    fn is(self, value: f64) -> bool {
        self.origin == Origin::Constant && self.value.to_bits() == value.to_bits()
    }

    /// The result of an operation.
    fn new(value: f64, origin: Origin) -> Self {
        COUNT.set(COUNT.get() + 1);
        Self { value, origin }
    }
}

impl From<f64> for OperationCount {
    fn from(value: f64) -> Self {
        Self { value, origin: Origin::Constant }
    }
}

impl PartialEq for OperationCount {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl Add for OperationCount {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        match (self.origin, other.origin) {
            _ if self.is(0.0) => other,
            _ if other.is(0.0) => self,
            (Origin::Constant, Origin::Constant) => Self::from(value),
            (Origin::Product, _) | (_, Origin::Product) => Self::given(value),
            _ => Self::new(value, Origin::Other),
        }
    }
}

impl Sub for OperationCount {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for OperationCount {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        match (self.origin, other.origin) {
            _ if self.is(0.0) || other.is(0.0) => Self::from(0.0),
            _ if self.is(1.0) => other,
            _ if other.is(1.0) => self,
            _ if self.is(-1.0) => -other,
            _ if other.is(-1.0) => -self,
            (Origin::Constant, Origin::Constant) => Self::from(value),
            _ => Self::new(value, Origin::Product),
        }
    }
}

impl Div for OperationCount {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        match (self.origin, other.origin) {
            _ if self.is(0.0) => self,
            _ if other.is(1.0) => self,
            (Origin::Constant, Origin::Constant) => Self::from(value),
            // The inverse of a constant is a constant too, so this is a product.
            (_, Origin::Constant) => Self::new(value, Origin::Product),
            _ => Self::new(value, Origin::Other),
        }
    }
}

impl Neg for OperationCount {
    type Output = Self;

    fn neg(self) -> Self {
        // The constant -0.0 would differ from 0.0.
        if self.is(0.0) { self } else { Self { value: -self.value, ..self } }
    }
}

field_from_operators!([] OperationCount);

impl Real for OperationCount {
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        if self.origin == Origin::Constant { Self::from(value) } else { Self::new(value, Origin::Other) }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        if self.origin == Origin::Constant {
            return (Self::from(sin), Self::from(cos));
        }
        (Self::new(sin, Origin::Other), Self::new(cos, Origin::Other))
    }
}

#[cfg(test)]
mod tests {
    use super::OperationCount;
    use crate::number::Real;
    use num_traits::{One, Zero};
    use std::hint::black_box;

    fn operations(work: impl FnOnce([OperationCount; 4]) -> OperationCount) -> usize {
        let given = [2.0, 3.0, 5.0, 7.0].map(OperationCount::given);
        OperationCount::count(|| {
            black_box(work(given));
        })
    }

    #[test]
    fn a_product_goes_into_the_sum_after_it() {
        assert_eq!(operations(|[a, b, ..]| a * b), 1);
        assert_eq!(operations(|[a, b, c, _]| a * b + c), 1);
        assert_eq!(operations(|[a, b, c, _]| c - a * b), 1);
        assert_eq!(operations(|[a, b, c, d]| a * b + c * d), 2);
        assert_eq!(operations(|[a, b, c, d]| (a * b + c) + d), 2);
        assert_eq!(operations(|[a, b, c, d]| a + b + c + d), 3);
    }

    #[test]
    fn what_is_known_before_counts_nothing() {
        let (zero, one, half) = (OperationCount::zero(), OperationCount::one(), OperationCount::from(0.5));
        assert_eq!(operations(|[a, ..]| (a + zero) * one - zero * a), 0);
        assert_eq!(operations(|[a, ..]| -a * -one / one), 0);
        assert_eq!(operations(|_| (half * half + half).sqrt() / half), 0);
        assert_eq!(operations(|[a, ..]| (a + one) * half), 2);
        assert_eq!(operations(|[a, ..]| a - -zero), 0);
    }

    #[test]
    fn what_takes_longer_is_one_operation_too() {
        assert_eq!(operations(|[a, b, ..]| a / b), 1);
        assert_eq!(operations(|[a, ..]| a.sqrt() + a), 2);
        assert_eq!(operations(|[a, ..]| a.sin_cos().0), 2);
        assert_eq!(operations(|[a, b, ..]| a / OperationCount::from(3.0) + b), 1);
    }
}
