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
    /// (r + r_bar)/d.
    radii: f64,
    /// mu F_N over the trial force: more than 1 sticks, less slips. Nothing for mu = 0.
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

    /// Draws the element of case `number` at contact points, and sets the radii.
    ///
    /// Situations, laws and both works alternate.
    pub(in crate::check) fn draw(
        number: u64,
        points: &Points<f64>,
        (xi, xi_bar): (f64, f64),
        held: Held,
        contact: &mut Contact,
        rng: &mut ChaCha8Rng,
    ) -> Self {
        let count = Self::SITUATIONS;
        let of = |number: u64, count: u64| usize::try_from(number % count).unwrap_or(0);
        let (situation, round) = (&SITUATIONS[of(number, count)], number / count);
        let distance = points.d.norm();
        let (sum, radii) = (contact.radius + contact.radius_bar, situation.radii * distance);
        let share = if sum > 0.0 { contact.radius / sum } else { 0.5 };
        (contact.radius, contact.radius_bar) = (radii * share, radii * (1.0 - share));
        let eps = 10.0_f64.powf(rng.random_range(-1.0..3.0));
        // With 7/8 of the distance as radii, g_N lies on the parabola.
        let lpqp = Law::Lpqp { eps, g_0: 0.25 * distance };
        let law = match (number + round) % 3 {
            _ if situation.radii > 0.5 && situation.radii < 1.0 => lpqp,
            0 => Law::Linear { eps },
            1 => lpqp,
            _ => Law::Augmented { eps, lambda: 0.25 * eps * distance },
        };
        let eps_t = eps * rng.random_range(0.1..2.0);
        let mut parameters = Parameters::with_friction(law, eps_t, 0.0);
        parameters.work =
            if number.is_multiple_of(2) == round.is_multiple_of(2) { Work::Rate } else { Work::Paper };
        let mut slip = |is_held: bool, t: f64| {
            let slip = situation.slip * rng.random_range(0.5..1.5) * sign(rng);
            if is_held { (0.0, 0.0) } else { (slip, slip * t * rng.random_range(-1.0..1.0)) }
        };
        let ((u, e), (u_bar, e_bar)) =
            (slip(held.xi, points.beam.t.norm()), slip(held.xi_bar, points.bar.t.norm()));
        let (tau, tau_bar) = (points.beam.t.normalize(), points.bar.t.normalize());
        let slips = Slips {
            xi: xi - u,
            xi_bar: xi_bar - u_bar,
            e,
            e_bar,
            held,
            cosine: tau.dot(&tau_bar),
            is_slipping: false,
        };
        let side = if situation.is_crossed { -1.0 } else { 1.0 };
        let normal = Some(points.d * (side / distance));
        let history = History { normal, slips: (!situation.is_new).then_some(slips) };
        if let Some(cone) = situation.cone {
            let radii = contact.radius + contact.radius_bar;
            let g_n = side * distance - radii;
            let force = force(law, g_n);
            let of_step = |t: f64, u: f64, e: f64| e + t * u;
            let trial = tau * of_step(points.beam.t.norm(), u, e)
                - tau_bar * of_step(points.bar.t.norm(), u_bar, e_bar);
            // An open contact, and one of two ends, has no cone.
            let ratio = eps_t * trial.norm() / force;
            parameters.mu = if ratio.is_finite() && ratio > 0.0 { cone * ratio } else { 0.5 };
        }
        Self { parameters, history }
    }
}

/// F_N; 0 if open.
fn force(law: Law, g_n: f64) -> f64 {
    use crate::contact::NormalLaw;
    law.piece(g_n).map_or(0.0, |piece| law.force(piece, g_n))
}
