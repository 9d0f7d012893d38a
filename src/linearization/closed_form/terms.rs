//! Terms by name: what stands between a formula and its terms, so that a gate can prove that it notices when one is
//! wrong.
//!
//! A formula is a sum of terms, and a term is a function of its operands. Each is evaluated through [`Terms`]: by
//! [`Sound`] it is just evaluated, which leaves no trace in the compiled code. A planted fault is another
//! implementation, which gives one term a wrong factor or wrong operands; so faults run through the very code they are
//! faults of, and the list of terms is what that code names.

use crate::number::Real;
use std::fmt;
use std::ops::Mul;

/// The name of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Label {
    /// Formula and term, such as `a: d.t,xi`; delta is written d, and Delta D.
    pub name: &'static str,
    /// Whether the formula serves both beams and this is its use for the bar beam.
    pub bar: bool,
}

impl Label {
    /// The name of a term whose formula is not shared by the two beams.
    pub const fn new(name: &'static str) -> Self {
        Self { name, bar: false }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        f.write_str(if self.bar { " (bar)" } else { "" })
    }
}

/// Evaluates the terms of formulas over the scalar `T` whose operands are `O`.
pub trait Terms<T, O> {
    /// The value of a term.
    fn term<V: Mul<T, Output = V>>(&self, label: Label, operands: &O, term: impl Fn(&O) -> V) -> V;

    /// Adds a product of two Jacobians of these orders to a block of a matrix, with a factor of 1.
    fn product(
        &self,
        label: Label,
        operands: &O,
        orders: (usize, usize),
        add: impl FnMut(&O, T, (usize, usize)),
    );
}

/// Every term as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sound;

impl<T: Real, O> Terms<T, O> for Sound {
    #[inline]
    fn term<V: Mul<T, Output = V>>(&self, _: Label, operands: &O, term: impl Fn(&O) -> V) -> V {
        term(operands)
    }

    #[inline]
    fn product(
        &self,
        _: Label,
        operands: &O,
        orders: (usize, usize),
        mut add: impl FnMut(&O, T, (usize, usize)),
    ) {
        add(operands, T::one(), orders);
    }
}
