//! A way in turns with two kernels that show what a core's arithmetic and its stores can do.

use crate::scenario::{Runner, Scenario};
use beamgap::report::Turns;
#[cfg(target_arch = "x86_64")]
use fearless_simd::{Level, Simd, f64x4, prelude::*, x86::Avx2};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// How many turns there are, and how long something takes its turn at least.
const TURNS: usize = 101;
const TURN: Duration = Duration::from_micros(100);

/// Chains of multiply-adds that do not wait for each other: enough for two units of five clocks each.
const CHAINS: usize = 12;
/// The length of a chain.
const LENGTH: usize = 64;
/// The numbers that are stored: a Hessian of 24 dofs.
const NUMBERS: usize = 24 * 24;

/// The scenario and the kernels in turns, if its arithmetic is counted.
pub(crate) fn turns(scenario: &Scenario) -> Option<Turns> {
    let multiply_adds = scenario.multiply_adds?;
    let [chains, stores] = kernels();
    let multiply_adds_alone = Timed::new(chains, CHAINS * LENGTH * 4);
    let stores_alone = Timed::new(stores, NUMBERS * size_of::<f64>());
    let mut ways = [Timed::new(scenario.runner(), scenario.pairs), multiply_adds_alone, stores_alone];
    let samples = (0..TURNS).map(|_| ways.each_mut().map(Timed::turn)).collect();
    Some(Turns { multiply_adds, samples })
}

/// What does so much in a run, run so many times a turn.
struct Timed {
    run: Runner,
    amount: usize,
    runs: u32,
}

impl Timed {
    /// With as many runs as fill a turn.
    fn new(run: Runner, amount: usize) -> Self {
        let mut timed = Self { run, amount, runs: 1 };
        while timed.elapsed() < TURN {
            timed.runs *= 2;
        }
        timed
    }

    fn elapsed(&mut self) -> Duration {
        let start = Instant::now();
        for _ in 0..self.runs {
            (self.run)();
        }
        start.elapsed()
    }

    /// The nanoseconds of one of what it does.
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    fn turn(&mut self) -> f64 {
        self.elapsed().as_nanos() as f64 / f64::from(self.runs) / self.amount as f64
    }
}

/// Multiply-adds, and stores, as fast as this machine can.
fn kernels() -> [Runner; 2] {
    let mut numbers = Numbers([0.0; NUMBERS]);
    #[cfg(target_arch = "x86_64")]
    if let Some(avx2) = Level::new().as_avx2() {
        let chains = move || {
            avx2.vectorize(
                #[inline(always)]
                || chains_by_four(avx2),
            );
        };
        let stores = move || {
            avx2.vectorize(
                #[inline(always)]
                || store(&mut numbers),
            );
        };
        return [Box::new(chains), Box::new(stores)];
    }
    [Box::new(chains), Box::new(move || store(&mut numbers))]
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn chains_by_four(avx2: Avx2) {
    let [factor, term] = black_box([0.999, 0.001]).map(|x| f64x4::splat(avx2, x));
    let mut sums = [term; CHAINS];
    for _ in 0..LENGTH {
        for sum in &mut sums {
            *sum = sum.mul_add(factor, term);
        }
    }
    let sum = sums.into_iter().fold(term, |all, sum| all + sum);
    black_box(sum[0] + sum[1] + sum[2] + sum[3]);
}

/// The same without vector instructions of its own.
fn chains() {
    let [factor, term] = black_box([0.999, 0.001]);
    let mut sums = [[term; 4]; CHAINS];
    for _ in 0..LENGTH {
        for sum in sums.as_flattened_mut() {
            *sum = *sum * factor + term;
        }
    }
    black_box(sums);
}

/// On a cache line, as results are: a vector that is stored across two lines takes twice as long.
#[repr(align(64))]
struct Numbers([f64; NUMBERS]);

#[inline(always)]
fn store(numbers: &mut Numbers) {
    numbers.0.fill(black_box(1.5));
    black_box(&mut numbers.0);
}
