//! Every second variation is symmetric: Delta-delta does not depend on the order of the directions. The block of each
//! beam is computed in full. The mixed block is stored once, so the check evaluates it in both orders.

use crate::bounded::{is_near, linearized_case, scalars};
use crate::pairs::{Contacting, Movable, any_helix, contacting, hermite, nurbs};
use beamgap::check::{Case, CheckConfig, Order, compare};
use beamgap::linearization::COMPONENTS;
use proptest::prelude::*;

fn symmetric<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(case: &Contacting<A, B, N, M>) {
    for (scalar, numbers) in scalars(&linearized_case(case)).into_iter().enumerate() {
        for (i, j) in (0..N + M).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let (one, other) = (numbers.hessian.entry(i, j), numbers.hessian.entry(j, i));
            assert!(is_near(one, other), "scalar {scalar}, dofs {i}, {j}: {one:?} and {other:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn of_two_hermites(case in contacting(hermite(), hermite())) { symmetric(&case); }

    #[test]
    fn of_weighted_nurbs_and_helix(case in contacting(nurbs(), any_helix())) { symmetric(&case); }

    /// The same for components of vectors, within the tolerances of the check.
    #[test]
    fn of_every_component(seed: u64, number in 0..100_000_u64) {
        for (point, verdict) in compare(&CheckConfig::default(), &Case::draw(seed, number)) {
            let entries: Vec<_> =
                verdict.entries().iter().filter(|entry| entry.order == Order::Symmetry).collect();
            prop_assert!(point.is_none() || entries.is_empty() || entries.len() == COMPONENTS);
            prop_assert!(entries.iter().all(|entry| entry.agrees()), "{entries:?}");
        }
    }
}
