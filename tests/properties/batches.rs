//! Four pairs in the lanes of a vector give the same results as four single pairs.

#![expect(clippy::large_stack_arrays, reason = "five quantities of 24 dofs")]

use crate::kernel::{brought_near, tolerances, without_slips};
use crate::pairs::{Contacting, Movable, contacting, hermite};
use crate::strategies::vector;
use beamgap::closest_point::Held;
use beamgap::curve::{Bezier, Hermite, Segment};
use beamgap::linearization::closed_form::Formulation;
use beamgap::linearization::closed_form::kernel::{
    DistanceAlone, Gradient, Packed, PairAtPoint, write_d_batch,
};
use beamgap::number::Lanes;
use beamgap::pair::{DofVector, Pair};
use nalgebra::SVector;
use proptest::prelude::*;

/// Each of at most eight pairs gives the same result in its lane as alone.
fn equal_in_lanes(cases: &[Contacting<Hermite, Hermite, 12, 12>]) {
    let pairs_at_points: Vec<_> =
        cases.iter().map(|Contacting { pair, q, point, .. }| PairAtPoint { pair, q, point }).collect();
    let mut d = [Packed::<Lanes, 24, 300>::zeros(); 2];
    assert_eq!(write_d_batch(&pairs_at_points, &mut d), cases.len());
    assert_eq!(write_d_batch(&pairs_at_points, &mut d[..1]), cases.len().min(4));
    for (i, case) in cases.iter().enumerate() {
        let Contacting { pair, q, point, .. } = case;
        let mut one = Packed::<f64, 24, 300>::zeros();
        pair.write(q, point, DistanceAlone { d: &mut one });
        near(&alone(&one), &lane(&d[i / 4], i % 4), &tolerances::<_, _, 12, 12, 24>(case)[0], 24);
    }
}

/// The packed numbers agree within the tolerances; the tolerances are those of a full matrix.
fn near(one: &[f64], in_lane: &[f64], tolerances: &[f64], dofs: usize) {
    let (of_value, of_hessian) = tolerances.split_at(1 + dofs);
    let of_half = of_hessian.chunks(dofs).enumerate().flat_map(|(i, row)| &row[..=i]);
    for ((one, in_lane), tolerance) in one.iter().zip(in_lane).zip(of_value.iter().chain(of_half)) {
        assert!((in_lane - one).abs() <= *tolerance, "{in_lane:e}, {one:e}, {tolerance:e}");
    }
}

/// Value, gradient and Hessian of one of four pairs.
fn lane(of_four: &Packed<Lanes, 24, 300>, lane: usize) -> Vec<f64> {
    let Packed { hessian, gradient, value } = of_four;
    [value].into_iter().chain(gradient).chain(hessian).map(|x| x.0[lane]).collect()
}

/// Value, gradient and Hessian of a single pair.
fn alone(Packed { hessian, gradient, value }: &Packed<f64, 24, 300>) -> Vec<f64> {
    [value].into_iter().chain(gradient).chain(hessian).copied().collect()
}

/// Beams whose tangents are those of the curve, or half of them.
fn scaled() -> impl Strategy<Value = (Hermite, SVector<f64, 12>)> {
    (prop_oneof![Just(Hermite::new()), Just(Hermite::scaled_by(4.0))], vector())
}

impl Movable<18> for Bezier<6> {
    const POINTS: &'static [usize] = &[0, 3, 6, 9, 12, 15];
}

/// A beam of six control vectors, bent by these dofs, above a beam of two control vectors.
fn long_and_short(bent: &SVector<f64, 18>) -> Contacting<Bezier<6>, Segment, 18, 6> {
    let pair = Pair::new(Bezier::new(), Segment::new());
    let straight = [-1.0, -0.6, -0.2, 0.2, 0.6, 1.0];
    let beam = SVector::from_fn(|i, _| if i % 3 == 0 { straight[i / 3] } else { 0.0 } + 0.03 * bent[i]);
    let q = DofVector { beam, bar: SVector::from([0.1, -1.0, -1.0, -0.1, 1.0, -1.1]) };
    let point = pair.refine(&q, (0.0, 0.0), Held::default()).unwrap();
    Contacting { pair, q, point, dq: DofVector::zeros(), linear_dq: DofVector::zeros() }
}

