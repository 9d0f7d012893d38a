//! Many cases at once, on all cores.

use super::compare::compare;
use super::config::CheckConfig;
use super::draw::{Case, Selection};
use super::shard::Shard;
use super::summary::Summary;
use rayon::prelude::*;
use std::time::Instant;

/// The number of cases between two checks of the time.
const BLOCK: usize = 256;

/// Draws all cases of a selection and compares them; `done` is called after each case.
///
/// The result depends on the config, the seed and the selection, not on the number of threads.
pub fn run(config: &CheckConfig, seed: u64, selection: &Selection, done: impl Fn() + Sync) -> Summary {
    run_part(config, seed, &selection.part(Shard::WHOLE), None, done)
}

/// Compares the cases with these numbers, in order, until the deadline if there is one; `done` is called after each.
///
/// The counts of the summary show how many cases were reached: the first ones of the list. [`Summary::merge`] combines
/// parts.
pub fn run_part(
    config: &CheckConfig,
    seed: u64,
    numbers: &[u64],
    deadline: Option<Instant>,
    done: impl Fn() + Sync,
) -> Summary {
    let add = |mut summary: Summary, &number: &u64| {
        let case = Case::draw(seed, number);
        let verdicts = compare(config, &case);
        summary.add(&case, &verdicts);
        summary.counts.add(&case, &verdicts);
        summary.search.add(seed, &case);
        done();
        summary
    };
    let is_over = || deadline.is_some_and(|deadline| Instant::now() >= deadline);
    let blocks = numbers.chunks(if deadline.is_some() { BLOCK } else { numbers.len().max(1) });
    let of_block =
        |block: &[u64]| block.par_iter().fold(Summary::default, add).reduce(Summary::default, Summary::merge);
    blocks.take_while(|_| !is_over()).map(of_block).fold(Summary::default(), Summary::merge)
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, Case, CheckConfig, Selection, Shard, Summary, compare, run, run_part};
    use crate::check::{Family, Regime, Tally};
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::{Duration, Instant};

    fn selection(cases: u64) -> Selection {
        let regimes = vec![Regime::NearEnd, Regime::Generic];
        Selection { regimes, family: Some(Family::Segment), cases }
    }

    #[test]
    fn a_run_is_the_sum_of_its_cases() {
        let (config, done) = (CheckConfig::default(), AtomicU64::new(0));
        let summary = run(&config, 7, &selection(4), || {
            done.fetch_add(1, Ordering::Relaxed);
        });
        let each = selection(4).numbers().into_iter().map(|number| {
            let case = Case::draw(7, number);
            let verdicts = compare(&config, &case);
            let mut summary = Summary::of(&case, &verdicts);
            summary.counts.add(&case, &verdicts);
            summary.search.add(7, &case);
            summary
        });
        assert_eq!(summary, each.reduce(Summary::merge).unwrap());
        assert_eq!(done.into_inner(), 8);
        assert!(summary.compared() >= 8);
    }

    #[test]
    fn shards_hold_every_case_once_and_some_of_each_regime() {
        let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 30 };
        let mut all = selection.numbers();
        all.sort_unstable();
        for of in [1, 2, 3, 7, 10] {
            let shards = (1..=of).map(|number| selection.part(format!("{number}/{of}").parse().unwrap()));
            let shards: Vec<_> = shards.collect();
            for shard in &shards {
                let of_regime =
                    |regime| shard.iter().filter(move |&&number| Case::draw(1, number).regime == regime);
                let counts = Regime::ALL.map(|regime| of_regime(regime).count());
                assert!(counts.iter().all(|count| count.abs_diff(30 / of) <= 1), "{of} {counts:?}");
            }
            let mut held = shards.concat();
            held.sort_unstable();
            assert_eq!(held, all);
        }
    }

    #[test]
    fn a_deadline_leaves_the_last_cases_out() {
        let config = CheckConfig::default();
        let numbers = selection(1000).part(Shard::WHOLE);
        let reached = |deadline| {
            let summary = run_part(&config, 7, &numbers, Some(deadline), || ());
            let reached: u64 = summary.regimes.values().map(|tally: &Tally| tally.cases).sum();
            (usize::try_from(reached).unwrap(), summary)
        };
        assert_eq!(reached(Instant::now()).0, 0);
        let (some, summary) = reached(Instant::now() + Duration::from_millis(50));
        assert!(some > 0 && some.is_multiple_of(BLOCK) && some < numbers.len(), "{some}");
        assert_eq!(summary, run_part(&config, 7, &numbers[..some], None, || ()));
    }
}
