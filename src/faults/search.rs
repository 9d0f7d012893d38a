//! Faults of the search for closest points: whether the comparison with the independent search detects them.
//!
//! The cases of a regime are searched in order, with the pairs for the search alone that they bring, until each fault is
//! detected at some case or the default number of cases is reached.

use crate::check::serialized::by_name;
use crate::check::{Case, IndependentSearch, Regime, SearchFindingKind, Selection, pair_of};
use crate::closest_point::{Search, SearchFault, closest_points, with_search_fault};
use crate::parallel;
use crate::test_beam::AnyBeam;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The largest number of cases of a regime: the default of `beamgap check`.
const CASES: u64 = 10_000;
/// The number of cases that are searched at a time, by all cores.
const AT_ONCE: usize = 320;

by_name!(SearchFault);

/// The detections of the faults of the search in a regime.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SearchFaults {
    /// The regime.
    pub regime: Regime,
    /// The number of cases that were searched.
    pub cases: u64,
    /// The pairs of beams at which the comparison rejects the unmodified search. They are not counted for a fault.
    pub rejected: u64,
    /// The detected faults.
    pub detected: BTreeMap<SearchFault, SearchDetection>,
    /// The faults that no case detects.
    pub missed: Vec<SearchFault>,
}

/// How a fault of the search is detected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SearchDetection {
    /// The number of cases of the regime after which it is detected.
    pub after: u64,
    /// The first difference.
    pub kind: SearchFindingKind,
}

impl SearchFaults {
    /// Whether every fault is detected, and the unmodified search is not rejected.
    pub fn holds(&self) -> bool {
        self.missed.is_empty() && self.rejected == 0 && self.detected.len() == SearchFault::ALL.len()
    }
}

/// Injects all faults of the search in these regimes.
///
/// The result depends on the seed and the regimes, not on the number of threads.
pub fn search_faults(seed: u64, regimes: &[Regime]) -> Vec<SearchFaults> {
    regimes.iter().map(|&regime| of_regime(seed, regime)).collect()
}

fn of_regime(seed: u64, regime: Regime) -> SearchFaults {
    let numbers = Selection { regimes: vec![regime], family: None, cases: CASES }.numbers();
    let (mut cases, mut rejected) = (0, 0);
    let mut detected = BTreeMap::new();
    for block in numbers.chunks(AT_ONCE) {
        let open: Vec<_> =
            SearchFault::ALL.into_iter().filter(|fault| !detected.contains_key(fault)).collect();
        if open.is_empty() {
            break;
        }
        let found = parallel::map(block, |&number| of_case(seed, number, &open));
        for (of_case, after) in found.into_iter().zip(cases + 1..) {
            rejected += of_case.rejected;
            for (fault, kind) in of_case.detected {
                detected.entry(fault).or_insert(SearchDetection { after, kind });
            }
        }
        cases += block.len() as u64;
    }
    let missed = SearchFault::ALL.into_iter().filter(|fault| !detected.contains_key(fault)).collect();
    SearchFaults { regime, cases, rejected, detected, missed }
}

#[derive(Default)]
struct Found {
    rejected: u64,
    detected: Vec<(SearchFault, SearchFindingKind)>,
}

/// The faults of these that are detected at a case, or at the pair that it brings.
fn of_case(seed: u64, number: u64, faults: &[SearchFault]) -> Found {
    let mut found = Found::default();
    found.add(Case::draw(seed, number).beams(), faults);
    if let Some(Ok(beams)) = pair_of(seed, number).map(|pair| pair.beams()) {
        found.add(beams.each_ref().map(|beam| &**beam), faults);
    }
    found
}

impl Found {
    fn add(&mut self, beams: [&dyn AnyBeam; 2], faults: &[SearchFault]) {
        let Some(mut independent) = IndependentSearch::new(beams) else { return };
        let mut first = |fault: Option<SearchFault>| {
            let found =
                with_search_fault(fault, || closest_points(beams[0], beams[1], &Search::default())).ok()?;
            independent.compared(&found).findings.first().map(|finding| finding.kind)
        };
        if first(None).is_some() {
            self.rejected += 1;
            return;
        }
        self.detected.extend(faults.iter().filter_map(|&fault| Some((fault, first(Some(fault))?))));
    }
}

#[cfg(test)]
mod tests {
    use super::{SearchFault, of_case, search_faults};
    use crate::check::Regime;

    #[test]
    fn every_fault_of_the_search_is_detected_by_pairs_of_a_generic_regime() {
        let found = search_faults(0x5eed, &[Regime::Generic]).remove(0);
        assert_eq!(found.missed, [], "{found:?}");
        assert!(found.rejected == 0 && found.holds(), "{found:?}");
    }

    #[test]
    fn a_fault_of_one_run_does_not_stay() {
        let all = SearchFault::ALL;
        let once = of_case(5, 0, &all).detected;
        assert!(!once.is_empty());
        assert_eq!(once, of_case(5, 0, &all).detected);
        assert_eq!(of_case(5, 0, &[]).rejected, 0);
    }
}
