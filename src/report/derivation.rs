//! The page of the derivation: the text, every equation with its numbers and its code, and figures.
//!
//! The numbers are from records, the code is from the source, and the prose is from text files in the same directory.

mod equation;
mod figures;
mod inline;
mod letters;
mod math;
mod page;
mod record;
mod source;
mod symbols;
mod tables;
mod text;

pub(super) use math::mathml;
pub use record::{ByHand, Derivation, DifferenceRow, NewtonRun};
