//! Continua of nearest points: the smallest distance of each open region, one of its points, and the kind of continuum.
//!
//! The expected distances of segments are those of their ends from the other segment. Those of circles are by hand.

mod curved;

use crate::centroids::{Cubic, close};
use beamgap::closest_point::{
    Centroid, ClosestPoints, Continuum, Degeneracy, ProjectionError, Search, Unresolved, closest_points,
};
use beamgap::curve::{Bezier, Hermite, Segment};
use beamgap::number::Which;
use beamgap::pair::{DofVector, Pair};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use std::f64::consts::TAU;

fn search(x: &dyn Centroid, bar: &dyn Centroid) -> ClosestPoints {
    closest_points(x, bar, &Search::default()).unwrap()
}

fn segments(ends: [[f64; 3]; 2], ends_bar: [[f64; 3]; 2]) -> ClosestPoints {
    let q: DofVector<f64, 6, 6> = DofVector::from_slices(&ends.concat(), &ends_bar.concat()).unwrap();
    Pair::new(Segment::new(), Segment::new()).closest_points(&q).unwrap()
}

/// The distance of two parallel segments: the smallest one of an end from the other segment.
fn by_ends(ends: [[f64; 3]; 2], ends_bar: [[f64; 3]; 2]) -> f64 {
    let to = |point: [f64; 3], [a, b]: [[f64; 3]; 2]| {
        let [point, a, b] = [point, a, b].map(Vector3::from);
        let along = b - a;
        let at = ((point - a).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        (point - a - along * at).norm()
    };
    let all = [to(ends[0], ends_bar), to(ends[1], ends_bar), to(ends_bar[0], ends), to(ends_bar[1], ends)];
    all.into_iter().fold(f64::INFINITY, f64::min)
}

/// The smallest distance found, over minima and open regions.
fn smallest(found: &ClosestPoints) -> f64 {
    let regions = found.unresolved.iter().map(|region| region.point.distance);
    found.minima.iter().map(|point| point.distance).chain(regions).fold(f64::INFINITY, f64::min)
}

/// The nearest open region.
fn nearest(found: &ClosestPoints) -> Unresolved {
    *found.unresolved.iter().min_by(|p, q| p.point.distance.total_cmp(&q.point.distance)).unwrap()
}

/// Asserts that a region has this smallest distance, and that its point has it too.
#[track_caller]
fn assert_distance(region: &Unresolved, curves: [&dyn Centroid; 2], expected: f64, width: f64) {
    let [low, high] = region.distance;
    assert!(low <= expected + 1e-14 && expected - 1e-14 <= high, "{expected} is not in {region:?}");
    assert!((high - expected).abs() < 1e-14 && high - low <= width, "{region:?}");
    let point = region.point;
    let there = (curves[0].geometry(point.xi).x - curves[1].geometry(point.xi_bar).x).norm();
    assert!((there - expected).abs() < 1e-14 && point.distance.to_bits() == high.to_bits(), "{region:?}");
    let contains = |[low, high]: [f64; 2], at: f64| low <= at && at <= high;
    assert!(contains(region.xi, point.xi) && contains(region.xi_bar, point.xi_bar), "{region:?}");
}

#[test]
fn parallel_beams_that_overlap_a_little_have_a_distance() {
    let (x, bar) = ([[0.0; 3], [1.0, 0.0, 0.0]], [[0.999, 0.001, 0.0], [10.999, 0.001, 0.0]]);
    for found in [segments(x, bar), segments([x[1], x[0]], bar), segments(bar, x)] {
        let [region] = found.unresolved[..] else { panic!("{found:?}") };
        close(region.point.distance, 0.001, 1e-12);
        assert!(region.distance[0] <= 0.001 && region.distance[0] > 0.001 - 1e-11, "{region:?}");
        assert_eq!(region.continuum, Continuum::Parallel);
        assert!(region.point.residual < 1e-12, "{region:?}");
    }
}

#[test]
fn collinear_beams_that_overlap_touch() {
    let x = [[0.0; 3], [1.0, 0.0, 0.0]];
    for (from, to) in [(0.5, 2.5), (-3.0, 0.25), (0.25, 0.5), (0.999, 11.0), (1.75, 0.75)] {
        let found = segments(x, [[from, 0.0, 0.0], [to, 0.0, 0.0]]);
        let [region] = found.unresolved[..] else { panic!("{found:?}") };
        assert_eq!((region.distance[0], region.continuum), (0.0, Continuum::Collinear));
        assert!(region.distance[1] < 1e-14, "{region:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

    /// Parallel up to the rounding of the ends: overlapping a lot, a little or not at all, reversed, and of unlike lengths.
    #[test]
    fn parallel_pairs_have_the_distance_of_their_ends(
        origin in prop::array::uniform3(-2.0..2.0_f64),
        direction in prop::array::uniform3(-1.0..1.0_f64),
        offset in prop::array::uniform3(-1.0..1.0_f64),
        size in -6..=0_i32,
        along in -1.5..1.5_f64,
        log_length in -3.0..3.0_f64,
        reversed: bool,
    ) {
        let (origin, direction) = (Vector3::from(origin), Vector3::from(direction));
        prop_assume!(direction.norm() > 0.1);
        let length = if reversed { -log_length.exp() } else { log_length.exp() };
        let start = origin + direction * along + Vector3::from(offset) * 10.0_f64.powi(size);
        let ends = [origin, origin + direction].map(Into::into);
        let ends_bar = [start, start + direction * length].map(Into::into);
        let (found, expected) = (segments(ends, ends_bar), by_ends(ends, ends_bar));
        let scale = 1.0 + origin.norm() + direction.norm() * (1.0 + length.abs());
        let distance = smallest(&found);
        prop_assert!((distance - expected).abs() < 1e-13 * scale, "{distance} is not {expected}: {found:?}");
        for region in &found.unresolved {
            let [low, high] = region.distance;
            prop_assert!(low <= expected + 1e-13 * scale && expected - 1e-13 * scale <= high, "{region:?}, {expected}");
            prop_assert!(high - low < 1e-12 * scale, "{region:?}");
            prop_assert!(region.continuum == Continuum::Parallel, "{region:?}");
        }
    }

    /// Angles at which rounding decides whether the minimum is a point.
    #[test]
    fn nearly_parallel_pairs_have_the_distance_of_their_ends(
        exponent in -10.0..-5.0_f64,
        turn in 0.0..TAU,
        along in -1.5..1.5_f64,
        gap in 0.01..1.0_f64,
    ) {
        let angle = 10.0_f64.powf(exponent);
        let direction = [1.0, angle * turn.cos(), angle * turn.sin()];
        let end = [along + direction[0], gap + direction[1], direction[2]];
        let (ends, ends_bar) = ([[0.0; 3], [1.0, 0.0, 0.0]], [[along, gap, 0.0], end]);
        let (found, expected) = (segments(ends, ends_bar), by_ends(ends, ends_bar));
        // The minimum may lie inside both, but then it is nearer by the gap times the square of the angle.
        let nearer = gap * angle * angle;
        let distance = smallest(&found);
        prop_assert!(distance <= expected + 1e-14 && distance >= expected - nearer - 1e-14, "{distance}, {expected}: {found:?}");
    }
}

#[test]
fn straight_beams_of_higher_degree_are_parallel_too() {
    // One of uniform speed, and one whose speed changes along the line.
    for speeds in [[1.0, 1.0], [0.5, 2.0]] {
        let q = SVector::from([0.0, 0.0, 0.0, speeds[0], 0.0, 0.0, 2.0, 0.0, 0.0, speeds[1], 0.0, 0.0]);
        let bar = SVector::from([1.0, 0.25, 0.0, 1.5, 0.25, 0.0, 2.5, 0.25, 0.0, 4.0, 0.25, 0.0]);
        let (pair, q) = (Pair::new(Hermite::new(), Bezier::<4>::new()), DofVector { beam: q, bar });
        let found = pair.closest_points(&q).unwrap();
        let [region] = found.unresolved[..] else { panic!("{found:?}") };
        let (x, bar) = pair.centroids(&q);
        assert_distance(&region, [&x, &bar], 0.25, 1e-5);
        assert_eq!(region.continuum, Continuum::Parallel);
    }
}

#[test]
fn beams_that_meet_end_to_end_on_one_line_have_one_closest_point() {
    let x = [[0.0; 3], [1.0, 0.0, 0.0]];
    for gap in [0.0, 1e-3, 0.5] {
        let (near, far) = ([1.0 + gap, 0.0, 0.0], [3.5, 0.0, 0.0]);
        for (ends, at) in [([near, far], -1.0), ([far, near], 1.0)] {
            let found = segments(x, ends);
            assert!(found.is_complete() && found.stationary.is_empty(), "{found:?}");
            let [point] = found.minima[..] else { panic!("{found:?}") };
            assert_eq!((point.xi, point.xi_bar), (1.0, at));
            assert!((point.distance - gap).abs() < 1e-15);
            assert_eq!(found.interior(), Err(ProjectionError::NoInteriorMinimum));
        }
    }
    // One end above the other, which is the last point of the overlap.
    let found = segments(x, [[1.0, 0.5, 0.0], [2.0, 0.5, 0.0]]);
    assert!(found.is_complete(), "{found:?}");
    let [point] = found.minima[..] else { panic!("{found:?}") };
    assert_eq!((point.xi, point.xi_bar, point.distance), (1.0, -1.0, 0.5));
    assert!(matches!(point.degeneracy(), Some(Degeneracy::WeakEnd { .. })));
}

/// Neither the reasons nor the digits depend on the unit of length, also where fourth powers of lengths overflow.
#[test]
fn continua_are_the_same_in_all_units() {
    let pairs = [
        // parallel, collinear, end to end, and across each other
        ([[0.0; 3], [1.0, 0.0, 0.0]], [[0.5, 0.25, 0.0], [2.5, 0.25, 0.0]]),
        ([[0.0; 3], [1.0, 0.0, 0.0]], [[0.5, 0.0, 0.0], [2.5, 0.0, 0.0]]),
        ([[0.0; 3], [1.0, 0.0, 0.0]], [[1.0, 0.0, 0.0], [2.5, 0.0, 0.0]]),
        ([[0.0; 3], [1.0, 0.0, 0.0]], [[0.5, -1.0, 0.25], [0.5, 1.0, 0.25]]),
        // a beam of length zero
        ([[0.0; 3], [1.0, 0.0, 0.0]], [[0.5, 0.0, 0.25], [0.5, 0.0, 0.25]]),
    ];
    let pair = Pair::new(Segment::new(), Segment::new());
    for (ends, ends_bar) in pairs {
        let found = |exponent: i32| {
            let factor = 2.0_f64.powi(exponent);
            let scaled = |ends: [[f64; 3]; 2]| ends.concat().iter().map(|x| x * factor).collect::<Vec<_>>();
            let q: DofVector<f64, 6, 6> = DofVector::from_slices(&scaled(ends), &scaled(ends_bar)).unwrap();
            pair.closest_points(&q).map(|mut found| {
                for point in &mut found.minima {
                    point.distance /= factor;
                }
                for region in &mut found.unresolved {
                    region.point.distance /= factor;
                    region.distance = region.distance.map(|distance| distance / factor);
                }
                found
            })
        };
        let usual = found(0);
        for exponent in [-480, -300, -266, -100, 100, 266, 300, 480] {
            assert_eq!(found(exponent), usual, "2^{exponent}");
        }
    }
}

#[test]
fn the_kinds_of_continua_have_words() {
    let words = [
        (Continuum::Parallel, "the centroids are parallel"),
        (Continuum::Collinear, "the centroids are collinear and overlap"),
        (Continuum::Concentric, "the centroids are concentric"),
        (Continuum::Coincident, "the centroids coincide"),
        (
            Continuum::CentreOfArc { which: Which::Beam },
            "a point of the bar beam is at the centre of an arc of the beam",
        ),
        (
            Continuum::CentreOfArc { which: Which::Bar },
            "a point of the beam is at the centre of an arc of the bar beam",
        ),
        (Continuum::ZeroTangent { which: Which::Bar }, "the tangent of the bar beam has no length"),
    ];
    for (continuum, expected) in words {
        assert_eq!(continuum.to_string(), expected);
    }
}

/// A curve in contact with itself: (s³ - s, s², h s), whose ends pass each other near s = ±1.
///
/// It is symmetric under s -> -s. The squared distance of s and -s is 4 u ((u - 1)² + h²) with u = s², and its minimum is
/// at 3 u² - 4 u + 1 + h² = 0.
#[test]
fn a_curve_touches_itself_apart_from_the_diagonal() {
    let (h, end) = (0.2_f64, 1.5_f64);
    let along = |x: f64, y: f64, z: f64| Vector3::new(x, y, z);
    let coefficients = [
        Vector3::zeros(),
        along(-end, 0.0, h * end),
        along(0.0, end * end, 0.0),
        along(end.powi(3), 0.0, 0.0),
    ];
    let curve = Cubic(coefficients);
    let found = search(&curve, &curve);
    assert!(found.unresolved.iter().any(|region| region.continuum == Continuum::Coincident), "{found:?}");
    assert!(smallest(&found) < 1e-14 && found.interior().is_err(), "{found:?}");
    let u = (2.0 + (1.0 - 3.0 * h * h).sqrt()) / 3.0;
    let (at, distance) = (u.sqrt() / end, 2.0 * (u * ((u - 1.0).powi(2) + h * h)).sqrt());
    for width in [0.125, 0.5, 1.0] {
        let found = closest_points(&curve, &curve, &Search::default().without_diagonal(width)).unwrap();
        assert!(found.is_complete(), "{found:?}");
        let [one, other] = found.minima[..] else { panic!("{found:?}") };
        for point in [one, other] {
            close(point.distance, distance, 1e-14);
            close(point.xi.abs(), at, 1e-14);
            assert!((point.xi + point.xi_bar).abs() < 1e-14 && point.is_interior(), "{point:?}");
        }
        assert!((one.xi + other.xi).abs() < 1e-14, "{found:?}");
        close(found.interior().unwrap().distance, distance, 1e-14);
    }
    // This band contains the minimum, in boxes that reach out of it.
    let width = 2.0 * at + 1e-3;
    let found = closest_points(&curve, &curve, &Search::default().without_diagonal(width)).unwrap();
    let listed = || found.minima.iter().chain(&found.stationary);
    assert!(listed().all(|point| (point.xi - point.xi_bar).abs() >= width), "{found:?}");
}
