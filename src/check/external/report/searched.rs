//! The library's search for closest points against the independent one, over the cases.

use crate::check::{SearchFinding, Searched};
use serde::{Deserialize, Serialize};

/// In which cases the two searches were compared, and in which they differ.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SearchFound {
    /// Cases for which both searches were compared.
    pub compared: u64,
    /// Of these, the cases in which something differs.
    pub differing: u64,
    /// The first of them, with its first difference.
    pub first: Option<(String, SearchFinding)>,
}

impl SearchFound {
    /// Adds the comparison of a case.
    pub fn add(&mut self, case: &str, searched: &Searched) {
        self.compared += u64::from(searched.is_compared);
        if let Some(finding) = searched.findings.first() {
            self.differing += 1;
            self.first.get_or_insert((case.to_owned(), *finding));
        }
    }
}
