//! Variations of one pair along two directions.

use super::input::{Input, Inputs, TimedCurve};
use super::truth::{self, by_quantity};
use super::work::{Judge, Method, scenario};
use super::{Scenario, Task};
use beamgap::linearization::ad::{self, Route, chord};
use beamgap::linearization::closed_form::vary;
use beamgap::linearization::{Quantities, Varied};
use beamgap_benchmark::CLOSED_FORM;

/// The same families as for the matrices.
pub(super) fn others(of: &Inputs) -> Vec<Scenario> {
    let mut all = Vec::new();
    all.extend(of_pair(of.segment));
    all.extend(of_pair(of.quadratic));
    all.extend(of_pair(of.spline));
    all.extend(of_pair(of.nurbs));
    all.extend(of_pair(of.helix));
    all
}

/// The scenarios by every route.
pub(super) fn of_pair<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: Input<A, B, N, M>,
) -> [Scenario; 4] {
    let judge = Judge::new(move || truth::directions(&input));
    let methods: [Method<A, B, Quantities<Varied<f64>>, N, M>; 4] = [
        (CLOSED_FORM, |p| vary(&p.pair, &p.q, &p.point, &p.dq, &p.linear_dq)),
        ("hyper-dual, chord", |p| by(Route::Chord(chord(&p.pair, &p.q, &p.point), 2), p)),
        ("hyper-dual, Newton", |p| by(Route::Newton, p)),
        ("hyper-dual, stationary", |p| by(Route::Stationary, p)),
    ];
    let rows = |of: &Quantities<Varied<f64>>| by_quantity(of.components());
    methods.map(|(method, work)| scenario((Task::Directions, method), &input, work, rows, judge.of_first(52)))
}

fn by<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    route: Route,
    p: &Input<A, B, N, M>,
) -> Quantities<Varied<f64>> {
    ad::vary(route, &p.pair, &p.q, &p.point, &p.dq, &p.linear_dq)
}
