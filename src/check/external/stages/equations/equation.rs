//! An equation as sums of terms that are zero.

use crate::check::external::stages::terms::{Beam, Part, Terms};
use crate::linearization::Quantity;

/// An equation, or a system of equations.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Equation {
    /// The results that it defines.
    pub(in crate::check::external::stages) results: Vec<(Quantity, Part)>,
    /// The number of the equation in the paper.
    pub(in crate::check::external::stages) number: &'static str,
    /// At which closest points it is valid.
    pub(in crate::check::external::stages) at: At,
    /// The forms in which programs may use it. Each is a list of sums that are zero.
    pub(in crate::check::external::stages) forms: Vec<Vec<Zero>>,
}

/// A sum that is zero.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Zero {
    pub(in crate::check::external::stages) terms: Terms,
    /// Other sums that programs add by mistake, each with its words.
    pub(in crate::check::external::stages) extras: Vec<(String, Terms)>,
    /// The number of its equation, if it is not that of the others.
    pub(in crate::check::external::stages) number: Option<&'static str>,
    /// What is wrong if this sum is zero, which it is not in a right program.
    pub(in crate::check::external::stages) is_wrong_form: Option<&'static str>,
    /// Whether single terms are looked at, or only groups of them.
    pub(in crate::check::external::stages) is_elementary: bool,
}

impl Zero {
    pub(in crate::check::external::stages) fn of(terms: Terms) -> Self {
        Self { terms, extras: Vec::new(), number: None, is_wrong_form: None, is_elementary: true }
    }
}

/// The closest points at which an equation is valid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::check::external::stages) enum At {
    All,
    /// Both parameters are free.
    Free,
    /// Some parameter is held.
    SomeHeld,
    /// This parameter is held.
    Held(Beam),
    /// This parameter is free.
    FreeOf(Beam),
    /// Only this parameter is free.
    Alone(Beam),
}

impl At {
    /// The other parameter, if only one is free: its variations are zero.
    pub(in crate::check::external::stages) fn other_is_held(self) -> Option<Quantity> {
        if let Self::Alone(beam) = self { Some(XI[1 - beam]) } else { None }
    }

    pub(in crate::check::external::stages) fn holds(self, held: [bool; 2]) -> bool {
        match self {
            Self::All => true,
            Self::Free => held == [false; 2],
            Self::SomeHeld => held != [false; 2],
            Self::Held(beam) => held[beam],
            Self::FreeOf(beam) => !held[beam],
            Self::Alone(beam) => !held[beam] && held[1 - beam],
        }
    }
}

pub(super) const XI: [Quantity; 2] = [Quantity::Xi, Quantity::XiBar];
