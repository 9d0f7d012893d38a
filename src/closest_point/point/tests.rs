//! Tests of tangents of zero length, of the ends of the parameters, and of equal points.

use super::{ClosestPoint, Held, Side, SquaredDistance};
use crate::closest_point::held::STANDSTILL;
use crate::curve::Geometry;

#[test]
fn a_tangent_stands_still_next_to_its_change() {
    for (bend, twist) in [(3.0, 4.0), (0.5, 0.25), (0.25, 0.5)] {
        let limit = STANDSTILL * (bend + twist);
        let at = |t: f64| Geometry {
            x: [1.0; 3].into(),
            t: [t, 0.0, 0.0].into(),
            t_xi: [0.0, bend, 0.0].into(),
            t_xixi: [0.0, 0.0, twist].into(),
        };
        for (factor, still) in [(0.5, true), (0.99, true), (1.001, false), (1.5, false), (1e12, false)] {
            let p = SquaredDistance::new(&at(1.0), &at(factor * limit));
            assert_eq!([p.stands_still(0), p.stands_still(1)], [false, still], "{bend}, {twist}, {factor}");
        }
    }
}

#[test]
fn ends_are_where_they_are() {
    assert_eq!(
        [Side::Lower, Side::Upper].map(|side| side.parameter().to_bits()),
        [-1.0, 1.0].map(f64::to_bits)
    );
}

#[test]
fn points_are_the_same_if_they_are_nearer_than_newtons_method_ends() {
    let line = |x: [f64; 3], t: [f64; 3]| Geometry {
        x: x.into(),
        t: t.into(),
        t_xi: [0.0; 3].into(),
        t_xixi: [0.0; 3].into(),
    };
    let p = SquaredDistance::new(&line([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]), &line([0.0; 3], [0.0, 1.0, 0.0]));
    let at = |xi, xi_bar, held| ClosestPoint::new((xi, xi_bar), &p, Held { xi: held, xi_bar: false });
    let same = |xi, xi_bar, held| at(0.0, 0.0, false).is_same(&at(xi, xi_bar, held));
    assert!(same(0.9e-9, -0.9e-9, false));
    assert!(!same(1e-9, 0.0, false) && !same(0.0, -1e-9, false) && !same(0.0, 0.0, true));
}
