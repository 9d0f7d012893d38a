//! The two kernels that show what a core's arithmetic and its stores can do.

use beamgap::report::Floor;
#[cfg(target_arch = "x86_64")]
use fearless_simd::{Level, Simd, f64x4, prelude::*, x86::Avx2};
use std::hint::black_box;

/// Chains of multiply-adds that do not wait for each other: enough for two units of five clocks each.
const CHAINS: usize = 12;
/// The length of a chain.
const LENGTH: usize = 64;
/// The numbers that are stored: a Hessian of 24 dofs.
const NUMBERS: usize = 24 * 24;

/// How many multiply-adds and how many bytes a run of the kernels does.
pub(crate) const AMOUNTS: [usize; 2] = [CHAINS * LENGTH * 4, NUMBERS * size_of::<f64>()];

/// A function that reaches a limit, as fast as this machine can.
pub(crate) fn kernel(of: Floor) -> Box<dyn FnMut()> {
    let mut numbers = [0.0; NUMBERS];
    #[cfg(target_arch = "x86_64")]
    if let Some(avx2) = Level::new().as_avx2() {
        return match of {
            Floor::MultiplyAdds => Box::new(move || {
                avx2.vectorize(
                    #[inline(always)]
                    || chains_by_four(avx2),
                );
            }),
            Floor::Bytes => Box::new(move || {
                avx2.vectorize(
                    #[inline(always)]
                    || store(&mut numbers),
                );
            }),
        };
    }
    match of {
        Floor::MultiplyAdds => Box::new(chains),
        Floor::Bytes => Box::new(move || store(&mut numbers)),
    }
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

#[inline(always)]
fn store(numbers: &mut [f64; NUMBERS]) {
    numbers.fill(black_box(1.5));
    black_box(numbers);
}
