//! Changes of some entries of a gradient or Hessian.

use super::change::Change;
use super::entries::{Entries, FACTORS, OF_GRADIENTS, OF_HESSIANS};
use super::list::Formulas;
use super::outputs::RESULTS;

/// The cost of such a change.
const COST: u32 = 3;

impl Formulas {
    /// Factors on entries of each result that is a gradient or a Hessian.
    pub(super) fn of_entries(&self) -> Vec<Change> {
        let mut found = Vec::new();
        let results = RESULTS.iter().copied().chain(["R", "K", "R_p", "K_p"].map(|name| self.name(name)));
        for name in results {
            let blocks: &[(&[usize], &str)] = match self.kinds[name].varies {
                [true, false] => &OF_GRADIENTS,
                [true, true] => &OF_HESSIANS,
                _ => continue,
            };
            for (blocks, of_blocks) in blocks.iter().copied() {
                for (factor, words) in FACTORS {
                    let of = self.names.0[name].trim_end_matches("_p");
                    let words = format!("in {of} {of_blocks}: {words}");
                    for is_stored in [true, false] {
                        let linear = self.linear.get(name);
                        let entries = Some(Entries { name, linear, blocks, factor });
                        found.push(Change { entries, is_stored, cost: COST, ..Change::of(words.clone()) });
                    }
                }
            }
        }
        found
    }
}
