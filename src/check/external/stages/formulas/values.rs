//! The values of formulas at a sample.

use super::axes::Axes;
use super::tree::Name;
use crate::check::candidate::CAREFUL;
use crate::number::{Real, RunningError};
use nalgebra::Vector3;

/// A number in formulas: with its rounding, or without for an estimate.
pub(in crate::check::external::stages) trait Number: Real {
    const NOT_A_NUMBER: Self;

    fn of(number: RunningError) -> Self;

    fn value(self) -> f64;

    /// The nearest number of single precision.
    fn in_single_precision(self) -> Self;

    /// Whether it is less than another one, if rounding does not hide it.
    fn is_less(self, other: Self) -> Option<bool>;
}

impl Number for RunningError {
    const NOT_A_NUMBER: Self = Self { value: f64::NAN, bound: f64::NAN };

    #[inline]
    fn of(number: RunningError) -> Self {
        number
    }

    #[inline]
    fn value(self) -> f64 {
        self.value
    }

    fn in_single_precision(self) -> Self {
        let [value, low, high] = [self.value, self.value - self.bound, self.value + self.bound].map(single);
        Self { value, bound: (value - low).max(high - value) }
    }

    fn is_less(self, other: Self) -> Option<bool> {
        let difference = other - self;
        let is_known = difference.value.abs() > difference.bound || difference.bound == 0.0;
        is_known.then_some(difference.value > 0.0)
    }
}

#[expect(clippy::cast_possible_truncation, reason = "this is meant")]
fn single(number: f64) -> f64 {
    f64::from(number as f32)
}

/// What rounding may change of a number without a bound.
const UNCLEAR: f64 = 1e-9;

impl Number for f64 {
    const NOT_A_NUMBER: Self = Self::NAN;

    #[inline]
    fn of(number: RunningError) -> Self {
        number.value
    }

    #[inline]
    fn value(self) -> f64 {
        self
    }

    fn in_single_precision(self) -> Self {
        single(self)
    }

    fn is_less(self, other: Self) -> Option<bool> {
        let size = self.abs() + other.abs();
        ((other - self).abs() > UNCLEAR * size || size == 0.0).then_some(self < other)
    }
}

/// A number or a vector.
#[derive(Copy, Debug, PartialEq)]
pub(in crate::check::external::stages) enum Value<S = RunningError> {
    Number(S),
    Vector(Vector3<S>),
}

#[expect(clippy::expl_impl_clone_on_copy, reason = "the derived one looks at the kind of each value")]
impl<S: Copy> Clone for Value<S> {
    fn clone(&self) -> Self {
        *self
    }
}

use Value::{Number as Scalar, Vector};

impl<S: Real> From<f64> for Value<S> {
    fn from(value: f64) -> Self {
        Scalar(S::from(value))
    }
}

impl<S: Real> From<bool> for Value<S> {
    fn from(value: bool) -> Self {
        Self::from(if value { 1.0 } else { 0.0 })
    }
}

impl Value<f64> {
    /// As another kind of number.
    pub(super) fn exact<S: Number>(self) -> Value<S> {
        match self {
            Scalar(number) => Scalar(S::from(number)),
            Vector(vector) => Vector(vector.map(S::from)),
        }
    }

    /// Whether both are the same but for the rounding of a few operations.
    pub(super) fn is_about(self, other: Self) -> bool {
        const ROUNDING: f64 = 1e-13;
        match (self, other) {
            (Scalar(one), Scalar(other)) => (one - other).abs() <= ROUNDING * one.abs(),
            (Vector(one), Vector(other)) => (one - other).norm() <= ROUNDING * one.norm(),
            _ => self.is_zero() && other.is_zero(),
        }
    }
}

impl Value {
    /// As another kind of number.
    pub(super) fn to<S: Number>(self) -> Value<S> {
        match self {
            Scalar(number) => Scalar(S::of(number)),
            Vector(vector) => Vector(vector.map(S::of)),
        }
    }

    /// Whether both differ by more than rounding, or are of different kinds.
    pub(super) fn differs(self, other: Self) -> bool {
        let is_near = |one: RunningError, other: RunningError| {
            one == other || (one.value - other.value).abs() <= CAREFUL * (one.bound + other.bound)
        };
        match (self, other) {
            (Scalar(one), Scalar(other)) => !is_near(one, other),
            (Vector(one), Vector(other)) => (0..3).any(|axis| !is_near(one[axis], other[axis])),
            _ => true,
        }
    }
}

