//! What is timed, and the verdict on it: every scenario's numbers are compared with another way's before its clock runs.

use crate::differences;
use crate::pairs::{Problem, hermites, quadratics, segments};
use beamgap::closest_point::{Beam, Search, closest_points, refine};
use beamgap::curve::Curve;
use beamgap::linearization::ad::{self, Route, chord, expand_by_sweep, expand_by_vector_dual};
use beamgap::linearization::closed_form::{Matrices, jets, linearize, vary};
use beamgap::linearization::{Expansion, Quantities, Quantity, Varied};
use std::hint::black_box;

/// What rounding explains, relative to the largest entry.
const ROUNDING: f64 = 1e-11;
/// What the truncation and the cancellation of differences explain.
const DIFFERENCES: f64 = 1e-4;

/// One way to do one task.
pub(crate) struct Scenario {
    /// The task and its size.
    pub(crate) group: String,
    /// The way.
    pub(crate) name: &'static str,
    /// Does it once; neither the input nor the result is visible to the optimizer.
    pub(crate) run: Box<dyn Fn()>,
    /// The largest difference from the reference, relative to the largest entry of its kind.
    pub(crate) error: f64,
    /// The most that is accepted.
    pub(crate) tolerance: f64,
}

/// Numbers of one kind stand in one row; errors are relative to the largest of their row.
type Rows = Vec<Vec<f64>>;

