//! Points at which a tangent has no length, or nearly none: coinciding control points. And points listed more than once.

use crate::centroids::{Cubic, close, line};
use beamgap::closest_point::{
    Centroid, ClosestPoint, ClosestPoints, Continuum, Degeneracy, Held, Kind, ProjectionError, Search, Side,
    closest_points, refine,
};
use beamgap::curve::{Bezier, Hermite, Segment};
use beamgap::number::Which;
use beamgap::pair::{DofVector, Pair};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

const XI: Held = Held { xi: true, xi_bar: false };

/// A cubic Bezier curve and a segment.
fn search(points: [[f64; 3]; 4], bar: [[f64; 3]; 2]) -> ClosestPoints {
    let (pair, q) = pair(points, bar);
    pair.closest_points(&q).unwrap()
}

fn pair(
    points: [[f64; 3]; 4],
    bar: [[f64; 3]; 2],
) -> (Pair<Bezier<4>, Segment, 12, 6>, DofVector<f64, 12, 6>) {
    let q = DofVector::from_slices(&points.concat(), &bar.concat()).unwrap();
    (Pair::new(Bezier::new(), Segment::new()), q)
}

/// The distance of a point from the line through two points.
fn from_line(point: [f64; 3], bar: [[f64; 3]; 2]) -> f64 {
    let [point, a, b] = [point, bar[0], bar[1]].map(Vector3::from);
    (point - a).cross(&(b - a)).norm() / (b - a).norm()
}

/// x = u³ along the first axis with u = (1 + xi)/2: three control points coincide.
const CUBED: [[f64; 3]; 4] = [[0.0; 3], [0.0; 3], [0.0; 3], [1.0, 0.0, 0.0]];

#[test]
fn where_three_control_points_coincide_the_end_is_the_minimum() {
    let reversed = |mut points: [[f64; 3]; 4]| {
        points.reverse();
        points
    };
    for bar in [[[-0.5, -1.0, 0.3], [-0.5, 1.0, 0.4]], [[-0.3, -1.0, 0.3], [0.2, 1.0, 0.4]]] {
        for (points, at, side) in [(CUBED, -1.0, Side::Lower), (reversed(CUBED), 1.0, Side::Upper)] {
            let found = search(points, bar);
            let [point] = found.minima[..] else { panic!("{found:?}") };
            close(point.distance, from_line([0.0; 3], bar), 1e-14);
            assert_eq!((point.xi, point.end.map(|end| (end.side, end.strict))), (at, Some((side, true))));
            assert_eq!(point.degeneracy(), Some(Degeneracy::ZeroTangent { which: Which::Beam }));
            assert!(found.stationary.is_empty(), "{found:?}");
            assert_eq!(found.interior(), Err(ProjectionError::NoInteriorMinimum));
            for region in &found.unresolved {
                assert_eq!(region.continuum, Continuum::ZeroTangent { which: Which::Beam });
            }
        }
    }
}

#[test]
fn where_the_distance_decreases_from_three_equal_control_points_the_end_is_no_minimum() {
    // The foot is at x = 0.5 = u³.
    let bar = [[0.5, -1.0, 0.3], [0.5, 1.0, 0.4]];
    let found = search(CUBED, bar);
    let [point] = found.minima[..] else { panic!("{found:?}") };
    close(point.xi, 2.0 * 0.5_f64.cbrt() - 1.0, 1e-14);
    assert!(found.stationary.is_empty(), "{found:?}");
    assert_eq!(found.interior(), Ok(&point));
}

/// A point whose d is not normal to a free tangent is not stationary, unless this tangent has no length.
fn assert_stationary(found: &ClosestPoints) {
    for point in found.minima.iter().chain(&found.stationary) {
        assert!(point.residual < 1e-6, "{point:?}");
        assert!(!point.conditioning.is_nan(), "{point:?}");
    }
}

#[test]
fn newtons_method_does_not_end_where_only_the_tangent_vanishes() {
    let bar = [[-0.5, -1.0, 0.3], [-0.5, 1.0, 0.4]];
    let (pair, q) = pair(CUBED, bar);
    for start in [-1.0, -0.999, -0.9, -0.5, 0.0, 0.5] {
        match pair.refine(&q, (start, 0.1), Held::default()) {
            Ok(point) => panic!("{start}: {point:?}"),
            Err(ProjectionError::Singular { conditioning }) => assert!(!conditioning.is_nan()),
            Err(error) => assert!(!matches!(error, ProjectionError::NonFinite), "{error}"),
        }
    }
    let held = pair.refine(&q, (-1.0, 0.1), XI).unwrap();
    close(held.distance, from_line([0.0; 3], bar), 1e-14);
    assert_eq!(held.kind, Kind::Minimum);
}

