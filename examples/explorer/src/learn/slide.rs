//! Scene 3: the beam moves, and the contact point moves by its material and along the beam.

use super::camera::Camera;
use super::pair::{Both, Dofs, First, above, below, drawn, followed, geometry, nearest};
use super::{Scene, rounded};
use crate::frame::{Frame, number, vector};
use beamgap::closest_point::Held;
use beamgap::nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// How much larger the second picture is.
const LARGER: f64 = 4.5;

/// The displacement of the second end of the beam.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Slide {
    end: [f64; 3],
}

impl Default for Slide {
    fn default() -> Self {
        Self { end: [0.0, 0.0, 0.3] }
    }
}

fn camera() -> Camera {
    Camera::usual(112.0, [168.0, 178.0])
}

/// The dofs, and the direction in which the beam turns about its first end.
fn moved(end: [f64; 3]) -> (Both, Both) {
    let mut dq = Dofs::zeros();
    dq.fixed_rows_mut::<3>(3).copy_from(&(Vector3::from(end) * 0.5));
    dq.fixed_rows_mut::<3>(6).copy_from(&Vector3::from(end));
    (Both { beam: above(), bar: below() }, Both::of_beam(dq))
}

impl Scene for Slide {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        if handle == "end" {
            let camera = camera();
            let [x, y] = camera.at(&geometry(&above(), 1.0).x);
            let [across, down] = [(to[0] - x).clamp(-60.0, 35.0), (to[1] - y).clamp(-35.0, 35.0)];
            let origin = camera.at(&Vector3::zeros());
            let end = camera.upright([origin[0] + across, origin[1] + down]);
            // A motion that is nearly vertical is vertical.
            let x = if end.x.abs() < 0.02 { 0.0 } else { end.x };
            self.end = [x, 0.0, end.z].map(rounded);
        }
    }

    fn choose(&mut self, _name: &str, value: &str) {
        self.end = if value == "along" { [0.2, 0.0, 0.0] } else { [0.0, 0.0, 0.3] };
    }

    fn frame(&self) -> Result<Frame, String> {
        let end = self.end.map(|x| x.clamp(-1.0, 1.0));
        let (q, dq) = moved(end);
        let point = nearest(&q, (0.0, 0.0)).ok_or("the beams have no closest point")?;
        let first = First::new(&q, &dq, (point.xi, point.xi_bar), Held::default());
        let (x, y) = (first.beam.geometry, first.bar.geometry);
        let material = first.delta.beam.u[0];
        let along = x.t * first.delta.beam.xi;
        let varied = q.plus(1.0, &dq);
        let again = followed(&q, &dq, 1.0, &point);

        let mut frame = Frame::default();
        let camera = camera();
        let close = Camera::usual(camera.scale * LARGER, [0.0, 0.0]);
        // The contact point before the motion keeps its place.
        let [u, v] = close.at(&x.x);
        let close = Camera::usual(camera.scale * LARGER, [180.0 - u, 120.0 - v]);
        for (camera, names) in [
            (
                camera,
                [
                    "beam",
                    "bar",
                    "varied",
                    "material",
                    "along",
                    "total",
                    "d",
                    "now",
                    "then",
                    "fibre",
                    "again",
                    "now_bar",
                    "again_bar",
                ],
            ),
            (
                close,
                [
                    "close_beam",
                    "close_bar",
                    "close_varied",
                    "close_material",
                    "close_along",
                    "close_total",
                    "close_d",
                    "close_now",
                    "close_then",
                    "close_fibre",
                    "close_again",
                    "close_now_bar",
                    "close_again_bar",
                ],
            ),
        ] {
            frame.line(names[0], drawn(&camera, |xi| geometry(&q.beam, xi)));
            frame.line(names[1], drawn(&camera, |xi| geometry(&q.bar, xi)));
            frame.line(names[2], drawn(&camera, |xi| geometry(&varied.beam, xi)));
            let at = |x: &Vector3<f64>| camera.at(x);
            frame.arrow(names[3], at(&x.x), at(&(x.x + material)));
            frame.arrow(names[4], at(&(x.x + material)), at(&(x.x + material + along)));
            frame.arrow(names[5], at(&x.x), at(&(x.x + material + along)));
            frame.line(names[6], [at(&y.x), at(&x.x)]);
            frame.place(names[7], at(&x.x));
            frame.place(names[8], at(&(x.x + material + along)));
            frame.place(names[9], at(&geometry(&varied.beam, point.xi).x));
            frame.place_if(names[10], again.map(|again| at(&geometry(&varied.beam, again.xi).x)));
            frame.place(names[11], at(&y.x));
            frame.place_if(names[12], again.map(|again| at(&geometry(&q.bar, again.xi_bar).x)));
        }
        frame.place("end", camera.at(&geometry(&varied.beam, 1.0).x));
        let [from, to] = [&q.beam, &varied.beam].map(|q| camera.at(&geometry(q, 1.0).x));
        frame.line("rod", [from, to]);

        frame.text("dx", vector(&(material + along)));
        frame.text("t_dxi", vector(&along));
        frame.text("du", vector(&material));
        let ratio = along.norm() / material.norm();
        frame.text("ratio", if ratio.is_finite() { format!("{ratio:.2}") } else { "–".to_owned() });
        frame.number("dxi", first.delta.beam.xi);
        frame.number("dxi_bar", first.delta.bar.xi);
        frame.number("xi", point.xi);
        frame.number("predicted", point.xi + first.delta.beam.xi);
        frame.text("solved", again.map_or_else(|| "none".to_owned(), |again| number(again.xi)));
        Ok(frame)
    }
}
