//! The contact element of two beams: residual R and tangent K of a point contact, with Coulomb friction.
//!
//! [`Element::evaluate`] takes the dofs, a closest point and the history of the last converged step. It writes R and K, and
//! returns the state, the forces and the next history. [`closed_form`] has the formulas over any scalar. [`ad`] computes R and
//! K once more, from positions and the definitions of friction alone.

pub mod ad;
pub mod chain;
pub mod closed_form;
mod decision;
mod element;
mod error;
mod geometry;
mod history;
mod law;
mod matrix;
pub mod multiplier;
mod parameters;
mod values;

pub use closed_form::Contribution;
pub use decision::{Decision, State};
pub use element::{Element, Kink, Outcome};
pub use error::ContactError;
pub use history::{History, Slips, Start};
pub use law::{Law, NormalLaw, Piece};
pub use matrix::BlockMatrix;
#[cfg(feature = "check")]
pub(crate) use matrix::contracted;
pub use parameters::{Parameters, Work};
pub use values::Values;

#[cfg(test)]
mod tests;
