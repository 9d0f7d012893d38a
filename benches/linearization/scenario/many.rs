//! Many pairs on one thread and on two: what an assembly asks for.

use super::error::Rows;
use super::input::{Twins, drawn};
use super::truth;
use super::work::{Judge, rows};
use super::{Error, Runner, Scenario, Task};
use beamgap::curve::Hermite;
use beamgap::linearization::Derivatives;
use beamgap::linearization::closed_form::kernel::{self, Packed, PairAtPoint, Targets};
use beamgap::number::Lanes;
use beamgap::test_beam::Family;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::hint::black_box;
use std::sync::Arc;

/// So many pairs of different shape, over and over.
const DIFFERENT: usize = 8;
/// So many quantities in a run, which then takes so long that waking a thread does not show.
const IN_CACHE: usize = 655_360;
/// So many quantities where each result has memory of its own: 98 MB, far more than the caches of one core.
const TO_MEMORY: usize = 40_960;
/// So many to a task of a thread, where the results stay in its cache.
const CHUNK: usize = 128;

/// The lanes by one thread.
pub(super) const FOUR_AT_ONCE: &str = "closed form, four at once, 1 thread";

type Hermites = Twins<Hermite, 12>;
type Met = PairAtPoint<'static, Hermite, Hermite, 12, 12>;
/// `K` quantities of a pair.
type AllDerivatives<const K: usize> = [Derivatives<f64, 12, 12>; K];
/// `K` quantities of four pairs, halves of the Hessians.
type Four<const K: usize> = [Packed<Lanes, 24, 300>; K];

/// `K` quantities of many pairs.
type Batch<const K: usize> = fn(&[Met], &mut [Four<K>]);

const D: Batch<1> = |of, to| {
    kernel::write_d_batch(of, to.as_flattened_mut());
};
const ALL: Batch<5> = |of, to| {
    kernel::write_all_batch(of, to);
};

/// By one thread and by two.
pub(super) fn scenarios() -> Vec<Scenario> {
    // For as long as the program runs.
    let different: &[Hermites] = drawn(Family::Hermite, DIFFERENT, |_| Hermite::new()).leak();
    let met = |Twins { pair, q, point, .. }: &'static Hermites| Met { pair, q, point };
    let pairs: Arc<[Met]> = different.iter().map(met).cycle().take(IN_CACHE).collect();
    let judges = different.iter().map(|&input| Judge::new(move || truth::all_derivatives(&input))).collect();
    let many = Many { pairs, judges };
    let mut all = Vec::new();
    for threads in [1, 2] {
        all.push(many.one_by_one(Task::DistanceOfMany, threads, |p, [d]: &mut AllDerivatives<1>| {
            kernel::write_d(p.pair, p.q, p.point, d);
        }));
        all.push(many.one_by_one(Task::AllOfMany, threads, |p, to: &mut AllDerivatives<5>| {
            let [d, xi, xi_bar, t, t_bar] = to;
            kernel::write_all(p.pair, p.q, p.point, &mut Targets { d, xi, xi_bar, t, t_bar });
        }));
        all.push(many.four_at_once(Task::DistanceOfMany, threads, D));
        all.push(many.four_at_once(Task::AllOfMany, threads, ALL));
        all.push(many.to_memory(Task::DistanceOfMany, threads, D));
        all.push(many.to_memory(Task::AllOfMany, threads, ALL));
    }
    all
}

struct Many {
    pairs: Arc<[Met]>,
    /// Of the first pairs, one each.
    judges: Arc<[Judge]>,
}

impl Many {
    /// `work` for all pairs, each result left where the next one will be.
    fn one_by_one<const K: usize>(
        &self,
        task: Task,
        threads: usize,
        work: fn(&Met, &mut AllDerivatives<K>),
    ) -> Scenario {
        let (pairs, of_first) = (self.pairs.clone(), self.pairs.clone());
        let runner = move || -> Runner {
            let (pool, pairs) = (pool(threads), pairs.clone());
            Box::new(move || {
                pool.install(|| {
                    pairs[..IN_CACHE / K].par_chunks(CHUNK).for_each(|chunk| {
                        let mut to = [Derivatives::zero(); K];
                        for pair in chunk {
                            work(black_box(pair), black_box(&mut to));
                        }
                    });
                });
            })
        };
        let rows = move |i: usize| {
            let mut to = [Derivatives::zero(); K];
            work(&of_first[i], &mut to);
            rows(&to.each_ref())
        };
        self.scenario::<K>((task, "closed form, one by one", threads), runner, rows)
    }

