//! Many cases at once, on all cores.

use super::compare::compare;
use super::config::CheckConfig;
use super::draw::{Case, Selection};
use super::summary::Summary;
use rayon::prelude::*;

/// Draws all cases of a selection and compares them; `done` is called after each.
///
/// The result depends on the config, the seed and the selection, not on the number of threads.
pub fn run(config: &CheckConfig, seed: u64, selection: &Selection, done: impl Fn() + Sync) -> Summary {
    selection
        .numbers()
        .into_par_iter()
        .fold(Summary::default, |mut summary, number| {
            let case = Case::draw(seed, number);
            summary.add(&case, &compare(config, &case));
            done();
            summary
        })
        .reduce(Summary::default, Summary::merge)
}

#[cfg(test)]
mod tests {
    use super::{Case, CheckConfig, Selection, Summary, compare, run};
    use crate::check::{Family, Regime};
    use std::sync::atomic::{AtomicU64, Ordering};

    #[test]
    fn a_run_is_the_sum_of_its_cases() {
        let regimes = vec![Regime::NearEnd, Regime::Generic];
        let selection = Selection { regimes, family: Some(Family::Segment), cases: 4 };
        let (config, done) = (CheckConfig::default(), AtomicU64::new(0));
        let summary = run(&config, 7, &selection, || {
            done.fetch_add(1, Ordering::Relaxed);
        });
        let each = selection.numbers().into_iter().map(|number| {
            let case = Case::draw(7, number);
            Summary::of(&case, &compare(&config, &case))
        });
        assert_eq!(summary, each.reduce(Summary::merge).unwrap());
        assert_eq!(done.into_inner(), 8);
        assert!(summary.compared() >= 8);
    }
}
