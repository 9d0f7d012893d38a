//! A bar is dragged along chains of elements.

use super::{Chain, Chains, Link, Owned, Owners};
use crate::closest_point::{ClosestPoint, Held};
use crate::contact::{
    Contribution, Decision, Element, History, Law, Outcome, Parameters, Slips, State, closed_form,
};
use crate::curve::{Hermite, Segment};
use crate::linearization::closed_form::{Points, jets};
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::{SVector, Vector3};

mod ownership;

const RADIUS: f64 = 0.125;

/// A chain of Hermite elements along a curve: the parameters of its nodes, and which elements are reversed.
struct Beam {
    dofs: Vec<SVector<f64, 12>>,
    chain: Chain,
}

impl Beam {
    /// `at` returns point and unit tangent at a length along the curve. |t| at the nodes is `stretch` times half the length
    /// of the element; |t| is constant along a straight element if that is 1.
    fn new(at: impl Fn(f64) -> [Vector3<f64>; 2], nodes: &[f64], reversed: &[bool], stretch: f64) -> Self {
        let mut dofs = Vec::new();
        for (ends, &is_reversed) in nodes.windows(2).zip(reversed) {
            let half = 0.5 * stretch * (ends[1] - ends[0]);
            let [[x, tau], [x_2, tau_2]] = [at(ends[0]), at(ends[1])];
            let all = if is_reversed {
                [x_2, -tau_2 * half, x, -tau * half]
            } else {
                [x, tau * half, x_2, tau_2 * half]
            };
            dofs.push(SVector::from_iterator(all.iter().flat_map(|v| v.iter().copied())));
        }
        let link = |(q, &is_reversed)| Link::new(&Hermite::new(), q, is_reversed);
        let chain = Chain::new(dofs.iter().zip(reversed).map(link).collect()).unwrap();
        Self { dofs, chain }
    }
}

fn line(s: f64) -> [Vector3<f64>; 2] {
    [Vector3::new(s, 0.0, 0.0), Vector3::x()]
}

/// An arc of radius 4 in the plane of x and y.
fn arc(s: f64) -> [Vector3<f64>; 2] {
    let (sin, cos) = (s / 4.0).sin_cos();
    [Vector3::new(4.0 * sin, 4.0 * (1.0 - cos), 0.0), Vector3::new(cos, sin, 0.0)]
}

const NODES: [f64; 5] = [0.0, 1.0, 1.75, 3.0, 4.0];
const REVERSED: [bool; 4] = [false, true, false, true];
const MU: f64 = 0.25;
const EPS_T: f64 = 20.0;

/// Drags a bar that is straight across the beam below it. Returns what each step has, and its element.
fn drag(
    beam: &Beam,
    curve: impl Fn(f64) -> [Vector3<f64>; 2],
    mu: f64,
    steps: impl Iterator<Item = f64>,
) -> Vec<(f64, usize, Outcome)> {
    let contact = Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() };
    let pair = Pair::new(Hermite::new(), Segment::new()).with_contact(contact);
    let parameters = Parameters::with_friction(Law::Linear { eps: 100.0 }, EPS_T, mu);
    let element = Element::new(&pair, &parameters).unwrap();
    let rigid = Chain::new(vec![Link { tangents: [1.0; 3], is_reversed: false }]).unwrap();
    let chains = Chains { beam: &beam.chain, bar: &rigid };
    let mut owned = Vec::<Owned>::new();
    let mut to = Contribution::zeros();
    steps
        .map(|s| {
            let [x, tau] = curve(s);
            let across = Vector3::z().cross(&tau) + tau * 0.3;
            let middle = x - Vector3::z() * (2.0 * RADIUS - 0.01) + across * 0.1;
            let (low, high) = (middle - across, middle + across);
            let bar = SVector::from([low.x, low.y, low.z, high.x, high.y, high.z]);
            let now = chains.minima(&minima_of_elements(&beam.dofs, bar)).unwrap();
            assert_eq!(now.len(), 1, "{s}: {now:?}");
            assert!(now[0].1.is_interior() && chains.own(now[0].0, &now[0].1).unwrap());
            let of = chains.hand_on(&owned, &now, 0.5).unwrap()[0];
            let q = DofVector { beam: beam.dofs[of.owners.beam], bar };
            let outcome = element.evaluate(&q, &now[0].1, &of.history, &mut to).unwrap();
            owned = vec![Owned { history: outcome.next, ..of }];
            (s, of.owners.beam, outcome)
        })
        .collect()
}

/// The minima of all elements of a beam and a straight bar.
fn minima_of_elements(beam: &[SVector<f64, 12>], bar: SVector<f64, 6>) -> Vec<(Owners, ClosestPoint)> {
    let pair = Pair::new(Hermite::new(), Segment::new());
    let of = |(k, &beam): (usize, &SVector<f64, 12>)| {
        let minima = pair.closest_points(&DofVector { beam, bar }).unwrap().minima;
        minima.into_iter().map(move |point| (Owners { beam: k, bar: 0 }, point))
    };
    beam.iter().enumerate().flat_map(of).collect()
}

/// Lengths from 0.25 to 3.75, none at a node.
fn steps(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| 0.25 + 3.5 * (f64::from(i) + 0.01) / f64::from(count))
}

/// The force and the slip along the chain.
fn along(element: usize, outcome: &Outcome) -> [f64; 4] {
    let sign = if REVERSED[element] { -1.0 } else { 1.0 };
    let values = &outcome.values;
    [values.f_n, sign * values.f, sign * values.g_t, sign * values.e]
}

