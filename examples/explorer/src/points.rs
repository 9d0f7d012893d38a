//! The closest points: the search, and the table.

use crate::html::{number, short, table};
use beamgap::check::CaseData;
use beamgap::closest_point::{
    Centroid, ClosestPoint, ClosestPoints, End, Kind, Search, Side, closest_points,
};
use beamgap::linearization::closed_form::Projection;
use std::fmt::Write;

/// The point that the numbers belong to.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) point: ClosestPoint,
    /// The index of the point among the minima.
    pub(crate) minimum: usize,
}

/// All closest points; the `minimum`-th is selected, or the last one.
///
/// # Errors
/// The reason why the search has no result.
pub(crate) fn find(
    centroids: [&dyn Centroid; 2],
    minimum: usize,
) -> Result<(ClosestPoints, Option<Found>), String> {
    let [beam, bar] = centroids;
    let closest = closest_points(beam, bar, &Search::default()).map_err(|error| error.to_string())?;
    let found = select(&closest, minimum);
    Ok((closest, found))
}

/// The selected minimum, or the last one.
pub(crate) fn select(closest: &ClosestPoints, minimum: usize) -> Option<Found> {
    let minimum = minimum.min(closest.minima.len().saturating_sub(1));
    closest.minima.get(minimum).map(|&point| Found { point, minimum })
}

/// The table of all points; a button at each minimum selects it.
pub(crate) fn points(
    case: &CaseData,
    centroids: [&dyn Centroid; 2],
    closest: &ClosestPoints,
    chosen: Option<usize>,
) -> String {
    let radii = case.contact.radius + case.contact.radius_bar;
    let all: Vec<ClosestPoint> = closest.minima.iter().chain(&closest.stationary).copied().collect();
    let geometry =
        |point: &ClosestPoint| [centroids[0].geometry(point.xi), centroids[1].geometry(point.xi_bar)];
    let det = |point: &ClosestPoint| {
        let [x, y] = geometry(point);
        // At an end there is no 2x2 system.
        if point.is_interior() {
            number(Projection::new(&x, &y, point.held()).det())
        } else {
            "–".to_owned()
        }
    };
    let conditioning = |point: &ClosestPoint| {
        if point.conditioning.is_finite() { number(point.conditioning) } else { "–".to_owned() }
    };
    let mut rows = String::new();
    let mut row = |name: &str, of: &dyn Fn(&ClosestPoint) -> String| {
        let cells: Vec<_> = all.iter().map(|point| format!("<td>{}</td>", of(point))).collect();
        let cells = cells.concat();
        let _ = writeln!(rows, "<tr><th scope=\"row\">{name}</th>{cells}</tr>");
    };
    row("kind", &|point| kind(point.kind).to_owned());
    row("ξ", &|point| parameter(point.xi, point.end));
    row("ξ̄", &|point| parameter(point.xi_bar, point.end_bar));
    row("distance d", &|point| number(point.distance));
    row("gap g<sub>N</sub>", &|point| number(point.distance - radii));
    row("t", &|point| number(geometry(point)[0].t.norm()));
    row("t̄", &|point| number(geometry(point)[1].t.norm()));
    row("D", &det);
    row("conditioning", &conditioning);
    row("cosine of d to a free tangent", &|point| short(point.residual));
    let heads: Vec<String> = (0..all.len())
        .map(|i| match (all[i].kind, chosen == Some(i)) {
            (_, true) => "shown".to_owned(),
            (Kind::Minimum, false) => format!("<button type=\"button\" data-minimum=\"{i}\">show</button>"),
            _ => "stationary".to_owned(),
        })
        .collect();
    let heads: Vec<&str> = ["point"].into_iter().chain(heads.iter().map(String::as_str)).collect();
    table("closest points", &heads, &rows)
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Minimum => "minimum",
        Kind::Saddle => "saddle",
        Kind::Maximum => "maximum",
    }
}

fn parameter(xi: f64, end: Option<End>) -> String {
    let held = match end {
        Some(End { side: Side::Lower, .. }) => ", first end",
        Some(End { side: Side::Upper, .. }) => ", second end",
        None => "",
    };
    number(xi) + held
}