proptest! {
    /// The lane arithmetic of a machine without vector instructions; it uses the source code of every scalar.
    #[test]
    fn numbers_in_lanes(cases in proptest::array::uniform4(contacting(hermite(), hermite()))) {
        let form = Formulation::paper(Held::default());
        let in_lanes = |of: fn(&Contacting<Hermite, Hermite, 12, 12>, usize) -> f64, i: usize| {
            Lanes(cases.each_ref().map(|case| of(case, i)))
        };
        let q = DofVector {
            beam: SVector::from_fn(|i, _| in_lanes(|case, i| case.q.beam[i], i)),
            bar: SVector::from_fn(|i, _| in_lanes(|case, i| case.q.bar[i], i)),
        };
        let at = (in_lanes(|case, _| case.point.xi, 0), in_lanes(|case, _| case.point.xi_bar, 0));
        let mut four = [Packed::<Lanes, 24, 300>::zeros(); 5];
        prop_assert!(cases[0].pair.write_over(&q, at, form, without_slips(&mut four)));
        for (i, Contacting { pair, q, point, .. }) in cases.iter().enumerate() {
            let mut one = [Packed::<f64, 24, 300>::zeros(); 5];
            prop_assert!(pair.write_over(q, (point.xi, point.xi_bar), form, without_slips(&mut one)));
            for (four, one) in four.iter().zip(&one) {
                let bits = |numbers: Vec<f64>| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>();
                prop_assert_eq!(bits(lane(four, i)), bits(alone(one)));
            }
        }
    }

    /// The lanes support any number of control vectors.
    #[test]
    fn batches_of_long_and_short_curves(bent in proptest::array::uniform4(vector::<18>())) {
        let cases = bent.each_ref().map(long_and_short);
        let pairs_at_points = cases.each_ref().map(|Contacting { pair, q, point, .. }| PairAtPoint { pair, q, point });
        let mut four = [Packed::<Lanes, 24, 300>::zeros()];
        write_d_batch(&pairs_at_points, &mut four);
        for (i, case) in cases.iter().enumerate() {
            let Contacting { pair, q, point, .. } = case;
            let mut one = Packed::<f64, 24, 300>::zeros();
            pair.write(q, point, DistanceAlone { d: &mut one });
            near(&alone(&one), &lane(&four[0], i), &tolerances::<_, _, 18, 6, 24>(case)[0], 24);
        }
    }

    /// Each lane equals its pair, also in an incomplete batch and at an end. Pairs beyond the memory are skipped.
    #[test]
    fn batches(cases in proptest::collection::vec(contacting(hermite(), hermite()), 1..=6)) {
        equal_in_lanes(&cases);
    }

    /// Pairs of different curves, which cannot share the lanes.
    #[test]
    fn batches_of_different_curves(cases in proptest::collection::vec(contacting(scaled(), scaled()), 2..=6)) {
        equal_in_lanes(&cases);
    }

    /// Each pair gives the result of a batch of four, for any length of the memory.
    #[test]
    fn batches_of_any_length(
        cases in proptest::collection::vec(contacting(hermite(), hermite()), 5),
        count in 1..=40_usize,
        memory in 1..=12_usize,
    ) {
        let pairs_at_points: Vec<_> = cases
            .iter()
            .map(|Contacting { pair, q, point, .. }| PairAtPoint { pair, q, point })
            .cycle()
            .take(count)
            .collect();
        let mut d = vec![Gradient::<Lanes, 24>::zeros(); memory];
        let mut d_of_four = d.clone();
        let written = count.min(4 * memory);
        prop_assert_eq!(write_d_batch(&pairs_at_points, &mut d), written);
        for (i, four) in pairs_at_points[..written].chunks(4).enumerate() {
            write_d_batch(four, &mut d_of_four[i..=i]);
        }
        prop_assert!(d == d_of_four);
    }

    /// The same is true of pairs that need another formulation than the paper's, or different formulations.
    #[test]
    fn batches_of_near_pairs(
        cases in proptest::collection::vec(contacting(hermite(), hermite()), 4),
        angles in proptest::array::uniform4((-12.0..0.5_f64).prop_map(f64::exp2)),
        gaps in proptest::array::uniform4(0.0..20.0_f64),
        alike in any::<bool>(),
    ) {
        let near = |i: usize| if alike { (1.0, f64::exp2(-6.0 - 0.5 * gaps[i])) } else { (angles[i], f64::exp2(-gaps[i])) };
        let cases: Vec<_> = cases.iter().enumerate().map(|(i, case)| brought_near(case, near(i).0, near(i).1)).collect();
        // Without a known closest point there are no tolerances.
        prop_assume!(cases.iter().all(|case| !tolerances::<_, _, 12, 12, 24>(case)[0].iter().any(|of| of.is_nan())));
        equal_in_lanes(&cases);
    }
}
