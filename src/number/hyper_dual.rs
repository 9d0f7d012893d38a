//! A hyper-dual number over any [`Real`]: a second implementation of the arithmetic of the AD side. It also runs over
//! scalars that num-dual does not support.
//!
//! AD and linearization correspond as follows. With q + eps1 dq + eps2 Dq as dofs, the eps1 part of a result is its
//! variation delta, the eps2 part its linearization Delta, and the eps1 eps2 part Delta-delta.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `re + eps1 e1 + eps2 e2 + eps1eps2 e1 e2` with e1^2 = e2^2 = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HyperDual<T> {
    /// The value.
    pub re: T,
    /// The first variation, delta.
    pub eps1: T,
    /// The first variation, Delta.
    pub eps2: T,
    /// The second variation, Delta-delta.
    pub eps1eps2: T,
}

impl<T: Real> HyperDual<T> {
    /// The number with the four given parts.
    pub fn new(re: T, eps1: T, eps2: T, eps1eps2: T) -> Self {
        Self { re, eps1, eps2, eps1eps2 }
    }

    /// The chain rule: f, f' and f'' at the value.
    fn chain(self, f0: T, f1: T, f2: T) -> Self {
        Self::new(f0, f1 * self.eps1, f1 * self.eps2, f1 * self.eps1eps2 + f2 * self.eps1 * self.eps2)
    }
}

impl<T: Real> From<f64> for HyperDual<T> {
    #[inline]
    fn from(value: f64) -> Self {
        Self::new(T::from(value), T::zero(), T::zero(), T::zero())
    }
}

impl<T: Real> Add for HyperDual<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(
            self.re + other.re,
            self.eps1 + other.eps1,
            self.eps2 + other.eps2,
            self.eps1eps2 + other.eps1eps2,
        )
    }
}

impl<T: Real> Sub for HyperDual<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(
            self.re - other.re,
            self.eps1 - other.eps1,
            self.eps2 - other.eps2,
            self.eps1eps2 - other.eps1eps2,
        )
    }
}

impl<T: Real> Mul for HyperDual<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re,
            self.re * other.eps1 + self.eps1 * other.re,
            self.re * other.eps2 + self.eps2 * other.re,
            self.re * other.eps1eps2
                + self.eps1 * other.eps2
                + self.eps2 * other.eps1
                + self.eps1eps2 * other.re,
        )
    }
}

impl<T: Real> Div for HyperDual<T> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        // From p = quotient * other, part by part. Each part takes one division, and no divisor is squared.
        let re = self.re / other.re;
        let eps1 = (self.eps1 - re * other.eps1) / other.re;
        let eps2 = (self.eps2 - re * other.eps2) / other.re;
        let eps1eps2 =
            (self.eps1eps2 - eps1 * other.eps2 - eps2 * other.eps1 - re * other.eps1eps2) / other.re;
        Self::new(re, eps1, eps2, eps1eps2)
    }
}

impl<T: Real> Neg for HyperDual<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.eps1, -self.eps2, -self.eps1eps2)
    }
}

field_from_operators!([T: Real] HyperDual<T>);

impl<T: Real> Real for HyperDual<T> {
    fn sqrt(self) -> Self {
        let root = self.re.sqrt();
        let slope = T::from(0.5) / root;
        self.chain(root, slope, -slope / (self.re + self.re))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.re.sin_cos();
        (self.chain(sin, cos, -sin), self.chain(cos, -sin, -cos))
    }
}
