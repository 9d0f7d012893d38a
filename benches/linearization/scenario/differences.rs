//! The methods without second derivatives: central differences, with the closest point solved for again each time.

use super::error::{Exact, Rows};
use super::input::{Input, TimedCurve};
use super::work::{Judge, rows, scenario};
use super::{Error, Scenario, Task, automatic};
use beamgap::closest_point::ClosestPoint;
use beamgap::linearization::ad::{Perturbed, evaluate};
use beamgap::linearization::closed_form::kernel::{DistanceAlone, Gradient, WithoutSlips};
use beamgap::linearization::{Derivatives, Quantities};
use beamgap::pair::DofVector;

/// The step for differences of values: the fourth root of epsilon, nearly optimal for lengths near 1.
const OF_VALUES: f64 = 1.0 / 8192.0;
/// The step for differences of gradients: the third root of epsilon.
const OF_GRADIENTS: f64 = 1.0 / 131_072.0;

/// The dofs after the steps, and the closest point there.
fn moved<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
    moves: &[(usize, f64)],
) -> (DofVector<f64, N, M>, ClosestPoint) {
    let Input { pair, q, point, .. } = input;
    let mut q = *q;
    for &(i, step) in moves {
        q.set(i, q.entry(i) + step);
    }
    let point = pair.refine(&q, (point.xi, point.xi_bar), point.held()).expect("a small move");
    (q, point)
}

/// Gradients and Hessians of the quantities that `pick` selects, by differences of values over `width` steps.
fn of_values<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize, const K: usize>(
    input: &Input<A, B, N, M>,
    pick: impl Fn(Quantities<f64>) -> [f64; K],
    width: f64,
) -> [Derivatives<f64, N, M>; K] {
    let h = width * OF_VALUES;
    let at = |moves: &[(usize, f64)]| {
        let (q, found) = moved(input, moves);
        let beam = Perturbed { curve: &input.pair.curve, q: q.beam };
        let bar = Perturbed { curve: &input.pair.curve_bar, q: q.bar };
        pick(evaluate(&beam, &bar, (found.xi, found.xi_bar), &input.pair.contact))
    };
    let centre = at(&[]);
    let mut all_derivatives = centre.map(|value| Derivatives { value, ..Derivatives::zero() });
    for j in 0..N + M {
        let (plus, minus) = (at(&[(j, h)]), at(&[(j, -h)]));
        for (k, derivatives) in all_derivatives.iter_mut().enumerate() {
            derivatives.gradient.set(j, (plus[k] - minus[k]) / (2.0 * h));
            derivatives.hessian.set(j, j, (plus[k] - 2.0 * centre[k] + minus[k]) / (h * h));
        }
        for i in 0..j {
            let [pp, pm, mp, mm] =
                [(h, h), (h, -h), (-h, h), (-h, -h)].map(|(one, other)| at(&[(i, one), (j, other)]));
            for (k, derivatives) in all_derivatives.iter_mut().enumerate() {
                derivatives.hessian.set(i, j, (pp[k] - pm[k] - mp[k] + mm[k]) / (4.0 * h * h));
            }
        }
    }
    all_derivatives
}

/// Values and gradients from `gradients` in closed form, and Hessians by differences of them over `width` steps.
fn of_gradients<
    A: TimedCurve<N>,
    B: TimedCurve<M>,
    const N: usize,
    const M: usize,
    const S: usize,
    const K: usize,
>(
    input: &Input<A, B, N, M>,
    gradients: impl Fn(&Input<A, B, N, M>) -> [Gradient<f64, S>; K],
    width: f64,
) -> [Derivatives<f64, N, M>; K] {
    let h = width * OF_GRADIENTS;
    let at = |moves: &[(usize, f64)]| {
        let (q, point) = moved(input, moves);
        gradients(&Input { q, point, ..*input })
    };
    let mut all_derivatives = at(&[]).map(|centre| {
        let mut derivatives = Derivatives { value: centre.value, ..Derivatives::zero() };
        centre.gradient.into_iter().enumerate().for_each(|(i, slope)| derivatives.gradient.set(i, slope));
        derivatives
    });
    for j in 0..N + M {
        let (plus, minus) = (at(&[(j, h)]), at(&[(j, -h)]));
        for (k, derivatives) in all_derivatives.iter_mut().enumerate() {
            for i in 0..=j {
                let slope = (plus[k].gradient[i] - minus[k].gradient[i]) / (2.0 * h);
                derivatives.hessian.set(i, j, slope);
            }
        }
    }
    all_derivatives
}

