//! Families of pairs with a known degeneracy: parallel, coaxial, crossing, collapsed or at an end.

use crate::centroids::{Cubic, Winding, close, ellipse, line};
use beamgap::closest_point::{
    Centroid, ClosestPoints, Degeneracy, Held, Kind, ProjectionError, Search, Side, closest_points, refine,
};
use beamgap::curve::{Geometry, Segment};
use beamgap::linearization::ad::{Perturbed, Route, hyper_dual, seeded};
use beamgap::number::Which;
use beamgap::pair::Contact;
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

fn search(x: &Winding, bar: &Winding) -> ClosestPoints {
    closest_points(x, bar, &Search::default()).unwrap()
}

fn circle(radius: f64, height: f64) -> Winding {
    ellipse([0.0, 0.0, height], [radius, 0.0, 0.0], [0.0, radius, 0.0])
}

#[track_caller]
fn assert_singular(found: &ClosestPoints) {
    assert!(matches!(found.interior(), Err(ProjectionError::Singular { .. })), "{found:?}");
    assert!(found.statistics.boxes <= Search::default().boxes);
}

#[test]
fn skew_lines_at_all_angles() {
    for k in 0..=80 {
        let degrees = 10.0_f64.powf(-6.0 + 0.1 * f64::from(k));
        let angle = degrees.to_radians();
        let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
        let bar = line([0.25, 0.0, 0.125], [angle.cos(), angle.sin(), 0.0], -1.0, 1.0);
        let found = search(&x, &bar);
        let conditioning = 2.0 * (0.5 * angle).sin().powi(2);
        if conditioning < 1e-14 {
            assert_singular(&found);
            assert_eq!(found.statistics.boxes, 1);
        } else if conditioning > 2e-14 {
            let point = found.interior().unwrap();
            close(point.distance, 0.125, 1e-15);
            close(point.conditioning, conditioning.min(2.0 - conditioning), 1e-9);
            assert!((point.xi - 0.25).abs() < 1e-15 / conditioning, "{degrees}: {}", point.xi);
            assert!(point.degeneracy().is_none() && found.is_complete());
        }
    }
}

