//! The part of space that is in both beams, as the outline of what is seen of it.
//!
//! Where the distance d of two points x and x_bar of the axes is less than r + r_bar, all points between x - n r and
//! x_bar + n r_bar are in both tubes. The outline is the convex hull of such pairs around the closest point.

use crate::frame::Frame;
use crate::view::View;
use beamgap::closest_point::{Centroid, ClosestPoints, SquaredDistance};

/// Rings of pairs around the closest point, as parts of the radius at which the surfaces meet.
const RINGS: [f64; 4] = [0.0, 0.4, 0.75, 0.97];
/// The pairs of a ring.
const AROUND: u8 = 24;
/// The smallest curvature of the distance that is used, as a part of the square of a tangent.
const FLAT: f64 = 1e-6;

/// Draws the overlap at each minimum, and where the beams are parallel.
pub(super) fn draw(
    frame: &mut Frame,
    view: &View,
    [beam, bar]: [&dyn Centroid; 2],
    [radius, radius_bar]: [f64; 2],
    closest: &ClosestPoints,
) {
    let mut outlines = String::new();
    let regions = closest.unresolved.iter().map(|region| &region.point);
    for point in closest.minima.iter().chain(regions).take(4) {
        let reach = radius + radius_bar;
        if point.distance >= reach {
            continue;
        }
        let at = SquaredDistance::new(&beam.geometry(point.xi), &bar.geometry(point.xi_bar));
        // d² + pᵀHp = (r + r̄)² around the point, with the Hessian H = [[a, −b], [−b, −ā]] of d²/2 as L Lᵀ
        let size = (reach * reach - point.distance * point.distance).sqrt();
        let l11 = at.a.max(FLAT).sqrt();
        let l21 = -at.b / l11;
        let l22 = (-at.a_bar - l21 * l21).max(FLAT * l11 * l11).sqrt();
        let mut seen = Vec::new();
        for ring in RINGS {
            for i in 0..AROUND {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(AROUND)).sin_cos();
                let y = ring * size * sin / l22;
                let x = (ring * size * cos - l21 * y) / l11;
                let xi = (point.xi + x).clamp(-1.0, 1.0);
                let xi_bar = (point.xi_bar + y).clamp(-1.0, 1.0);
                let (x, y) = (beam.geometry(xi).x, bar.geometry(xi_bar).x);
                let d = (x - y).norm();
                if d < reach && d > 0.0 {
                    let n = (x - y) / d;
                    seen.extend([x - n * radius, y + n * radius_bar].map(|x| view.at(&x)));
                }
            }
        }
        crate::frame::push_line(&mut outlines, hull(seen));
    }
    if !outlines.is_empty() {
        outlines.push('z');
    }
    frame.paths.insert("overlap".into(), outlines);
}

/// The convex hull of points, counterclockwise.
pub fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
    points.dedup();
    let mut hull: Vec<[f64; 2]> = Vec::new();
    let turns_left = |o: [f64; 2], p: [f64; 2], q: [f64; 2]| {
        (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]) > 0.0
    };
    let mut half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let start = hull.len();
        for point in points {
            while hull.len() >= start + 2 && !turns_left(hull[hull.len() - 2], hull[hull.len() - 1], point) {
                hull.pop();
            }
            hull.push(point);
        }
        hull.pop();
    };
    half(&mut points.iter().copied());
    half(&mut points.iter().rev().copied());
    hull
}
