//! The record of the bounds.

use crate::check::distribution::Quantiles;
use crate::check::regime::Regime;
use crate::check::serialized::{Name, by_name, name, nested, number};
use crate::check::verdict::Order;
use crate::linearization::Quantity;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

enumeration! {
    /// The side whose bounds are measured.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Side {
        /// The closed form.
        Closed => "closed form",
        /// Our own hyper-dual numbers, lifted by chord steps.
        Chord => "AD",
        /// The public functions of the kernel, with the beams' own numbers of dofs.
        Kernel => "kernel",
        /// Residual (first order) and tangent (second order) of a contact element, in its two ways to the geometry.
        Element => "contact element",
    }
}

by_name!(Side);

/// The results for one side and one order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Numbers with an error.
    pub entries: u64,
    /// Numbers without an error.
    pub exact: u64,
    /// Numbers without a finite bound.
    pub unbounded: u64,
    /// The bound over the true error, where there is an error.
    pub overestimation: Option<Quantiles>,
    /// The true error over the scale, where there is an error.
    pub error: Option<Quantiles>,
}

/// The closest points of one regime.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Points {
    /// Closest points measured.
    pub measured: u64,
    /// Of these, those where a tolerance exceeds a thousandth of its scale.
    pub not_meaningful: u64,
    /// Closest points without derivatives that can be compared, and those that double-double could not refine.
    pub left_out: u64,
}

/// A violated bound.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Violation {
    /// The side of the bound.
    pub side: Side,
    /// The quantity.
    pub quantity: Quantity,
    /// Which part of it.
    #[serde(deserialize_with = "name")]
    pub part: Name,
    /// The bound.
    #[serde(with = "number")]
    pub bound: f64,
    /// The true error, which is larger.
    #[serde(with = "number")]
    pub error: f64,
}

/// All results of the measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// The closest points, by regime.
    pub points: BTreeMap<Regime, Points>,
    /// The results over all regimes, by side and order.
    #[serde(with = "nested")]
    pub all: BTreeMap<(Side, Order), Measured>,
    /// The same in each regime.
    #[serde(with = "nested")]
    pub regimes: BTreeMap<(Side, Order), BTreeMap<Regime, Measured>>,
    /// The worst violation of each case that has one.
    pub violations: BTreeMap<u64, Violation>,
}
