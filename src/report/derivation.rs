//! The page of the derivation: the story, every equation with its numbers and its code, and figures.
//!
//! The numbers come from records, the code from the source, the prose from text files beside this one.

mod equation;
mod figures;
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
