//! Two beams of many elements in contact: beam problems with exact tangents.
//!
//! A [`Chain`] is a beam of cubic Hermite elements without torsion. A [`Model`] is two chains and the contact element of
//! [`crate::contact`] between them. [`Model::step`] moves given dofs and finds the equilibrium by Newton's method.
//! [`Problem`] has the problems with reference values.

mod chain;
mod convergence;
mod dragged;
mod model;
mod precise;
mod problem;
mod rod;
mod search;
#[cfg(test)]
mod tests;

pub use chain::Chain;
pub use convergence::{order, quadratic_factor};
pub use model::{Model, ModelError, State, Step};
pub use problem::Problem;
pub use rod::{Density, Gauss, density};
pub use search::{Owner, Place};