/// All scenarios.
pub(crate) fn scenarios() -> Vec<Scenario> {
    let mut all = Vec::new();
    for task in [Task::DOnly, Task::All] {
        all.extend(expansions::<_, _, 6, 6, 12>(task, segments()));
        all.extend(expansions::<_, _, 9, 9, 18>(task, quadratics()));
        all.extend(expansions::<_, _, 12, 12, 24>(task, hermites()));
    }
    all.extend(directions(segments()));
    all.extend(directions(quadratics()));
    all.extend(directions(hermites()));
    all.extend(projections(segments()));
    all.extend(projections(quadratics()));
    all.extend(projections(hermites()));
    all
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Task {
    /// d with gradient and Hessian.
    DOnly,
    /// d, t, t_bar, xi, xi_bar, g_T and g_T_bar with gradients and Hessians.
    All,
}

/// A scenario still to be judged: its numbers stand in for its verdict.
struct Way {
    name: &'static str,
    run: Box<dyn Fn()>,
    rows: Rows,
    tolerance: f64,
}

/// One way to work on a problem, whose results `rows` sorts.
fn way<P: Copy + 'static, R: 'static>(
    name: &'static str,
    problem: &P,
    work: impl Fn(&P) -> R + 'static,
    rows: impl Fn(&R) -> Rows,
) -> Way {
    let problem = *problem;
    let rows = rows(&work(&problem));
    // The result is looked at where it lies: to pass it on would cost a copy of it.
    let run = Box::new(move || {
        black_box(&work(black_box(&problem)));
    });
    Way { name, run, rows, tolerance: ROUNDING }
}

/// Judges the first way, the closed form, by the second, and all others by the first.
fn judged(group: &str, ways: Vec<Way>) -> Vec<Scenario> {
    let errors: Vec<f64> =
        (0..ways.len()).map(|i| error(&ways[i].rows, &ways[usize::from(i == 0)].rows)).collect();
    let scenario = |(way, error): (Way, f64)| {
        let Way { name, run, tolerance, .. } = way;
        assert!(error <= tolerance, "{group}, {name}: off by {error:e} of the largest entry");
        Scenario { group: group.to_owned(), name, run, error, tolerance }
    };
    ways.into_iter().zip(errors).map(scenario).collect()
}

/// The largest difference over all rows, each relative to its row's largest entry.
fn error(rows: &Rows, reference: &Rows) -> f64 {
    assert_eq!(rows.len(), reference.len(), "the same quantities");
    let of_row = |(row, reference): (&Vec<f64>, &Vec<f64>)| {
        let largest = reference.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
        let off = row.iter().zip(reference).map(|(a, b)| (a - b).abs());
        // What is not a number is infinitely off.
        off.map(|off| if off == 0.0 { 0.0 } else { off / largest }).fold(0.0_f64, |a, b| {
            if b <= a {
                a
            } else if b.is_nan() {
                f64::INFINITY
            } else {
                b
            }
        })
    };
    rows.iter().zip(reference).map(of_row).fold(0.0, f64::max)
}

/// Values, gradients and Hessians.
fn expansion_rows<const N: usize, const M: usize>(expansions: &[&Expansion<f64, N, M>]) -> Rows {
    let rows = |expansion: &&Expansion<f64, N, M>| {
        let Expansion { value, gradient, hessian } = expansion;
        let all = || 0..N + M;
        let entries = all().flat_map(|i| all().map(move |j| hessian.entry(i, j))).collect();
        [vec![*value], all().map(|i| gradient.entry(i)).collect(), entries]
    };
    expansions.iter().flat_map(rows).collect()
}

/// The quantities of [`Task::All`].
fn all<S>(of: Quantities<S>) -> [S; 7] {
    [of.d, of.t, of.t_bar, of.xi, of.xi_bar, of.g_t, of.g_t_bar]
}

/// The quantity of [`Task::DOnly`].
fn d_only<S>(of: Quantities<S>) -> [S; 1] {
    [of.d]
}

/// Gradients and Hessians in all `S` dofs.
fn expansions<A, B, const N: usize, const M: usize, const S: usize>(
    task: Task,
    problem: Problem<A, B, N, M>,
) -> Vec<Scenario>
where
    A: Curve<N> + Copy + 'static,
    B: Curve<M> + Copy + 'static,
{
    let p = &problem;
    let newton = "hyper-dual, Newton";
    let stationary = "hyper-dual, stationary";
    let chords = "hyper-dual, chord";
    let vector = "vector dual, chord";
    let central = "central differences";
    let mut ways = if task == Task::DOnly {
        let rows = |e: &[Expansion<f64, N, M>; 1]| expansion_rows(&e.each_ref());
        // One chord step makes the first variation of xi exact, and d needs no more.
        vec![
            way("closed form", p, d_in_closed_form, |d| expansion_rows(&[d])),
            way(chords, p, |p| sweep(Route::Chord(chord_of(p), 1), p, d_only), rows),
            way(newton, p, |p| sweep(Route::Newton, p, d_only), rows),
            way(stationary, p, |p| sweep(Route::Stationary, p, d_only), rows),
            way(
                vector,
                p,
                |p| {
                    expand_by_vector_dual::<_, _, N, M, S, 1>(chord_of(p), 1, &p.pair, &p.q, &p.point, d_only)
                },
                rows,
            ),
            way(central, p, |p| differences::expand(p, d_only), rows),
        ]
    } else {
        let rows = |e: &[Expansion<f64, N, M>; 7]| expansion_rows(&e.each_ref());
        vec![
            way(
                "closed form",
                p,
                |p| linearize(&p.pair, &p.q, &p.point),
                |l| expansion_rows(&[&l.d, &l.t, &l.t_bar, &l.xi, &l.xi_bar, &l.g_t, &l.g_t_bar]),
            ),
            way(chords, p, |p| sweep(Route::Chord(chord_of(p), 2), p, all), rows),
            way(newton, p, |p| sweep(Route::Newton, p, all), rows),
            way(stationary, p, |p| sweep(Route::Stationary, p, all), rows),
            way(
                vector,
                p,
                |p| expand_by_vector_dual::<_, _, N, M, S, 7>(chord_of(p), 2, &p.pair, &p.q, &p.point, all),
                rows,
            ),
            way(central, p, |p| differences::expand(p, all), rows),
        ]
    };
    if let Some(last) = ways.last_mut() {
        last.tolerance = DIFFERENCES;
    }
    let task = if task == Task::DOnly { "d only" } else { "all quantities" };
    judged(&format!("{task}/{S} dofs"), ways)
}

fn d_in_closed_form<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    p: &Problem<A, B, N, M>,
) -> Expansion<f64, N, M> {
    let (jet, jet_bar) = jets(&p.pair, &p.q, (p.point.xi, p.point.xi_bar));
    Matrices::new(&jet, &jet_bar, p.point.active()).d()
}

