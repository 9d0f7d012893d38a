//! The closed form, in every layout of its kernel, and every method of automatic differentiation, tested by the
//! check for linearizations of users: in every regime, within tolerances derived from rounding.

use crate::kernel::without_slips;
use beamgap::check::{self, Answer, Case, CheckConfig, Family, Situation, Verdict, compare};
use beamgap::closest_point::ClosestPoint;
use beamgap::curve::{Arc, Curve, Helix, Hermite, NurbsWeighted, Quadratic, Segment};
use beamgap::linearization::ad::{self, Route};
use beamgap::linearization::closed_form::kernel::{
    Full, Gradient, Packed, PairAtPoint, Target, write_d_batch,
};
use beamgap::linearization::closed_form::{self, Matrices, VectorQuantity};
use beamgap::linearization::{Derivatives, Quantities, Quantity, Varied};
use beamgap::number::Lanes;
use beamgap::pair::{DofVector, Pair};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

/// Value, gradient and Hessian of one component.
fn of_expansion<const N: usize, const M: usize>(
    component: usize,
    numbers: &Derivatives<f64, N, M>,
) -> Answer {
    let (mut gradient, mut hessian) = (vec![0.0; N + M], vec![0.0; (N + M) * (N + M)]);
    numbers.gradient.write_to(&mut gradient).unwrap();
    numbers.hessian.write_dense(&mut hessian).unwrap();
    Answer {
        axis: Quantity::axis_of_component(component),
        value: Some(numbers.value),
        gradient: Some(gradient),
        hessian: Some(hessian),
        ..Answer::of(Quantity::of_component(component))
    }
}

/// The variations of all components.
fn of_variations(all: &Quantities<Varied<f64>>) -> Vec<Answer> {
    let of = |(component, varied): (usize, Varied<f64>)| Answer {
        axis: Quantity::axis_of_component(component),
        value: Some(varied.value),
        variations: [varied.delta, varied.linear, varied.second].map(Some),
        ..Answer::of(Quantity::of_component(component))
    };
    all.components().into_iter().enumerate().map(of).collect()
}

/// A pair at a closest point, with two directions.
struct At<A, B, const N: usize, const M: usize> {
    pair: Pair<A, B, N, M>,
    q: DofVector<f64, N, M>,
    point: ClosestPoint,
    dq: DofVector<f64, N, M>,
    linear_dq: DofVector<f64, N, M>,
}

/// The vectors in the order of their components.
const VECTORS: [VectorQuantity; 5] =
    [VectorQuantity::X, VectorQuantity::XBar, VectorQuantity::D, VectorQuantity::T, VectorQuantity::TBar];

/// The scalars that are differentiated, in the order of their components.
fn scalars<S: nalgebra::Scalar>(q: Quantities<S>) -> [S; 8] {
    [q.d, q.t, q.t_bar, q.xi, q.xi_bar, q.g_n, q.g_t, q.g_t_bar]
}

fn of_scalars<const N: usize, const M: usize>(all: [Derivatives<f64, N, M>; 8]) -> Vec<Answer> {
    all.iter().enumerate().map(|(i, numbers)| of_expansion(15 + i, numbers)).collect()
}

