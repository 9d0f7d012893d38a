//! Named terms, so that a check can inject a fault into one of them, and can explain a mismatch by one.

use super::Real;
use nalgebra::SMatrix;
use std::fmt;

/// The name of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Label {
    /// Formula and term, such as `a: d.t,xi`; delta is written d, and Delta D.
    pub name: &'static str,
    /// The beam that it is used for, if the formula serves both.
    pub which: Which,
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
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
pub(crate) fn named<T, V: Term<T>>(name: &'static str, term: V) -> V {
    Which::Beam.named(name, term)
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
    pub(crate) fn named<T, V: Term<T>>(self, name: &'static str, term: V) -> V {
        term.with_name(Label { name, which: self })
    }
}

/// The orders of the two Jacobians in a product, by the name of the product.
#[inline(always)]
pub(crate) fn orders<T: Real>(name: &'static str, orders: [usize; 2]) -> [usize; 2] {
    T::orders(Label { name, which: Which::Beam }, orders)
}
