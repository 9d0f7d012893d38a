//! Hessians of which only some blocks are wrong. A program may write each block by itself.

use super::formulas;
use super::sample::{Along, Sample};
use super::sentences::Reading;

/// The dofs of rows and columns: those of the beam, or of the bar beam.
const BLOCKS: [[usize; 2]; 4] = [[0, 0], [0, 1], [1, 0], [1, 1]];

/// What explains the wrong blocks, if all gradients are right and some blocks are. `samples` are along random directions.
pub(super) fn found(samples: &[Sample], of: &dyn Fn(Along) -> Vec<Sample>) -> Vec<Reading> {
    if formulas::are_wrong(samples)[0] {
        return Vec::new();
    }
    let blocks = BLOCKS.map(|block| of(Along::Block(block)));
    let mut wrong = Vec::new();
    for (place, samples) in blocks.iter().enumerate() {
        let [gradients, hessians] = formulas::are_wrong(samples);
        if gradients {
            return Vec::new();
        }
        wrong.extend(hessians.then_some(place));
    }
    let Some(words) = formulas::words_of_blocks(&wrong) else { return Vec::new() };
    let samples: Vec<Sample> = wrong.iter().flat_map(|place| blocks[*place].clone()).collect();
    let mut found = formulas::of_all(&samples);
    for of in &mut found {
        of.words = format!("{}, in {words}", of.words);
    }
    found
}
