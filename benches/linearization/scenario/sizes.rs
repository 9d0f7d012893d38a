//! The closed form for curves with increasing numbers of dofs, 12 to 96 for a pair.

use super::input::{Input, TimedCurve, Twins};
use super::work::Judge;
use super::{Scenario, Task, closed, truth};
use beamgap::curve::{BSpline, Curve, Lagrange};

/// Lagrange curves and B-splines of increasing degree.
pub(super) fn scenarios() -> Vec<Scenario> {
    let mut all = Vec::new();
    all.extend(of_pair(lagrange::<2, 6>()));
    all.extend(of_pair(lagrange::<4, 12>()));
    all.extend(of_pair(lagrange::<8, 24>()));
    all.extend(of_pair(lagrange::<12, 36>()));
    all.extend(of_pair(lagrange::<16, 48>()));
    all.extend(of_pair(spline::<4, 12>()));
    all.extend(of_pair(spline::<8, 24>()));
    all.extend(of_pair(spline::<16, 48>()));
    all
}

#[expect(clippy::cast_precision_loss, reason = "a handful of nodes")]
fn lagrange<const P: usize, const N: usize>() -> Twins<Lagrange<P>, N>
where
    Lagrange<P>: Curve<N>,
{
    let nodes: [f64; P] = std::array::from_fn(|i| 2.0 * i as f64 / (P - 1) as f64 - 1.0);
    Input::of_nodes("lagrange", Lagrange::new(), &nodes)
}

/// Spans of length 2, like the range of xi, and control points at the averages of their knots.
#[expect(clippy::cast_precision_loss, reason = "a handful of knots")]
fn spline<const P: usize, const N: usize>() -> Twins<BSpline<P>, N>
where
    BSpline<P>: Curve<N>,
{
    let knots: Vec<f64> = (0..2 * (P - 1)).map(|i| 2.0 * i as f64).collect();
    let nodes: [f64; P] = std::array::from_fn(|i| 2.0 * i as f64 - (P - 1) as f64);
    Input::of_nodes("bspline", BSpline::new(&knots).expect("the knots rise"), &nodes)
}

fn of_pair<C: TimedCurve<N>, const N: usize>(input: Twins<C, N>) -> [Scenario; 2] {
    let judge = Judge::new(move || truth::all_derivatives(&input));
    [closed::distance(Task::DistanceBySize, &input, &judge), closed::all(Task::AllBySize, &input, &judge)]
}
