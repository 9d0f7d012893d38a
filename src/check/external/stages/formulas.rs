//! The cause of wrong answers of a contact element: one change of a list of formulas.
//!
//! The equations say which answer is wrong. A number that is not answered, such as grad gamma, is not seen there, and its
//! error runs on into all that follows. So all formulas of an element stand in a list, from the curves to K. An error is
//! one change of a formula: a sign, a factor, a name. It explains the answers if the list with this change yields all of
//! them, to rounding.

mod changes;
mod derivative;
mod edits;
mod evaluation;
mod inputs;
mod list;
mod matrices;
mod pairs;
mod parser;
mod point;
mod relations;
mod search;
mod tree;
mod values;

#[cfg(test)]
mod tests;

pub(super) use inputs::Inputs;
pub use list::ELEMENT_FORMULAS;
pub(super) use search::found;
