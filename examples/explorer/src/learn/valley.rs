//! Scene 1: the squared distance as a landscape over both parameters.

use super::camera::Camera;
use super::pair::drawn;
use super::{Scene, rounded};
use crate::frame::{Frame, line, number};
use crate::map::{self, Grid};
use beamgap::closest_point::{
    Centroid, ClosestPoint, ClosestPoints, Kind, Search, SquaredDistance, closest_points,
};
use beamgap::nalgebra::Vector3;
use beamgap::test_beam::{Family, TestBeam};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;

/// Steps of the way down, and the fraction of the slope that a step follows.
const STEPS: usize = 120;
const STEP: f64 = 0.12;
/// Lines of equal distance.
const LEVELS: u8 = 9;

const MINIMA: [[&str; 4]; 3] = [
    ["min0", "low0", "low_bar0", "link0"],
    ["min1", "low1", "low_bar1", "link1"],
    ["min2", "low2", "low_bar2", "link2"],
];
const SADDLES: [&str; 3] = ["saddle0", "saddle1", "saddle2"];

/// The beams, how far the bar beam is turned, and where the walker stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Valley {
    situation: Situation,
    /// Cosine and sine of the angle of the bar beam about the vertical axis.
    turn: [f64; 2],
    at: [f64; 2],
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Situation {
    Crossing,
    Waves,
    Straight,
    Arcs,
}

impl Default for Valley {
    fn default() -> Self {
        Self { situation: Situation::Crossing, turn: [0.4, 0.9165], at: [0.6, -0.75] }
    }
}

fn camera() -> Camera {
    Camera::usual(122.0, [180.0, 170.0])
}

impl Valley {
    /// Both beams; the second is turned about the vertical axis through the origin.
    fn beams(&self) -> Result<[Box<dyn Centroid>; 2], String> {
        let turned = |points: &[f64]| {
            let [cos, sin] = self.turn;
            let of = |x: &[f64]| [cos * x[0] - sin * x[1], sin * x[0] + cos * x[1], x[2]];
            points.chunks_exact(3).flat_map(of).collect::<Vec<_>>()
        };
        let half = [f64::midpoint(1.0, self.turn[0]).max(0.0).sqrt(), self.turn[1] / 2.0];
        let half = if half[0] > 1e-6 { [half[0], half[1] / half[0]] } else { [0.0, 1.0] };
        let arc = |radius: f64, [cos, sin]: [f64; 2]| {
            vec![0.0, 0.0, -1.15, radius, cos, cos, sin, sin, std::f64::consts::FRAC_PI_2]
        };
        let (family, beam, bar) = match self.situation {
            Situation::Crossing => (
                Family::Quadratic,
                vec![-1.15, -0.1, 0.5, 0.0, 0.1, 0.2, 1.15, -0.1, 0.5],
                turned(&[-1.15, 0.0, -0.5, 0.0, 0.0, -0.25, 1.15, 0.0, -0.55]),
            ),
            Situation::Waves => (
                Family::Cubic,
                vec![-1.15, 0.0, 0.1, -0.5, 0.0, 0.5, 0.5, 0.0, 0.0, 1.15, 0.0, 0.5],
                turned(&[-1.15, 0.0, -0.5, -0.4, 0.0, -0.2, 0.4, 0.0, -0.5, 1.15, 0.0, -0.2]),
            ),
            Situation::Straight => (
                Family::Segment,
                vec![-1.15, 0.0, 0.25, 1.15, 0.0, 0.25],
                turned(&[-1.15, 0.0, -0.25, 1.15, 0.0, -0.25]),
            ),
            Situation::Arcs => (Family::Arc, arc(1.45, [1.0, 0.0]), arc(1.0, half)),
        };
        let parameters = if family == Family::Arc { vec![0.8] } else { Vec::new() };
        let made = |q: Vec<f64>| {
            let zeros = vec![0.0; q.len()];
            TestBeam { family, parameters: parameters.clone(), dq: zeros.clone(), linear_dq: zeros, q }
                .centroid()
                .map_err(|error| error.to_string())
        };
        Ok([made(beam)?, made(bar)?])
    }
}

impl Valley {
    /// The end of the bar beam that is on the side of its angle. An arc begins there.
    fn end(&self) -> f64 {
        if self.situation == Situation::Arcs { -1.0 } else { 1.0 }
    }

