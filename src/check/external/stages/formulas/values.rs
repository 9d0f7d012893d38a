//! The values of formulas at a sample.

use super::tree::{Name, Op, Tree};
use crate::check::candidate::CAREFUL;
use crate::number::{Real, RunningError};
use nalgebra::Vector3;

/// A number or a vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::check::external::stages) enum Value {
    Number(RunningError),
    Vector(Vector3<RunningError>),
}

use Value::{Number, Vector};

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Number(RunningError::from(value))
    }
}

impl From<bool> for Value {
    fn from(value: bool) -> Self {
        Self::from(if value { 1.0 } else { 0.0 })
    }
}

impl Value {
    pub(super) const NOT_A_NUMBER: Self = Number(RunningError { value: f64::NAN, bound: f64::NAN });

    /// The derivative of a number by itself, or of a component by its vector.
    pub(super) fn of_axis(axis: Option<usize>) -> Self {
        axis.map_or(Self::from(1.0), |axis| Vector(Vector3::ith(axis, RunningError::from(1.0))))
    }

    pub(super) fn is_vector(self) -> bool {
        matches!(self, Vector(_))
    }

    /// The number; not a number for a vector.
    pub(super) fn number(self) -> RunningError {
        match self {
            Number(number) => number,
            Vector(_) => RunningError { value: f64::NAN, bound: f64::NAN },
        }
    }

    /// The number, or the component of a vector.
    pub(super) fn component(self, axis: Option<usize>) -> RunningError {
        match (self, axis) {
            (Vector(vector), Some(axis)) => vector[axis],
            _ => self.number(),
        }
    }

    pub(super) fn is_zero(self) -> bool {
        match self {
            Number(number) => number.value == 0.0,
            Vector(vector) => vector.iter().all(|of| of.value == 0.0),
        }
    }

    pub(super) fn is_nan(self) -> bool {
        matches!(self, Number(number) if number.value.is_nan())
    }

    /// Whether both differ by more than rounding, or are of different kinds.
    pub(super) fn differs(self, other: Self) -> bool {
        let is_near = |one: RunningError, other: RunningError| {
            one == other || (one.value - other.value).abs() <= CAREFUL * (one.bound + other.bound)
        };
        match (self, other) {
            (Number(one), Number(other)) => !is_near(one, other),
            (Vector(one), Vector(other)) => (0..3).any(|axis| !is_near(one[axis], other[axis])),
            _ => true,
        }
    }

    pub(super) fn negative(self) -> Self {
        match self {
            Number(number) => Number(-number),
            Vector(vector) => Vector(-vector),
        }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Number(one), Number(other)) => Number(one + other),
            (Vector(one), Vector(other)) => Vector(one + other),
            // A term that is zero.
            (Vector(one), Number(RunningError { value: 0.0, .. })) => Vector(one),
            (Number(RunningError { value: 0.0, .. }), Vector(other)) => Vector(other),
            _ => Self::NOT_A_NUMBER,
        }
    }

    pub(super) fn times(self, other: Self) -> Self {
        match (self, other) {
            (Number(one), Number(other)) => Number(one * other),
            (Vector(v), Number(by)) | (Number(by), Vector(v)) => Vector(v.map(|of| of * by)),
            _ => Self::NOT_A_NUMBER,
        }
    }

    pub(super) fn over(self, other: Self) -> Self {
        match (self, other) {
            (Number(one), Number(other)) => Number(one / other),
            (Vector(v), Number(by)) => Vector(v.map(|of| of / by)),
            _ => Self::NOT_A_NUMBER,
        }
    }

    fn dot(self, other: Self) -> Self {
        match (self, other) {
            (Vector(one), Vector(other)) => Number(one.dot(&other)),
            // A vector that is missing.
            (zero @ Number(RunningError { value: 0.0, .. }), Vector(_))
            | (Vector(_), zero @ Number(RunningError { value: 0.0, .. })) => zero,
            _ => Self::NOT_A_NUMBER,
        }
    }

    /// The product of two numbers, or the scalar product of two vectors.
    pub(super) fn along(self, other: Self) -> Self {
        match (self, other) {
            (Number(one), Number(other)) => Number(one * other),
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
pub(super) trait Values {
    fn at(&self, name: Name) -> Value;
}

impl Values for [Value] {
    fn at(&self, name: Name) -> Value {
        self[name]
    }
}

/// The value of a formula. A comparison within rounding is not a number.
pub(super) fn value(tree: &Tree, values: &(impl Values + ?Sized)) -> Value {
    let at = |i: usize| value(&tree.of[i], values);
    match &tree.op {
        Op::Number(number) => Value::from(*number),
        Op::Name(name) => values.at(*name),
        Op::Sum(minus) => {
            let signed = |i: usize| if minus[i] { at(i).negative() } else { at(i) };
            (1..minus.len()).fold(signed(0), |sum, i| sum.plus(signed(i)))
        }
        Op::Product(divides) => {
            let first = usize::from(!divides[0]);
            let start = if divides[0] { Value::from(1.0) } else { at(0) };
            (first..divides.len())
                .fold(start, |product, i| if divides[i] { product.over(at(i)) } else { product.times(at(i)) })
        }
        Op::Dot => at(0).dot(at(1)),
        Op::Cross => at(0).cross(at(1)),
        Op::Axes(axes) => match at(0) {
            Vector(of) => {
                Vector(of.map_with_location(|c, _, _| of[axes[c].0] * RunningError::from(axes[c].1)))
            }
            Number(_) => Value::NOT_A_NUMBER,
        },
        Op::Root => Number(at(0).number().sqrt()),
        Op::Less => {
            let difference = at(1).number() - at(0).number();
            if difference.value.abs() > difference.bound || difference.bound == 0.0 {
                Value::from(difference.value > 0.0)
            } else {
                Value::NOT_A_NUMBER
            }
        }
        Op::If => match at(0).number().value {
            condition if condition.is_nan() => Value::NOT_A_NUMBER,
            0.0 => at(2),
            _ => at(1),
        },
    }
}
