//! Many pairs on one thread and on two, as in an assembly.

use super::error::Rows;
use super::input::{Twins, drawn};
use super::truth;
use super::work::{Judge, rows};
use super::{Error, Runner, Scenario, Task};
use beamgap::curve::Hermite;
use beamgap::linearization::Derivatives;
use beamgap::linearization::closed_form::kernel::{
    DistanceAlone, Packed, PairAtPoint, WithoutSlips, write_d_batch,
};
use beamgap::number::Lanes;
use beamgap::test_beam::Family;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::hint::black_box;
use std::sync::Arc;

/// The number of different pairs, which are repeated.
const DIFFERENT: usize = 8;
/// The number of quantities in a run. Such a run takes so long that the wake-up time of a thread is negligible.
const IN_CACHE: usize = 655_360;
/// The number of quantities if each result has separate memory: 98 MB, far more than the caches of one core.
const TO_MEMORY: usize = 40_960;
/// The number of pairs in a task of a thread. Their results stay in its cache.
const CHUNK: usize = 128;

/// One pair after another.
const ONE_BY_ONE: &str = "closed form, one by one";
/// Four pairs in the lanes of a vector.
const LANES: &str = "closed form, four at once";
/// The suffix of the name of a method that writes each result to separate memory.
const TO_MEMORY_NAME: &str = ", to memory";
/// The lanes on one thread.
pub(super) const FOUR_AT_ONCE: &str = "closed form, four at once, 1 thread";

/// The name of the same work one pair after another, if `method` is four at once.
pub(super) fn one_by_one(method: &str) -> Option<String> {
    method.strip_prefix(LANES).map(|rest| format!("{ONE_BY_ONE}{rest}"))
}

type Hermites = Twins<Hermite, 12>;
type Met = PairAtPoint<'static, Hermite, Hermite, 12, 12>;
/// `K` quantities of a pair.
type AllDerivatives<const K: usize> = [Derivatives<f64, 12, 12>; K];
/// d of four pairs, with half of the Hessians.
type Four = Packed<Lanes, 24, 300>;
/// A method for `K` quantities of a pair.
type One<const K: usize> = fn(&Met, &mut AllDerivatives<K>);