fn chord_of<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    p: &Problem<A, B, N, M>,
) -> ad::Chord<f64> {
    chord(&p.pair, &p.q, &p.point)
}

fn sweep<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize, const K: usize>(
    route: Route,
    p: &Problem<A, B, N, M>,
    pick: impl Fn(Quantities<num_dual::HyperDual64>) -> [num_dual::HyperDual64; K],
) -> [Expansion<f64, N, M>; K] {
    expand_by_sweep(route, &p.pair, &p.q, &p.point, pick)
}

/// Variations of all quantities, vectors included, in two directions.
fn directions<A, B, const N: usize, const M: usize>(problem: Problem<A, B, N, M>) -> Vec<Scenario>
where
    A: Curve<N> + Copy + 'static,
    B: Curve<M> + Copy + 'static,
{
    let p = &problem;
    let by = |route: fn(&Problem<A, B, N, M>) -> Route| {
        move |p: &Problem<A, B, N, M>| ad::vary(route(p), &p.pair, &p.q, &p.point, &p.dq, &p.linear_dq)
    };
    let ways = vec![
        way("closed form", p, |p| vary(&p.pair, &p.q, &p.point, &p.dq, &p.linear_dq), variation_rows),
        way("hyper-dual, chord", p, by(|p| Route::Chord(chord_of(p), 2)), variation_rows),
        way("hyper-dual, Newton", p, by(|_| Route::Newton), variation_rows),
        way("hyper-dual, stationary", p, by(|_| Route::Stationary), variation_rows),
    ];
    judged(&format!("two directions/{} dofs", N + M), ways)
}

/// The four parts of each quantity.
fn variation_rows(varied: &Quantities<Varied<f64>>) -> Rows {
    let mut rows = vec![Vec::new(); 4 * Quantity::ALL.len()];
    for (i, component) in varied.components().into_iter().enumerate() {
        for (k, part) in component.parts().into_iter().enumerate() {
            rows[4 * (Quantity::of_component(i) as usize) + k].push(part);
        }
    }
    rows
}

/// Where the closest point comes from, which all the rest take as given.
fn projections<A, B, const N: usize, const M: usize>(problem: Problem<A, B, N, M>) -> Vec<Scenario>
where
    A: Curve<N> + Copy + 'static,
    B: Curve<M> + Copy + 'static,
{
    type At = (f64, f64);
    let search = |p: &Problem<A, B, N, M>| -> At {
        let beam = Beam { curve: &p.pair.curve, q: &p.q.beam };
        let bar = Beam { curve: &p.pair.curve_bar, q: &p.q.bar };
        let found = closest_points(&beam, &bar, &Search::default()).expect("the pairs are regular");
        found.interior().map(|point| (point.xi, point.xi_bar)).expect("they cross inside")
    };
    let refinement = |p: &Problem<A, B, N, M>| -> At {
        let beam = Beam { curve: &p.pair.curve, q: &p.q.beam };
        let bar = Beam { curve: &p.pair.curve_bar, q: &p.q.bar };
        let start = (p.point.xi + 0.05, p.point.xi_bar - 0.05);
        refine(&beam, &bar, start, p.point.active())
            .map(|point| (point.xi, point.xi_bar))
            .expect("it is near")
    };
    let rows = |&(xi, xi_bar): &At| vec![vec![xi, xi_bar]];
    let ways = vec![
        way("search", &problem, search, rows),
        way("refinement from 0.05 off", &problem, refinement, rows),
    ];
    judged(&format!("closest point/{} dofs", N + M), ways)
}
