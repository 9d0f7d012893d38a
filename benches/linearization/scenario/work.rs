//! Makes a scenario from a function on a pair: how it is run, and how it is verified.

use super::error::Rows;
use super::input::{Input, TimedCurve};
use super::truth::Truth;
use super::{Error, Runner, Scenario, Task};
use beamgap::linearization::Derivatives;
use std::hint::black_box;
use std::sync::{Arc, OnceLock};

/// The name of a method, and the method from a pair to `R`.
pub(super) type Method<A, B, R, const N: usize, const M: usize> = (&'static str, fn(&Input<A, B, N, M>) -> R);

/// The exact result for a pair, computed once at the first use.
#[derive(Clone)]
pub(super) struct Judge {
    truth: Arc<dyn Fn() -> Truth + Send + Sync>,
    found: Arc<OnceLock<Truth>>,
}

impl Judge {
    pub(super) fn new(truth: impl Fn() -> Truth + Send + Sync + 'static) -> Self {
        Self { truth: Arc::new(truth), found: Arc::default() }
    }

    pub(super) fn truth(&self) -> &Truth {
        self.found.get_or_init(|| (self.truth)())
    }

    /// Verifies results that consist of the first `rows` rows of the exact result.
    pub(super) fn of_first(&self, rows: usize) -> impl Fn(Rows) -> Error + Send + Sync + 'static {
        let judge = self.clone();
        move |result| Error::of(&result, &judge.truth()[..rows], |_| 0.0)
    }

    /// Verifies values and gradients, without the Hessians of the exact result.
    pub(super) fn of_gradients(&self, quantities: usize) -> impl Fn(Rows) -> Error + Send + Sync + 'static {
        let judge = self.clone();
        move |result| {
            let truth = judge.truth().chunks(3).take(quantities);
            let truth: Vec<_> = truth.flat_map(|of| of[..2].to_vec()).collect();
            Error::of(&result, &truth, |_| 0.0)
        }
    }
}

/// A method on a pair; `rows` arranges its result in rows, and `judge` verifies the rows.
pub(super) fn scenario<A, B, R, const N: usize, const M: usize>(
    (task, method): (Task, &str),
    input: &Input<A, B, N, M>,
    work: impl Fn(&Input<A, B, N, M>) -> R + Send + Sync + Copy + 'static,
    rows: impl Fn(&R) -> Rows + Send + Sync + 'static,
    judge: impl Fn(Rows) -> Error + Send + Sync + 'static,
) -> Scenario
where
    A: TimedCurve<N>,
    B: TimedCurve<M>,
{
    let input = *input;
    let runner = move || -> Runner {
        // The result is passed to the optimizer by reference, because a copy takes time.
        Box::new(move || {
            black_box(&work(black_box(&input)));
        })
    };
    let (family, dofs, method) = (input.family, N + M, method.to_owned());
    let judge = Box::new(move || judge(rows(&work(&input))));
    let runner = Box::new(runner);
    Scenario { task, family, dofs, method, pairs: 1, multiply_adds: None, runner, judge }
}

/// A method on a pair that writes its result to memory of the caller.
pub(super) fn written<A, B, R, const N: usize, const M: usize>(
    (task, method): (Task, &str),
    input: &Input<A, B, N, M>,
    work: impl Fn(&Input<A, B, N, M>, &mut R) + Send + Sync + Copy + 'static,
    memory: fn() -> R,
    rows: impl Fn(&R) -> Rows + Send + Sync + 'static,
    judge: impl Fn(Rows) -> Error + Send + Sync + 'static,
) -> Scenario
where
    A: TimedCurve<N>,
    B: TimedCurve<M>,
    R: 'static,
{
    let input = *input;
    let runner = move || -> Runner {
        let mut to = Box::new(memory());
        Box::new(move || {
            work(black_box(&input), black_box(&mut to));
        })
    };
    let judge = move || {
        let mut to = memory();
        work(&input, &mut to);
        judge(rows(&to))
    };
    let (family, dofs, method) = (input.family, N + M, method.to_owned());
    let (runner, judge) = (Box::new(runner), Box::new(judge));
    Scenario { task, family, dofs, method, pairs: 1, multiply_adds: None, runner, judge }
}

/// Values, gradients and Hessians.
pub(super) fn rows<const N: usize, const M: usize>(all_derivatives: &[&Derivatives<f64, N, M>]) -> Rows {
    let rows = |derivatives: &&Derivatives<f64, N, M>| {
        let Derivatives { value, gradient, hessian } = derivatives;
        let all = || 0..N + M;
        let entries = all().flat_map(|i| all().map(move |j| hessian.entry(i, j))).collect();
        [vec![*value], all().map(|i| gradient.entry(i)).collect(), entries]
    };
    all_derivatives.iter().flat_map(rows).collect()
}
