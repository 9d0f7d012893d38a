//! The closed form: blocks, which is the fastest layout, and term by term, which is the most readable.

use super::error::Rows;
use super::input::{Input, TimedCurve};
use super::work::{Judge, rows, scenario, written};
use super::{Scenario, Task};
use beamgap::linearization::Derivatives;
use beamgap::linearization::closed_form::kernel::{DistanceAlone, Full, Gradient, Packed, WithoutSlips};
use beamgap::linearization::closed_form::{Matrices, jets};
use beamgap_benchmark::CLOSED_FORM;

pub(super) const IN_FULL: &str = "closed form, in full";
pub(super) const PACKED: &str = "closed form, packed";
/// For all quantities this is `Pair::linearize`, which uses the kernel. The pages call it so.
const BY_TERMS: &str = "closed form, term by term";

/// All methods of the closed form for a pair of `S` dofs.
pub(super) fn scenarios<
    A: TimedCurve<N>,
    B: TimedCurve<M>,
    const N: usize,
    const M: usize,
    const S: usize,
>(
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> [Scenario; 6] {
    let gradients = |of: &[Gradient<f64, S>]| -> Rows {
        of.iter().flat_map(|of| [vec![of.value], of.gradient.to_vec()]).collect()
    };
    [
        distance(Task::Distance, input, judge),
        distance_by_terms(input, judge),
        all(Task::All, input, judge),
        scenario(
            (Task::WithSlips, BY_TERMS),
            input,
            |p| p.pair.linearize(&p.q, &p.point),
            |of| rows(&[&of.d, &of.xi, &of.xi_bar, &of.t, &of.t_bar, &of.g_t, &of.g_t_bar]),
            judge.of_first(21),
        ),
        written(
            (Task::GradientOfDistance, CLOSED_FORM),
            input,
            |p, to| p.pair.write(&p.q, &p.point, DistanceAlone { d: to }),
            Gradient::<f64, S>::zeros,
            move |of| gradients(std::slice::from_ref(of)),
            judge.of_gradients(1),
        ),
        written(
            (Task::Gradients, CLOSED_FORM),
            input,
            |p, [d, xi, xi_bar, t, t_bar]: &mut [Gradient<f64, S>; 5]| {
                p.pair.write(&p.q, &p.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
            },
            || [Gradient::zeros(); 5],
            move |of| gradients(of),
            judge.of_gradients(5),
        ),
    ]
}

/// d with its gradient and Hessian.
pub(super) fn distance<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    task: Task,
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> Scenario {
    let work = |p: &Input<A, B, N, M>, to: &mut Derivatives<f64, N, M>| {
        p.pair.write(&p.q, &p.point, DistanceAlone { d: to });
    };
    written((task, CLOSED_FORM), input, work, Derivatives::zero, |of| rows(&[of]), judge.of_first(3))
}

/// All quantities except the slips.
pub(super) fn all<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    task: Task,
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> Scenario {
    let work = |p: &Input<A, B, N, M>, to: &mut [Derivatives<f64, N, M>; 5]| {
        let [d, xi, xi_bar, t, t_bar] = to;
        p.pair.write(&p.q, &p.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
    };
    let memory = || [Derivatives::zero(); 5];
    written((task, CLOSED_FORM), input, work, memory, |of| rows(&of.each_ref()), judge.of_first(15))
}

/// d term by term, written to memory like the other methods: a large result that is returned is set to zero and copied.
fn distance_by_terms<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> Scenario {
    let work = |p: &Input<A, B, N, M>, to: &mut Derivatives<f64, N, M>| {
        let (jet, jet_bar) = jets(&p.pair, &p.q, (p.point.xi, p.point.xi_bar));
        Matrices::new(&jet, &jet_bar, p.point.held()).write_d(to);
    };
    written((Task::Distance, BY_TERMS), input, work, Derivatives::zero, |of| rows(&[of]), judge.of_first(3))
}

/// The layouts other than blocks: `S` dofs, `H` entries of the lower triangle.
pub(super) fn layouts<
    A: TimedCurve<N>,
    B: TimedCurve<M>,
    const N: usize,
    const M: usize,
    const S: usize,
    const H: usize,
>(
    input: &Input<A, B, N, M>,
    judge: &Judge,
) -> [Scenario; 4] {
    let full = |of: &[Full<f64, S>]| -> Rows {
        let rows =
            |of: &Full<f64, S>| [vec![of.value], of.gradient.to_vec(), of.hessian.as_flattened().to_vec()];
        of.iter().flat_map(rows).collect()
    };
    let packed = |of: &[Packed<f64, S, H>]| -> Rows {
        let rows = |of: &Packed<f64, S, H>| {
            let entries = (0..S).flat_map(|i| (0..S).map(move |j| of.entry(i, j))).collect();
            [vec![of.value], of.gradient.to_vec(), entries]
        };
        of.iter().flat_map(rows).collect()
    };
    [
        written(
            (Task::Distance, IN_FULL),
            input,
            |p, to| p.pair.write(&p.q, &p.point, DistanceAlone { d: to }),
            Full::<f64, S>::zeros,
            move |of| full(std::slice::from_ref(of)),
            judge.of_first(3),
        ),
        written(
            (Task::Distance, PACKED),
            input,
            |p, to| p.pair.write(&p.q, &p.point, DistanceAlone { d: to }),
            Packed::<f64, S, H>::zeros,
            move |of| packed(std::slice::from_ref(of)),
            judge.of_first(3),
        ),
        written(
            (Task::All, IN_FULL),
            input,
            |p, [d, xi, xi_bar, t, t_bar]: &mut [Full<f64, S>; 5]| {
                p.pair.write(&p.q, &p.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
            },
            || [Full::zeros(); 5],
            move |of| full(of),
            judge.of_first(15),
        ),
        written(
            (Task::All, PACKED),
            input,
            |p, [d, xi, xi_bar, t, t_bar]: &mut [Packed<f64, S, H>; 5]| {
                p.pair.write(&p.q, &p.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
            },
            || [Packed::zeros(); 5],
            move |of| packed(of),
            judge.of_first(15),
        ),
    ]
}
