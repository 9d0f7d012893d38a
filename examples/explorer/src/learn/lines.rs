//! Scene 4: the two equations for the variations of the parameters, as two lines.

use super::camera::Camera;
use super::pair::{Both, Dofs, First, drawn, followed, geometry, nearest};
use super::{Scene, rounded};
use crate::frame::{Frame, number};
use beamgap::closest_point::Held;
use beamgap::nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// The plane of both unknowns: its middle, and the pixels per unit.
const MIDDLE: [f64; 2] = [190.0, 162.0];
const UNIT: f64 = 150.0;

/// The angle between the straight beams, and how far the beam is tilted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Lines {
    /// Cosine and sine of the angle.
    turn: [f64; 2],
    /// The displacement of the second end of the beam upwards; the first end is at rest.
    lift: f64,
}

impl Default for Lines {
    fn default() -> Self {
        Self { turn: [0.5, 0.866], lift: -0.3 }
    }
}

fn camera() -> Camera {
    Camera::usual(112.0, [180.0, 160.0])
}

impl Lines {
    fn dofs(&self) -> (Both, Both) {
        let [cos, sin] = self.turn;
        let straight = |x: f64, y: f64, z: f64| Dofs::from([-x, -y, z, 0.0, 0.0, z, x, y, z]);
        let tilt = Dofs::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.5 * self.lift, 0.0, 0.0, self.lift]);
        let q = Both { beam: straight(1.0, 0.0, 0.4), bar: straight(cos, sin, -0.4) };
        (q, Both::of_beam(tilt))
    }
}

impl Scene for Lines {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        let camera = camera();
        match handle {
            "turn" => {
                let x = camera.on_level(to, -0.4);
                let length = (x.x * x.x + x.y * x.y).sqrt();
                if length > 0.05 {
                    let [cos, sin] = [x.x / length, x.y / length];
                    self.turn = if sin.abs() < 0.03 {
                        [1.0_f64.copysign(cos), 0.0]
                    } else {
                        [rounded(cos), rounded(sin)]
                    };
                }
            }
            "lift" => {
                let [_, y] = camera.at(&Vector3::new(1.0, 0.0, 0.4));
                let [_, above] = camera.at(&Vector3::new(1.0, 0.0, 1.4));
                self.lift = rounded(((y - to[1]) / (y - above)).clamp(-0.8, 0.8));
            }
            _ => {}
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let (q, dq) = self.dofs();
        let first = First::new(&q, &dq, (0.0, 0.0), Held::default());
        let (a, b, a_bar) = (first.projection.a, first.projection.b, first.projection.a_bar);
        let det = first.projection.det();
        let [r, r_bar] = first.right_hand_sides();
        let mut frame = Frame::default();
        beams(&mut frame, &q, &dq);

        // The lines a δξ − b δξ̄ = R and b δξ + ā δξ̄ = R̄.
        for (name, [u, v], r) in [("row", [a, -b], r), ("row_bar", [b, a_bar], r_bar)] {
            let size = (u * u + v * v).sqrt().max(1e-9);
            let foot = [u * r / (size * size), v * r / (size * size)];
            let along = [-v / size, u / size];
            let at = |s: f64| plane([foot[0] + s * along[0], foot[1] + s * along[1]]);
            frame.line(name, [at(-4.0), at(4.0)]);
        }
        // For beams of equal length, D of parallel ones is zero but for rounding.
        let is_singular = det.abs() < 1e-6;
        let (xi, xi_bar) = (first.delta.beam.xi, first.delta.bar.xi);
        let is_inside = |x: f64| x.abs() < 0.98;
        frame.hide("crossing");
        frame.no_path("away");
        if !is_singular {
            if is_inside(xi) && is_inside(xi_bar) {
                frame.place("crossing", plane([xi, xi_bar]));
            } else {
                let far = xi.abs().max(xi_bar.abs());
                let edge = [0.97 * xi / far, 0.97 * xi_bar / far];
                frame.arrow("away", plane(edge.map(|x| 0.82 * x)), plane(edge));
            }
        }
        let again = nearest(&q, (0.0, 0.0)).and_then(|point| followed(&q, &dq, 1.0, &point));
        frame.place_if("solved", again.map(|point| plane([point.xi, point.xi_bar])));

        for (name, x) in [("a", a), ("b_minus", -b), ("b", b), ("a_bar", a_bar), ("R", r), ("R_bar", r_bar)] {
            frame.number(name, if x.abs() < 1e-12 { 0.0 } else { x });
        }
        frame.text("D", if is_singular { "0.000".to_owned() } else { number(det) });
        let none = || "none".to_owned();
        frame.text("dxi", if is_singular { none() } else { number(xi) });
        frame.text("dxi_bar", if is_singular { none() } else { number(xi_bar) });
        // The first variation of d does not use the system.
        let d = first.delta.u_hat.dot(&first.d) / first.d.norm();
        let is_at_rest = r.abs().max(r_bar.abs()) < 1e-12;
        let has_dd = !is_singular || is_at_rest;
        frame.text("dd", if has_dd { number(d) } else { none() });
        frame.shown.insert("has_dd".into(), has_dd);
        frame.shown.insert("ends".into(), again.is_none() && !is_singular);
        let [cos, sin] = self.turn;
        frame.text("angle", format!("{:.1}°", (sin / cos.abs().max(1e-12)).atan().abs().to_degrees()));
        frame.text(
            "says",
            if is_singular && is_at_rest {
                "D is zero, and both lines are one: every pair on it fulfils both equations."
            } else if is_singular {
                "D is zero, and the lines are parallel: no pair fulfils both equations. The distance has a kink."
            } else if is_inside(xi) && is_inside(xi_bar) {
                "The lines cross in one point. It is the pair of variations."
            } else {
                "The lines cross outside the picture, in the direction of the arrow."
            },
        );
        Ok(frame)
    }
}

/// Where a pair of variations is drawn.
fn plane([xi, xi_bar]: [f64; 2]) -> [f64; 2] {
    [MIDDLE[0] + UNIT * xi, MIDDLE[1] - UNIT * xi_bar]
}

/// The picture of the beams.
fn beams(frame: &mut Frame, q: &Both, dq: &Both) {
    let camera = camera();
    for (name, q) in [("beam", &q.beam), ("bar", &q.bar)] {
        frame.line(name, drawn(&camera, |xi| geometry(q, xi)));
    }
    let varied = q.plus(1.0, dq).beam;
    frame.line("varied", drawn(&camera, |xi| geometry(&varied, xi)));
    let [on_beam, on_bar] = [&q.beam, &q.bar].map(|q| camera.at(&geometry(q, 0.0).x));
    frame.line("d", [on_bar, on_beam]);
    frame.place("point", on_beam);
    frame.place("point_bar", on_bar);
    frame.place("turn", camera.at(&geometry(&q.bar, 1.0).x));
    frame.place("lift", camera.at(&geometry(&varied, 1.0).x));
    let again = nearest(q, (0.0, 0.0)).and_then(|point| followed(q, dq, 1.0, &point));
    let places = again.map(|point| {
        let places = [geometry(&varied, point.xi).x, geometry(&q.bar, point.xi_bar).x];
        places.map(|x| camera.at(&x))
    });
    frame.place_if("again", places.map(|[x, _]| x));
    frame.place_if("again_bar", places.map(|[_, y]| y));
    frame.line("again_d", places.into_iter().flatten());
}
