//! The closed form equals automatic differentiation, by every route and in every layer.

use crate::pairs::{
    Contacting, Movable, any_arc, any_helix, contacting, hermite, nurbs, quadratic, relative_difference,
    segment,
};
use beamgap::check::{Case, Trial, Verdict, compare};
use beamgap::linearization::ad::{self, Route};
use beamgap::linearization::closed_form::{self, Matrices, VectorQuantity};
use beamgap::linearization::{Expansion, Quantities};
use nalgebra::Vector3;
use proptest::prelude::*;

/// The pairs are conditioned to 0.1 at worst; second variations go with the third power, and with that of the ratio of
/// the lengths in a pair, which reaches 50. The gate's own tolerance, entry by entry, is tested at the end.
const TOLERANCE: f64 = 1e-8;

/// Value, both first and the second variation of every component, by all three hyper-dual routes.
fn variations_agree<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    case: &Contacting<A, B, N, M>,
) {
    let Contacting { pair, q, point, dq, linear_dq } = case;
    let closed = closed_form::vary(pair, q, point, dq, linear_dq).components();
    for route in [Route::Newton, Route::Stationary, Route::Chord(ad::chord(pair, q, point), 2)] {
        let other = ad::vary(route, pair, q, point, dq, linear_dq).components();
        for part in 0..4 {
            // Vectors by their size, scalars one by one.
            for range in (0..15).step_by(3).map(|i| i..i + 3).chain((15..23).map(|i| i..i + 1)) {
                let of = |row: &[_]| -> Vec<f64> {
                    row[range.clone()]
                        .iter()
                        .map(|v: &beamgap::linearization::Varied<f64>| v.parts()[part])
                        .collect()
                };
                let (ours, theirs) = (of(&closed), of(&other));
                let size = closed[18].parts()[part].abs().max(closed[19].parts()[part].abs()).max(1.0);
                let error = ours.iter().zip(&theirs).fold(0.0_f64, |worst, (x, y)| worst.max((x - y).abs()));
                let scale = theirs.iter().fold(size, |scale, x| scale.max(x.abs()));
                assert!(
                    error <= TOLERANCE * scale,
                    "{route:?} part {part} of {range:?}: {ours:?} {theirs:?}"
                );
            }
        }
    }
}

fn flat<const N: usize, const M: usize>(expansion: &Expansion<f64, N, M>) -> [Vec<f64>; 2] {
    let entries = |i: usize| (0..N + M).map(move |j| (i, j));
    [
        (0..N + M).map(|i| expansion.gradient.entry(i)).collect(),
        (0..N + M).flat_map(entries).map(|(i, j)| expansion.hessian.entry(i, j)).collect(),
    ]
}

fn assert_same<const N: usize, const M: usize>(
    name: &str,
    ours: &Expansion<f64, N, M>,
    theirs: &Expansion<f64, N, M>,
    terms: f64,
) {
    let value = (ours.value - theirs.value).abs();
    assert!(value <= TOLERANCE * (1.0 + theirs.value.abs()), "{name}: value off by {value:e}");
    let ([gradient, hessian], [ours_gradient, ours_hessian]) = (flat(theirs), flat(ours));
    let error = relative_difference(&ours_gradient, &gradient);
    assert!(error <= TOLERANCE, "gradient of {name} off by {error:e}");
    let largest = |row: &[f64]| row.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let scale = largest(&hessian).max(terms);
    for (x, y) in ours_hessian.iter().zip(&hessian) {
        assert!((x - y).abs() <= TOLERANCE * scale, "Hessian of {name}: {x:e}, not {y:e}, of {scale:e}");
    }
}

fn scalars<S>(q: Quantities<S>) -> [S; 7]
where
    S: nalgebra::Scalar,
{
    [q.d, q.t, q.t_bar, q.xi, q.xi_bar, q.g_t, q.g_t_bar]
}

