//! The regions that the search for closest points leaves open: why, where, and how near the beams are there.

use beamgap::closest_point::Unresolved;
use serde_json::{Value, json};

/// The region for people.
pub(super) fn described(region: &Unresolved) -> String {
    let Unresolved {
        xi: [xi, to], xi_bar: [xi_bar, to_bar], distance: [low, high], point, continuum, ..
    } = region;
    format!(
        "\nopen region: {continuum}\n  xi from {xi:e} to {to:e}\n  xi_bar from {xi_bar:e} to {to_bar:e}\n  \
         smallest d from {low:e} to {high:e}\n  at xi = {:e}, xi_bar = {:e}\n",
        point.xi, point.xi_bar
    )
}

/// The region as JSON.
pub(super) fn json(region: &Unresolved) -> Value {
    let Unresolved { xi, xi_bar, boxes, distance, point, continuum, .. } = region;
    json!({
        "reason": continuum.to_string(),
        "xi": xi,
        "xi_bar": xi_bar,
        "boxes": boxes,
        "smallest_distance": distance,
        "at": { "xi": point.xi, "xi_bar": point.xi_bar, "distance": point.distance },
    })
}
