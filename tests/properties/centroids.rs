//! Centroids in the parametrization of the sources of the reference values, and pieces of closed curves.

use beamgap::closest_point::{Centroid, ClosestPoint, Search, closest_points};
use beamgap::curve::Geometry;
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// x = centre + cos(s) u + sin(s) v + s w for s in [from, to]: lines, circles, ellipses and helices.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Winding {
    pub(crate) centre: Vector3<f64>,
    pub(crate) u: Vector3<f64>,
    pub(crate) v: Vector3<f64>,
    pub(crate) w: Vector3<f64>,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

pub(crate) fn line(start: [f64; 3], direction: [f64; 3], from: f64, to: f64) -> Winding {
    Winding { centre: start.into(), w: direction.into(), from, to, ..Winding::default() }
}

pub(crate) fn ellipse(centre: [f64; 3], u: [f64; 3], v: [f64; 3]) -> Winding {
    Winding { centre: centre.into(), u: u.into(), v: v.into(), from: 0.0, to: TAU, ..Winding::default() }
}

impl Winding {
    pub(crate) fn over(self, from: f64, to: f64) -> Self {
        Self { from, to, ..self }
    }

    fn half(&self) -> f64 {
        0.5 * (self.to - self.from)
    }

    pub(crate) fn parameter(&self, xi: f64) -> f64 {
        0.5 * (self.from + self.to) + self.half() * xi
    }

    /// The curve divided into `count` equal pieces.
    pub(crate) fn pieces(&self, count: u32) -> Vec<Self> {
        let step = (self.to - self.from) / f64::from(count);
        let from = |i: u32| self.from + step * f64::from(i);
        (0..count).map(|i| self.over(from(i), from(i + 1))).collect()
    }
}

impl Centroid for Winding {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        let (s, h) = (self.parameter(xi), self.half());
        let (sin, cos) = s.sin_cos();
        let (radial, tangential) = (self.u * cos + self.v * sin, self.v * cos - self.u * sin);
        Geometry {
            x: self.centre + radial + self.w * s,
            t: (tangential + self.w) * h,
            t_xi: -radial * h * h,
            t_xixi: -tangential * h * h * h,
        }
    }

    fn third_derivative_bound(&self) -> f64 {
        self.half().powi(3) * (self.u.norm_squared() + self.v.norm_squared()).sqrt()
    }
}

/// x = c₀ + c₁ xi + c₂ xi² + c₃ xi³.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cubic(pub(crate) [Vector3<f64>; 4]);

impl Cubic {
    pub(crate) fn times(&self, factor: f64) -> Self {
        Self(self.0.map(|c| c * factor))
    }
}

impl Centroid for Cubic {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        let [c0, c1, c2, c3] = self.0;
        Geometry {
            x: c0 + (c1 + (c2 + c3 * xi) * xi) * xi,
            t: c1 + (c2 * 2.0 + c3 * (3.0 * xi)) * xi,
            t_xi: c2 * 2.0 + c3 * (6.0 * xi),
            t_xixi: c3 * 6.0,
        }
    }

    fn third_derivative_bound(&self) -> f64 {
        6.0 * self.0[3].norm()
    }
}

/// The points over the union of all pieces at which the distance is stationary. Points strictly at an end of a piece
/// are omitted. Each point is listed once, with the parameters of the closed curves in place of xi and `xi_bar`.
pub(crate) fn over_pieces(curve: &Winding, bar: &Winding, counts: [u32; 2]) -> Vec<ClosestPoint> {
    let mut points: Vec<ClosestPoint> = Vec::new();
    for piece in curve.pieces(counts[0]) {
        for piece_bar in bar.pieces(counts[1]) {
            let found = closest_points(&piece, &piece_bar, &Search::default()).unwrap();
            assert!(found.is_complete(), "{:?}", found.unresolved);
            for mut point in found.minima.into_iter().chain(found.stationary) {
                if [point.end, point.end_bar].into_iter().flatten().any(|end| end.strict) {
                    continue;
                }
                (point.xi, point.xi_bar) = (piece.parameter(point.xi), piece_bar.parameter(point.xi_bar));
                let known = points.iter().any(|other| {
                    apart(other.xi, point.xi) < 1e-9 && apart(other.xi_bar, point.xi_bar) < 1e-9
                });
                if !known {
                    points.push(point);
                }
            }
        }
    }
    points.sort_by(|p, q| p.distance.total_cmp(&q.distance));
    points
}

/// The absolute difference of two angles.
pub(crate) fn apart(a: f64, b: f64) -> f64 {
    let turn = (a - b).rem_euclid(TAU);
    turn.min(TAU - turn)
}

/// Asserts that a value equals the expected one within a relative tolerance.
#[track_caller]
pub(crate) fn close(value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs() / expected.abs();
    assert!(error <= tolerance, "{value} is not {expected}: {error:e}");
}
