//! The record of the check, `beamgap-crosscheck/2`.

use super::{Environment, Record};
use crate::check::Summary;
use serde::{Deserialize, Serialize};

/// The results of a run of the check, and its environment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crosscheck {
    /// `beamgap-crosscheck/2`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The seed of all cases.
    pub seed: u64,
    /// The cases of each regime.
    pub cases_per_regime: u64,
    /// The results.
    pub found: Summary,
}

impl Record for Crosscheck {
    const SCHEMA: &'static str = "beamgap-crosscheck/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Crosscheck {
    /// The record of a run.
    pub fn new(found: Summary, seed: u64, cases_per_regime: u64, environment: Environment) -> Self {
        Self { schema: Self::SCHEMA.to_owned(), environment, seed, cases_per_regime, found }
    }
}