#[test]
fn no_route_finds_numbers_where_the_closest_point_is_not_determined() {
    let (q, none) = (SVector::from([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0]), SVector::zeros());
    let above = q + SVector::from([0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let curve = Segment::new();
    let [beam, bar] = [q, above].map(|q| Perturbed { curve: &curve, q: seeded(&q, &none, &none) });
    for route in [Route::Newton, Route::Stationary] {
        let found = hyper_dual(route, &beam, &bar, (0.0, 0.0), Held::default(), &Contact::default());
        assert!(!found.xi.re.is_finite());
    }
}

#[test]
fn overlapping_parallel_segments_are_singular_at_once() {
    for direction in [[1.0, 0.0, 0.0], [0.3, -0.7, 1.1]] {
        for factor in [0.5, 1.0, -3.0] {
            let x = line([0.0; 3], direction, -1.0, 1.0);
            let bar = line([0.1, 0.2, 0.3], direction.map(|c| c * factor), -1.0, 1.0);
            let found = search(&x, &bar);
            assert_singular(&found);
            assert_eq!(found.statistics.boxes, 1);
        }
    }
}

#[test]
fn parallel_segments_that_do_not_overlap_meet_at_their_ends() {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    let bar = line([3.0, 0.0, 0.5], [1.0, 0.0, 0.0], -1.0, 1.0);
    let found = search(&x, &bar);
    assert!(found.is_complete());
    assert_eq!(found.minima.len(), 1);
    let point = found.minima[0];
    assert_eq!((point.xi, point.xi_bar), (1.0, -1.0));
    assert_eq!(point.end.map(|end| (end.side, end.strict)), Some((Side::Upper, true)));
    assert_eq!(point.end_bar.map(|end| (end.side, end.strict)), Some((Side::Lower, true)));
    close(point.end.unwrap().multiplier, 1.0 / 1.25_f64.sqrt(), 1e-15);
    assert_eq!((point.conditioning, point.degeneracy()), (f64::INFINITY, None));
    assert_eq!(found.interior(), Err(ProjectionError::NoInteriorMinimum));
}

#[test]
fn line_along_the_axis_of_a_circle() {
    let bar = line([0.0; 3], [0.0, 0.0, 1.0], -1.0, 1.5);
    for k in 0..12 {
        let (radius, offset) = (2.0, 2.0 * 0.1_f64.powi(k) * 0.75);
        let bar = Winding { centre: Vector3::new(offset, 0.0, 0.0), ..bar };
        let found = search(&circle(radius, 0.0).over(-2.0, 1.0), &bar);
        let point = found.interior().unwrap();
        close(point.distance, radius - offset, 1e-15);
        close(point.conditioning, offset / radius, 1e-15 / offset);
        assert!(k > 5 || found.is_complete(), "{k} {:?}", found.statistics);
    }
    assert_singular(&search(&circle(2.0, 0.0).over(-2.0, 1.0), &bar));
}

#[test]
fn coaxial_circles() {
    for (radius, height) in [(1.0, 0.5), (0.5, 0.25), (3.0, 0.0), (1.0, 1e-3), (1.0, 0.0)] {
        assert_singular(&search(&circle(1.0, 0.0).over(-1.5, 1.5), &circle(radius, height).over(-1.0, 2.0)));
    }
}

#[test]
fn cross_of_minima() {
    let x = circle(1.0, 0.0).over(-1.0, 1.5);
    let bar = ellipse([1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]).over(2.0, 4.0);
    let found = search(&x, &bar);
    assert_singular(&found);
    close(found.unresolved[0].point.distance, 1.0, 1e-14);
}

/// A singular region matters only if it is the nearest.
#[test]
fn a_continuum_hides_no_nearer_minimum() {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    let mut found = search(&x, &line([0.0, 0.0, 0.5], [1.0, 0.0, 0.0], -1.0, 1.0));
    for (gap, hidden) in [(0.25, false), (0.75, true)] {
        found.minima = search(&x, &line([0.25, 0.0, gap], [0.0, 1.0, 0.0], -1.0, 1.0)).minima;
        assert_eq!(found.interior().is_err(), hidden, "{gap}");
    }
}

/// A line that is finite only at fractions of a power of two. The search evaluates these before Newton's method starts.
struct Holey(Winding);

impl Centroid for Holey {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        let Geometry { x, t, t_xi, t_xixi } = self.0.geometry(xi);
        let x = if (xi * 1024.0).fract() == 0.0 { x } else { x * f64::NAN };
        Geometry { x, t, t_xi, t_xixi }
    }

    fn third_derivative_bound(&self) -> f64 {
        self.0.third_derivative_bound()
    }
}

/// At the centre of curvature of the bar beam, the equation of its parameter is singular.
#[test]
fn newtons_method_tells_where_one_parameter_is_singular() {
    let zero = Vector3::zeros();
    let x = Cubic([Vector3::new(1.0, -1.0, 1.0), Vector3::y(), zero, zero]);
    let bar = Cubic([zero, Vector3::x(), Vector3::z() * 0.5, zero]);
    let found = refine(&x, &bar, (1.0, 0.0), Held { xi: true, xi_bar: false });
    assert!(matches!(found, Err(ProjectionError::Singular { .. })), "{found:?}");
}

#[test]
fn what_is_not_finite_on_the_way_of_newtons_method_is_told() {
    let x = Holey(line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0));
    for start in [[0.3, 0.1, 0.25], [0.3, 1.7, 0.25]] {
        let bar = line(start, [0.1, 1.0, 0.0], -1.0, 1.0);
        let found = closest_points(&x, &bar, &Search::default());
        assert_eq!(found, Err(ProjectionError::NonFinite), "{start:?}");
    }
}