type Method<A, B, const N: usize, const M: usize> = (&'static str, fn(&At<A, B, N, M>) -> Vec<Answer>);

/// All methods that are compared, by name.
fn methods<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize, const S: usize>()
-> [Method<A, B, N, M>; 10] {
    [
        ("equations", |at| {
            of_variations(&closed_form::vary(&at.pair, &at.q, &at.point, &at.dq, &at.linear_dq))
        }),
        ("matrices of scalars", |at| {
            let all = at.pair.linearize(&at.q, &at.point);
            let g_n = all.g_n();
            of_scalars([all.d, all.t, all.t_bar, all.xi, all.xi_bar, g_n, all.g_t, all.g_t_bar])
        }),
        ("matrices of vectors", |at| {
            let parameters = (at.point.xi, at.point.xi_bar);
            let (jet, jet_bar) = closed_form::jets(&at.pair, &at.q, parameters);
            let matrices = Matrices::new(&jet, &jet_bar, at.point.held());
            let all = matrices.all(parameters, &at.pair.contact);
            let of = |component: usize| {
                let axis = Vector3::from_fn(|c, _| if c == component % 3 { 1.0 } else { 0.0 });
                let vector = VECTORS[component / 3];
                of_expansion(component, &matrices.vector(vector, &axis, [&all.xi, &all.xi_bar]))
            };
            (0..15).map(of).collect()
        }),
        ("hyper-dual, Newton", |at| by_route(Route::Newton, at)),
        ("hyper-dual, stationary", |at| by_route(Route::Stationary, at)),
        ("hyper-dual, chord", |at| by_route(Route::Chord(ad::chord(&at.pair, &at.q, &at.point), 2), at)),
        ("second-order dual", |at| {
            let chord = ad::chord(&at.pair, &at.q, &at.point);
            let (pair, q, point) = (&at.pair, &at.q, &at.point);
            of_scalars(ad::expand_by_vector_dual::<_, _, N, M, S, 8>(chord, 2, pair, q, point, scalars))
        }),
        ("sweep", |at| {
            let chord = ad::chord(&at.pair, &at.q, &at.point);
            of_scalars(ad::expand_by_sweep(Route::Chord(chord, 2), &at.pair, &at.q, &at.point, scalars))
        }),
        // Rows of eight dofs are longer than the rest of some rows. With rows of five dofs no length is a multiple.
        ("orders", |at| {
            let mut all =
                of_scalars(ad::expand_by_orders::<_, _, N, M, 8, 8>(&at.pair, &at.q, &at.point, scalars));
            let d = ad::expand_d_by_orders::<_, _, N, M, 8>(&at.pair, &at.q, &at.point);
            all.push(of_expansion(15, &d));
            all
        }),
        ("rows", |at| {
            let chord = ad::chord(&at.pair, &at.q, &at.point);
            of_scalars(ad::expand_by_rows::<_, _, N, M, 5, 8>(chord, 2, &at.pair, &at.q, &at.point, scalars))
        }),
    ]
}

fn by_route<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    route: Route,
    at: &At<A, B, N, M>,
) -> Vec<Answer> {
    of_variations(&ad::vary(route, &at.pair, &at.q, &at.point, &at.dq, &at.linear_dq))
}

/// Value, gradient and Hessian of the scalars except the slips, as the kernel writes them in one layout.
fn of_kernel<A: Curve<N>, B: Curve<M>, W: Target<f64, N, M> + Copy, const N: usize, const M: usize>(
    at: &At<A, B, N, M>,
    zeros: W,
    hessian: impl Fn(&W, usize, usize) -> f64,
) -> Vec<Answer> {
    let mut all = [zeros; 5];
    at.pair.write(&at.q, &at.point, without_slips(&mut all));
    let quantities = [Quantity::D, Quantity::Xi, Quantity::XiBar, Quantity::T, Quantity::TBar];
    let of = |(quantity, memory): (Quantity, &mut W)| {
        let places = || (0..N + M).flat_map(|i| (0..N + M).map(move |j| (i, j)));
        let hessian = W::SECOND.then(|| places().map(|(i, j)| hessian(memory, i, j)).collect());
        let (beam, bar) = memory.gradient();
        let gradient = Some([&*beam, &*bar].concat());
        Answer { value: Some(*memory.value()), gradient, hessian, ..Answer::of(quantity) }
    };
    quantities.into_iter().zip(&mut all).map(of).collect()
}

/// The layouts of the kernel besides blocks, which `linearize` returns.
fn layouts<A: Curve<9>, B: Curve<12>>() -> [Method<A, B, 9, 12>; 3] {
    [
        ("kernel, full", |at| of_kernel(at, Full::<f64, 21>::zeros(), |full, i, j| full.hessian[i][j])),
        ("kernel, packed", |at| of_kernel(at, Packed::<f64, 21, 231>::zeros(), Packed::entry)),
        ("kernel, gradient", |at| of_kernel(at, Gradient::<f64, 21>::zeros(), |_, _, _| f64::NAN)),
    ]
}

