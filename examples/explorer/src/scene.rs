//! The picture: both beams, their closest points, and the varied state.

use crate::draw::{arrow, dot, path, text};
use crate::handles::Handle;
use crate::points::Found;
use crate::prediction::Varied;
use crate::state::State;
use crate::view::View;
use beamgap::closest_point::{Centroid, ClosestPoint, Kind};
use beamgap::nalgebra::Vector3;

/// The number of pieces of a drawn beam.
const PIECES: u32 = 32;
/// The fraction of the next piece that each piece covers, so that no gap is visible between them.
const OVERLAP: f64 = 0.3;
/// The length of a tangent in the picture.
const TANGENT: f64 = 90.0;

/// The colours of beam and bar beam.
const COLOURS: [&str; 2] = ["b", "r"];

/// The picture without its frame.
pub(crate) fn scene(
    state: &State,
    view: &View,
    centroids: [&dyn Centroid; 2],
    found: Option<&Found>,
    varied: Option<&Varied>,
    handles: &[Handle],
) -> String {
    let radii = [state.contact.radius, state.contact.radius_bar];
    let mut body = tubes(view, centroids, radii);
    if let Some(varied) = varied {
        body += &of_varied(view, varied);
    }
    for handle in handles {
        if handle.is_rod {
            body += &path(&format!("rod {}", COLOURS[handle.beam]), [handle.from, handle.at]);
        }
    }
    if let Some(found) = found {
        let others = found.closest.minima.iter().chain(&found.closest.stationary);
        for point in others.filter(|point| **point != found.point) {
            body += &other_point(view, centroids, point);
        }
        body += &closest_point(view, centroids, radii, &found.point);
    }
    body
}

/// Both beams. The pieces farthest from the eye come first, so nearer pieces cover them.
fn tubes(view: &View, centroids: [&dyn Centroid; 2], radii: [f64; 2]) -> String {
    let mut pieces: Vec<(f64, String)> = Vec::new();
    for (i, centroid) in centroids.into_iter().enumerate() {
        let at = |s: f64| centroid.geometry((-1.0 + 2.0 * s / f64::from(PIECES)).clamp(-1.0, 1.0)).x;
        // A beam without thickness is drawn as a line.
        let width = (2.0 * radii[i].abs() * view.scale).clamp(1.0, 400.0);
        for piece in 0..PIECES {
            let s = f64::from(piece);
            let middle = at(s + 0.5);
            let seen =
                |overlap: f64| [s - overlap, s, s + 0.5, s + 1.0, s + 1.0 + overlap].map(|s| view.at(&at(s)));
            let colour = COLOURS[i];
            let svg = format!(
                "<g style=\"stroke-width:{:.1}\">{}</g><g style=\"stroke-width:{width:.1}\">{}</g>{}",
                width + 6.0,
                path("halo", seen(0.0)),
                path(&format!("tube {colour}"), seen(OVERLAP)),
                path(&format!("axis {colour}"), seen(OVERLAP))
            );
            pieces.push((view.depth(&middle), svg));
        }
    }
    pieces.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    pieces.into_iter().map(|(_, svg)| svg).collect()
}

/// d, both tangents and the gap at the selected closest point.
fn closest_point(
    view: &View,
    centroids: [&dyn Centroid; 2],
    radii: [f64; 2],
    point: &ClosestPoint,
) -> String {
    let [x, y] = [centroids[0].geometry(point.xi), centroids[1].geometry(point.xi_bar)];
    let [at, at_bar] = [x.x, y.x].map(|x| view.at(&x));
    let tangent = |x: &Vector3<f64>, t: &Vector3<f64>| {
        let length = t.norm();
        if length > 0.0 { x + t * (TANGENT / (view.scale * length)) } else { *x }
    };
    let (t, t_bar) = (view.at(&tangent(&x.x, &x.t)), view.at(&tangent(&y.x, &y.t)));
    let d = x.x - y.x;
    let mut body = String::new();
    if point.distance > 0.0 {
        let n = d / point.distance;
        let surfaces = [y.x + n * radii[1], x.x - n * radii[0]];
        let aside = |x: &Vector3<f64>| {
            let [u, v] = view.at(x);
            [u + 14.0, v]
        };
        body += &path("gap", surfaces.each_ref().map(aside));
    }
    body += &(arrow("b", at, t) + &arrow("r", at_bar, t_bar) + &arrow("d", at_bar, at));
    body += &(dot("b", at) + &dot("r", at_bar));
    let letter = |[u, v]: [f64; 2], [right, down]: [f64; 2], class: &str, words: &str| {
        text(&format!("letter {class}"), [u + right, v + down], words)
    };
    let middle = view.at(&((x.x + y.x) * 0.5));
    body += &letter(t, [8.0, -6.0], "b", "t");
    body += &letter(t_bar, [10.0, 14.0], "r", "t̄");
    body += &letter(middle, [-26.0, 6.0], "d", "d");
    body += &letter(middle, [22.0, 6.0], "g", "g<tspan dy=\"5\" font-size=\"13\">N</tspan>");
    body
}

/// Another stationary point.
fn other_point(view: &View, centroids: [&dyn Centroid; 2], point: &ClosestPoint) -> String {
    let [at, at_bar] =
        [centroids[0].geometry(point.xi), centroids[1].geometry(point.xi_bar)].map(|x| view.at(&x.x));
    let class = if point.kind == Kind::Minimum { "" } else { " faint" };
    path(&format!("dashed d{class}"), [at, at_bar])
        + &dot(&format!("b hollow{class}"), at)
        + &dot(&format!("r hollow{class}"), at_bar)
}

/// The centroids moved along the direction, dashed, with their closest points.
fn of_varied(view: &View, varied: &Varied) -> String {
    let mut body = String::new();
    for (centroid, colour) in varied.centroids.iter().zip(COLOURS) {
        let at = |i: u32| view.at(&centroid.geometry(-1.0 + 2.0 * f64::from(i) / f64::from(PIECES)).x);
        body += &path(&format!("dashed {colour}"), (0..=PIECES).map(at));
    }
    if let Some(point) = &varied.point {
        let [beam, bar] = &varied.centroids;
        let [at, at_bar] = [beam.geometry(point.xi), bar.geometry(point.xi_bar)].map(|x| view.at(&x.x));
        body += &(path("dashed d", [at, at_bar]) + &dot("b hollow", at) + &dot("r hollow", at_bar));
    }
    body
}
