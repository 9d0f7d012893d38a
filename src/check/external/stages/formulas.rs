//! The cause of wrong answers: one change of a list of formulas.
//!
//! The equations say which answer is wrong. A number that is not answered, such as det or grad gamma, is not seen there, and
//! its error runs on into all that follows. So all formulas stand in a list, from the curves to the tangent of a contact
//! element. An error is one change of a formula: a sign, a factor, a name. It explains the answers if the list with this change
//! yields all of them, to rounding. A program may write each formula in its own way, so the list has several.

mod axes;
mod change;
mod changes;
mod degrees;
mod derivative;
mod derivatives;
mod differences;
mod edits;
mod effects;
mod entries;
mod estimates;
mod evaluation;
mod expanded;
mod explained;
mod first_wrong;
mod folded;
mod friction;
mod inputs;
mod kinds;
mod list;
mod matrices;
mod names;
mod of_entries;
mod operations;
mod outputs;
mod pairs;
mod parser;
mod point;
mod products;
mod relations;
mod results;
mod right;
mod search;
mod span;
mod tree;
mod values;
mod ways;
mod whole;
mod words;

#[cfg(test)]
mod tests;

pub(super) use entries::words_of_blocks;
pub(super) use first_wrong::FirstWrong;
pub(super) use inputs::Inputs;
pub use list::LIST_OF_FORMULAS;
pub(super) use products::found as product;
pub(super) use right::{Answers, Written};
pub(super) use search::{are_wrong, found, of_all};