    /// Goes some steps down.
    fn walk(&mut self, steps: usize) {
        let Ok([beam, bar]) = self.beams() else { return };
        for _ in 0..steps {
            self.at = down([&*beam, &*bar], self.at).map(rounded);
        }
    }
}

/// What depends on the beams alone.
#[derive(Clone, Debug)]
struct Landscape {
    of: (Situation, [f64; 2]),
    contours: String,
    shades: String,
    found: ClosestPoints,
}

/// The landscape of these beams. The last one is kept, since the walker moves in it.
fn landscape(of: (Situation, [f64; 2]), beams: [&dyn Centroid; 2]) -> Result<Landscape, String> {
    thread_local! {
        static LAST: RefCell<Option<Landscape>> = const { RefCell::new(None) };
    }
    let last = LAST.with_borrow(|last| last.as_ref().filter(|last| last.of == of).cloned());
    if let Some(last) = last {
        return Ok(last);
    }
    let [grid] = Grid::of(beams, [|at| at.distance]);
    let [low, high] = grid.range();
    let level = |i: u8| low + (high - low) * (f64::from(i) + 0.35) / f64::from(LEVELS);
    let levels: Vec<f64> = (0..LEVELS).map(level).collect();
    let found = closest_points(beams[0], beams[1], &Search::default()).map_err(|e| e.to_string())?;
    let landscape = Landscape { of, contours: grid.contours(&levels), shades: grid.shades(), found };
    LAST.with_borrow_mut(|last| *last = Some(landscape.clone()));
    Ok(landscape)
}

impl Scene for Valley {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        match handle {
            "walker" => self.at = map::from(to).map(rounded),
            "turn" => {
                let Some(end) = self.beams().ok().map(|[_, bar]| bar.geometry(self.end()).x) else { return };
                let x = camera().on_level(to, end.z);
                let length = (x.x * x.x + x.y * x.y).sqrt();
                if length > 0.05 {
                    // Near the parallel position the handle goes there.
                    let [cos, sin] = [x.x / length, x.y / length];
                    self.turn = if sin.abs() < 0.02 {
                        [1.0_f64.copysign(cos), 0.0]
                    } else {
                        [rounded(cos), rounded(sin)]
                    };
                }
            }
            _ => {}
        }
    }

    fn choose(&mut self, name: &str, value: &str) {
        if name == "walk" {
            self.walk(if value == "end" { STEPS } else { 1 });
            return;
        }
        let turn = match (name, value) {
            ("situation", "crossing") => (Situation::Crossing, [0.4, 0.9165]),
            ("situation", "waves") => (Situation::Waves, [0.9, 0.436]),
            ("situation", "straight") => (Situation::Straight, [1.0, 0.0]),
            ("situation", "arcs") => (Situation::Arcs, [1.0, 0.0]),
            _ => return,
        };
        (self.situation, self.turn) = turn;
    }

    fn frame(&self) -> Result<Frame, String> {
        let beams = self.beams()?;
        let [beam, bar] = beams.each_ref().map(|beam| &**beam);
        let camera = camera();
        let mut frame = Frame::default();
        let at = self.at.map(|xi| xi.clamp(-1.0, 1.0));
        let (x, y) = (beam.geometry(at[0]), bar.geometry(at[1]));
        let here = SquaredDistance::new(&x, &y);
        for (name, beam) in [("beam", beam), ("bar", bar)] {
            frame.line(name, drawn(&camera, |xi| beam.geometry(xi)));
        }
        let [on_beam, on_bar] = [x.x, y.x].map(|x| camera.at(&x));
        frame.line("distance", [on_bar, on_beam]);
        frame.place("point", on_beam);
        frame.place("point_bar", on_bar);
        frame.place("turn", camera.at(&bar.geometry(self.end()).x));
        frame.place("walker", map::at(at));

        let Landscape { contours, shades, found, .. } = landscape((self.situation, self.turn), [beam, bar])?;
        frame.paths.insert("contours".into(), contours);
        frame.shades.insert("map".into(), shades);
        let (way, end) = descent([beam, bar], at);
        frame.paths.insert("way".into(), line(way));
        frame.place("end", map::at(end));
        let [slope, slope_bar] = here.gradient;
        let scale = 0.35 / (x.t.norm() * y.t.norm() * here.distance).max(1e-9).sqrt();
        let tip = |slope: [f64; 2]| {
            let go = |slope: f64| (-slope * scale).clamp(-0.5, 0.5);
            map::at([at[0] + go(slope[0]), at[1] + go(slope[1])])
        };
        frame.arrow("slope", map::at(at), tip([slope, 0.0]));
        frame.arrow("slope_bar", map::at(at), tip([0.0, slope_bar]));

        marks(&mut frame, &camera, [beam, bar], &found);
        frame.number("F", 0.5 * here.distance * here.distance);
        frame.number("F_xi", slope);
        frame.number("F_xi_bar", slope_bar);
        frame.number("d", here.distance);
        frame.number("xi", at[0]);
        frame.number("xi_bar", at[1]);
        frame.text("found", words(&found));
        let in_trough = found.unresolved.first().map(|region| &region.point);
        let smallest = in_trough.or(found.minima.first()).map(|point| point.distance);
        frame.text("smallest", smallest.map_or_else(|| "none".to_owned(), number));
        let situation = serde_json::to_value(self.situation).map_err(|error| error.to_string())?;
        frame.controls.insert("situation".into(), situation.as_str().unwrap_or_default().to_owned());
        Ok(frame)
    }
}

