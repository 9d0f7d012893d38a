//! Four pairs in the lanes of a vector are four pairs one by one.

#![expect(clippy::large_stack_arrays, reason = "five quantities of 24 dofs")]

use crate::blocks::{brought_near, targets};
use crate::pairs::{Contacting, contacting, hermite};
use beamgap::curve::Hermite;
use beamgap::linearization::closed_form::blocks::{
    Encounter, Packed, write_all, write_all_batch, write_d_batch,
};
use beamgap::number::Lanes;
use proptest::prelude::*;
use std::num::NonZeroUsize;

/// Each of at most eight pairs is the same in its lane as alone, on any number of threads.
fn equal_in_lanes(cases: &[Contacting<Hermite, Hermite, 12, 12>], rounding: f64) {
    let encounters: Vec<_> =
        cases.iter().map(|Contacting { pair, q, point, .. }| Encounter { pair, q, point }).collect();
    let threads = |count| NonZeroUsize::new(count).unwrap();
    let zeros = Packed::<Lanes, 24, 300>::zeros();
    let (mut d, mut all, mut shared) = ([zeros; 2], [[zeros; 5]; 2], [[zeros; 5]; 2]);
    assert_eq!(write_d_batch(&encounters, &mut d, threads(1)), cases.len());
    assert_eq!(write_all_batch(&encounters, &mut all, threads(1)), cases.len());
    assert_eq!(write_all_batch(&encounters, &mut shared, threads(3)), cases.len());
    assert!(all == shared, "threads make no difference");
    assert_eq!(write_d_batch(&encounters, &mut d[..1], threads(1)), cases.len().min(4));
    for (i, Contacting { pair, q, point, .. }) in cases.iter().enumerate() {
        let mut one_by_one = [Packed::<f64, 24, 300>::zeros(); 5];
        write_all(pair, q, point, &mut targets(&mut one_by_one));
        let in_lanes = all[i / 4].iter().chain([&d[i / 4]]).map(|of_four| lane(of_four, i % 4));
        for (one, in_lane) in one_by_one.iter().chain([&one_by_one[0]]).map(alone).zip(in_lanes) {
            let largest = one.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            for (one, in_lane) in one.iter().zip(&in_lane) {
                assert!((in_lane - one).abs() <= rounding * largest, "{in_lane:e}, {one:e} of {largest:e}");
            }
        }
    }
}

/// Value, gradient and Hessian of one of four pairs.
fn lane(of_four: &Packed<Lanes, 24, 300>, lane: usize) -> Vec<f64> {
    let Packed { hessian, gradient, value } = of_four;
    [value].into_iter().chain(gradient).chain(hessian).map(|x| x.0[lane]).collect()
}

/// The same of one pair.
fn alone(Packed { hessian, gradient, value }: &Packed<f64, 24, 300>) -> Vec<f64> {
    [value].into_iter().chain(gradient).chain(hessian).copied().collect()
}

proptest! {
    /// Each lane is its pair, the last four and those at an end of a beam among them; whatever is too long is left.
    #[test]
    fn batches(cases in proptest::collection::vec(contacting(hermite(), hermite()), 1..=6)) {
        equal_in_lanes(&cases, 1e-12);
    }

    /// So it is where pairs ask for another form than the paper's, or for several.
    #[test]
    fn batches_of_near_pairs(
        cases in proptest::collection::vec(contacting(hermite(), hermite()), 4),
        angles in proptest::array::uniform4(1e-2..1.5_f64),
        gaps in proptest::array::uniform4(0.0..20.0_f64),
        alike in any::<bool>(),
    ) {
        let near = |i: usize| if alike { (1.0, f64::exp2(-6.0 - 0.5 * gaps[i])) } else { (angles[i], f64::exp2(-gaps[i])) };
        let cases: Vec<_> = cases.iter().enumerate().map(|(i, case)| brought_near(case, near(i).0, near(i).1)).collect();
        equal_in_lanes(&cases, 1e-10);
    }
}
