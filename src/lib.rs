//! Consistent linearization of beam-to-beam contact geometry, twice, and the gate that compares the two.

pub mod closest_point;
pub mod curve;
pub mod linearization;
pub mod number;
pub mod pair;

#[cfg(feature = "cli")]
pub mod check;
#[cfg(feature = "cli")]
pub mod report;
