//! Elements in every state, drawn for a closest point.

use super::ElementData;
use crate::check::regime::sign;
use crate::closest_point::Held;
use crate::contact::{History, Law, Parameters, Slips, Work};
use crate::linearization::closed_form::Points;
use crate::pair::Contact;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// A situation of a contact.
struct Situation {
    /// About (r + r_bar)/d.
    radii: f64,
    /// About mu F_N over the trial force: more than 1 sticks, less slips. Nothing for mu = 0.
    cone: Option<f64>,
    /// Whether the beam has crossed to the other side of the bar beam.
    is_crossed: bool,
    /// The slip of the step in xi.
    slip: f64,
    /// Whether the contact is new: it has no slips yet.
    is_new: bool,
}

const STICK: Situation =
    Situation { radii: 1.25, cone: Some(4.0), is_crossed: false, slip: 0.05, is_new: false };
const SLIP: Situation = Situation { cone: Some(0.25), ..STICK };

/// The situations, in turn.
const SITUATIONS: [Situation; 12] = [
    STICK,
    SLIP,
    Situation { radii: 0.5, ..STICK },
    Situation { cone: None, ..STICK },
    SLIP,
    Situation { is_new: true, ..STICK },
    Situation { cone: Some(1.0 + 1e-6), ..STICK },
    Situation { is_crossed: true, ..SLIP },
    Situation { cone: Some(1.0 - 1e-6), ..STICK },
    Situation { slip: 1.5, ..SLIP },
    Situation { is_crossed: true, radii: 0.5, ..STICK },
    Situation { radii: 0.875, ..SLIP },
];

impl ElementData {
    /// The number of situations, which alternate.
    pub(in crate::check) const SITUATIONS: u64 = SITUATIONS.len() as u64;

    /// In the situations of these numbers, a parameter that is held was not held before.
    pub(in crate::check) const BECOMES_HELD_IN_STICK: u64 = Self::SITUATIONS;
    pub(in crate::check) const BECOMES_HELD_IN_SLIP: u64 = Self::SITUATIONS + 1;

    /// mu F_N over the trial force in the situation of this number; nothing for mu = 0.
    pub(in crate::check) fn cone(number: u64) -> Option<f64> {
        situation(number).cone
    }

    /// The slip of the step in xi in the situation of this number.
    pub(in crate::check) fn slip(number: u64) -> f64 {
        situation(number).slip
    }

    /// Draws the element of case `number` at contact points, and sets the radii.
    ///
    /// Situations, laws and both works alternate. If `is_crossing`, the element is for centroids that are moved along d until they
    /// cross.
    pub(in crate::check) fn draw(
        number: u64,
        points: &Points<f64>,
        (xi, xi_bar): (f64, f64),
        held: Held,
        is_crossing: bool,
        contact: &mut Contact,
        rng: &mut ChaCha8Rng,
    ) -> Self {
        let (situation, round) = (situation(number), number / Self::SITUATIONS);
        let distance = points.d.norm();
        let eps = 10.0_f64.powf(rng.random_range(-1.0..3.0));
        let lpqp = Law::Lpqp { eps, g_0: 0.25 * distance };
        // The radii over the distance. On the parabola of lpqp, g_N lies anywhere between 0 and g_0.
        let is_on_parabola = situation.radii > 0.5 && situation.radii < 1.0;
        let mut radii = if is_on_parabola {
            rng.random_range(0.76..0.99)
        } else {
            situation.radii * rng.random_range(0.9..1.2)
        };
        let law = match (number + round) % 3 {
            _ if is_on_parabola => lpqp,
            0 => Law::Linear { eps },
            1 => lpqp,
            // A force at an open gap.
            _ if !situation.is_crossed && (number / 3 + round) % 3 == 1 => {
                radii = rng.random_range(0.45..0.6);
                Law::Augmented { eps, lambda: eps * (1.0 - radii) * distance * rng.random_range(1.2..3.0) }
            }
            _ => Law::Augmented { eps, lambda: eps * distance * rng.random_range(0.1..0.4) },
        };
        let sum = contact.radius + contact.radius_bar;
        let share = if sum > 0.0 { contact.radius / sum } else { 0.5 };
        (contact.radius, contact.radius_bar) = (radii * distance * share, radii * distance * (1.0 - share));
        let eps_t = eps * rng.random_range(0.1..2.0);
        let mut parameters = Parameters::with_friction(law, eps_t, 0.0);
        parameters.work =
            if number.is_multiple_of(2) == round.is_multiple_of(2) { Work::Rate } else { Work::Paper };
        // Independent of the work.
        let before = held_before(number / 2 + round, held);
        // The slip of the step in the parameter, and the elastic slip of the last one.
        let mut slip = |is_held: bool, was_held: bool, t: f64| {
            let slip = situation.slip * rng.random_range(0.5..1.5) * sign(rng);
            let e = if was_held { 0.0 } else { slip * t * rng.random_range(-1.0..1.0) };
            (if is_held && was_held { 0.0 } else { slip }, e)
        };
        let [t, t_bar] = [points.beam.t.norm(), points.bar.t.norm()];
        let ((u, e), (u_bar, e_bar)) = (slip(held.xi, before.xi, t), slip(held.xi_bar, before.xi_bar, t_bar));
        let (tau, tau_bar) = (points.beam.t / t, points.bar.t / t_bar);
        let slips = Slips {
            xi: xi - u,
            xi_bar: xi_bar - u_bar,
            e,
            e_bar,
            held: before,
            // The angle has changed.
            cosine: 0.95 * tau.dot(&tau_bar),
            is_slipping: false,
        };
        let side = if situation.is_crossed { -1.0 } else { 1.0 };
        let is_first = situation.is_new && round.is_multiple_of(2);
        let normal = (!is_first).then(|| points.d * (side / distance));
        let history = History { normal, slips: (!situation.is_new).then_some(slips) };
        if let Some(cone) = situation.cone {
            let radii = contact.radius + contact.radius_bar;
            let g_n = if is_crossing { -radii } else { side * distance - radii };
            let force = force(law, g_n);
            let of_step = |is_held: bool, t: f64, u: f64, e: f64| if is_held { e } else { e + t * u };
            let trial = history.start(held).map_or(0.0, |start| {
                let along = tau * of_step(held.xi, t, u, start.e);
                (along - tau_bar * of_step(held.xi_bar, t_bar, u_bar, start.e_bar)).norm()
            });
            // An open contact, a new one, and one of two ends have no cone.
            let ratio = eps_t * trial / force;
            // Beside the cone itself, any distance from it.
            let cone = if (cone - 1.0).abs() < 0.1 { cone } else { cone * rng.random_range(0.5..2.0) };
            parameters.mu = if ratio.is_finite() && ratio > 0.0 { cone * ratio } else { 0.5 };
        }
        Self { parameters, history }
    }
}