/// The kind of numbers that are differenced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Differenced {
    Values,
    Gradients,
}

pub(super) fn scenarios<
    A: TimedCurve<N>,
    B: TimedCurve<M>,
    const N: usize,
    const M: usize,
    const S: usize,
>(
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> [Scenario; 4] {
    use Differenced::{Gradients, Values};
    [
        by(Task::Distance, Gradients, input, judge, |p, width| {
            of_gradients(p, gradient_of_d::<_, _, N, M, S>, width)
        }),
        by(Task::Distance, Values, input, judge, |p, width| of_values(p, automatic::d, width)),
        by(Task::All, Gradients, input, judge, |p, width| {
            of_gradients(p, gradients_of_all::<_, _, N, M, S>, width)
        }),
        by(Task::All, Values, input, judge, |p, width| of_values(p, automatic::all, width)),
    ]
}

fn gradient_of_d<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize, const S: usize>(
    p: &Input<A, B, N, M>,
) -> [Gradient<f64, S>; 1] {
    let mut to = [Gradient::zeros()];
    p.pair.write(&p.q, &p.point, DistanceAlone { d: &mut to[0] });
    to
}

fn gradients_of_all<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize, const S: usize>(
    p: &Input<A, B, N, M>,
) -> [Gradient<f64, S>; 5] {
    let mut to = [Gradient::zeros(); 5];
    let [d, xi, xi_bar, t, t_bar] = &mut to;
    p.pair.write(&p.q, &p.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
    to
}

/// The scenario of `work` by differences. The second argument of `work` is the factor on the width of the steps.
fn by<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize, const K: usize>(
    task: Task,
    differenced: Differenced,
    input: &Input<A, B, N, M>,
    judge: &Judge,
    work: fn(&Input<A, B, N, M>, f64) -> [Derivatives<f64, N, M>; K],
) -> Scenario {
    let method = match differenced {
        Differenced::Values => "differences of values",
        Differenced::Gradients => "differences of gradients",
    };
    let rows = |of: &[Derivatives<f64, N, M>; K]| rows(&of.each_ref());
    let (moved, judge) = (*input, judge.clone());
    let error =
        move |fine: Rows| error(&fine, &rows(&work(&moved, 2.0)), &judge.truth()[..3 * K], differenced);
    scenario((task, method), input, move |p| work(p, 1.0), rows, error)
}

/// The error of differences. The allowance is the change if the steps are doubled, which is three times the truncation,
/// and the rounding error of the differenced numbers divided by the steps.
fn error(fine: &Rows, coarse: &Rows, truth: &[Vec<Exact>], differenced: Differenced) -> Error {
    let rounding = |row: usize| truth[row].iter().fold(0.0_f64, |most, exact| most.max(exact.tolerance));
    let allowance = |row: usize| {
        let changes = fine[row].iter().zip(&coarse[row]).map(|(a, b)| (a - b).abs());
        // The rows are values, gradients and Hessians in turn.
        let divided = match (differenced, row % 3) {
            (Differenced::Values, 1) => rounding(row - 1) / OF_VALUES,
            (Differenced::Values, 2) => 4.0 * rounding(row - 2) / (OF_VALUES * OF_VALUES),
            (Differenced::Gradients, 2) => rounding(row - 1) / OF_GRADIENTS,
            _ => 0.0,
        };
        changes.fold(0.0, f64::max) + divided
    };
    Error::of(fine, truth, allowance)
}
