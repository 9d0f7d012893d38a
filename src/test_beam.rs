//! Test beams: random beams of every family, without their type and number of dofs.
//!
//! The check and the proof are therefore compiled once, and not once for each pair of families.

mod beam;
mod data;
mod draw;
mod exact;
mod family;
mod padded;
mod stationary;

pub(crate) use beam::{AnyBeam, Drawn, RunningError2};
pub use data::{TestBeam, TestBeamError};
pub(crate) use draw::Target;
pub(crate) use exact::ExactBeam;
pub use family::{Family, Unit};
pub(crate) use padded::{DOFS, FEW_DOFS, Padded, PaddedBeam, map_padded};
pub(crate) use stationary::{normal_to_free, robust, stationary, stationary_at};