#[test]
fn an_end_at_the_centre_of_an_arc() {
    let x = line([0.0; 3], [0.0, 0.0, 1.0], 0.0, 1.0);
    let bar = circle(1.0, -0.5).over(0.5, 1.5);
    let found = search(&x, &bar);
    assert!(found.minima.is_empty() && !found.is_complete());
    let point = found.unresolved[0].point;
    assert_eq!((point.xi, point.end_bar), (-1.0, None));
    assert!(matches!(point.degeneracy(), Some(Degeneracy::Singular { .. })));
}

#[test]
fn crossing_centroids_are_found() {
    let x = line([0.0; 3], [1.0, 0.25, 0.0], -1.0, 1.0);
    let bar = line([0.25, 0.0625, -0.25], [0.0, 1.0, 0.5], -1.0, 1.0);
    let bar = Winding { centre: bar.centre - bar.w * 0.5 + Vector3::new(0.0, 0.0, 0.25), ..bar };
    let found = search(&x, &bar);
    let point = found.interior().unwrap();
    assert_eq!((point.xi, point.xi_bar, point.distance, point.residual), (0.25, 0.5, 0.0, 0.0));
    assert_eq!(point.degeneracy(), Some(Degeneracy::Crossing));
}

/// The line x = (xi, 0, 0) and a line across it, at `at`.
fn tee(at: f64) -> ClosestPoints {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    search(&x, &line([at, 0.0, 0.5], [0.25, 1.0, 0.125], -1.0, 1.0))
}

#[test]
fn a_minimum_about_an_end_is_reported_once() {
    let end = |found: &ClosestPoints| found.minima[0].end;
    // The bar is inclined: its nearest point to the line is at xi_bar = -4/65, and the foot is 1/65 away.
    for sign in [-1.0, 1.0] {
        for offset in [-3e-15, -1e-15, -2e-16, 0.0, 2e-16, 1e-15, 3e-15] {
            let found = tee(sign * (1.0 + 1.0 / 65.0 * sign + offset));
            assert_eq!((found.minima.len(), found.stationary.len()), (1, 0), "{found:?}");
            assert_eq!(end(&found).map(|end| end.strict), Some(false));
            assert!(matches!(found.minima[0].degeneracy(), Some(Degeneracy::WeakEnd { .. })));
            assert_eq!(found.minima[0].held(), Held { xi: true, xi_bar: false });
        }
        for offset in [1e-11, 1e-9, 1e-7, 1e-5, 1e-3] {
            let inside = tee(sign * (1.0 + 1.0 / 65.0 * sign - offset));
            assert_eq!((inside.minima.len(), end(&inside)), (1, None));
            let outside = tee(sign * (1.0 + 1.0 / 65.0 * sign + offset));
            assert_eq!((outside.minima.len(), outside.minima[0].is_strict()), (1, true));
        }
    }
}

#[test]
fn a_minimum_in_a_corner_may_be_weak_in_both_parameters() {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    let bar = line([1.0, 1.0, 0.25], [0.0, 1.0, 0.0], -1.0, 1.0);
    let found = search(&x, &bar);
    assert_eq!((found.minima.len(), found.stationary.len()), (1, 0), "{found:?}");
    let point = found.minima[0];
    assert_eq!((point.xi, point.xi_bar, point.distance), (1.0, -1.0, 0.25));
    assert!([point.end, point.end_bar].iter().all(|end| end.is_some_and(|end| !end.strict)));
    assert!(!point.is_strict());
}

