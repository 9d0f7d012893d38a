//! The record of the digits that each formulation keeps, `beamgap-accuracy/2`.

use super::{Environment, Record};
use crate::check;
use serde::{Deserialize, Serialize};

/// The digits that each formulation loses, over the gap and over the angle, and the environment of the measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Accuracy {
    /// `beamgap-accuracy/2`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The seed of all pairs.
    pub seed: u64,
    /// The pairs at each gap and angle.
    pub pairs: usize,
    /// The measurements.
    #[serde(flatten)]
    pub found: check::Accuracy,
}

impl Record for Accuracy {
    const SCHEMA: &'static str = "beamgap-accuracy/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Accuracy {
    /// The record of a run.
    pub fn new(found: check::Accuracy, seed: u64, pairs: usize, environment: Environment) -> Self {
        Self { schema: Self::SCHEMA.to_owned(), environment, seed, pairs, found }
    }
}
