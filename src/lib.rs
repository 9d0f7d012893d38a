#![doc = include_str!("front_page.md")]

#[macro_use]
mod enumeration;
mod source_fault;

pub mod closest_point;
pub mod contact;
pub mod curve;
pub mod linearization;
pub mod number;
pub mod pair;

#[cfg(feature = "check")]
pub mod check;
#[cfg(feature = "check")]
pub mod equations;
#[cfg(feature = "check")]
pub mod faults;
#[cfg(feature = "check")]
mod parallel;
#[cfg(feature = "check")]
pub mod prove;
#[cfg(feature = "cli")]
pub mod report;
// The chains need nothing of the check, and are tested without it.
#[cfg(any(test, feature = "check"))]
pub mod teaching;
#[cfg(feature = "check")]
pub mod test_beam;
#[cfg(feature = "check")]
pub mod variant;

/// The examples of the README and of guides, which are tested with those of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
#[doc = include_str!("../docs/curve.md")]
#[doc = include_str!("../docs/contact-element.md")]
struct Guides;

// Their types stand in signatures: vectors, dual numbers, and what a scalar of one's own implements.
pub use nalgebra;
pub use num_dual;
pub use num_traits;
