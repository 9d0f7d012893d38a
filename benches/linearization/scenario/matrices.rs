//! Gradients and Hessians of one pair, in closed form, by automatic differentiation and by differences.

use super::input::{self, Input, Inputs, TimedCurve, Twins};
use super::work::Judge;
use super::{Scenario, Task, automatic, closed, differences, element, truth};
use beamgap::curve::Hermite;

/// The standard pair, with the methods that are compiled for one pair only.
pub(super) fn standard(input: &Twins<Hermite, 12>) -> Vec<Scenario> {
    let owned = *input;
    let judge = Judge::new(move || truth::all_derivatives(&owned));
    let mut scenarios = Vec::from(closed::scenarios::<_, _, 12, 12, 24>(input, &judge));
    scenarios.extend(closed::layouts::<_, _, 12, 12, 24, 300>(input, &judge));
    scenarios.extend(automatic::scenarios(input, &judge));
    scenarios.extend(automatic::at_once::<_, _, 12, 12, 24>(input, &judge));
    scenarios.extend(differences::scenarios::<_, _, 12, 12, 24>(input, &judge));
    scenarios.extend(element::scenarios(input, &judge));
    scenarios
}

/// Straight and curved families, rational ones, and families with dofs that enter nonlinearly.
pub(super) fn others(of: &Inputs) -> Vec<Scenario> {
    let mut all = Vec::new();
    all.extend(near());
    all.extend(of_pair::<_, _, 6, 6, 12>(of.segment));
    all.extend(of_pair::<_, _, 9, 9, 18>(of.quadratic));
    all.extend(of_pair::<_, _, 12, 12, 24>(of.spline));
    all.extend(of_pair::<_, _, 9, 9, 18>(of.nurbs));
    all.extend(of_pair::<_, _, 10, 10, 20>(of.helix));
    all
}

/// The closed form at a small gap.
fn near() -> [Scenario; 2] {
    let input = input::near();
    let judge = Judge::new(move || truth::all_derivatives(&input));
    [closed::distance(Task::Distance, &input, &judge), closed::all(Task::All, &input, &judge)]
}

/// The first scenario of each task is the closed form.
fn of_pair<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize, const S: usize>(
    input: Input<A, B, N, M>,
) -> Vec<Scenario> {
    let judge = Judge::new(move || truth::all_derivatives(&input));
    let mut scenarios = Vec::from(closed::scenarios::<_, _, N, M, S>(&input, &judge));
    scenarios.extend(automatic::scenarios(&input, &judge));
    scenarios.extend(differences::scenarios::<_, _, N, M, S>(&input, &judge));
    scenarios
}
