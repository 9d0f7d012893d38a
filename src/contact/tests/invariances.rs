//! Equilibrium, rigid motions, exchange of the beams, units, and the isotropy of friction.

use super::beams::{Case, HELD, LAWS, RADIUS, STATES, Wish, numbers};
use crate::closest_point::Held;
use crate::contact::{BlockMatrix, Contribution, Element, History, Law, Parameters, Slips, State, Work};
use crate::curve::{Hermite, Segment};
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::{Rotation3, SVector, Vector3};
use proptest::prelude::*;

type Hermites = Case<Hermite, Hermite, f64, 12, 12>;
type Dofs = DofVector<f64, 12, 12>;

fn wishes() -> impl Strategy<Value = (Wish, u32)> {
    let wish = |(held, state, law, paper, crossed): (usize, usize, usize, bool, bool)| {
        let mut wish = Wish::new(HELD[held], STATES[state], LAWS[law]);
        wish.parameters.work = if paper { Work::Paper } else { Work::Rate };
        wish.distance *= if crossed { -0.25 } else { 1.0 };
        wish
    };
    let choices = (0..4_usize, 1..4_usize, 0..3_usize, any::<bool>(), any::<bool>());
    (choices.prop_map(wish), any::<u32>())
}

/// Applies a linear map to every 3-vector of the dofs.
fn turned(q: &Dofs, map: impl Fn(Vector3<f64>) -> Vector3<f64>) -> Dofs {
    let beam = |q: &SVector<f64, 12>| {
        let mut to = SVector::<f64, 12>::zeros();
        for a in 0..4 {
            to.fixed_rows_mut::<3>(3 * a).copy_from(&map(q.fixed_rows::<3>(3 * a).into_owned()));
        }
        to
    };
    DofVector { beam: beam(&q.beam), bar: beam(&q.bar) }
}

/// A translation of both beams: the points move, the tangents do not.
fn translation(axis: usize) -> Dofs {
    let mut v = Dofs::zeros();
    for start in [0, 6] {
        v.beam[start + axis] = 1.0;
        v.bar[start + axis] = 1.0;
    }
    v
}

fn size(v: &Dofs) -> f64 {
    v.beam.amax().max(v.bar.amax())
}

fn size_of(k: &BlockMatrix<f64, 12, 12>) -> f64 {
    k.to_dense().amax()
}

fn case(wish: Wish, seed: u32) -> Hermites {
    Case::new(Hermite::new(), Hermite::new(), wish, numbers(seed))
}

