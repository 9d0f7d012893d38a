//! Scene 8: the beam is moved over the bar beam; friction sticks, then slips.

use super::camera::Camera;
use super::pair::{Both, Dofs, First, above, below, drawn, followed, geometry, nearest, parabolas};
use super::{Scene, rounded};
use crate::frame::{Frame, line, number};
use beamgap::closest_point::{ClosestPoint, Held};
use beamgap::contact::{Contribution, Element, History, Law, Outcome, Parameters, Slips, State};
use beamgap::nalgebra::Vector3;
use beamgap::pair::Contact;
use serde::{Deserialize, Serialize};

/// The radii, both penalties, and the coefficient of friction.
const RADIUS: f64 = 0.27;
const PENALTY: f64 = 20.0;
const PENALTY_T: f64 = 6.0;
const MU: f64 = 0.4;
/// The plane of the forces: its middle, and the pixels per unit of force.
const MIDDLE: [f64; 2] = [180.0, 178.0];
const UNIT: f64 = 300.0;
/// The part of mu F_N within which a trial force is on the edge: a state keeps its slips with four decimals.
const EDGE: f64 = 2e-3;
/// The vertices of the drawn circle.
const VERTICES: u8 = 48;

/// The displacement of the beam, and the slips at the last accepted step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Friction {
    moved: [f64; 2],
    /// xi, xi_bar, e and e_bar.
    accepted: Option<[f64; 4]>,
}

impl Default for Friction {
    fn default() -> Self {
        Self { moved: [0.04, 0.01], accepted: None }
    }
}

fn camera() -> Camera {
    Camera::usual(118.0, [180.0, 160.0])
}

fn beam(moved: [f64; 2]) -> Dofs {
    above() + shift(moved)
}

fn shift([x, y]: [f64; 2]) -> Dofs {
    Dofs::from([x, y, 0.0, x, y, 0.0, x, y, 0.0])
}

impl Friction {
    /// The contact, with the beam where it is.
    fn contact(&self) -> Result<(Both, ClosestPoint, Outcome, Contribution<f64, 9, 9>), String> {
        let start = Both { beam: beam([0.0; 2]), bar: below() };
        let first = nearest(&start, (0.0, 0.0)).ok_or("the beams have no closest point")?;
        let moved = self.moved.map(|x| x.clamp(-0.5, 0.5));
        let dq = Both::of_beam(shift(moved));
        let point = followed(&start, &dq, 1.0, &first).ok_or("the contact leaves the beams")?;
        let q = start.plus(1.0, &dq);
        let [xi, xi_bar, e, e_bar] = self.accepted.unwrap_or([first.xi, first.xi_bar, 0.0, 0.0]);
        let slips = Slips { xi, xi_bar, e, e_bar, ..Slips::default() };
        let history = History { normal: None, slips: Some(slips) };
        let pair =
            parabolas().with_contact(Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() });
        let parameters = Parameters::with_friction(Law::Linear { eps: PENALTY }, PENALTY_T, MU);
        let element = Element::new(&pair, &parameters).map_err(|error| error.to_string())?;
        let mut to = Contribution::zeros();
        let outcome = element.evaluate(&q, &point, &history, &mut to).map_err(|error| error.to_string())?;
        Ok((q, point, outcome, to))
    }
}

/// The largest difference of two mirrored entries of the tangent after the first shift, over the largest entry. The page states it,
/// and its module does not contain it.
///
/// # Errors
/// If there is no contact.
pub fn asymmetry(moved: [f64; 2]) -> Result<f64, String> {
    let (.., to) = Friction { moved, accepted: None }.contact()?;
    let [mut largest, mut difference] = [0.0_f64; 2];
    for (i, j) in (0..18).flat_map(|i| (0..18).map(move |j| (i, j))) {
        let entry = to.tangent.entry(i, j);
        largest = largest.max(entry.abs());
        difference = difference.max((entry - to.tangent.entry(j, i)).abs());
    }
    Ok(difference / largest)
}

