//! The record of how sharp the tolerances are, `beamgap-bounds/3`.

use super::{Environment, Record};
use crate::check;
use serde::{Deserialize, Serialize};

/// What the bounds allow for, against the errors that there are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// `beamgap-bounds/3`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of all cases.
    pub seed: u64,
    /// The cases of each regime.
    pub cases_per_regime: u64,
    /// What was measured.
    pub found: check::Bounds,
}

impl Record for Bounds {
    const SCHEMA: &'static str = "beamgap-bounds/3";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Bounds {
    /// The record of a run.
    pub fn new(found: check::Bounds, seed: u64, cases_per_regime: u64, environment: Environment) -> Self {
        Self { schema: Self::SCHEMA.to_owned(), environment, seed, cases_per_regime, found }
    }
}
