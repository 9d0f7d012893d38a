//! What the derivation is taught with: two elastic beams in contact, solved by Newton's method.
//!
//! `examples/newton.rs` prints what happens if a term of the tangent is missing or wrong. The page of the derivation draws
//! it.

mod contact;
mod effect;
mod elastic;
mod solve;

pub use contact::{Contribution, Tangent, contact};
pub use effect::{Effect, SELF_CHECKS, SelfCheck};
pub use elastic::{Beam, DOFS, FREE, Material};
pub use solve::{Equilibrium, Iterate, Problem};
