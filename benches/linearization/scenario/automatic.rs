//! Automatic differentiation, by every route and with rows of every width.

use super::input::{Input, TimedCurve};
use super::work::{Judge, Method, rows, scenario};
use super::{Scenario, Task};
use beamgap::linearization::ad::{
    Chord, Route, chord, expand_by_orders, expand_by_rows, expand_by_sweep, expand_by_vector_dual,
    expand_d_by_orders,
};
use beamgap::linearization::{Derivatives, Quantities};

/// The number of dofs in a row: four vectors of the default target.
const ROW: usize = 8;

/// The quantity of [`Task::Distance`].
pub(super) fn d<S>(of: Quantities<S>) -> [S; 1] {
    [of.d]
}

/// The quantities of [`Task::All`].
pub(super) fn all<S>(of: Quantities<S>) -> [S; 5] {
    [of.d, of.xi, of.xi_bar, of.t, of.t_bar]
}

/// Every method except [`at_once`].
pub(super) fn scenarios<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> Vec<Scenario> {
    // One chord step makes the first variation of xi exact, which is sufficient for d.
    let of_d: [Method<A, B, [Derivatives<f64, N, M>; 1], N, M>; 5] = [
        ("rows of hyper-duals, by orders", |p| {
            [expand_d_by_orders::<_, _, N, M, ROW>(&p.pair, &p.q, &p.point)]
        }),
        ("rows of hyper-duals, chord", |p| {
            expand_by_rows::<_, _, N, M, ROW, 1>(chord_of(p), 1, &p.pair, &p.q, &p.point, d)
        }),
        ("hyper-dual, chord", |p| expand_by_sweep(Route::Chord(chord_of(p), 1), &p.pair, &p.q, &p.point, d)),
        ("hyper-dual, Newton", |p| expand_by_sweep(Route::Newton, &p.pair, &p.q, &p.point, d)),
        ("hyper-dual, stationary", |p| expand_by_sweep(Route::Stationary, &p.pair, &p.q, &p.point, d)),
    ];
    let of_all: [Method<A, B, [Derivatives<f64, N, M>; 5], N, M>; 5] = [
        ("rows of hyper-duals, by orders", |p| {
            expand_by_orders::<_, _, N, M, ROW, 5>(&p.pair, &p.q, &p.point, all)
        }),
        ("rows of hyper-duals, chord", |p| {
            expand_by_rows::<_, _, N, M, ROW, 5>(chord_of(p), 2, &p.pair, &p.q, &p.point, all)
        }),
        ("hyper-dual, chord", |p| {
            expand_by_sweep(Route::Chord(chord_of(p), 2), &p.pair, &p.q, &p.point, all)
        }),
        ("hyper-dual, Newton", |p| expand_by_sweep(Route::Newton, &p.pair, &p.q, &p.point, all)),
        ("hyper-dual, stationary", |p| expand_by_sweep(Route::Stationary, &p.pair, &p.q, &p.point, all)),
    ];
    let mut scenarios = Vec::new();
    scenarios.extend(of_d.map(|(method, work)| {
        scenario((Task::Distance, method), input, work, |of| rows(&of.each_ref()), judge.of_first(3))
    }));
    scenarios.extend(of_all.map(|(method, work)| {
        scenario((Task::All, method), input, work, |of| rows(&of.each_ref()), judge.of_first(15))
    }));
    scenarios
}

/// Numbers with all `S` dofs at once. They take the longest to compile, so they are used for one family only.
pub(super) fn at_once<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize, const S: usize>(
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> [Scenario; 2] {
    let method = "vector dual, chord";
    [
        scenario(
            (Task::Distance, method),
            input,
            |p| expand_by_vector_dual::<_, _, N, M, S, 1>(chord_of(p), 1, &p.pair, &p.q, &p.point, d),
            |of| rows(&of.each_ref()),
            judge.of_first(3),
        ),
        scenario(
            (Task::All, method),
            input,
            |p| expand_by_vector_dual::<_, _, N, M, S, 5>(chord_of(p), 2, &p.pair, &p.q, &p.point, all),
            |of| rows(&of.each_ref()),
            judge.of_first(15),
        ),
    ]
}

fn chord_of<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    p: &Input<A, B, N, M>,
) -> Chord<f64> {
    chord(&p.pair, &p.q, &p.point)
}
