//! Hyper-dual numbers for a whole row of a Hessian: one direction delta against `C` directions Delta.
//!
//! The value and the variation delta do not depend on the directions Delta. They are computed once and not `C` times.
//! The rest are loops over `C`, which a compiler vectorizes. One number over all dofs of a pair has hundreds of parts
//! and does not fit into registers. A few rows of four or eight directions are much faster.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `re + eps1 e1 + sum_j (eps2[j] e2_j + eps1eps2[j] e1 e2_j)`, where e1^2 and all products of two e2 are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HyperDualRow<const C: usize> {
    /// The value.
    pub re: f64,
    /// The first variation, delta.
    pub eps1: f64,
    /// The first variations, Delta.
    pub eps2: [f64; C],
    /// The second variations, Delta-delta.
    pub eps1eps2: [f64; C],
}

impl<const C: usize> HyperDualRow<C> {
    /// A number with first derivatives and no mixed ones.
    #[inline]
    pub fn to_first_order(re: f64, eps1: f64, eps2: impl Fn(usize) -> f64) -> Self {
        Self { re, eps1, eps2: std::array::from_fn(eps2), eps1eps2: [0.0; C] }
    }

    /// The chain rule: f, f' and f'' at the value.
    #[inline]
    fn chain(self, f0: f64, f1: f64, f2: f64) -> Self {
        let slope = f2 * self.eps1;
        Self {
            re: f0,
            eps1: f1 * self.eps1,
            eps2: std::array::from_fn(|j| f1 * self.eps2[j]),
            eps1eps2: std::array::from_fn(|j| f1 * self.eps1eps2[j] + slope * self.eps2[j]),
        }
    }

    /// Both numbers, part by part.
    #[inline]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            re: f(self.re, other.re),
            eps1: f(self.eps1, other.eps1),
            eps2: std::array::from_fn(|j| f(self.eps2[j], other.eps2[j])),
            eps1eps2: std::array::from_fn(|j| f(self.eps1eps2[j], other.eps1eps2[j])),
        }
    }
}

impl<const C: usize> From<f64> for HyperDualRow<C> {
    #[inline]
    fn from(re: f64) -> Self {
        Self::to_first_order(re, 0.0, |_| 0.0)
    }
}

impl<const C: usize> Add for HyperDualRow<C> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<const C: usize> Sub for HyperDualRow<C> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<const C: usize> Mul for HyperDualRow<C> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re,
            eps1: self.re * other.eps1 + self.eps1 * other.re,
            eps2: std::array::from_fn(|j| self.re * other.eps2[j] + self.eps2[j] * other.re),
            eps1eps2: std::array::from_fn(|j| {
                self.re * other.eps1eps2[j]
                    + self.eps1 * other.eps2[j]
                    + self.eps2[j] * other.eps1
                    + self.eps1eps2[j] * other.re
            }),
        }
    }
}

impl<const C: usize> Div for HyperDualRow<C> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        // From p = quotient * other, part by part.
        let inverse = 1.0 / other.re;
        let re = self.re * inverse;
        let eps1 = (self.eps1 - re * other.eps1) * inverse;
        let eps2: [f64; C] = std::array::from_fn(|j| (self.eps2[j] - re * other.eps2[j]) * inverse);
        let eps1eps2 = std::array::from_fn(|j| {
            (self.eps1eps2[j] - eps1 * other.eps2[j] - eps2[j] * other.eps1 - re * other.eps1eps2[j])
                * inverse
        });
        Self { re, eps1, eps2, eps1eps2 }
    }
}

impl<const C: usize> Neg for HyperDualRow<C> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::from(0.0) - self
    }
}

field_from_operators!([const C: usize] HyperDualRow<C>);

impl<const C: usize> Real for HyperDualRow<C> {
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.re.sqrt();
        let slope = 0.5 / root;
        self.chain(root, slope, -slope / (self.re + self.re))
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.re.sin_cos();
        (self.chain(sin, cos, -sin), self.chain(cos, -sin, -cos))
    }
}
