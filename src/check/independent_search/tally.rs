//! What the comparisons of the two searches give, over many pairs of beams.

use super::{SearchFinding, Searched, pair_of, searched};
use crate::check::draw::Case;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The results of the comparisons of the library's search with the independent one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SearchTally {
    /// Pairs of beams for which both searches were compared: all cases, and pairs for the search alone.
    pub pairs: u64,
    /// Of these, the pairs for which the independent search left no box open.
    pub certain: u64,
    /// Minima that both searches found.
    pub minima: u64,
    /// Open regions whose smallest distance was compared.
    pub regions: u64,
    /// Cases in which something differs, by number, with the first difference.
    pub differences: BTreeMap<u64, SearchFinding>,
    /// The same for the pairs that are drawn for the search alone, by the number of the case that brings them.
    pub differences_of_pairs: BTreeMap<u64, SearchFinding>,
}

impl SearchTally {
    /// Adds a case, and the pair for the search alone that it brings.
    pub(crate) fn add(&mut self, seed: u64, case: &Case) {
        let of_case = self.add_pair(&searched(case.beams()));
        self.differences.extend(of_case.map(|finding| (case.number, finding)));
        let Some(Ok(found)) = pair_of(seed, case.number).map(|pair| pair.searched()) else { return };
        let of_pair = self.add_pair(&found);
        self.differences_of_pairs.extend(of_pair.map(|finding| (case.number, finding)));
    }

    fn add_pair(&mut self, searched: &Searched) -> Option<SearchFinding> {
        self.pairs += u64::from(searched.is_compared);
        self.certain += u64::from(searched.is_compared && searched.is_certain);
        self.minima += searched.minima;
        self.regions += searched.regions;
        searched.findings.first().copied()
    }

    /// The number of pairs of beams for which something differs.
    pub fn differing(&self) -> u64 {
        (self.differences.len() + self.differences_of_pairs.len()) as u64
    }

    pub(crate) fn merge(&mut self, other: Self) {
        self.pairs += other.pairs;
        self.certain += other.certain;
        self.minima += other.minima;
        self.regions += other.regions;
        self.differences.extend(other.differences);
        self.differences_of_pairs.extend(other.differences_of_pairs);
    }
}
