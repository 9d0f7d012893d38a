//! Residual and tangent of a contact element with friction, for the standard pair: in closed form, and by automatic
//! differentiation of the virtual work.

use super::error::{Exact, Rows};
use super::input::Twins;
use super::truth::{Truth, parameters as parameters_of};
use super::work::{Judge, rows, written};
use super::{Scenario, Task};
use beamgap::contact::{
    Contribution, Decision, Element, History, Law, Parameters, Slips, State, ad, closed_form,
};
use beamgap::curve::{Curve, Hermite};
use beamgap::linearization::Derivatives;
use beamgap::linearization::closed_form::kernel::WithSlips;
use beamgap::number::{DoubleDouble, Real, RunningError};
use beamgap::pair::{Contact, DofVector};
use beamgap_benchmark::CLOSED_FORM;

/// The dofs of a beam.
const N: usize = 12;
type Input = Twins<Hermite, N>;
type Memory<T> = Contribution<T, N, N>;

/// A contact element in one state.
#[derive(Clone, Copy)]
struct Situation {
    state: State,
    parameters: Parameters<Law>,
    history: History,
}

/// All methods in both states, and the quantities of the geometry for comparison.
pub(super) fn scenarios(input: &Input, geometry: &Judge) -> Vec<Scenario> {
    let input = in_contact(input);
    let mut all = vec![written(
        (Task::ContactElement, "geometry alone, by the kernel"),
        &input,
        |p, [d, xi, xi_bar, t, t_bar, g_t, g_t_bar]: &mut [Derivatives<f64, N, N>; 7]| {
            p.pair.write(&p.q, &p.point, WithSlips { d, xi, xi_bar, t, t_bar, g_t, g_t_bar });
        },
        || [Derivatives::zero(); 7],
        |of| rows(&of.each_ref()),
        geometry.of_first(21),
    )];
    for (state, closed, by_ad) in [
        (State::Slip, CLOSED_FORM, "hyper-dual, chord"),
        (State::Stick, "closed form, stick", "hyper-dual, chord, stick"),
        (State::Frictionless, "closed form, frictionless", "hyper-dual, chord, frictionless"),
    ] {
        let situation = situation(&input, state);
        let judge = Judge::new(move || truth(&input, &situation));
        all.push(written(
            (Task::ContactElement, closed),
            &input,
            move |p, to: &mut Memory<f64>| in_closed_form(p, &situation, to),
            Memory::<f64>::zeros,
            entries,
            judge.of_first(2),
        ));
        all.push(written(
            (Task::ContactElement, by_ad),
            &input,
            move |p, to: &mut Memory<f64>| {
                let at = (p.point.xi, p.point.xi_bar);
                (to.residual, to.tangent) =
                    ad::residual_and_tangent(&decision(p, &situation), &p.pair, &p.q, at);
            },
            Memory::<f64>::zeros,
            entries,
            judge.of_first(2),
        ));
    }
    all
}

/// The pair with radii that overlap.
fn in_contact(input: &Input) -> Input {
    let Input { pair, q, point, .. } = input;
    let radius = 0.625 * pair.linearize(q, point).d.value;
    Input { pair: pair.with_contact(Contact { radius, radius_bar: radius, ..pair.contact }), ..*input }
}

/// The element in a state, after a step in which both contact points have moved.
fn situation(input: &Input, state: State) -> Situation {
    let Input { point, .. } = input;
    let mu = if state == State::Slip { 1e-3 } else { 1e3 };
    let slips = Slips {
        xi: point.xi - 0.05,
        xi_bar: point.xi_bar + 0.03,
        e: 0.02,
        e_bar: 0.01,
        cosine: 0.0,
        held: point.held(),
        is_slipping: false,
    };
    let history = History { normal: None, slips: (state != State::Frictionless).then_some(slips) };
    let parameters = Parameters::with_friction(Law::Linear { eps: 100.0 }, 80.0, mu);
    let situation = Situation { state, parameters, history };
    assert_eq!(decision(input, &situation).state, state);
    situation
}

fn decision<'a>(input: &'a Input, situation: &'a Situation) -> Decision<'a, Law> {
    let element = Element::new(&input.pair, &situation.parameters).expect(VALID);
    element.decide(&input.q, &input.point, &situation.history).expect(VALID)
}

fn in_closed_form(input: &Input, situation: &Situation, to: &mut Memory<f64>) {
    let element = Element::new(&input.pair, &situation.parameters).expect(VALID);
    let outcome = element.evaluate(&input.q, &input.point, &situation.history, to).expect(VALID);
    debug_assert_eq!(outcome.state, situation.state);
}

const VALID: &str = "the element is valid";

/// Residual and tangent, each a row.
fn entries(of: &Memory<f64>) -> Rows {
    let [residual, tangent] = read(&of.residual, |i, j| of.tangent.entry(i, j));
    vec![residual, tangent]
}

fn read<T: Real>(residual: &DofVector<T, N, N>, entry: impl Fn(usize, usize) -> T) -> [Vec<T>; 2] {
    let all = || 0..2 * N;
    [
        all().map(|i| residual.entry(i)).collect(),
        all().flat_map(|i| all().map(move |j| (i, j))).map(|(i, j)| entry(i, j)).collect(),
    ]
}

/// Residual and tangent in double-double, with the bounds on the rounding of both methods.
fn truth(input: &Input, situation: &Situation) -> Truth {
    let [(xi, near), (xi_bar, near_bar)] = parameters_of(input);
    let decision = decision(input, situation);
    let precise = closed(input, &decision, (xi, xi_bar), DoubleDouble::from);
    let bounded = closed(input, &decision, (near, near_bar), RunningError::from);
    let q =
        DofVector { beam: input.q.beam.map(RunningError::from), bar: input.q.bar.map(RunningError::from) };
    let (residual, tangent) = ad::residual_and_tangent(&decision, &input.pair, &q, (near, near_bar));
    let by_ad = read(&residual, |i, j| tangent.entry(i, j));
    let exact = |((value, one), other): ((DoubleDouble, RunningError), RunningError)| Exact {
        value,
        tolerance: one.bound + other.bound,
    };
    let rows = precise.into_iter().zip(bounded).zip(by_ad);
    rows.map(|((precise, bounded), by_ad)| precise.into_iter().zip(bounded).zip(by_ad).map(exact).collect())
        .collect()
}

/// The closed form in another scalar.
fn closed<T: Real>(
    input: &Input,
    decision: &Decision<'_, Law>,
    at: (T, T),
    of: impl Fn(f64) -> T,
) -> [Vec<T>; 2] {
    let Input { pair, q, .. } = input;
    let jet = pair.curve.jet(&q.beam.map(&of), at.0);
    let jet_bar = pair.curve_bar.jet(&q.bar.map(&of), at.1);
    let mut to = Memory::<T>::zeros();
    closed_form::write(decision, (&jet, &jet_bar), at, &mut to);
    read(&to.residual, |i, j| to.tangent.entry(i, j))
}