const D: One<1> = |p, [d]| p.pair.write(p.q, p.point, DistanceAlone { d });
const ALL: One<5> = |p, [d, xi, xi_bar, t, t_bar]| {
    p.pair.write(p.q, p.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
};

/// The scenarios on one thread and on two.
pub(super) fn scenarios() -> Vec<Scenario> {
    // The pairs live as long as the program.
    let different: &[Hermites] = drawn(Family::Hermite, DIFFERENT, |_| Hermite::new()).leak();
    let met = |Twins { pair, q, point, .. }: &'static Hermites| Met { pair, q, point };
    let pairs: Arc<[Met]> = different.iter().map(met).cycle().take(IN_CACHE).collect();
    let judges = different.iter().map(|&input| Judge::new(move || truth::all_derivatives(&input))).collect();
    let many = Many { pairs, judges };
    let mut all = Vec::new();
    for threads in [1, 2] {
        all.push(many.one_by_one(Task::DistanceOfMany, threads, D));
        all.push(many.four_at_once(threads));
        all.push(many.one_by_one_to_memory(Task::DistanceOfMany, threads, D));
        all.push(many.four_at_once_to_memory(threads));
        all.push(many.one_by_one(Task::AllOfMany, threads, ALL));
        all.push(many.one_by_one_to_memory(Task::AllOfMany, threads, ALL));
    }
    all
}

struct Many {
    pairs: Arc<[Met]>,
    /// One judge for each of the different pairs.
    judges: Arc<[Judge]>,
}

impl Many {
    /// `work` for all pairs; each result overwrites the previous one.
    fn one_by_one<const K: usize>(&self, task: Task, threads: usize, work: One<K>) -> Scenario {
        let pairs = self.pairs.clone();
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
        self.scenario::<K>((task, ONE_BY_ONE, threads), runner, self.rows_of_one(work))
    }

    /// `work` for all pairs; each result has separate memory.
    fn one_by_one_to_memory<const K: usize>(&self, task: Task, threads: usize, work: One<K>) -> Scenario {
        let pairs = self.pairs.clone();
        let many = TO_MEMORY / K;
        let runner = move || -> Runner {
            let (pool, pairs) = (pool(threads), pairs.clone());
            let mut to = vec![[Derivatives::zero(); K]; many];
            Box::new(move || {
                pool.install(|| {
                    let chunks = pairs[..many].par_chunks(CHUNK).zip(to.par_chunks_mut(CHUNK));
                    chunks.for_each(|(of, to)| {
                        for (pair, to) in of.iter().zip(to) {
                            work(black_box(pair), black_box(to));
                        }
                    });
                });
            })
        };
        let method = format!("{ONE_BY_ONE}{TO_MEMORY_NAME}");
        let scenario = self.scenario::<K>((task, &method, threads), runner, self.rows_of_one(work));
        Scenario { pairs: many, ..scenario }
    }

    /// d of four pairs in the lanes of a vector; the results overwrite the previous ones.
    fn four_at_once(&self, threads: usize) -> Scenario {
        let pairs = self.pairs.clone();
        let runner = move || -> Runner {
            let (pool, pairs) = (pool(threads), pairs.clone());
            Box::new(move || {
                pool.install(|| {
                    pairs[..IN_CACHE].par_chunks(CHUNK).for_each(|chunk| {
                        let mut to = [Four::zeros()];
                        for four in chunk.chunks(4) {
                            write_d_batch(black_box(four), black_box(&mut to));
                        }
                    });
                });
            })
        };
        self.scenario::<1>((Task::DistanceOfMany, LANES, threads), runner, self.rows_of_four())
    }

    /// d of four pairs in the lanes of a vector; the results have separate memory.
    fn four_at_once_to_memory(&self, threads: usize) -> Scenario {
        let pairs = self.pairs.clone();
        let runner = move || -> Runner {
            let (pool, pairs) = (pool(threads), pairs.clone());
            let mut to = vec![Four::zeros(); TO_MEMORY / 4];
            Box::new(move || {
                pool.install(|| {
                    let chunks = pairs[..TO_MEMORY].par_chunks(CHUNK).zip(to.par_chunks_mut(CHUNK / 4));
                    chunks.for_each(|(of, to)| {
                        write_d_batch(black_box(of), black_box(to));
                    });
                });
            })
        };
        let method = format!("{LANES}{TO_MEMORY_NAME}");
        let scenario =
            self.scenario::<1>((Task::DistanceOfMany, &method, threads), runner, self.rows_of_four());
        Scenario { pairs: TO_MEMORY, ..scenario }
    }

    /// The result of a method for one of the different pairs.
    fn rows_of_one<const K: usize>(&self, work: One<K>) -> impl Fn(usize) -> Rows + Send + Sync + 'static {
        let pairs = self.pairs.clone();
        move |i| {
            let mut to = [Derivatives::zero(); K];
            work(&pairs[i], &mut to);
            rows(&to.each_ref())
        }
    }

    /// The result of the lanes for one of the different pairs.
    fn rows_of_four(&self) -> impl Fn(usize) -> Rows + Send + Sync + 'static {
        let pairs = self.pairs.clone();
        move |i| {
            let mut to = vec![Four::zeros(); DIFFERENT / 4];
            write_d_batch(&pairs[..DIFFERENT], &mut to);
            lane(&to[i / 4], i % 4).into_iter().collect()
        }
    }

    /// A scenario that is verified on the different pairs.
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

/// The name of a method on this number of threads.
pub(super) fn by_threads(method: &str, threads: usize) -> String {
    format!("{method}, {threads} {}", if threads == 1 { "thread" } else { "threads" })
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("threads")
}

/// The numbers in one lane.
fn lane(of: &Four, lane: usize) -> [Vec<f64>; 3] {
    let entries = (0..24).flat_map(|i| (0..24).map(move |j| of.entry(i, j).0[lane]));
    [vec![of.value.0[lane]], of.gradient.iter().map(|g| g.0[lane]).collect(), entries.collect()]
}
