//! Scene 5: the distance along a motion, with the closest points followed and with their parameters frozen.

use super::pair::{Both, Dofs, First, above, below, followed, geometry, nearest};
use super::{Scene, rounded};
use crate::frame::{Frame, line, number};
use beamgap::closest_point::{ClosestPoint, Held};
use serde::{Deserialize, Serialize};
use std::cell::OnceCell;

/// The frame of both plots: left, right, top, bottom.
const PLOT: [f64; 4] = [48.0, 344.0, 20.0, 270.0];
/// The pieces of a drawn curve.
const PIECES: u32 = 32;
/// The shown range of the parameters, in multiples of their variation.
const RANGE: f64 = 1.6;

/// The distances that are written at the axis.
const LEVELS: [(&str, f64); 3] = [("level0", 0.4), ("level1", 0.5), ("level2", 0.6)];

/// The amplitude of the motion, from -1 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Envelope {
    step: f64,
}

impl Default for Envelope {
    fn default() -> Self {
        Self { step: 0.7 }
    }
}

/// The beams, and the motion: the beam tilts and shifts.
fn motion() -> (Both, Both) {
    let dq = Dofs::from([0.0, 0.25, 0.42, 0.0, 0.25, 0.06, 0.0, 0.25, -0.3]);
    (Both { beam: above(), bar: below() }, Both::of_beam(dq))
}

/// The distance of the beams after a step, between points with given parameters.
fn distance(q: &Both, (xi, xi_bar): (f64, f64)) -> f64 {
    (geometry(&q.beam, xi).x - geometry(&q.bar, xi_bar).x).norm()
}

/// The distances of the closest points over the step. The motion does not change, so they are computed once.
fn all_followed(q: &Both, dq: &Both, point: &ClosestPoint) -> Vec<Option<f64>> {
    thread_local! {
        static ALL: OnceCell<Vec<Option<f64>>> = const { OnceCell::new() };
    }
    let at = |i: u32| followed(q, dq, part(i), point).map(|found| found.distance);
    ALL.with(|all| all.get_or_init(|| (0..=PIECES).map(at).collect()).clone())
}

/// The steps of a drawn curve, from -1 to 1.
fn part(i: u32) -> f64 {
    2.0 * f64::from(i) / f64::from(PIECES) - 1.0
}

fn across(x: f64) -> f64 {
    PLOT[0] + (PLOT[1] - PLOT[0]) * 0.5 * (x + 1.0)
}

impl Scene for Envelope {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        if handle == "step" {
            let step = 2.0 * (to[0] - PLOT[0]) / (PLOT[1] - PLOT[0]) - 1.0;
            self.step = rounded(step.clamp(-1.0, 1.0));
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let (q, dq) = motion();
        let point = nearest(&q, (0.0, 0.0)).ok_or("the beams have no closest point")?;
        let at = (point.xi, point.xi_bar);
        let first = First::new(&q, &dq, at, Held::default());
        let (xi, xi_bar) = (first.delta.beam.xi, first.delta.bar.xi);
        let along = |s: f64| ((at.0 + s * xi).clamp(-1.0, 1.0), (at.1 + s * xi_bar).clamp(-1.0, 1.0));
        let step = self.step.clamp(-1.0, 1.0);
        let moved = q.plus(step, &dq);

        // The scale of both plots contains all that they show.
        let followed_all = all_followed(&q, &dq, &point);
        let corners = [-1.0, 1.0].map(|s| distance(&q.plus(s, &dq), at));
        let high = corners[0].max(corners[1]) + 0.02;
        let low = followed_all.iter().flatten().fold(point.distance, |low, &d| low.min(d)) - 0.03;
        let up = |d: f64| PLOT[3] - (PLOT[3] - PLOT[2]) * ((d - low) / (high - low)).clamp(-0.2, 1.3);
        let curve = |f: &dyn Fn(f64) -> Option<f64>| {
            let place = |x: f64| f(x).map(|d| [across(x), up(d)]);
            (0..=PIECES).map(part).filter_map(place).collect::<Vec<_>>()
        };