#[test]
fn two_equal_control_points_at_an_end_are_one_point() {
    let points = [[0.0; 3], [0.0; 3], [1.0, 0.2, 0.0], [1.0, 0.0, 0.0]];
    for bar in [[[-0.5, -1.0, 0.3], [-0.5, 1.0, 0.4]], [[-0.3, -1.0, 0.3], [0.2, 1.0, 0.4]]] {
        let found = search(points, bar);
        let at_end: Vec<_> = found.minima.iter().filter(|point| point.xi < -0.99).collect();
        let [point] = at_end[..] else { panic!("{found:?}") };
        close(point.distance, from_line([0.0; 3], bar), 1e-14);
        assert_eq!(point.held(), XI);
        assert!(found.stationary.iter().all(|point| point.xi > -0.99), "{found:?}");
        assert_stationary(&found);
    }
    let found = search(points, [[0.5, -1.0, 0.3], [0.5, 1.0, 0.4]]);
    assert!(found.minima.iter().chain(&found.stationary).all(|point| point.xi > -0.99), "{found:?}");
    assert_stationary(&found);
}

/// The curvature of a beam whose parameter is held has no effect, however short its tangent is.
#[test]
fn a_held_parameter_does_not_make_a_point_singular() {
    let bar = [[-0.5, -1.0, 0.3], [-0.5, 1.0, 0.4]];
    for apart in [1e-6, 1e-8, 1e-9] {
        let points = [[0.0; 3], [apart, 0.0, 0.0], [0.5, 0.2, 0.0], [1.0, 0.0, 0.0]];
        let (pair, q) = pair(points, bar);
        let point = pair.refine(&q, (-1.0, 0.1), XI).unwrap();
        assert_eq!(point.degeneracy(), None, "{point:?}");
        close(point.conditioning, 1.0, 1e-14);
        close(point.distance, from_line([0.0; 3], bar), 1e-14);
        let found = pair.closest_points(&q).unwrap();
        assert_eq!((found.minima[0].held(), found.minima[0].degeneracy()), (XI, None), "{found:?}");
    }
}

#[test]
fn a_point_at_an_end_that_is_not_held_has_one_sided_derivatives() {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    // The bar crosses above xi = 1 or xi = -1.
    for at in [1.0, -1.0] {
        let bar = line([at, 0.0, 0.5], [0.0, 1.0, 0.0], -1.0, 1.0);
        let point = refine(&x, &bar, (at, 0.0), Held::default()).unwrap();
        assert_eq!((point.xi, point.end), (at, None));
        assert!(matches!(point.degeneracy(), Some(Degeneracy::WeakEnd { .. })), "{point:?}");
        let point = refine(&bar, &x, (0.0, at), Held::default()).unwrap();
        assert!(matches!(point.degeneracy(), Some(Degeneracy::WeakEnd { .. })), "{point:?}");
    }
    let inside = line([0.5, 0.0, 0.5], [0.0, 1.0, 0.0], -1.0, 1.0);
    assert_eq!(refine(&x, &inside, (0.5, 0.0), Held::default()).unwrap().degeneracy(), None);
}

/// A tangent that is short next to its change: the distance increases from the end only over 1e-7 of the parameter.
#[test]
fn the_end_of_a_beam_that_turns_back_soon_is_a_minimum() {
    for turn in [1e2, 1e4, 2e7, 1e9] {
        // x = s - turn s²/2 + .. along the first axis, with s = 1 + xi; the bar leads away from (-1, 0, 0).
        let x = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, turn, 0.0, 0.0];
        let q: DofVector<f64, 12, 6> = DofVector::from_slices(&x, &[-1.0, 0.0, 0.0, -2.0, 1.0, 0.5]).unwrap();
        let pair = Pair::new(Hermite::new(), Segment::new());
        let found = pair.closest_points(&q).unwrap();
        let corner = found.minima.iter().find(|point| (point.xi, point.xi_bar) == (-1.0, -1.0));
        let corner = corner.unwrap_or_else(|| panic!("{turn}: {found:?}"));
        assert!(corner.is_strict() && corner.degeneracy().is_none(), "{corner:?}");
        close(corner.distance, 1.0, 1e-15);
    }
}