/// The way down from here, against the slope for unit tangents; its last point.
fn descent([beam, bar]: [&dyn Centroid; 2], from: [f64; 2]) -> (Vec<[f64; 2]>, [f64; 2]) {
    let mut at = from;
    let mut way = vec![map::at(at)];
    for _ in 0..STEPS {
        let next = down([beam, bar], at);
        let moved = (next[0] - at[0]).abs() + (next[1] - at[1]).abs();
        at = next;
        way.push(map::at(at));
        if moved < 1e-4 {
            break;
        }
    }
    (way, at)
}

/// One step down, in both parameters, within the square.
fn down([beam, bar]: [&dyn Centroid; 2], at: [f64; 2]) -> [f64; 2] {
    let (x, y) = (beam.geometry(at[0]), bar.geometry(at[1]));
    let slopes = SquaredDistance::new(&x, &y).gradient;
    let squares = [x.t.norm_squared(), y.t.norm_squared()];
    [0, 1].map(|i| (at[i] - STEP * slopes[i] / squares[i].max(1e-9)).clamp(-1.0, 1.0))
}

/// The minima, in both pictures, and the saddles.
fn marks(frame: &mut Frame, camera: &Camera, [beam, bar]: [&dyn Centroid; 2], found: &ClosestPoints) {
    for (i, [on_map, low, low_bar, link]) in MINIMA.into_iter().enumerate() {
        let point = found.minima.get(i);
        let places = point.map(|point| {
            let places: [Vector3<f64>; 2] = [beam.geometry(point.xi).x, bar.geometry(point.xi_bar).x];
            places.map(|x| camera.at(&x))
        });
        frame.place_if(on_map, point.map(|point| map::at([point.xi, point.xi_bar])));
        frame.place_if(low, places.map(|[x, _]| x));
        frame.place_if(low_bar, places.map(|[_, y]| y));
        frame.line(link, places.into_iter().flatten());
    }
    let saddles: Vec<&ClosestPoint> = saddles(found).collect();
    for (i, name) in SADDLES.into_iter().enumerate() {
        frame.place_if(name, saddles.get(i).map(|point| map::at([point.xi, point.xi_bar])));
    }
}

fn saddles(found: &ClosestPoints) -> impl Iterator<Item = &ClosestPoint> {
    found.stationary.iter().filter(|point| point.kind == Kind::Saddle)
}

/// What the search has found.
fn words(found: &ClosestPoints) -> String {
    if !found.unresolved.is_empty() {
        return "A trough: the distance is equally small along a whole line. There is no single closest point."
            .to_owned();
    }
    let count = |n: usize, one: &str, many: &str| match n {
        0 => format!("no {one}"),
        1 => format!("one {one}"),
        n => format!("{n} {many}"),
    };
    let inside = found.minima.iter().filter(|point| point.is_interior()).count();
    let ends = found.minima.len() - inside;
    format!(
        "The search finds {} inside both beams, {} at an end, and {}.",
        count(inside, "minimum", "minima"),
        count(ends, "minimum", "minima"),
        count(saddles(found).count(), "saddle", "saddles")
    )
}