        let mut frame = Frame::default();
        let mut levels = String::new();
        for (name, level) in LEVELS {
            levels += &line([[PLOT[0], up(level)], [PLOT[1], up(level)]]);
            frame.place(name, [PLOT[0] - 5.0, up(level) + 5.0]);
            frame.text(name, format!("{level:.2}"));
        }
        frame.paths.insert("levels".into(), levels);
        // Left: the valley's floor along the variation of the parameters, before the step and after it.
        frame.line("floor", curve(&|x| Some(distance(&moved, along(RANGE * x)))));
        frame.line("floor_before", curve(&|x| Some(distance(&q, along(RANGE * x)))));
        let again = followed(&q, &dq, step, &point);
        let frozen = distance(&moved, at);
        frame.place("frozen", [across(0.0), up(frozen)]);
        let slid = |found: &ClosestPoint| {
            let moves = [found.xi - at.0, found.xi_bar - at.1];
            (moves[0] * xi + moves[1] * xi_bar) / (xi * xi + xi_bar * xi_bar)
        };
        let followed_distance = again.map(|found| found.distance);
        let lowest = again.map(|found| [across(slid(&found) / RANGE), up(found.distance)]);
        frame.place_if("lowest", lowest);
        let drop = lowest.map(|lowest| [[across(0.0), up(frozen)], [across(0.0), lowest[1]], lowest]);
        frame.line("drop", drop.into_iter().flatten());

        // Right: the distance over the step.
        let places = (0..=PIECES).map(part).zip(&followed_all);
        frame.line("followed", places.filter_map(|(s, d)| d.map(|d| [across(s), up(d)])));
        frame.line("held", curve(&|s| Some(distance(&q.plus(s, &dq), at))));
        let all = first.seconds(at, Held::default());
        let held = first.seconds(at, Held { xi: true, xi_bar: true });
        let slope = all.d.delta;
        frame.line("slope", curve(&|s| Some(point.distance + s * slope)));
        frame.place("start", [across(0.0), up(point.distance)]);
        frame.place("step", [across(step), PLOT[3]]);
        frame.line("here", [[across(step), PLOT[2]], [across(step), PLOT[3]]]);
        frame.place("held_now", [across(step), up(frozen)]);
        frame.place_if("followed_now", followed_distance.map(|d| [across(step), up(d)]));

        // d = f(p(Q), Q): f,QQ is the second variation with held parameters. f,pp = H/d, and f,Qp p' = -p' f,pp p'.
        let (a, b, a_bar) = (first.projection.a, first.projection.b, first.projection.a_bar);
        let curvature = (a * xi * xi - 2.0 * b * xi * xi_bar - a_bar * xi_bar * xi_bar) / point.distance;
        frame.number("dd", slope);
        frame.number("f_QQ", held.d.second);
        frame.number("f_Qp", -curvature);
        frame.number("f_pp", curvature);
        frame.number("ddd", all.d.second);
        frame.number("dxi", xi);
        frame.number("dxi_bar", xi_bar);
        frame.number("s", step);
        frame.number("d_held", frozen);
        frame.text("d_followed", followed_distance.map_or_else(|| "none".to_owned(), number));
        frame.text("apart", followed_distance.map_or_else(|| "none".to_owned(), |d| number(frozen - d)));
        frame.number("predicted_apart", 0.5 * step * step * curvature);
        frame.controls.insert("step".into(), format!("{step:.2}"));
        Ok(frame)
    }
}

/// d Hess d with frozen parameters: from the terms that the page states, and as computed.
pub fn frozen_part() -> Option<[f64; 2]> {
    let (q, dq) = motion();
    let point = nearest(&q, (0.0, 0.0))?;
    let at = (point.xi, point.xi_bar);
    let first = First::new(&q, &dq, at, Held::default());
    let held = first.seconds(at, Held { xi: true, xi_bar: true });
    Some([first.delta.u_hat.norm_squared() - held.d.delta * held.d.delta, held.d.second * point.distance])
}