proptest! {
    #[test]
    fn forces_and_moments_are_in_equilibrium((wish, seed) in wishes()) {
        let case = case(wish, seed);
        let (to, values) = case.closed(&case.decision());
        let (r, k) = (to.residual, to.tangent);
        let transposed = k.transposed();
        for axis in 0..3 {
            let v = translation(axis);
            prop_assert!(r.along(&v).abs() < 1e-13 * size(&r));
            prop_assert!(size(&k.times(&v)).max(size(&transposed.times(&v))) < 1e-13 * size_of(&k));
            let omega = Vector3::ith(axis, 1.0);
            let turn = |q: &Dofs| turned(q, |v| omega.cross(&v));
            let (moved, expected) = (turn(&case.q), turn(&r));
            prop_assert!(r.along(&moved).abs() < 1e-13 * size(&r));
            for k in [&k, &transposed] {
                let rest = k.times(&moved).plus(-1.0, &expected);
                prop_assert!(size(&rest) < 1e-13 * size_of(k), "{:e}", size(&rest) / size_of(k));
            }
        }
        // The friction force lies in the cone and in the tangent plane, and friction dissipates.
        let cone = wish.parameters.mu * values.f_n;
        prop_assert!(values.traction.norm() <= cone * (1.0 + 1e-14));
        prop_assert!(values.rho <= 1.0);
        if case.decision().state == State::Slip {
            prop_assert!((values.traction.norm() - cone).abs() < 1e-14 * cone);
        }
        if wish.held == Held::default() {
            prop_assert!(values.traction.dot(&values.normal).abs() < 1e-14 * (cone + values.f_n));
        }
    }

    #[test]
    fn rigid_motions_turn_the_result((wish, seed) in wishes(), angles in [-3.0..3.0, -3.0..3.0, -3.0..3.0]) {
        let case = case(wish, seed);
        let rotation = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let turn = |q: &Dofs| turned(q, |v| rotation * v);
        let history = History { normal: case.history.normal.map(|n| rotation * n), ..case.history };
        let moved = Case { q: turn(&case.q).plus(0.5, &translation(1)), history, ..case };
        let (before, _) = case.closed(&case.decision());
        let (after, _) = moved.closed(&moved.decision());
        let rest = turn(&before.residual).plus(-1.0, &after.residual);
        prop_assert!(size(&rest) < 1e-11 * size(&after.residual));
        for i in 0..24 {
            let unit = Dofs::unit(i);
            let column = turn(&before.tangent.times(&unit)).plus(-1.0, &after.tangent.times(&turn(&unit)));
            prop_assert!(size(&column) < 1e-11 * size_of(&after.tangent));
        }
    }

    #[test]
    fn exchanged_beams_have_exchanged_results((wish, seed) in wishes()) {
        let case = case(wish, seed);
        let exchanged = |v: &Dofs| DofVector { beam: v.bar, bar: v.beam };
        let Held { xi, xi_bar } = wish.held;
        let wish = Wish { held: Held { xi: xi_bar, xi_bar: xi }, ..wish };
        let slips = case.history.slips.map(|s| Slips {
            xi: s.xi_bar,
            xi_bar: s.xi,
            e: s.e_bar,
            e_bar: s.e,
            held: wish.held,
            ..s
        });
        let history = History { normal: case.history.normal.map(|n| -n), slips };
        let other = Case { q: exchanged(&case.q), at: (case.at.1, case.at.0), history, wish, ..case };
        let (before, values) = case.closed(&case.decision());
        let (after, values_after) = other.closed(&other.decision());
        prop_assert!((values.f_n - values_after.f_n).abs() < 1e-12 * values.f_n);
        prop_assert!((values.traction + values_after.traction).norm() < 1e-12 * values.f_n);
        let rest = exchanged(&before.residual).plus(-1.0, &after.residual);
        prop_assert!(size(&rest) < 1e-12 * size(&after.residual));
        for i in 0..24 {
            let unit = Dofs::unit(i);
            let rest =
                exchanged(&before.tangent.times(&unit)).plus(-1.0, &after.tangent.times(&exchanged(&unit)));
            prop_assert!(size(&rest) < 1e-12 * size_of(&after.tangent));
        }
    }

    #[test]
    fn lengths_scale((wish, seed) in wishes(), exponent in -20..20) {
        let case = case(wish, seed);
        let scale = 2.0_f64.powi(exponent);
        let law = match wish.parameters.law {
            Law::Lpqp { eps, g_0 } => Law::Lpqp { eps, g_0: g_0 * scale },
            Law::Augmented { eps, lambda } => Law::Augmented { eps, lambda: lambda * scale },
            law => law,
        };
        let wish = Wish { parameters: Parameters { law, ..wish.parameters }, ..wish };
        let slips = case.history.slips.map(|s| Slips { e: s.e * scale, e_bar: s.e_bar * scale, ..s });
        let radius = RADIUS * scale;
        let contact = Contact { radius, radius_bar: radius, ..case.pair.contact };
        let history = History { slips, ..case.history };
        let q = case.q.times(scale);
        let scaled = Case { q, history, wish, pair: case.pair.with_contact(contact), ..case };
        let (before, _) = case.closed(&case.decision());
        let (after, _) = scaled.closed(&scaled.decision());
        // Powers of two: the same bits.
        prop_assert_eq!(before.residual.times(scale), after.residual);
        prop_assert_eq!(before.tangent, after.tangent);
    }

    #[test]
    fn scaled_tangents_scale_their_rows_and_columns((wish, seed) in wishes()) {
        let case = case(wish, seed);
        let curve = Hermite::scaled_by(4.0);
        let pair = Pair::new(curve, curve).with_contact(case.pair.contact);
        let scale = |i: usize| if i % 6 < 3 { 1.0 } else { 2.0 };
        let mut q = case.q;
        for i in 0..24 {
            q.set(i, case.q.entry(i) / scale(i));
        }
        let (of, _) = case.closed(&case.decision());
        let scaled = Case { pair, q, ..case };
        let (found, _) = scaled.closed(&scaled.decision());
        for i in 0..24 {
            let difference = found.residual.entry(i) - scale(i) * of.residual.entry(i);
            prop_assert!(difference.abs() < 1e-13 * size(&of.residual));
            for j in 0..24 {
                let expected = scale(i) * of.tangent.entry(i, j) * scale(j);
                prop_assert!((found.tangent.entry(i, j) - expected).abs() < 1e-13 * 4.0 * size_of(&of.tangent));
            }
        }
    }

    /// A straight bar is translated by v in the tangent plane of two straight beams: the friction force is against v.
    #[test]
    fn friction_is_isotropic(angle in 0.3..2.8_f64, direction in 0.0..6.0_f64, stretch in 0.5..2.0_f64) {
        let contact = Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() };
        let pair = Pair::new(Segment::new(), Segment::new()).with_contact(contact);
        let tangent = Vector3::new(angle.cos(), angle.sin(), 0.0) * stretch;
        let v = Vector3::new(direction.cos(), direction.sin(), 0.0) * 0.0625;
        let dofs = |moved: Vector3<f64>| -> DofVector<f64, 6, 6> {
            let middle = Vector3::new(0.1, -0.05, -0.1875);
            let (low, high) = (middle - tangent + moved, middle + tangent + moved);
            ([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [low.x, low.y, low.z, high.x, high.y, high.z]).into()
        };
        let parameters = Parameters::with_friction(Law::Linear { eps: 100.0 }, 1e4, 0.25);
        let element = Element::new(&pair, &parameters).unwrap();
        let mut to = Contribution::zeros();
        let mut evaluate = |q: DofVector<f64, 6, 6>, history: &History| {
            let found = pair.closest_points(&q).unwrap();
            element.evaluate(&q, found.interior().unwrap(), history, &mut to).unwrap()
        };
        let first = evaluate(dofs(Vector3::zeros()), &History::default());
        prop_assert_eq!(first.state, State::Frictionless);
        let second = evaluate(dofs(v), &first.next);
        prop_assert_eq!(second.state, State::Slip);
        let expected = v / v.norm() * (0.25 * second.values.f_n);
        prop_assert!((second.values.traction - expected).norm() < 1e-12 * expected.norm());
    }
}
