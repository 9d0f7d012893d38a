//! Named terms, so that a check can inject a fault into one of them, and can explain a mismatch by one.

use super::{Formula, Real};
use nalgebra::SMatrix;
use std::fmt;

/// The name of a term. It is shown as `a: d.t,xi`; delta is written d, and Delta D.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Label {
    /// The formula.
    pub formula: Formula,
    /// The term in it.
    pub term: &'static str,
    /// The beam that it is used for, if the formula serves both.
    pub which: Which,
}

impl Label {
    /// A term in the formula of the beam.
    pub const fn of_beam(formula: Formula, term: &'static str) -> Self {
        Self { formula, term, which: Which::Beam }
    }

    /// The term that is shown so.
    pub fn read(name: &'static str) -> Option<Self> {
        let (formula, term) = Formula::of_term(name)?;
        let bar = term.strip_suffix(" (bar)");
        let which = if bar.is_some() { Which::Bar } else { Which::Beam };
        Some(Self { formula, term: bar.unwrap_or(term), which })
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.formula.name(), self.term)?;
        f.write_str(if self.which == Which::Bar { " (bar)" } else { "" })
    }
}

/// A value that can have a name: a number, a vector, or a matrix over the scalar `T`.
pub trait Term<T> {
    /// The same value, with this name on each number.
    #[must_use]
    fn with_name(self, label: Label) -> Self;
}

impl<T: Real> Term<T> for T {
    #[inline(always)]
    fn with_name(self, label: Label) -> Self {
        self.named(label)
    }
}

impl<T: Real, const R: usize, const C: usize> Term<T> for SMatrix<T, R, C> {
    #[inline(always)]
    fn with_name(self, label: Label) -> Self {
        self.map(|entry| entry.named(label))
    }
}

/// A term with its name. The result is the term itself, except for scalars for fault injection.
#[inline(always)]
pub(crate) fn named<T, V: Term<T>>(formula: Formula, term: &'static str, value: V) -> V {
    Which::Beam.named(formula, term, value)
}

/// One of the two beams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Which {
    /// The beam.
    Beam,
    /// The bar beam.
    Bar,
}

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Beam => "beam",
            Self::Bar => "bar beam",
        })
    }
}

impl Which {
    /// A term with its name, in the formula of this beam.
    #[inline(always)]
    pub(crate) fn named<T, V: Term<T>>(self, formula: Formula, term: &'static str, value: V) -> V {
        value.with_name(Label { formula, term, which: self })
    }
}

/// The orders of the two Jacobians in a product, by the name of the product.
#[inline(always)]
pub(crate) fn orders<T: Real>(formula: Formula, term: &'static str, orders: [usize; 2]) -> [usize; 2] {
    T::orders(Label { formula, term, which: Which::Beam }, orders)
}