/// d in the last of four lanes. The other lanes have another beam.
fn in_lanes(at: &At<Hermite, Hermite, 12, 12>) -> Vec<Answer> {
    let At { pair, point, q, .. } = at;
    let other = DofVector { beam: q.beam * 1.5, bar: q.bar };
    let of = |q| PairAtPoint { pair, q, point };
    let mut four = [Packed::<Lanes, 24, 300>::zeros()];
    write_d_batch(&[of(&other), of(q), of(&other), of(q)], &mut four);
    let [four] = four;
    let lane = |lanes: Lanes| lanes.0[3];
    let hessian = (0..24 * 24).map(|i| lane(four.entry(i / 24, i % 24))).collect();
    let gradient = Some(four.gradient.map(lane).to_vec());
    vec![Answer {
        value: Some(lane(four.value)),
        gradient,
        hessian: Some(hessian),
        ..Answer::of(Quantity::D)
    }]
}

/// All methods agree, for a pair of families whose curves are built from their parameters.
fn agree<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    methods: impl IntoIterator<Item = Method<A, B, N, M>>,
    families: [Family; 2],
    curves: impl Fn([&[f64]; 2]) -> (A, B) + Sync,
) {
    for (name, method) in methods {
        let answers = |at: &Situation<'_>| {
            let (curve, curve_bar) = curves(at.parameters);
            let along = |dq: &[f64]| DofVector::from_slice(dq).unwrap();
            method(&At {
                pair: Pair { curve, curve_bar, contact: at.contact },
                q: DofVector {
                    beam: SVector::from_column_slice(at.q),
                    bar: SVector::from_column_slice(at.q_bar),
                },
                point: at.point,
                dq: along(at.dq),
                linear_dq: along(at.linear_dq),
            })
        };
        // 23 numbers, each with a Hessian over 25 dofs, need a large stack.
        let pool = rayon::ThreadPoolBuilder::new().stack_size(16 << 20).build().unwrap();
        let found = pool.install(|| check::linearization(&answers, families, 4));
        assert!(found.agrees(), "{name}\n{found}");
    }
}

#[test]
fn two_segments() {
    agree(methods::<_, _, 6, 6, 12>(), [Family::Segment; 2], |_| (Segment::new(), Segment::new()));
}

#[test]
fn two_hermites() {
    let lanes: Method<_, _, 12, 12> = ("kernel in lanes, d alone", in_lanes);
    let methods = methods::<_, _, 12, 12, 24>().into_iter().chain([lanes]);
    agree(methods, [Family::Hermite; 2], |_| (Hermite::new(), Hermite::new()));
}

#[test]
fn quadratic_and_hermite_in_every_layout() {
    let families = [Family::Quadratic, Family::Hermite];
    agree(layouts(), families, |_| (Quadratic::new(), Hermite::new()));
}

#[test]
fn quadratic_and_helix() {
    let curves = |of: [&[f64]; 2]| (Quadratic::new(), Helix::new(of[1][0]));
    agree(methods::<_, _, 9, 10, 19>(), [Family::Quadratic, Family::Helix], curves);
}

#[test]
fn weighted_nurbs_and_arc() {
    let curves = |of: [&[f64]; 2]| (NurbsWeighted::<4>::new(of[0]).unwrap(), Arc::new(of[1][0]));
    agree(methods::<_, _, 16, 9, 25>(), [Family::NurbsWeighted, Family::Arc], curves);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Agreement within the derived tolerance, for any seed, regime and pair of families.
    #[test]
    fn every_case_that_the_gate_can_draw(seed: u64, number in 0..100_000_u64) {
        let case = Case::draw(seed, number);
        for (point, verdict) in compare(&CheckConfig::default(), &case) {
            prop_assert!(!matches!(verdict, Verdict::Mismatch(_)), "{case:?} {point:?} {verdict:?}");
        }
    }
}
