//! Two kernels that measure the peak rates of a core: of its arithmetic and of its stores.

use crate::scenario::Runner;
use crate::timed::Timed;
#[cfg(target_arch = "x86_64")]
use fearless_simd::{Level, Simd, f64x4, prelude::*, x86::Avx2};
use std::hint::black_box;
use std::time::Duration;

/// The number of independent chains of multiply-adds: enough for two units with a latency of five cycles each.
const CHAINS: usize = 12;
/// The length of a chain.
const LENGTH: usize = 64;
/// The number of stored numbers: a Hessian of 24 dofs.
const NUMBERS: usize = 24 * 24;

/// Both kernels in rounds of this length. The times are those of one multiply-add and of one stored byte.
pub(crate) fn roofline(round: Duration) -> [Timed; 2] {
    let [chains, stores] = kernels();
    [Timed::new(chains, CHAINS * LENGTH * 4, round), Timed::new(stores, NUMBERS * size_of::<f64>(), round)]
}

/// The number of runs of the chains in a thread. They take longer than a round, so the start of a thread is negligible.
const RUNS: usize = 1 << 19;

/// Multiply-adds alone on several threads, in rounds of this length. The time is that of one multiply-add.
pub(crate) fn multiply_adds_by(threads: usize, round: Duration) -> Timed {
    let run = || {
        let [mut chains, _] = kernels();
        (0..RUNS).for_each(|_| chains());
    };
    let by_all = move || {
        std::thread::scope(|scope| {
            for _ in 1..threads {
                scope.spawn(run);
            }
            run();
        });
    };
    Timed::new(Box::new(by_all), threads * RUNS * CHAINS * LENGTH * 4, round)
}

/// The multiply-adds and the stores, with the vector instructions of this machine.
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

/// The multiply-adds without explicit vector instructions.
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

/// Aligned to a cache line, like the results. A vector store across two lines takes twice as long.
#[repr(align(64))]
struct Numbers([f64; NUMBERS]);

#[inline(always)]
fn store(numbers: &mut Numbers) {
    numbers.0.fill(black_box(1.5));
    black_box(&mut numbers.0);
}