impl Scene for Friction {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        if handle == "move" {
            let camera = camera();
            let x = geometry(&beam([0.0; 2]), 1.0).x;
            let moved = camera.on_level(to, x.z) - x;
            self.moved = [moved.x.clamp(-0.2, 0.2), moved.y.clamp(-0.2, 0.2)].map(rounded);
        }
    }

    fn choose(&mut self, name: &str, _value: &str) {
        match name {
            "accept" => {
                if let Ok((.., outcome, _)) = self.contact() {
                    let next = outcome.next.slips;
                    self.accepted =
                        next.map(|slips| [slips.xi, slips.xi_bar, slips.e, slips.e_bar].map(rounded));
                }
            }
            "again" => *self = Self::default(),
            _ => {}
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let (q, point, outcome, _) = self.contact()?;
        let mut frame = Frame::default();
        let camera = camera();
        for (name, q) in [("beam", &q.beam), ("bar", &q.bar)] {
            frame.line(name, drawn(&camera, |xi| geometry(q, xi)));
        }
        let before = beam([0.0; 2]);
        frame.line("before", drawn(&camera, |xi| geometry(&before, xi)));
        frame.place("move", camera.at(&geometry(&q.beam, 1.0).x));
        let (x, y) = (geometry(&q.beam, point.xi), geometry(&q.bar, point.xi_bar));
        let middle = (x.x + y.x) * 0.5;
        let values = outcome.values;
        frame.place("contact", camera.at(&middle));
        frame.arrow("force", camera.at(&middle), camera.at(&(middle + values.traction * 1.6)));

        // The trial force is the force without the return to the cone.
        let returned = values.traction;
        let trial = returned / values.rho.max(1e-9);
        let (tau, tau_bar) = (x.t / x.t.norm(), y.t / y.t.norm());
        let across = tau;
        let up = values.normal.cross(&across);
        let plane = |v: &Vector3<f64>| [MIDDLE[0] + UNIT * v.dot(&across), MIDDLE[1] - UNIT * v.dot(&up)];
        let cone = MU * values.f_n;
        let circle = (0..=VERTICES).map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / f64::from(VERTICES)).sin_cos();
            [MIDDLE[0] + UNIT * cone * cos, MIDDLE[1] - UNIT * cone * sin]
        });
        frame.paths.insert("cone".into(), line(circle));
        frame.arrow("trial", MIDDLE, plane(&trial));
        frame.arrow("returned", MIDDLE, plane(&returned));
        frame.arrow("along", MIDDLE, plane(&(tau * 0.45)));
        frame.arrow("along_bar", MIDDLE, plane(&(tau_bar * 0.45)));

        let sizes = [cone, trial.norm(), returned.norm()];
        frame.number("F_N", values.f_n);
        frame.number("mu_F_N", cone);
        frame.number("trial_size", sizes[1]);
        frame.number("T", sizes[2]);
        frame.number("Phi", sizes[1] - sizes[0]);
        frame.number("g_N", values.g_n);
        frame.number("g_T", values.g_t);
        frame.text(
            "state",
            match outcome.state {
                State::Stick | State::Slip if (sizes[1] - sizes[0]).abs() < EDGE * sizes[0] => {
                    "The trial force is on the edge of the cone."
                }
                State::Stick => "The contact sticks: the trial force is inside the cone.",
                State::Slip => {
                    "The contact slips: the trial force is outside the cone and returns to its edge."
                }
                _ => "The contact is open.",
            },
        );
        // The second variation of the parameter along the motion, which the tangent of friction contains.
        let dq = Both::of_beam(shift([1.0, 0.0]));
        let at = (point.xi, point.xi_bar);
        let all = First::new(&q, &dq, at, Held::default()).seconds(at, Held::default());
        frame.number("F", values.f);
        frame.number("t", x.t.norm());
        frame.number("dxi", all.xi.delta);
        frame.number("ddxi", all.xi.second);
        frame.text("t_ddxi", number(values.f * x.t.norm() * all.xi.second));
        Ok(frame)
    }
}
