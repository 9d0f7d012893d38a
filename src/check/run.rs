//! Many cases at once, on all cores.

use super::compare::{Oracles, compare_with};
use super::draw::{Case, Selection};
use super::summary::Summary;
use rayon::prelude::*;

/// Draws all cases of a selection and compares them with automatic differentiation; `done` is called after each.
///
/// The result depends on the seed and the selection, not on the number of threads.
pub fn run(seed: u64, selection: &Selection, done: impl Fn() + Sync) -> Summary {
    run_with(seed, selection, Oracles::Ad, done)
}

/// The same with these oracles.
pub fn run_with(seed: u64, selection: &Selection, oracles: Oracles, done: impl Fn() + Sync) -> Summary {
    selection
        .numbers()
        .into_par_iter()
        .map(|number| {
            let case = Case::draw(seed, number);
            let summary = Summary::of(&case, &compare_with(&case, oracles));
            done();
            summary
        })
        .reduce(Summary::default, Summary::merge)
}
