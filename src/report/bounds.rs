//! The record of the overestimation of the tolerances, `beamgap-bounds/3`.

use super::{Environment, Record};
use crate::check;
use serde::{Deserialize, Serialize};

/// The bounds on the errors, compared with the actual errors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// `beamgap-bounds/3`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The seed of all cases.
    pub seed: u64,
    /// The cases of each regime.
    pub cases_per_regime: u64,
    /// The measurements.
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
