//! The computation of the closest point, which all other tasks take as given.

use super::input::{Input, Inputs, TimedCurve};
use super::truth;
use super::work::{Judge, Method, scenario};
use super::{Scenario, Task};

/// The distance from the closest point at which Newton's method starts, like the change in a time step.
const OFF: f64 = 0.05;

/// Every other family.
pub(super) fn others(of: &Inputs) -> Vec<Scenario> {
    let mut all = Vec::new();
    all.extend(of_pair(of.segment));
    all.extend(of_pair(of.quadratic));
    all.extend(of_pair(of.cubic));
    all.extend(of_pair(of.hermite_scaled));
    all.extend(of_pair(of.bezier));
    all.extend(of_pair(of.spline));
    all.extend(of_pair(of.nurbs));
    all.extend(of_pair(of.nurbs_weighted));
    all.extend(of_pair(of.arc));
    all.extend(of_pair(of.helix));
    all
}

/// The search and Newton's method.
pub(super) fn of_pair<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: Input<A, B, N, M>,
) -> [Scenario; 2] {
    let judge = Judge::new(move || truth::closest_point(&input));
    let methods: [Method<A, B, (f64, f64), N, M>; 2] = [
        ("search for all minima", |p| {
            let found = p.pair.closest_points(&p.q).expect("the pairs are regular");
            found.interior().map(|point| (point.xi, point.xi_bar)).expect("they cross inside")
        }),
        ("Newton from 0.05 off", |p| {
            let start = (p.point.xi + OFF, p.point.xi_bar - OFF);
            let found = p.pair.refine(&p.q, start, p.point.held()).expect("it is near");
            (found.xi, found.xi_bar)
        }),
    ];
    methods.map(|(method, work)| {
        scenario(
            (Task::ClosestPoint, method),
            &input,
            work,
            |&(xi, xi_bar)| vec![vec![xi, xi_bar]],
            judge.of_first(1),
        )
    })
}
