//! The record of fault injection, `beamgap-faults/2`.

use super::{Environment, Record};
use crate::check::Regime;
use crate::faults::{
    Check, ElementFaults, Gate, Injected, Limit, OneSided, Operations, Sampled, SearchFaults,
};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

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
    /// Faults of the terms of residual and tangent of the contact element, by regime.
    #[serde(default)]
    pub elements: Vec<ElementFaults>,
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
        let holds = self.is_complete()
            && self.terms.holds()
            && self.operations.iter().all(Operations::is_whole)
            && self.search.iter().all(SearchFaults::holds)
            && self.elements.iter().all(ElementFaults::holds)
            && self.one_sided.iter().all(OneSided::holds)
            && self.gate.iter().all(Gate::holds);
        Self { holds, ..self }
    }

    /// Whether each part has all regimes, so that none was left out. Faults of operations over the prime field do not depend
    /// on the regime, and are injected only with all regimes.
    fn is_complete(&self) -> bool {
        let of_gate = self.terms.detections.iter().filter(|of| of.check == Check::Gate);
        let regimes: BTreeSet<Regime> = of_gate.filter_map(|of| of.regime).collect();
        let parts: [BTreeSet<Regime>; 5] = [
            self.search.iter().map(|of| of.regime).collect(),
            self.elements.iter().map(|of| of.regime).collect(),
            self.gate.iter().map(|of| of.regime).collect(),
            self.sampled.iter().map(|of| of.regime).collect(),
            self.limits.values().flat_map(BTreeMap::keys).copied().collect(),
        ];
        let is_whole = regimes.len() < Regime::ALL.len() || !self.operations.is_empty();
        !regimes.is_empty() && parts.iter().all(|of| *of == regimes) && self.one_sided.is_some() && is_whole
    }
}

#[cfg(test)]
mod tests {
    use super::{Faults, Record};
    use std::path::Path;

    #[test]
    fn a_part_that_is_left_out_is_told() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/faults.json");
        let whole = Faults::from_json(&std::fs::read_to_string(path).unwrap()).unwrap();
        assert!(whole.clone().judged().holds);
        let without: [fn(&mut Faults); 10] = [
            |of| of.elements.clear(),
            |of| of.search.clear(),
            |of| of.search.truncate(1),
            |of| of.gate.clear(),
            |of| of.sampled.clear(),
            |of| of.limits.clear(),
            |of| of.operations.clear(),
            |of| of.one_sided = None,
            |of| of.terms.detections.clear(),
            |of| of.terms.detections.truncate(2),
        ];
        for (i, leave_out) in without.into_iter().enumerate() {
            let mut part = whole.clone();
            leave_out(&mut part);
            assert!(!part.judged().holds, "part {i}");
        }
    }
}
