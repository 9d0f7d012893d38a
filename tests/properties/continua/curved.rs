//! Arcs and helices: circles about the same axis, an arc about its axis, strands of a double helix.

use super::{assert_distance, nearest, search, smallest};
use crate::centroids::{Winding, ellipse, line};
use beamgap::closest_point::{Continuum, ProjectionError};
use beamgap::curve::Arc;
use beamgap::number::Which;
use beamgap::pair::{DofVector, Pair};
use nalgebra::Vector3;

fn circle(radius: f64, height: f64) -> Winding {
    ellipse([0.0, 0.0, height], [radius, 0.0, 0.0], [0.0, radius, 0.0])
}

#[test]
fn concentric_arcs_have_the_distance_of_their_radii() {
    for (radius, height) in [(1.5, 0.0), (0.5, 0.25), (3.0, 1.0), (1.0, 1e-3)] {
        let (x, bar) = (circle(1.0, 0.0).over(-1.5, 1.5), circle(radius, height).over(-1.0, 2.0));
        let found = search(&x, &bar);
        let region = nearest(&found);
        assert_distance(&region, [&x, &bar], f64::hypot(radius - 1.0, height), 1e-5);
        assert!(found.unresolved.iter().all(|region| region.continuum == Continuum::Concentric), "{found:?}");
        assert!(region.point.residual < 1e-9, "{region:?}");
        assert!(matches!(found.interior(), Err(ProjectionError::Singular { .. })), "{found:?}");
    }
    let found = search(&circle(1.0, 0.0).over(-1.5, 1.5), &circle(1.0, 0.0).over(-1.0, 2.0));
    assert_eq!(nearest(&found).continuum, Continuum::Coincident, "{found:?}");
    assert!(smallest(&found) < 1e-14, "{found:?}");
}

/// The same by the curve of the library, with the plane and the phase turned.
#[test]
fn concentric_arcs_of_the_library() {
    let pair = Pair::new(Arc::new(1.0), Arc::new(0.5));
    let turned = [0.8, 0.6, 0.0, 0.0];
    let arc = |radius: f64, phase: f64| [&[0.5, -0.25, 1.0, radius], &turned[..], &[phase]].concat();
    let q: DofVector<f64, 9, 9> = DofVector::from_slices(&arc(1.0, 0.0), &arc(1.25, 0.75)).unwrap();
    let found = pair.closest_points(&q).unwrap();
    let [region] = found.unresolved[..] else { panic!("{found:?}") };
    let (x, bar) = pair.centroids(&q);
    assert_distance(&region, [&x, &bar], 0.25, 1e-5);
    assert_eq!(region.continuum, Continuum::Concentric);
}

#[test]
fn an_arc_about_its_axis_is_as_far_away_as_its_radius() {
    let axis = line([0.0; 3], [0.0, 0.0, 1.0], -1.0, 1.5);
    let arc = circle(2.0, 0.0).over(-2.0, 1.0);
    for (x, bar, which) in [(&arc, &axis, Which::Beam), (&axis, &arc, Which::Bar)] {
        let found = search(x, bar);
        assert!(!found.unresolved.is_empty());
        for region in &found.unresolved {
            assert_distance(region, [x, bar], 2.0, 1e-5);
            assert_eq!(region.continuum, Continuum::CentreOfArc { which });
        }
    }
    // An end of the line at the centre, without and with an offset along the axis.
    for (start, height) in [(0.0, 0.0), (0.0, -0.5)] {
        let (x, bar) = (axis.over(start, 1.0), circle(1.0, height).over(0.5, 1.5));
        let found = search(&x, &bar);
        let [region] = found.unresolved[..] else { panic!("{found:?}") };
        assert_distance(&region, [&x, &bar], f64::hypot(1.0, height), 1e-5);
        assert_eq!(region.continuum, Continuum::CentreOfArc { which: Which::Bar });
    }
}

/// Two strands of a double helix.
#[test]
fn coaxial_helices_are_equidistant() {
    let strand = |radius: f64, turn: f64| Winding {
        u: Vector3::new(turn.cos(), turn.sin(), 0.0) * radius,
        v: Vector3::new(-turn.sin(), turn.cos(), 0.0) * radius,
        w: Vector3::new(0.0, 0.0, 0.5),
        from: -1.0,
        to: 1.0,
        ..Winding::default()
    };
    let (x, bar) = (strand(1.0, 0.0), strand(1.5, 0.0));
    let found = search(&x, &bar);
    let [region] = found.unresolved[..] else { panic!("{found:?}") };
    assert_distance(&region, [&x, &bar], 0.5, 1e-5);
    assert_eq!(region.continuum, Continuum::Equidistant);
}
