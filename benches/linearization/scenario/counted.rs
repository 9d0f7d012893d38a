//! Operation counts of the closed form for the standard pair.

use super::closed::{IN_FULL, PACKED};
use super::input::{Input, hermites};
use super::many::FOUR_AT_ONCE;
use super::{Scenario, Task};
use beamgap::curve::Hermite;
use beamgap::linearization::Derivatives;
use beamgap::linearization::closed_form::Formulation;
use beamgap::linearization::closed_form::kernel::{DistanceAlone, Full, Packed, Target, WithoutSlips};
use beamgap::number::OperationCount;
use beamgap::pair::{DofVector, Pair};
use beamgap_benchmark::CLOSED_FORM;
use nalgebra::SVector;

/// The scenarios with the multiply-adds of those of the standard family that are counted.
pub(super) fn counted(mut scenarios: Vec<Scenario>) -> Vec<Scenario> {
    for scenario in &mut scenarios {
        scenario.multiply_adds = multiply_adds(scenario.task, &scenario.method);
    }
    scenarios
}

fn multiply_adds(task: Task, method: &str) -> Option<usize> {
    let full = Full::<OperationCount, 24>::zeros();
    let packed = Packed::<OperationCount, 24, 300>::zeros();
    match task {
        Task::Distance if method == CLOSED_FORM => Some(of_d(Derivatives::zero())),
        Task::Distance if method == IN_FULL => Some(of_d(full)),
        Task::Distance if method == PACKED => Some(of_d(packed)),
        Task::DistanceOfMany if method == FOUR_AT_ONCE => Some(of_d(packed)),
        Task::All if method == CLOSED_FORM => Some(of_all(Derivatives::zero())),
        Task::All if method == IN_FULL => Some(of_all(full)),
        Task::All if method == PACKED => Some(of_all(packed)),
        _ => None,
    }
}

fn of_d(mut to: impl Target<OperationCount, 12, 12>) -> usize {
    let Given { pair, q, at, form } = given();
    OperationCount::count(|| assert!(pair.write_over(&q, at, form, DistanceAlone { d: &mut to })))
}

fn of_all(to: impl Target<OperationCount, 12, 12> + Copy) -> usize {
    let Given { pair, q, at, form } = given();
    let mut five = [to; 5];
    let [d, xi, xi_bar, t, t_bar] = &mut five;
    let to = WithoutSlips { d, xi, xi_bar, t, t_bar };
    OperationCount::count(|| assert!(pair.write_over(&q, at, form, to)))
}

struct Given {
    pair: Pair<Hermite, Hermite, 12, 12>,
    q: DofVector<OperationCount, 12, 12>,
    at: (OperationCount, OperationCount),
    form: Formulation,
}

fn given() -> Given {
    let Input { pair, q, point, .. } = hermites();
    let counted = |q: SVector<f64, 12>| q.map(OperationCount::given);
    let q = DofVector { beam: counted(q.beam), bar: counted(q.bar) };
    let at = (OperationCount::given(point.xi), OperationCount::given(point.xi_bar));
    Given { pair, q, at, form: Formulation::paper(point.held()) }
}
