#![doc = include_str!("../README.md")]

pub mod closest_point;
pub mod curve;
pub mod linearization;
pub mod number;
pub mod pair;

#[cfg(feature = "cli")]
pub mod check;
#[cfg(feature = "cli")]
pub mod ledger;
#[cfg(feature = "cli")]
pub mod prove;
#[cfg(feature = "cli")]
pub mod report;
#[cfg(feature = "cli")]
pub mod specimen;
#[cfg(feature = "cli")]
pub mod subject;
#[cfg(feature = "cli")]
pub mod teeth;

pub use nalgebra;
