//! Every second variation is symmetric: Delta-delta does not depend on the order. All entries are computed, none
//! is mirrored: each pair of unit directions is taken in both orders.

use crate::pairs::{Contacting, Movable, any_helix, contacting, hermite, nurbs};
use beamgap::linearization::{COMPONENTS, closed_form};
use beamgap::pair::DofVector;
use proptest::prelude::*;

fn symmetric<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(case: &Contacting<A, B, N, M>) {
    let Contacting { pair, q, point, .. } = case;
    let unit = DofVector::<f64, N, M>::unit;
    let entry = |i: usize, j: usize| {
        closed_form::vary(pair, q, point, &unit(i), &unit(j)).components().map(|component| component.second)
    };
    let all: Vec<Vec<[f64; COMPONENTS]>> =
        (0..N + M).map(|i| (0..N + M).map(|j| entry(i, j)).collect()).collect();
    let ours = pair.linearize(q, point);
    let matrices = [
        (15, &ours.d),
        (16, &ours.t),
        (17, &ours.t_bar),
        (18, &ours.xi),
        (19, &ours.xi_bar),
        (20, &ours.d),
        (21, &ours.g_t),
        (22, &ours.g_t_bar),
    ];
    for c in 0..COMPONENTS {
        let size = all.iter().flatten().fold(0.0_f64, |size, entry| size.max(entry[c].abs()));
        // What cancels to nothing has the rounding of its terms, which are as large as those of the parameters.
        let size = size.max(
            1e-3 * all.iter().flatten().fold(1.0, |size: f64, e| size.max(e[18].abs()).max(e[19].abs())),
        );
        for (i, row) in all.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let (one, other) = (entry[c], all[j][i][c]);
                assert!(
                    (one - other).abs() <= 1e-9 * size,
                    "component {c}, dofs {i}, {j}: {one:e} and {other:e}"
                );
                for (_, matrix) in matrices.iter().filter(|(component, _)| *component == c) {
                    let entry = matrix.hessian.entry(i, j);
                    assert!(
                        (one - entry).abs() <= 1e-9 * size,
                        "component {c}, dofs {i}, {j}: {one:e}, {entry:e}"
                    );
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn of_two_hermites(case in contacting(hermite(), hermite())) { symmetric(&case); }

    #[test]
    fn of_weighted_nurbs_and_helix(case in contacting(nurbs(), any_helix())) { symmetric(&case); }
}