fn situation(number: u64) -> &'static Situation {
    &SITUATIONS[usize::try_from(number % ElementData::SITUATIONS).unwrap_or(0)]
}

/// What was held at the last converged step: something else than now in half of the cases at an end, and in an eighth of the
/// others. In a few cases the other parameter was held, or both.
fn held_before(number: u64, held: Held) -> Held {
    match held {
        Held { xi: false, xi_bar: false } if number % 8 == 5 => {
            let is_xi = number % 16 == 5;
            Held { xi: is_xi, xi_bar: !is_xi }
        }
        Held { xi: false, xi_bar: false } => held,
        _ if number.is_multiple_of(2) => held,
        _ if number % 32 == 15 => Held { xi: true, xi_bar: true },
        Held { xi, xi_bar } if number % 32 == 31 => Held { xi: !xi, xi_bar: !xi_bar },
        _ => Held::default(),
    }
}

/// F_N; 0 if open.
fn force(law: Law, g_n: f64) -> f64 {
    use crate::contact::NormalLaw;
    law.piece(g_n).map_or(0.0, |piece| law.force(piece, g_n))
}

#[cfg(test)]
mod tests {
    use super::{ElementData, Held, force};
    use crate::contact::{Law, Work};
    use crate::curve::Geometry;
    use crate::linearization::closed_form::Points;
    use crate::pair::Contact;
    use nalgebra::Vector3;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use std::collections::BTreeSet;

    /// A law is not tried at one point of its range alone: a wrong law may be right there.
    #[test]
    fn every_part_of_the_laws_and_every_change_of_held_parameters_is_drawn() {
        let beam = |x, t| Geometry { x, t, t_xi: Vector3::zeros(), t_xixi: Vector3::zeros() };
        let points = Points::new(
            &beam(Vector3::z() * 0.5, Vector3::x()),
            &beam(Vector3::zeros(), Vector3::new(1.0, 2.0, 0.0)),
        );
        let (mut on_parabola, mut changes, mut forces) = (BTreeSet::<i32>::new(), BTreeSet::new(), [0; 2]);
        for number in 0..600 {
            for held in [(false, false), (true, false), (false, true), (true, true)] {
                let (mut contact, mut rng) = (Contact::default(), ChaCha8Rng::seed_from_u64(number));
                let now = Held { xi: held.0, xi_bar: held.1 };
                let element =
                    ElementData::draw(number, &points, (0.0, 0.0), now, false, &mut contact, &mut rng);
                element.check().unwrap();
                let g_n = 0.5 - contact.radius - contact.radius_bar;
                match element.parameters.law {
                    Law::Lpqp { g_0, .. } if g_n > 0.0 && g_n < g_0 => {
                        // The tenth of the parabola.
                        let at = 10.0 * g_n / g_0;
                        on_parabola.extend((0..10).filter(|&k| (at - f64::from(k) - 0.5).abs() <= 0.5));
                    }
                    law @ Law::Augmented { .. } if g_n > 0.0 => {
                        forces[usize::from(force(law, g_n) > 0.0)] += 1;
                    }
                    _ => {}
                }
                let before = element.history.slips.map(|slips| (slips.held.xi, slips.held.xi_bar));
                changes.insert((before, held, element.parameters.work == Work::Rate));
            }
        }
        assert!(on_parabola.len() >= 9, "{on_parabola:?}");
        assert!(forces.iter().all(|&count| count > 20), "{forces:?}");
        let free = Some((false, false));
        for (before, now) in [
            (free, (true, false)),
            (free, (false, true)),
            (Some((true, false)), (false, false)),
            (Some((false, true)), (false, false)),
            (Some((true, false)), (false, true)),
            (Some((false, true)), (true, false)),
            (Some((true, true)), (true, false)),
        ] {
            for is_rate in [false, true] {
                assert!(changes.contains(&(before, now, is_rate)), "{before:?} {now:?} {is_rate}");
            }
        }
    }
}