#[test]
fn a_straight_beam_cut_into_elements_has_the_same_forces() {
    let whole = Beam::new(line, &[0.0, 4.0], &[false], 1.0);
    let cut = Beam::new(line, &NODES, &REVERSED, 1.0);
    // Between the nodes, and exactly at each inner node.
    let at_nodes: Vec<f64> = (2..=14).map(|k| 0.25 * f64::from(k)).collect();
    for (mu, state, steps) in [
        (1e4, State::Stick, steps(11).collect::<Vec<_>>()),
        (MU, State::Slip, steps(11).collect()),
        (1e4, State::Stick, at_nodes.clone()),
        (MU, State::Slip, at_nodes.clone()),
    ] {
        let of_whole = drag(&whole, line, mu, steps.iter().copied());
        let of_cut = drag(&cut, line, mu, steps.iter().copied());
        assert_eq!(of_cut.iter().map(|of| of.1).max(), Some(3));
        for ((_, _, of_whole), (_, k, of_cut)) in of_whole.iter().zip(&of_cut) {
            for (whole, cut) in along(0, of_whole).into_iter().zip(along(*k, of_cut)) {
                assert!((whole - cut).abs() <= 1e-13 * whole.abs(), "{whole:e} {cut:e}");
            }
            let difference = of_whole.values.traction - of_cut.values.traction;
            assert!(difference.norm() <= 1e-13 * of_whole.values.traction.norm());
        }
        assert!(of_cut[2..].iter().all(|(.., outcome)| outcome.state == state));
    }
}

/// The largest difference of e and the way of the bar in a drag that sticks.
fn worst_error(beam: &Beam, curve: impl Fn(f64) -> [Vector3<f64>; 2], count: u32) -> f64 {
    let of = drag(beam, curve, 1e6, steps(count));
    assert_eq!(of.windows(2).filter(|of| of[0].1 != of[1].1).count(), 3);
    let errors = of[1..].iter().map(|(s, k, outcome)| {
        assert_eq!(outcome.state, State::Stick);
        let [.., e] = along(*k, outcome);
        (e - (s - of[0].0)).abs()
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn a_drag_over_three_boundaries_sums_up_the_way() {
    // The slip of a step has an error of second order in the step where |t| varies, eq. (15).
    let beam = Beam::new(line, &NODES, &REVERSED, 1.4);
    let errors = [28, 56, 112].map(|count| worst_error(&beam, line, count));
    println!("errors of the elastic slip: {errors:?}");
    assert!(errors[0] < 0.1 && errors[2] < 0.4 * errors[0], "{errors:?}");
    let of_arc = worst_error(&Beam::new(arc, &NODES, &REVERSED, 1.0), arc, 28);
    assert!(of_arc < 1e-3, "{of_arc:e}");
}

#[test]
fn forces_and_slips_are_continuous_at_a_boundary() {
    // The contact point is at a node, in both of its elements, and the history is the same.
    let beam = Beam::new(arc, &NODES, &REVERSED, 1.2);
    let rigid = Chain::new(vec![Link { tangents: [1.0; 3], is_reversed: false }]).unwrap();
    let chains = Chains { beam: &beam.chain, bar: &rigid };
    let contact = Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() };
    let pair = Pair::new(Hermite::new(), Segment::new()).with_contact(contact);
    for (node, mu) in [(1, 1e6), (2, 1e6), (3, 1e6), (1, MU), (2, MU), (3, MU)] {
        let parameters = Parameters::with_friction(Law::Linear { eps: 100.0 }, EPS_T, mu);
        let [x, tau] = arc(NODES[node]);
        let across = Vector3::z().cross(&tau) + tau * 0.3;
        let middle = x - Vector3::z() * (2.0 * RADIUS - 0.01);
        let (low, high) = (middle - across, middle + across);
        let bar = SVector::from([low.x, low.y, low.z, high.x, high.y, high.z]);
        // The last converged step was in the element before the node.
        let last = if REVERSED[node - 1] { -1.0 } else { 1.0 };
        let first = if REVERSED[node] { 1.0 } else { -1.0 };
        let slips = Slips { xi: 0.9 * last, xi_bar: 0.05, e: 0.02 * last, e_bar: 0.03, ..Slips::default() };
        let history = History { normal: Some(Vector3::z()), slips: Some(slips) };
        let owners = Owners { beam: node - 1, bar: 0 };
        let before = Owned { owners, at: (slips.xi, slips.xi_bar), history };
        let found = [(node - 1, last), (node, first)].map(|(k, xi)| {
            let history = chains.carry(&before, Owners { beam: k, bar: 0 }).unwrap();
            let q = DofVector { beam: beam.dofs[k], bar };
            let (jet, jet_bar) = jets(&pair, &q, (xi, 0.0));
            let points = Points::new(&jet.geometry, &jet_bar.geometry);
            let held = Held::default();
            let decision = Decision::new(&parameters, contact, &points, (xi, 0.0), held, &history).unwrap();
            let mut to = Contribution::<f64, 12, 6>::zeros();
            let values = closed_form::write(&decision, (&jet, &jet_bar), (xi, 0.0), &mut to);
            let sign = if REVERSED[k] { -1.0 } else { 1.0 };
            (decision.state, values, [sign * values.f, sign * values.g_t, sign * values.e, values.f_bar])
        });
        let [(state, values, lengths), (state_after, after, lengths_after)] = found;
        assert_eq!(state, if mu > 1.0 { State::Stick } else { State::Slip });
        assert_eq!(state, state_after);
        assert!((values.f_n - after.f_n).abs() < 1e-12 && (values.traction - after.traction).norm() < 1e-12);
        for (length, after) in lengths.into_iter().zip(lengths_after) {
            assert!((length - after).abs() < 1e-12 && length.abs() > 1e-3, "{length} {after}");
        }
    }
}
