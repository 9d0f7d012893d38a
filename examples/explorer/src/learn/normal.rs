//! Scene 2: two points on the beams, and the two products that vanish at a closest point.

use super::camera::Camera;
use super::pair::{Dofs, above, below, drawn, geometry, nearest_drawn};
use super::{Scene, rounded};
use crate::frame::Frame;
use crate::map::{self, Grid};
use beamgap::closest_point::{Centroid, SquaredDistance};
use beamgap::nalgebra::Vector3;
use beamgap::pair::DofVector;
use serde::{Deserialize, Serialize};

/// The length of the drawn tangents in space.
const TANGENT: f64 = 0.55;
/// The size of the mark of an angle in space.
const MARK: f64 = 0.13;

/// The parameters of both points.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Normal {
    at: [f64; 2],
}

impl Default for Normal {
    fn default() -> Self {
        Self { at: [-0.5, -0.6] }
    }
}

fn camera() -> Camera {
    Camera::usual(122.0, [180.0, 174.0])
}

fn beams() -> [Dofs; 2] {
    [above(), below()]
}

impl Scene for Normal {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        let [beam, bar] = beams();
        match handle {
            "point" => self.at[0] = rounded(nearest_drawn(&camera(), &beam, to)),
            "point_bar" => self.at[1] = rounded(nearest_drawn(&camera(), &bar, to)),
            "both" => self.at = map::from(to).map(rounded),
            _ => {}
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let [beam, bar] = beams();
        let camera = camera();
        let mut frame = Frame::default();
        for (name, q) in [("beam", &beam), ("bar", &bar)] {
            frame.line(name, drawn(&camera, |xi| geometry(q, xi)));
        }
        let at = self.at.map(|xi| xi.clamp(-1.0, 1.0));
        let (x, y) = (geometry(&beam, at[0]), geometry(&bar, at[1]));
        let here = SquaredDistance::new(&x, &y);
        let [on_beam, on_bar] = [x.x, y.x].map(|x| camera.at(&x));
        frame.place("point", on_beam);
        frame.place("point_bar", on_bar);
        frame.arrow("d", on_bar, on_beam);
        frame.place("d_letter", middle(on_bar, on_beam, [-24.0, 6.0]));
        let n = here.d / here.distance.max(1e-9);
        // The letters of both tangents are on different sides of them.
        for (names, x, towards, below) in [
            (["t", "t_letter", "angle"], &x, -n, -8.0),
            (["t_bar", "t_bar_letter", "angle_bar"], &y, n, 16.0),
        ] {
            let unit = x.t / x.t.norm();
            let [from, tip] = [x.x, x.x + unit * TANGENT].map(|x| camera.at(&x));
            frame.arrow(names[0], from, tip);
            frame.place(
                names[1],
                middle(from, tip, [0.6 * (tip[0] - from[0]) + 4.0, 0.6 * (tip[1] - from[1]) + below]),
            );
            let corners: [Vector3<f64>; 3] =
                [x.x + unit * MARK, x.x + (unit + towards) * MARK, x.x + towards * MARK];
            frame.line(names[2], corners.map(|x| camera.at(&x)));
        }

        let [zero, zero_bar] = zeros();
        frame.paths.insert("zero".into(), zero);
        frame.paths.insert("zero_bar".into(), zero_bar);
        frame.place("both", map::at(at));
        frame.number("d_t", here.gradient[0]);
        frame.number("d_t_bar", -here.gradient[1]);
        frame.number("length", here.distance);
        frame.number("xi", at[0]);
        frame.number("xi_bar", at[1]);
        let degrees = |cosine: f64| format!("{:.0}°", cosine.clamp(-1.0, 1.0).acos().to_degrees());
        frame.text("degrees", degrees(n.dot(&x.t) / x.t.norm()));
        frame.text("degrees_bar", degrees(n.dot(&y.t) / y.t.norm()));
        Ok(frame)
    }
}

/// The lines on which d.t = 0 and d.t_bar = 0. The beams do not move, so the lines are computed once.
fn zeros() -> [String; 2] {
    thread_local! {
        static ZEROS: [String; 2] = {
            let [beam, bar] = beams();
            let (pair, q) = (super::pair::parabolas(), DofVector { beam, bar });
            let (beam, bar) = pair.centroids(&q);
            let centroids: [&dyn Centroid; 2] = [&beam, &bar];
            Grid::of(centroids, [|at| at.gradient[0], |at| -at.gradient[1]]).map(|grid| grid.contours(&[0.0]))
        };
    }
    ZEROS.with(Clone::clone)
}

/// The middle of two places, moved aside.
fn middle(from: [f64; 2], to: [f64; 2], aside: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| 0.5 * (from[i] + to[i]) + aside[i])
}
