//! Tests of regions: what they contain, what they touch, and the point that represents them.

use super::super::search::{Band, Pair};
use super::super::tree::Tree;
use super::super::{Centroid, Continuum, Degeneracy};
use super::{Region, gather};
use crate::curve::Geometry;

fn region(extent: [[f64; 2]; 2], distance: f64) -> Region {
    Region { extent, boxes: 1, nearest: (extent[0][0], extent[1][1]), distance }
}

#[test]
fn a_region_contains_its_rim_and_nothing_beyond() {
    let region = region([[-1.0, 0.5], [0.0, 0.25]], 1.0);
    for (xi, xi_bar) in [(-1.0, 0.0), (0.5, 0.25), (0.0, 0.125)] {
        assert!(region.contains(xi, xi_bar), "{xi}, {xi_bar}");
    }
    for (xi, xi_bar) in [(-1.1, 0.1), (0.6, 0.1), (0.0, -0.1), (0.0, 0.3)] {
        assert!(!region.contains(xi, xi_bar), "{xi}, {xi_bar}");
    }
}

#[test]
fn regions_touch_if_they_have_a_point_in_common() {
    let middle = region([[-0.5, 0.5], [-0.25, 0.25]], 1.0);
    let touches = |extent| [middle.touches(&region(extent, 1.0)), region(extent, 1.0).touches(&middle)];
    for extent in [[[0.5, 1.0], [0.25, 1.0]], [[-1.0, -0.5], [0.0, 0.1]], [[-1.0, 1.0], [-1.0, 1.0]]] {
        assert_eq!(touches(extent), [true; 2], "{extent:?}");
    }
    for extent in [[[0.6, 1.0], [0.0, 0.1]], [[0.0, 0.1], [0.3, 1.0]], [[0.6, 1.0], [0.3, 1.0]]] {
        assert_eq!(touches(extent), [false; 2], "{extent:?}");
    }
}

#[test]
fn boxes_that_touch_are_gathered() {
    let boxes = [
        region([[-1.0, -0.5], [-1.0, 0.0]], 3.0),
        region([[0.0, 0.5], [-1.0, -0.5]], 2.0),
        region([[0.75, 1.0], [0.5, 1.0]], 1.0),
        region([[-0.5, 0.0], [-0.5, 0.25]], 2.0),
    ];
    let [apart, hull] = gather(boxes.to_vec())[..] else { panic!("two regions") };
    assert_eq!((apart.extent, apart.boxes), (boxes[2].extent, 1));
    assert_eq!((hull.extent, hull.boxes), ([[-1.0, 0.5], [-1.0, 0.25]], 3));
    // The first of the nearest ones counts: the last box absorbed the first one, and then the second.
    assert_eq!((hull.nearest, hull.distance), (boxes[3].nearest, 2.0));
}

/// A straight beam along the first axis.
struct Line(f64, f64);

impl Centroid for Line {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        let along = |x: f64, z: f64| [x, 0.0, z].into();
        Geometry {
            x: along(self.0 * xi, self.1),
            t: along(self.0, 0.0),
            t_xi: along(0.0, 0.0),
            t_xixi: along(0.0, 0.0),
        }
    }

    fn third_derivative_bound(&self) -> f64 {
        0.0
    }
}

fn pair<'a>(beam: &'a Line, bar: &'a Line) -> Pair<'a> {
    let trees = [Tree::new(beam).unwrap(), Tree::new(bar).unwrap()];
    Pair { curves: [beam, bar], trees, band: Band { width: 0.0 } }
}

#[test]
fn the_point_of_a_region_is_in_the_middle_of_the_continuum() {
    // The points (xi, 1) and (2 xi_bar, 0) are nearest at xi = 2 xi_bar.
    let (beam, bar) = (Line(1.0, 1.0), Line(2.0, 0.0));
    let square = Region { nearest: (0.5, -0.25), ..region([[-1.0, 1.0]; 2], 1.5) };
    let found = square.unresolved(&mut pair(&beam, &bar), 64).unwrap();
    assert_eq!((found.point.xi, found.point.xi_bar, found.distance[1]), (0.0, 0.0, 1.0));
    assert!(found.distance[0] <= 1.0 && found.distance[0] > 1.0 - 1e-13, "{found:?}");
    assert!(matches!(found.point.degeneracy(), Some(Degeneracy::Singular { .. })));
    assert_eq!(found.continuum, Continuum::Parallel);
    // If an edge has no width, only the other parameter moves.
    let edge = Region { nearest: (1.0, -0.25), ..region([[1.0, 1.0], [-1.0, 1.0]], 1.5) };
    let found = edge.unresolved(&mut pair(&beam, &bar), 64).unwrap();
    assert_eq!((found.point.xi, found.point.xi_bar, found.distance[1]), (1.0, 0.5, 1.0));
    // In this part of the square, the nearest points are those of a corner.
    let part = Region { nearest: (-0.75, 0.75), ..region([[-1.0, -0.5], [0.25, 1.0]], 1.5) };
    let found = part.unresolved(&mut pair(&beam, &bar), 64).unwrap();
    assert_eq!((found.point.xi, found.point.xi_bar), (-0.5, 0.25));
    assert_eq!(found.distance[1].to_bits(), 2.0_f64.sqrt().to_bits());
    assert!(found.distance[0] <= 2.0_f64.sqrt() && found.distance[0] > 2.0_f64.sqrt() - 1e-6, "{found:?}");
}