#[test]
fn input_that_is_not_finite() {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let bar = line([0.0, 0.0, bad], [0.0, 1.0, 0.0], -1.0, 1.0);
        assert_eq!(closest_points(&x, &bar, &Search::default()), Err(ProjectionError::NonFinite));
        assert_eq!(closest_points(&bar, &x, &Search::default()), Err(ProjectionError::NonFinite));
        assert_eq!(refine(&x, &bar, (0.0, 0.0), Held::default()), Err(ProjectionError::NonFinite));
        assert_eq!(refine(&x, &x, (bad, 0.0), Held::default()), Err(ProjectionError::NonFinite));
    }
    // These numbers are finite, but their squares are not.
    for huge in
        [line([0.0, 0.0, 1e155], [0.0, 1.0, 0.0], -1.0, 1.0), line([0.0; 3], [0.0, 1e155, 0.0], -1.0, 1.0)]
    {
        assert_eq!(refine(&x, &huge, (0.0, 0.5), Held::default()), Err(ProjectionError::NonFinite));
        assert_eq!(refine(&huge, &x, (0.5, 0.0), Held::default()), Err(ProjectionError::NonFinite));
        assert_eq!(closest_points(&x, &huge, &Search::default()), Err(ProjectionError::NonFinite));
    }
}

#[test]
fn tangents_of_zero_length() {
    let x = line([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], -1.0, 1.0);
    let point = line([0.5, 0.0, 0.0], [0.0; 3], -1.0, 1.0);
    let collapsed = |which| Err(ProjectionError::ZeroTangent { which });
    assert_eq!(closest_points(&point, &x, &Search::default()), collapsed(Which::Beam));
    assert_eq!(closest_points(&x, &point, &Search::default()), collapsed(Which::Bar));

    // A cusp that points towards the line.
    let zero = Vector3::zeros();
    let cusp = Cubic([Vector3::new(0.25, 0.0, 0.0), zero, Vector3::new(0.0, 0.5, -1.0), Vector3::y()]);
    let found = closest_points(&x, &cusp, &Search::default()).unwrap();
    let point = found.minima.iter().find(|point| point.is_interior()).unwrap();
    assert!((point.xi - 0.25).abs() < 1e-15 && point.xi_bar.abs() < 1e-15);
    assert_eq!(point.degeneracy(), Some(Degeneracy::ZeroTangent { which: Which::Bar }));
}

#[test]
fn newton_says_what_it_found() {
    let (x, bar) = (circle(1.0, 0.0).over(-1.0, 1.0), line([3.0, 0.0, 0.25], [0.0, 1.0, 0.0], -1.0, 1.0));
    let point = refine(&x, &bar, (0.1, -0.1), Held::default()).unwrap();
    assert_eq!((point.kind, point.xi, point.xi_bar), (Kind::Minimum, 0.0, 0.0));
    let held = refine(&x, &bar, (0.9, 0.1), Held { xi: true, xi_bar: false }).unwrap();
    assert_eq!((held.xi, held.kind), (1.0, Kind::Saddle));
    assert!(held.end.unwrap().multiplier < 0.0);
    let away = line([3.0, 9.0, 0.25], [0.0, 1.0, 0.0], -1.0, 1.0);
    let failure = refine(&x, &away, (0.1, 0.1), Held::default());
    assert_eq!(failure, Err(ProjectionError::AtEnd { which: Which::Bar, side: Side::Lower }));
}

proptest! {
    #[test]
    fn the_foot_on_a_line_stays_put_at_any_distance_from_the_origin(shift in -1e3..1e3_f64, at in -0.9..0.9_f64) {
        let origin = Vector3::new(shift, -shift, 0.5 * shift);
        let arc = Winding { centre: origin, ..circle(1.0, 0.0).over(at - 1.0, at + 1.0) };
        let bar = Winding { centre: origin + Vector3::x() * 3.0, w: Vector3::z(), from: -1.0, to: 1.0, ..Winding::default() };
        let found = search(&arc, &bar);
        let point = found.interior().unwrap();
        prop_assert!((point.xi + at).abs() < 1e-11 && (point.distance - 2.0).abs() < 1e-11);
        prop_assert!(point.degeneracy().is_none());
        assert_singular(&search(&arc, &Winding { centre: origin, ..bar }));
    }
}
