//! The values of formulas at a sample.

use super::axes::AXES;
use super::tree::{Name, Op, Tree};
use crate::check::candidate::CAREFUL;
use crate::number::{Real, RunningError};
use nalgebra::Vector3;

/// A number in formulas: with its rounding, or without for an estimate.
pub(in crate::check::external::stages) trait Number: Real {
    const NOT_A_NUMBER: Self;

    fn of(number: RunningError) -> Self;

    fn value(self) -> f64;

    /// Whether it is less than another one, if rounding does not hide it.
    fn is_less(self, other: Self) -> Option<bool>;
}

impl Number for RunningError {
    const NOT_A_NUMBER: Self = Self { value: f64::NAN, bound: f64::NAN };

    fn of(number: RunningError) -> Self {
        number
    }

    fn value(self) -> f64 {
        self.value
    }

    fn is_less(self, other: Self) -> Option<bool> {
        let difference = other - self;
        let is_known = difference.value.abs() > difference.bound || difference.bound == 0.0;
        is_known.then_some(difference.value > 0.0)
    }
}

/// What rounding may change of a number without a bound.
const UNCLEAR: f64 = 1e-9;

impl Number for f64 {
    const NOT_A_NUMBER: Self = Self::NAN;

    fn of(number: RunningError) -> Self {
        number.value
    }

    fn value(self) -> f64 {
        self
    }

    fn is_less(self, other: Self) -> Option<bool> {
        let size = self.abs() + other.abs();
        ((other - self).abs() > UNCLEAR * size || size == 0.0).then_some(self < other)
    }
}

/// A number or a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::check::external::stages) enum Value<S = RunningError> {
    Number(S),
    Vector(Vector3<S>),
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

    pub(super) fn is_vector(self) -> bool {
        matches!(self, Vector(_))
    }

    /// The number; not a number for a vector.
    pub(super) fn number(self) -> S {
        match self {
            Scalar(number) => number,
            Vector(_) => S::NOT_A_NUMBER,
        }
    }

    /// The number, or the component of a vector.
    pub(super) fn component(self, axis: Option<usize>) -> S {
        match (self, axis) {
            (Vector(vector), Some(axis)) => vector[axis],
            _ => self.number(),
        }
    }

    pub(super) fn is_zero(self) -> bool {
        match self {
            Scalar(number) => number.value() == 0.0,
            Vector(vector) => vector.iter().all(|of| of.value() == 0.0),
        }
    }

    pub(super) fn is_nan(self) -> bool {
        matches!(self, Scalar(number) if number.value().is_nan())
    }

    pub(super) fn negative(self) -> Self {
        match self {
            Scalar(number) => Scalar(-number),
            Vector(vector) => Vector(-vector),
        }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one + other),
            (Vector(one), Vector(other)) => Vector(one + other),
            // A term that is zero.
            (Vector(of), Scalar(zero)) | (Scalar(zero), Vector(of)) if zero.value() == 0.0 => Vector(of),
            _ => Self::NOT_A_NUMBER,
        }
    }

    pub(super) fn times(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one * other),
            (Vector(v), Scalar(by)) | (Scalar(by), Vector(v)) => Vector(v.map(|of| of * by)),
            _ => Self::NOT_A_NUMBER,
        }
    }

    pub(super) fn over(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one / other),
            (Vector(v), Scalar(by)) => Vector(v.map(|of| of / by)),
            _ => Self::NOT_A_NUMBER,
        }
    }

    fn dot(self, other: Self) -> Self {
        match (self, other) {
            (Vector(one), Vector(other)) => Scalar(one.dot(&other)),
            // A vector that is missing.
            (Scalar(zero), Vector(_)) | (Vector(_), Scalar(zero)) if zero.value() == 0.0 => Scalar(zero),
            _ => Self::NOT_A_NUMBER,
        }
    }

    /// The product of two numbers, or the scalar product of two vectors.
    pub(super) fn along(self, other: Self) -> Self {
        match (self, other) {
            (Scalar(one), Scalar(other)) => Scalar(one * other),
            _ => self.dot(other),
        }
    }

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

/// The value of a formula. A comparison within rounding is not a number.
pub(super) fn value<S: Number>(tree: &Tree, values: &(impl Values<S> + ?Sized)) -> Value<S> {
    let at = |i: usize| value(&tree.of[i], values);
    match &tree.op {
        Op::Number(number) => Value::from(*number),
        Op::Name(name) => values.at(*name),
        Op::Sum(minus) => {
            let signed = |i: usize| if minus.has(i) { at(i).negative() } else { at(i) };
            (1..minus.len()).fold(signed(0), |sum, i| sum.plus(signed(i)))
        }
        Op::Product(divides) => {
            let first = usize::from(!divides.has(0));
            let start = if divides.has(0) { Value::from(1.0) } else { at(0) };
            (first..divides.len()).fold(start, |product, i| {
                if divides.has(i) { product.over(at(i)) } else { product.times(at(i)) }
            })
        }
        Op::Dot => at(0).dot(at(1)),
        Op::Cross => at(0).cross(at(1)),
        Op::Axes(axes) => match at(0) {
            Vector(of) => {
                let axes = AXES[*axes].0;
                Vector(of.map_with_location(|c, _, _| of[axes[c].0] * S::from(axes[c].1)))
            }
            Scalar(_) => Value::NOT_A_NUMBER,
        },
        Op::Root => Scalar(at(0).number().sqrt()),
        Op::Less => at(0).number().is_less(at(1).number()).map_or(Value::NOT_A_NUMBER, Value::from),
        Op::If => match at(0).number().value() {
            condition if condition.is_nan() => Value::NOT_A_NUMBER,
            0.0 => at(2),
            _ => at(1),
        },
    }
}
