//! Gradients and Hessians of which only the entries of some beams are wrong. A program may write each block by itself.

use super::formulas;
use super::sample::{Along, Sample};
use super::sentences::Reading;

/// The dofs of rows and columns: those of the beam, or of the bar beam.
const BLOCKS: [[usize; 2]; 4] = [[0, 0], [0, 1], [1, 0], [1, 1]];
/// The entries of gradients, in words.
const OF_BEAMS: [&str; 2] =
    ["the entries of the dofs of the beam", "the entries of the dofs of the bar beam"];

/// What explains the wrong entries, if those of one beam alone are wrong, or some blocks of Hessians.
pub(super) fn found(of: &dyn Fn(Along) -> Vec<Sample>) -> Vec<Reading> {
    let of_beams = [0, 1].map(|beam| of(Along::Block([beam, beam])));
    let [beam, bar] = of_beams.each_ref().map(|samples| formulas::are_wrong(samples));
    if beam[0] || bar[0] {
        let wrong = usize::from(bar != [false; 2]);
        // The entries of the other beam must be right.
        let is_alone = [beam, bar][1 - wrong] == [false; 2];
        return if is_alone { told(&of_beams[wrong], OF_BEAMS[wrong]) } else { Vec::new() };
    }
    let mut wrong = Vec::new();
    let mut all = Vec::new();
    for (place, block) in BLOCKS.into_iter().enumerate() {
        let samples = of(Along::Block(block));
        if formulas::are_wrong(&samples)[1] {
            wrong.push(place);
            all.extend(samples);
        }
    }
    formulas::words_of_blocks(&wrong).map_or_else(Vec::new, |words| told(&all, words))
}

/// What explains these answers, which are those of some entries: all of them, or those of the geometry. A program may use a
/// wrong gradient or Hessian in its contact element, too.
fn told(samples: &[Sample], entries: &str) -> Vec<Reading> {
    let mut found = formulas::of_all(samples);
    if found.is_empty() && samples.iter().any(|sample| sample.element.is_some()) {
        let of_geometry = |sample: &Sample| {
            let mut sample = Sample { element: None, ..sample.clone() };
            sample.inputs.leave_forces();
            sample
        };
        found = formulas::of_all(&samples.iter().map(of_geometry).collect::<Vec<_>>());
    }
    for of in &mut found {
        of.words = format!("{}, in {entries}", of.words);
    }
    found
}
