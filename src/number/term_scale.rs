//! The size of the terms of a formula: the scale that decides whether a difference is small.
//!
//! A result of cancellation is small although its terms are large. Relative to its own size, correct code would be
//! rejected. Relative to a fixed number, wrong code would pass. `TermScale` contains, next to the value, the sum of
//! the absolute values of the terms: |a| + |b| for a sum, the product of both for a product.

use super::{Real, field_from_operators};
use nalgebra::Vector3;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and the sum of the absolute values of its terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TermScale {
    /// The value.
    pub value: f64,
    /// The sum of the absolute values of its terms; never below |value|.
    pub scale: f64,
}

impl TermScale {
    /// A vector. All components have the scale of the whole vector, because the axes decide which component is small.
    ///
    /// The scale of each is ‖v‖/√3, so that the scale of v·w is ‖v‖‖w‖. A larger component has its size as its scale.
    pub fn vector(v: Vector3<f64>) -> Vector3<Self> {
        let share = v.norm() / 3.0_f64.sqrt();
        v.map(|value| Self { value, scale: share.max(value.abs()) })
    }

    /// A parameter of a curve: its scale is the half-width of its range, [-1, 1].
    pub fn parameter(value: f64) -> Self {
        Self { value, scale: 1.0 }
    }
}

impl From<f64> for TermScale {
    fn from(value: f64) -> Self {
        Self { value, scale: value.abs() }
    }
}

impl Add for TermScale {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, scale: self.scale + other.scale }
    }
}

impl Sub for TermScale {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, scale: self.scale + other.scale }
    }
}

impl Mul for TermScale {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, scale: self.scale * other.scale }
    }
}

impl Div for TermScale {
    type Output = Self;
    /// The denominator counts by its value. Its own cancellation belongs to the conditioning and not to the terms.
    fn div(self, other: Self) -> Self {
        Self { value: self.value / other.value, scale: self.scale / other.value.abs() }
    }
}

impl Neg for TermScale {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, scale: self.scale }
    }
}

field_from_operators!([] TermScale);

impl Real for TermScale {
    /// The scale of a length is the scale of the components of the vector, even if the vector is short by cancellation.
    fn sqrt(self) -> Self {
        Self { value: self.value.sqrt(), scale: self.scale.sqrt() }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (Self::from(sin), Self::from(cos))
    }
}
