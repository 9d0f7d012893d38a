//! The record of fault injection, `beamgap-faults/2`.

use super::{Environment, Record};
use crate::check::Regime;
use crate::faults::{Gate, Injected, Limit, OneSided, Operations, Sampled, SearchFaults};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The results of the checks for injected faults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Faults {
    /// `beamgap-faults/2`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The seed of the cases and of the pairs of faults.
    pub seed: u64,
    /// Whether the gate and the exact check detect every fault and reject nothing that is correct.
    pub holds: bool,
    /// Faults of terms.
    pub terms: Injected,
    /// Faults of single operations over the prime field, by code and place.
    pub operations: Vec<Operations>,
    /// Faults of a sample of operations in `f64`, by regime and code.
    pub sampled: Vec<Sampled>,
    /// The detection limits of each term, by regime.
    pub limits: BTreeMap<String, BTreeMap<Regime, Limit>>,
    /// Faults of the search for closest points, by regime.
    #[serde(default)]
    pub search: Vec<SearchFaults>,
    /// Faults of terms that act on one side of a symmetry only.
    #[serde(default)]
    pub one_sided: Option<OneSided>,
    /// What the gate itself compares, by regime.
    #[serde(default)]
    pub gate: Vec<Gate>,
}

impl Record for Faults {
    const SCHEMA: &'static str = "beamgap-faults/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Faults {
    /// The record, with whether all of it holds.
    #[must_use]
    pub fn judged(self) -> Self {
        let holds = self.terms.holds()
            && self.operations.iter().all(Operations::is_whole)
            && self.search.iter().all(SearchFaults::holds)
            && self.one_sided.iter().all(OneSided::holds)
            && self.gate.iter().all(Gate::holds);
        Self { holds, ..self }
    }
}
