//! Beams to test with: one of every family, drawn at random, with the family and the number of dofs forgotten.
//!
//! What comes after, the gate and the proof, is thereby compiled once and not once per pair of families.

mod beam;
mod exact;
mod family;
mod padded;
mod stationary;

pub(crate) use beam::AnyBeam;
pub use beam::Shown;
pub(crate) use exact::ExactBeam;
pub use family::Family;
pub(crate) use family::Target;
pub(crate) use padded::{Padded, PaddedBeam};
pub(crate) use stationary::stationary;
