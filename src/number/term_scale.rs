//! The size of a formula's terms: the scale against which a difference is small or not.
//!
//! A result that came about by cancellation is small though its terms are large; judged by its own size, a correct
//! code would be rejected, and judged by a fixed number, a wrong code would pass. `TermScale` carries next to the
//! value the sum of the absolute values of the terms: |a| + |b| for a sum, the product of both for a product.

use super::{Real, field_from_operators};
use nalgebra::Vector3;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and the sum of the absolute values of the terms it is the sum of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TermScale {
    /// The value.
    pub value: f64,
    /// The sum of the absolute values of its terms; never below |value|.
    pub scale: f64,
}

impl TermScale {
    /// A vector, whose components have the scale of the whole: which of them is small is the choice of the axes.
    ///
    /// The scale of each is ‖v‖/√3, so that the scale of v·w is ‖v‖‖w‖; that of a larger component is its size.
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
    /// The denominator counts by its value: what its own cancellation does is conditioning, not a term.
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
    /// The length of a vector is as large as the terms of its components, however short it came out.
    fn sqrt(self) -> Self {
        Self { value: self.value.sqrt(), scale: self.scale.sqrt() }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (Self::from(sin), Self::from(cos))
    }
}
