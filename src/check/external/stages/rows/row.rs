//! A possible error of an equation, and groups of terms.

use crate::check::external::stages::terms::{Reach, Terms};

/// A possible error: the sum that a program with it adds to the equation.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Row {
    pub(in crate::check::external::stages) what: What,
    pub(in crate::check::external::stages) terms: Terms,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::check::external::stages) enum What {
    /// These terms have another factor.
    Factor(String),
    /// Something is wrong in these terms, as the words say.
    Replaced {
        /// The terms.
        of: String,
        /// What is wrong in them.
        words: String,
    },
}

/// Some terms of an equation.
#[derive(Clone)]
pub(super) struct Group {
    pub(super) name: String,
    pub(super) terms: Terms,
    /// The factors of each that the name is on.
    pub(super) reach: Vec<Reach>,
}