#[test]
fn conditioning_is_a_number() {
    let x = line([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], -1.0, 1.0);
    let zero = Vector3::zeros();
    let cusp = Cubic([Vector3::new(0.25, 0.0, 0.0), zero, Vector3::new(0.0, 0.5, -1.0), Vector3::y()]);
    let still = Cubic([Vector3::new(0.25, 0.0, 0.0), zero, zero, Vector3::y()]);
    for curve in [cusp, still] {
        let found = closest_points(&x, &curve, &Search::default()).unwrap();
        assert_stationary(&found);
        for held in [Held::default(), XI, Held { xi: false, xi_bar: true }] {
            if let Ok(point) = refine(&x, &curve, (0.25, 0.0), held) {
                assert!(!point.conditioning.is_nan(), "{held:?} {point:?}");
            }
        }
    }
}

/// Whether two minima are the same up to the rounding of the positions.
fn repeated(found: &ClosestPoints, size: f64) -> bool {
    let same = |p: &ClosestPoint, q: &ClosestPoint| {
        (p.xi - q.xi).abs() < 1e-15 * size + 1e-9 && (p.xi_bar - q.xi_bar).abs() < 1e-9
    };
    let minima = &found.minima;
    (0..minima.len()).any(|i| minima[..i].iter().any(|known| same(known, &minima[i])))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    /// A beam of length 1, and one 1e6 to 1e13 times as long that passes by. The last digit of the long beam's parameter
    /// moves the foot on the short beam.
    #[test]
    fn beams_of_unlike_lengths_have_each_minimum_once(
        short in prop::array::uniform12(-1.0..1.0_f64),
        long in prop::array::uniform12(-1.0..1.0_f64),
        exponent in 6..=13_i32,
        at in -1.0..1.0_f64,
        at_bar in -1.0..1.0_f64,
        offset in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let size = 10.0_f64.powi(exponent);
        let (curve, q) = (Hermite::new(), SVector::from(short));
        let mut q_bar = SVector::from(long) * size;
        let point = |q: &SVector<f64, 12>, xi: f64| beamgap::curve::Curve::position(&curve, q, xi);
        let by = point(&q, at) + Vector3::from(offset) - point(&q_bar, at_bar);
        for node in [0, 6] {
            for i in 0..3 {
                q_bar[node + i] += by[i];
            }
        }
        let pair = Pair::new(curve, curve);
        let found = pair.closest_points(&DofVector { beam: q, bar: q_bar }).unwrap();
        prop_assert!(!repeated(&found, size), "{:?}", found.minima);
    }

    /// Cubics with coinciding control points, inside and at the ends.
    #[test]
    fn what_is_listed_is_stationary(
        points in prop::array::uniform4(prop::array::uniform3((-2..=2_i32).prop_map(f64::from))),
        equal in 0..6_usize,
        bar in prop::array::uniform2(prop::array::uniform3(-2.0..2.0_f64)),
    ) {
        let mut points = points;
        for (i, j) in [(0, 1), (1, 2), (2, 3)] {
            if equal & (1 << i) != 0 {
                points[j] = points[i];
            }
        }
        let (pair, q) = pair(points, bar);
        let Ok(found) = pair.closest_points(&q) else { return Ok(()) };
        assert_stationary(&found);
        // Independent: no point of a grid is nearer than the nearest minimum or the nearest open region.
        let (x, bar) = pair.centroids(&q);
        let listed = found.minima.iter().map(|point| point.distance);
        let smallest = listed.chain(found.unresolved.iter().map(|region| region.distance[0])).fold(f64::INFINITY, f64::min);
        for i in 0..=40 {
            for j in 0..=40 {
                let (xi, xi_bar) = (f64::from(i) / 20.0 - 1.0, f64::from(j) / 20.0 - 1.0);
                let there = (x.geometry(xi).x - bar.geometry(xi_bar).x).norm();
                prop_assert!(there >= smallest - 1e-12, "{there} at ({xi}, {xi_bar}) in {found:?}");
            }
        }
    }
}
