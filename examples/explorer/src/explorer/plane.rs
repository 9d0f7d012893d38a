//! The distance over both parameters as a map, with the closest points and the predicted motion of the shown one.

use super::marks::Predicted;
use crate::frame::{Frame, push_line};
use crate::map::{self, Grid};
use crate::points::Found;
use crate::prediction::Varied;
use crate::state::{BeamState, State};
use beamgap::closest_point::{Centroid, ClosestPoint, ClosestPoints, Kind, Search, closest_points};
use beamgap::linearization::Quantity;
use std::cell::RefCell;

/// Lines of equal distance.
const LEVELS: u8 = 5;
/// Points of a kind that the page can show.
const MARKS: usize = 4;

/// What depends on the beams alone.
#[derive(Clone, Debug)]
pub(super) struct Landscape {
    of: [BeamState; 2],
    pub(super) closest: ClosestPoints,
    map: Option<Map>,
}

/// The map of the distance.
#[derive(Clone, Debug)]
struct Map {
    contours: String,
    shades: String,
}

impl Landscape {
    /// The landscape of the beams, with the map or without. The last one is kept: view, step and fault do not change it.
    ///
    /// # Errors
    /// The reason why the search has no result.
    pub(super) fn of(state: &State, beams: [&dyn Centroid; 2], has_map: bool) -> Result<Self, String> {
        thread_local! {
            static LAST: RefCell<Option<Landscape>> = const { RefCell::new(None) };
        }
        let is_same =
            |last: &Self| last.of[0].has_same_curve(&state.beam) && last.of[1].has_same_curve(&state.bar);
        let known = LAST.take().filter(is_same);
        let mut found = match known {
            Some(known) => known,
            None => Self {
                of: [state.beam.clone(), state.bar.clone()],
                closest: closest_points(beams[0], beams[1], &Search::default())
                    .map_err(|error| error.to_string())?,
                map: None,
            },
        };
        if has_map && found.map.is_none() {
            found.map = Some(Map::of(beams));
        }
        LAST.set(Some(found.clone()));
        Ok(found)
    }
}

impl Map {
    fn of(beams: [&dyn Centroid; 2]) -> Self {
        let [grid] = Grid::of(beams, [|at| at.distance]);
        let [low, high] = grid.range();
        let level = |i: u8| low + (high - low) * (f64::from(i) + 0.35) / f64::from(LEVELS);
        let levels: Vec<f64> = (0..LEVELS).map(level).collect();
        Self { contours: grid.contours(&levels), shades: grid.shades() }
    }
}

fn of(point: &ClosestPoint) -> [f64; 2] {
    map::at([point.xi, point.xi_bar])
}

pub(super) fn draw(
    frame: &mut Frame,
    landscape: &Landscape,
    found: Option<&Found>,
    predicted: Option<&Predicted>,
    varied: Option<&Varied>,
) {
    let Landscape { closest, map, .. } = landscape;
    if let Some(map) = map {
        frame.paths.insert("contours".into(), map.contours.clone());
        frame.shades.insert("map".into(), map.shades.clone());
    }
    let saddles: Vec<_> = closest.stationary.iter().filter(|point| point.kind == Kind::Saddle).collect();
    for i in 0..MARKS {
        frame.place_if(format!("minimum{i}"), closest.minima.get(i).map(of));
        frame.place_if(format!("saddle{i}"), saddles.get(i).map(|point| of(point)));
    }
    let mut open = String::new();
    for region in &closest.unresolved {
        let [low, high] = [0, 1].map(|i| map::at([region.xi[i], region.xi_bar[i]]));
        push_line(&mut open, [low, [high[0], low[1]], high, [low[0], high[1]], low]);
    }
    frame.paths.insert("open".into(), open);

    let here = found.map(|found| of(&found.point));
    frame.place_if("here", here);
    frame.place_if("map_varied", varied.and_then(|varied| varied.point.as_ref()).map(of));
    let tip = |all: &[f64]| {
        let [xi, xi_bar] = [Quantity::Xi, Quantity::XiBar].map(|of| all[of.component()].clamp(-1.3, 1.3));
        map::at([xi, xi_bar])
    };
    let moved = predicted.map(|predicted| tip(&predicted.faulty));
    let right = predicted.filter(|predicted| predicted.is_faulty).map(|predicted| tip(&predicted.right));
    for (name, to) in [("map_predicted", moved), ("map_right", right)] {
        match here.zip(to) {
            Some((from, to)) => frame.arrow(name, from, to),
            None => frame.no_path(name),
        }
    }
}