    /// Four pairs in the lanes of a vector, the results left where the next ones will be.
    fn four_at_once<const K: usize>(&self, task: Task, threads: usize, batch: Batch<K>) -> Scenario {
        let pairs = self.pairs.clone();
        let runner = move || -> Runner {
            let (pool, pairs) = (pool(threads), pairs.clone());
            Box::new(move || {
                pool.install(|| {
                    pairs[..IN_CACHE / K].par_chunks(CHUNK).for_each(|chunk| {
                        let mut to = [[Packed::zeros(); K]];
                        for four in chunk.chunks(4) {
                            batch(black_box(four), black_box(&mut to));
                        }
                    });
                });
            })
        };
        let rows = self.rows_of_four(batch);
        self.scenario::<K>((task, "closed form, four at once", threads), runner, rows)
    }

    /// Each result in memory of its own.
    fn to_memory<const K: usize>(&self, task: Task, threads: usize, batch: Batch<K>) -> Scenario {
        let pairs = self.pairs.clone();
        let many = TO_MEMORY / K;
        let runner = move || -> Runner {
            let (pool, pairs) = (pool(threads), pairs.clone());
            let mut to = vec![[Packed::zeros(); K]; many / 4];
            Box::new(move || {
                pool.install(|| {
                    let chunks = pairs[..many].par_chunks(CHUNK).zip(to.par_chunks_mut(CHUNK / 4));
                    chunks.for_each(|(of, to)| batch(black_box(of), black_box(to)));
                });
            })
        };
        let rows = self.rows_of_four(batch);
        let scenario = self.scenario::<K>((task, "closed form, to memory", threads), runner, rows);
        Scenario { pairs: many, ..scenario }
    }

    /// What a batch yields for one of the first pairs.
    fn rows_of_four<const K: usize>(
        &self,
        batch: Batch<K>,
    ) -> impl Fn(usize) -> Rows + Send + Sync + 'static {
        let pairs = self.pairs.clone();
        move |i| {
            let mut to = [[Packed::zeros(); K]; DIFFERENT / 4];
            batch(&pairs[..DIFFERENT], &mut to);
            to[i / 4].iter().flat_map(|of| lane(of, i % 4)).collect()
        }
    }

    /// Judged by the first pairs.
    fn scenario<const K: usize>(
        &self,
        (task, method, threads): (Task, &str, usize),
        runner: impl Fn() -> Runner + Send + Sync + 'static,
        rows: impl Fn(usize) -> Rows + Send + Sync + 'static,
    ) -> Scenario {
        let judges = self.judges.clone();
        let judge = move || {
            let of_pair = |(i, judge): (usize, &Judge)| Error::of(&rows(i), &judge.truth()[..3 * K], |_| 0.0);
            judges.iter().enumerate().map(of_pair).fold(Error::NONE, Error::worse)
        };
        let method = by_threads(method, threads);
        Scenario {
            task,
            family: Family::Hermite.name(),
            dofs: 24,
            method,
            pairs: IN_CACHE / K,
            multiply_adds: None,
            runner: Box::new(runner),
            judge: Box::new(judge),
        }
    }
}

/// The name of a method by so many threads.
pub(super) fn by_threads(method: &str, threads: usize) -> String {
    format!("{method}, {threads} {}", if threads == 1 { "thread" } else { "threads" })
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("threads")
}

/// What one lane holds.
fn lane(of: &Packed<Lanes, 24, 300>, lane: usize) -> [Vec<f64>; 3] {
    let entries = (0..24).flat_map(|i| (0..24).map(move |j| of.entry(i, j).0[lane]));
    [vec![of.value.0[lane]], of.gradient.iter().map(|g| g.0[lane]).collect(), entries.collect()]
}
