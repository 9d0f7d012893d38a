//! The record of the check, `beamgap-crosscheck/2`.

use super::{Environment, Record};
use crate::check::Summary;
use serde::{Deserialize, Serialize};

/// What a run of the check found, and where.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crosscheck {
    /// `beamgap-crosscheck/2`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of all cases.
    pub seed: u64,
    /// The cases of each regime.
    pub cases_per_regime: u64,
    /// What was found.
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
