//! A fault: one term is wrong, as in derivations by hand.

use crate::number::Label;
use std::fmt;
use thiserror::Error;

enumeration! {
    /// The kind of error in a term.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Kind {
        /// It has the wrong sign.
        Sign => "sign",
        /// It is missing.
        Dropped => "dropped",
        /// It is doubled.
        Doubled => "doubled",
        /// It is halved.
        Halved => "halved",
        /// Its directions are exchanged, delta for Delta. In a product of Jacobians, their orders are exchanged.
        Transposed => "transposed",
        /// Its beams are exchanged.
        Swapped => "swapped",
        /// It uses the beam instead of the bar beam.
        BarForgotten => "bar-forgotten",
        /// It is evaluated at the parameters of the step before.
        Stale => "stale",
    }
}

impl Kind {
    /// The factor on the term; nothing if its operands are wrong instead.
    pub(crate) fn factor(self) -> Option<f64> {
        match self {
            Self::Sign => Some(-1.0),
            Self::Dropped => Some(0.0),
            Self::Doubled => Some(2.0),
            Self::Halved => Some(0.5),
            Self::Transposed | Self::Swapped | Self::BarForgotten | Self::Stale => None,
        }
    }
}

/// A term and the kind of its error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fault {
    /// The term.
    pub label: Label,
    /// The kind of its error.
    pub kind: Kind,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.label, self.kind.name())
    }
}

/// No fault of the catalogue has this name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("no fault is called `{0}`; expected a term and a kind, such as `a: d.t,xi = dropped`")]
pub struct UnknownFault(pub String);
