//! How sharp the tolerances are: the rounding that the bounds allow, compared with the actual rounding.
//!
//! The true error of a number is its distance from the closed form in double-double, at the closest point refined
//! there. A bound below the true error is violated. A bound far above it hides faults.

mod counted;
mod record;

use super::draw::{Case, Selection};
use counted::Counted;
use rayon::prelude::*;
pub use record::{Bounds, Measured, Points, Side, Violation};

/// Measures all cases of a selection.
///
/// `done` is called after each case. The result depends on the seed and the selection, not on the number of threads.
pub fn bounds(seed: u64, selection: &Selection, done: impl Fn() + Sync) -> Bounds {
    let add = |mut all: Counted, number: u64| {
        all.add(&Case::draw(seed, number));
        done();
        all
    };
    let numbers = selection.numbers().into_par_iter();
    numbers.fold(Counted::default, add).reduce(Counted::default, Counted::merge).bounds()
}