/// Gradients and Hessians of all scalars and of the components of all vectors, entry by entry.
fn matrices_agree<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    case: &Contacting<A, B, N, M>,
) {
    let Contacting { pair, q, point, .. } = case;
    let ours = pair.linearize(q, point);
    let [by_sweep] = ad::expand_by_sweep(Route::Newton, pair, q, point, |q| [q.g_n]);
    let size = flat(&ours.d)[0].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    assert_same("g_N", &ours.g_n(), &by_sweep, size * size / ours.d.value);
    let ours = [&ours.d, &ours.t, &ours.t_bar, &ours.xi, &ours.xi_bar, &ours.g_t, &ours.g_t_bar];
    let names = ["d", "t", "t_bar", "xi", "xi_bar", "g_T", "g_T_bar"];
    let chord = ad::chord(pair, q, point);
    let (jet, jet_bar) = closed_form::jets(pair, q, (point.xi, point.xi_bar));
    let by_vector = ad::expand_by_vector_dual::<_, _, N, M, S, 7>(chord, 2, pair, q, point, scalars);
    let by_sweep = ad::expand_by_sweep(Route::Newton, pair, q, point, scalars);
    // Rows of eight are longer than what is left of some rows, and with rows of five no length is a multiple.
    let by_orders = ad::expand_by_orders::<_, _, N, M, 8, 7>(pair, q, point, scalars);
    let by_rows = ad::expand_by_rows::<_, _, N, M, 5, 7>(chord, 2, pair, q, point, scalars);
    for (i, name) in names.into_iter().enumerate() {
        // A parameter that is held has no variation, and nothing to be compared relative to.
        if (point.active().xi && name == "xi") || (point.active().xi_bar && name == "xi_bar") {
            assert!(flat(ours[i]).iter().flatten().all(|entry| *entry == 0.0));
            continue;
        }
        // The Hessian of a norm v has terms of the size |grad v|^2 / v, and so has that of a slip, in t; that of a tangent's
        // length has t,xi H_xi. The sum of them may vanish, as it does for an arc.
        let norm = ours[[0, 1, 2, 3, 4, 1, 2][i]];
        let size = flat(norm)[0].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let largest = |e: &Expansion<f64, N, M>| flat(e)[1].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let turning = match name {
            "t" | "g_T" => jet.geometry.t_xi.norm() * largest(ours[3]),
            "t_bar" | "g_T_bar" => jet_bar.geometry.t_xi.norm() * largest(ours[4]),
            _ => 0.0,
        };
        let terms = if name.starts_with("xi") { 0.0 } else { size * size / norm.value + turning };
        assert_same(name, ours[i], &by_vector[i], terms);
        assert_same(name, ours[i], &by_sweep[i], terms);
        assert_same(name, ours[i], &by_orders[i], terms);
        assert_same(name, ours[i], &by_rows[i], terms);
    }
    let terms = size * size / ours[0].value;
    assert_same("d", ours[0], &ad::expand_d_by_orders::<_, _, N, M, 8>(pair, q, point), terms);

    let matrices = Matrices::new(&jet, &jet_bar, point.active());
    let all = matrices.all((point.xi, point.xi_bar), &pair.contact);
    let by_vector = ad::expand_by_vector_dual::<_, _, N, M, S, 15>(chord, 2, pair, q, point, |q| {
        std::array::from_fn(|i| q.components()[i])
    });
    let vectors =
        [VectorQuantity::X, VectorQuantity::XBar, VectorQuantity::D, VectorQuantity::T, VectorQuantity::TBar];
    for (i, theirs) in by_vector.iter().enumerate() {
        let axis = Vector3::from_fn(|c, _| if c == i % 3 { 1.0 } else { 0.0 });
        let ours = matrices.vector(vectors[i / 3], &axis, [&all.xi, &all.xi_bar]);
        // A component that hardly varies is judged by the vector it is part of.
        let size = |e: &Expansion<f64, N, M>| flat(e)[1].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let whole = by_vector[i / 3 * 3..i / 3 * 3 + 3].iter().map(size).fold(0.0_f64, f64::max);
        for (x, y) in flat(&ours)[1].iter().zip(&flat(theirs)[1]) {
            assert!((x - y).abs() <= TOLERANCE * whole, "{:?} {x:e} {y:e} of {whole:e}", vectors[i / 3]);
        }
        let error = relative_difference(&flat(&ours)[0], &flat(theirs)[0]);
        assert!(error <= TOLERANCE, "gradient of {:?} off by {error:e}", vectors[i / 3]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn variations_of_two_segments(case in contacting(segment(), segment())) { variations_agree(&case); }

    #[test]
    fn variations_of_two_hermites(case in contacting(hermite(), hermite())) { variations_agree(&case); }

    #[test]
    fn variations_of_weighted_nurbs_and_helix(case in contacting(nurbs(), any_helix())) { variations_agree(&case); }

    #[test]
    fn variations_of_arc_and_quadratic(case in contacting(any_arc(), quadratic())) { variations_agree(&case); }

    #[test]
    fn matrices_of_two_segments(case in contacting(segment(), segment())) {
        matrices_agree::<_, _, 6, 6, 12>(&case);
    }

    #[test]
    fn matrices_of_two_hermites(case in contacting(hermite(), hermite())) {
        matrices_agree::<_, _, 12, 12, 24>(&case);
    }

    #[test]
    fn matrices_of_quadratic_and_helix(case in contacting(quadratic(), any_helix())) {
        matrices_agree::<_, _, 9, 10, 19>(&case);
    }

    #[test]
    fn matrices_of_weighted_nurbs_and_arc(case in contacting(nurbs(), any_arc())) {
        matrices_agree::<_, _, 12, 9, 21>(&case);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Within the derived tolerance, whatever the seed, the regime and the pair of families.
    #[test]
    fn every_case_that_the_gate_can_draw(seed: u64, number in 0..100_000_u64) {
        let case = Case::draw(seed, number);
        for (point, verdict) in compare(&Trial::default(), &case) {
            prop_assert!(!matches!(verdict, Verdict::Mismatch(_)), "{case:?} {point:?} {verdict:?}");
        }
    }
}
