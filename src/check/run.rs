//! Many cases at once, on all cores.

use super::compare::compare;
use super::draw::{Case, Selection};
use super::summary::Summary;
use super::trial::Trial;
use rayon::prelude::*;

/// Draws all cases of a selection and compares them; `done` is called after each.
///
/// The result depends on the trial, the seed and the selection, not on the number of threads.
pub fn run(trial: &Trial, seed: u64, selection: &Selection, done: impl Fn() + Sync) -> Summary {
    selection
        .numbers()
        .into_par_iter()
        .map(|number| {
            let case = Case::draw(seed, number);
            let summary = Summary::of(&case, &compare(trial, &case));
            done();
            summary
        })
        .reduce(Summary::default, Summary::merge)
}
