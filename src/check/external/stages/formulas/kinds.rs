//! The kinds of errors, and the order in which they are looked for.

use super::tree::Name;

/// The kind of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum What {
    Sign,
    Missing,
    Doubled,
    Halved,
    Transposed,
    /// The names of the other beam.
    Exchanged,
    /// Those of the beam.
    Forgotten,
    /// A factor is left out.
    Without(usize),
    /// A factor is there twice.
    Squared(usize),
    /// It is divided by a factor, or multiplied by what it must be divided by.
    Inverted(usize),
    /// Of a sum that is divided, one term alone is.
    Alone(usize),
    /// A branch of a choice is always taken.
    Always(usize),
    Reversed,
    /// A condition is always taken to hold, or never.
    Holds(bool),
    NoRoot,
    /// Another number.
    Number(u8),
    /// The form for straight beams, at this place alone.
    Straight,
    /// Another name.
    Other(Name),
    /// Another name with the opposite sign, as in programs that use the symmetric matrix.
    Negative(Name),
    /// A variation in the place of another one, along both directions.
    AlongBoth(Name, Name),
    /// A name in the place of a difference of two, or the difference in the place of a name.
    Difference(Name),
    /// The length of a variation in the place of the variation of a length.
    Length,
    /// The product of the first variations in the place of the second.
    Product,
    /// Other components of a vector, by their place in [`axes`].
    Axes(usize),
}

impl What {
    pub(super) fn cost(self) -> u32 {
        match self {
            Self::Sign | Self::Missing | Self::Holds(_) => 2,
            Self::Other(_) | Self::Straight | Self::Alone(_) => 4,
            Self::Squared(_)
            | Self::Inverted(_)
            | Self::Axes(_)
            | Self::Negative(_)
            | Self::AlongBoth(..)
            | Self::Difference(_)
            | Self::Exchanged
            | Self::Forgotten
            | Self::Length
            | Self::Product => 5,
            _ => 3,
        }
    }
}

/// The errors in the order in which they are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// Signs, factors, conditions, terms that are missing.
    Simple,
    /// All others: those with something else in the place of a name, which are many.
    Other,
    /// All of both where the residual is differentiated, and not in the residual: a tangent may have its own code.
    Tangent,
    /// Errors of one use of a formula. They are made when they are tried, because they are so many.
    Expanded,
}

impl Class {
    /// Those that are kept.
    pub(super) const KEPT: [Self; 3] = [Self::Simple, Self::Other, Self::Tangent];
    pub(super) const ALL: [Self; 4] = [Self::Simple, Self::Other, Self::Tangent, Self::Expanded];
    /// The largest cost of a simple error.
    pub(super) const SIMPLE: u32 = 3;

    pub(super) fn has(self, cost: u32) -> bool {
        match self {
            Self::Simple => cost <= Self::SIMPLE,
            Self::Other => cost > Self::SIMPLE,
            Self::Tangent | Self::Expanded => true,
        }
    }
}
