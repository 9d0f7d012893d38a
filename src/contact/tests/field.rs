//! The closed form equals automatic differentiation over a prime field, without a tolerance.

use super::beams::{HELD, LAWS, Movable, RADIUS};
use crate::closest_point::Held;
use crate::contact::{Contribution, Decision, Law, Parameters, Piece, Start, State, Work, ad, closed_form};
use crate::curve::{Arc, Hermite, Segment};
use crate::linearization::closed_form::formulation::{Distance, System};
use crate::linearization::closed_form::{Formulation, Points, jets};
use crate::number::PrimeField;
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::Vector3;

/// Random elements (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
fn residues(mut state: u64) -> impl FnMut() -> PrimeField {
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        PrimeField::new(z ^ (z >> 31))
    }
}

/// Draws a stationary point at which all square roots exist.
fn draw<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    decision: &Decision<'_, Law>,
    random: &mut impl FnMut() -> PrimeField,
) -> (DofVector<PrimeField, N, M>, (PrimeField, PrimeField)) {
    loop {
        let mut q = DofVector { beam: A::dofs().map(|_| random()), bar: B::dofs().map(|_| random()) };
        let at = (random(), random());
        let (jet, jet_bar) = jets(pair, &q, at);
        let points = Points::new(&jet.geometry, &jet_bar.geometry);
        let (t, t_bar) = (points.beam.t, points.bar.t);
        let some = Vector3::new(random(), random(), random());
        let normal_to = |t: Vector3<PrimeField>| some - t * (some.dot(&t) / t.dot(&t));
        let d = match decision.form.held {
            Held { xi: false, xi_bar: false } => points.cross() * random(),
            Held { xi: true, xi_bar: false } => normal_to(t_bar),
            Held { xi: false, xi_bar: true } => normal_to(t),
            Held { xi: true, xi_bar: true } => some,
        };
        B::translate(&mut q.bar, &(points.d - d));
        let square = |v: Vector3<PrimeField>| v.dot(&v);
        let slip = |t: Vector3<PrimeField>, xi: PrimeField, xi_n: f64, e_n: f64, held: bool| {
            let u = if held { PrimeField::from(0.0) } else { xi - PrimeField::from(xi_n) };
            t * (u + PrimeField::from(e_n) / crate::number::Real::sqrt(square(t)))
        };
        let start = decision.start.unwrap();
        let slips = slip(t, at.0, start.xi, start.e, decision.form.held.xi)
            - slip(t_bar, at.1, start.xi_bar, start.e_bar, decision.form.held.xi_bar);
        if [t, t_bar, d, points.cross(), slips].into_iter().all(|v| square(v).is_square()) {
            return (q, at);
        }
    }
}

fn check<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(curve: A, curve_bar: B) {
    let mut random = residues(7);
    let contact = Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() };
    let pair = Pair::new(curve, curve_bar).with_contact(contact);
    let mut count = 0;
    for held in HELD {
        for state in [State::Frictionless, State::Stick, State::Slip] {
            for work in [Work::Rate, Work::Paper] {
                count += 1;
                if held.xi && held.xi_bar && state != State::Frictionless {
                    continue;
                }
                let parameters =
                    Parameters { work, ..Parameters::with_friction(LAWS[count % 3], 16.0, 0.375) };
                let reversed = count % 4 < 2;
                let distance = if count % 2 == 0 { Distance::Normal { reversed } } else { Distance::Length };
                let system = if count % 5 < 2 { System::CrossProducts } else { System::Determinants };
                let e = |held: bool, e: f64| if held { 0.0 } else { e };
                let decision = Decision {
                    parameters: &parameters,
                    contact,
                    start: Some(Start {
                        xi: 0.25,
                        xi_bar: -0.75,
                        e: e(held.xi, 0.125),
                        e_bar: e(held.xi_bar, 0.625),
                    }),
                    state,
                    piece: Some(if count % 7 < 4 { Piece::Parabola } else { Piece::Line }),
                    form: Formulation { held, distance, system },
                    is_crossed: count % 3 == 1,
                };
                let (q, at) = draw(&pair, &decision, &mut random);
                let (jet, jet_bar) = jets(&pair, &q, at);
                let mut to = Contribution::zeros();
                closed_form::write(&decision, (&jet, &jet_bar), at, &mut to);
                let (residual, tangent) = ad::residual_and_tangent(&decision, &pair, &q, at);
                assert_eq!(to.residual, residual, "{decision:?}");
                assert_eq!(to.tangent, tangent, "{decision:?}");
            }
        }
    }
}

#[test]
fn closed_form_equals_ad() {
    check(Hermite::new(), Segment::new());
    check(Segment::new(), Segment::new());
    check(Segment::new(), Arc::new(0.75));
}
