//! What is special about the beams, in one sentence.

use super::plane::Landscape;
use crate::frame::number;
use crate::html::{short, whole};
use crate::points::Found;
use crate::situation::nearly_parallel;
use beamgap::closest_point::{Centroid, Degeneracy, End, Side};

/// The sentence of the picture.
pub(super) fn of(
    beams: [&dyn Centroid; 2],
    [radius, radius_bar]: [f64; 2],
    landscape: &Landscape,
    found: Option<&Found>,
    second: Option<f64>,
) -> String {
    let is_open = !landscape.closest.unresolved.is_empty();
    let Some(found) = found else {
        return if is_open {
            "The beams are parallel along a part of their length: no closest point stands alone, and nothing is linearized."
        } else {
            "No minimum of the distance stands alone, and nothing is linearized."
        }
        .to_owned();
    };
    let point = &found.point;
    match point.degeneracy() {
        Some(Degeneracy::Crossing) => {
            return "The centroids cross: d = 0, and the length d has no derivative there.".to_owned();
        }
        Some(Degeneracy::Singular { .. }) => {
            return "D = 0 to rounding: the parameters have no derivative.".to_owned();
        }
        Some(Degeneracy::WeakEnd { .. }) => {
            return "A parameter is about to leave its end: the derivatives to both sides differ.".to_owned();
        }
        Some(Degeneracy::ZeroTangent { which }) => {
            return format!("The tangent of the {which} has no length at the closest point.");
        }
        _ => {}
    }
    if let Some(det) = nearly_parallel(beams, point) {
        let second = second.map(|second| format!(", the second variation of the gap is {}", whole(second)));
        return format!(
            "The beams are nearly parallel: D is {}{}, and the linearization holds for very small steps alone.",
            short(det),
            second.unwrap_or_default()
        );
    }
    let ends = [(point.end, "beam", "ξ"), (point.end_bar, "bar beam", "ξ̄")];
    let ends: Vec<String> = ends
        .into_iter()
        .filter_map(|(end, name, letter)| {
            let End { side, .. } = end?;
            let which = if side == Side::Lower { "first" } else { "second" };
            Some(format!("the {which} end of the {name}, where {letter} is held"))
        })
        .collect();
    if !ends.is_empty() {
        return format!("The closest point is at {}.", ends.join(", and at "));
    }
    let minima = landscape.closest.minima.len();
    if minima > 1 {
        return format!(
            "The distance has {minima} minima, each with a gap of its own; the numbers are those of number {}.",
            found.minimum + 1
        );
    }
    let gap = point.distance - radius - radius_bar;
    if is_open {
        "One minimum stands alone; in the framed region of the map the beams are parallel.".to_owned()
    } else if gap < 0.0 {
        format!("The beams overlap: the gap is {}.", number(gap))
    } else {
        "One closest point inside both beams: all equations of the paper hold.".to_owned()
    }
}