impl<S: Number> Value<S> {
    pub(super) const NOT_A_NUMBER: Self = Scalar(S::NOT_A_NUMBER);

    /// The derivative of a number by itself, or of a component by its vector.
    pub(super) fn of_axis(axis: Option<usize>) -> Self {
        axis.map_or(Self::from(1.0), |axis| Vector(Vector3::ith(axis, S::from(1.0))))
    }

    #[inline]
    pub(super) fn is_vector(self) -> bool {
        matches!(self, Vector(_))
    }

    /// The number; not a number for a vector.
    #[inline]
    pub(super) fn number(self) -> S {
        match self {
            Scalar(number) => number,
            Vector(_) => S::NOT_A_NUMBER,
        }
    }

    /// The number, or the component of a vector.
    #[inline]
    pub(super) fn component(self, axis: Option<usize>) -> S {
        match (self, axis) {
            (Vector(vector), Some(axis)) => vector[axis],
            _ => self.number(),
        }
    }

    #[inline]
    pub(super) fn is_zero(self) -> bool {
        match self {
            Scalar(number) => number.value() == 0.0,
            Vector(vector) => vector.iter().all(|of| of.value() == 0.0),
        }
    }

    #[inline]
    pub(super) fn is_nan(self) -> bool {
        matches!(self, Scalar(number) if number.value().is_nan())
    }

    #[inline]
    pub(super) fn negative(self) -> Self {
        match self {
            Scalar(number) => Scalar(-number),
            Vector(vector) => Vector(-vector),
        }
    }

    #[inline]
    pub(super) fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one + other),
            (Vector(one), Vector(other)) => Vector(one + other),
            // A term that is zero.
            (Vector(of), Scalar(zero)) | (Scalar(zero), Vector(of)) if zero.value() == 0.0 => Vector(of),
            _ => Self::NOT_A_NUMBER,
        }
    }

    #[inline]
    pub(super) fn times(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one * other),
            (Vector(v), Scalar(by)) | (Scalar(by), Vector(v)) => Vector(v.map(|of| of * by)),
            _ => Self::NOT_A_NUMBER,
        }
    }

    #[inline]
    pub(super) fn over(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one / other),
            (Vector(v), Scalar(by)) => Vector(v.map(|of| of / by)),
            _ => Self::NOT_A_NUMBER,
        }
    }

    #[inline]
    pub(super) fn dot(self, other: Self) -> Self {
        match (self, other) {
            (Vector(one), Vector(other)) => Scalar(one.dot(&other)),
            // A vector that is missing.
            (Scalar(zero), Vector(_)) | (Vector(_), Scalar(zero)) if zero.value() == 0.0 => Scalar(zero),
            _ => Self::NOT_A_NUMBER,
        }
    }

    /// As a program with single precision keeps it.
    pub(super) fn in_single_precision(self) -> Self {
        match self {
            Scalar(number) => Scalar(number.in_single_precision()),
            Vector(vector) => Vector(vector.map(S::in_single_precision)),
        }
    }

    /// The vector with other components.
    pub(super) fn with_axes(self, axes: &Axes) -> Self {
        match self {
            Vector(of) => Vector(of.map_with_location(|c, _, _| of[axes[c].0] * S::from(axes[c].1))),
            Scalar(_) => Self::NOT_A_NUMBER,
        }
    }

    /// The product of two numbers, or the scalar product of two vectors.
    #[inline]
    pub(super) fn along(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one * other),
            _ => self.dot(other),
        }
    }

    #[inline]
    pub(super) fn cross(self, other: Self) -> Self {
        match (self, other) {
            (Vector(one), Vector(other)) => Vector(one.cross(&other)),
            _ => Self::NOT_A_NUMBER,
        }
    }
}

/// The values of all names.
pub(super) trait Values<S = RunningError> {
    fn at(&self, name: Name) -> Value<S>;
}

impl<S: Number> Values<S> for [Value<S>] {
    fn at(&self, name: Name) -> Value<S> {
        self[name]
    }
}
