//! Tests of the parts of both formulations, and of the choice between them.

use super::{Distance, Formulation, Held, Points, Squares, System, inverse_gram};
use crate::curve::Geometry;
use nalgebra::Vector3;

/// Curved beams whose tangents are at the angle `angle` and whose gap is d.
fn points(angle: f64, d: f64) -> Points<f64> {
    let geometry = |x: [f64; 3], t: [f64; 3], t_xi: [f64; 3]| Geometry {
        x: x.into(),
        t: t.into(),
        t_xi: t_xi.into(),
        t_xixi: Vector3::zeros(),
    };
    let (sin, cos) = angle.sin_cos();
    let beam = geometry([0.25, 0.5, d], [1.5, 0.0, 0.0], [0.25, -0.5, 0.75]);
    let bar = geometry([0.25, 0.5, 0.0], [0.75 * cos, 0.75 * sin, 0.0], [0.5, 0.25, 0.5]);
    Points { beam, bar, d: beam.x - bar.x }
}

#[test]
fn the_inverse_of_the_gram_matrix_is_one() {
    let Points { beam, bar, .. } = points(0.75, 0.0);
    let [g11, g12, g22] = inverse_gram(&beam.t, &bar.t);
    let (t2, b, t_bar2) = (beam.t.dot(&beam.t), beam.t.dot(&bar.t), bar.t.dot(&bar.t));
    let product = [g11 * t2 + g12 * b, g11 * b + g12 * t_bar2, g12 * t2 + g22 * b, g12 * b + g22 * t_bar2];
    for (entry, of_unit) in product.into_iter().zip([1.0, 0.0, 0.0, 1.0]) {
        assert!((entry - of_unit).abs() < 1e-15, "{product:?}");
    }
}

#[test]
fn the_form_is_that_of_the_smaller_loss() {
    let at = |angle, d| {
        let Formulation { distance, system, .. } = Formulation::at(&points(angle, d), Held::default());
        (distance, system)
    };
    let normal = |reversed| Distance::Normal { reversed };
    let (products, cross_products) = (System::Determinants, System::CrossProducts);
    assert_eq!(at(1.5, 0.5), (normal(false), products));
    assert_eq!(at(1.5, 8.0), (Distance::Length, products));
    assert_eq!(at(1.5, 1e-2), (normal(false), products));
    assert_eq!(at(1.5, -1e-2), (normal(true), products));
    assert_eq!(at(1.5, 0.0), (normal(false), products));
    assert_eq!(at(1e-2, 1e-2), (Distance::Length, cross_products));
    assert_eq!(at(1e-2, 1e-4), (normal(false), cross_products));
    // Parallel tangents have no common normal, not even where the centroids cross.
    assert_eq!(at(0.0, 1e-9), (Distance::Length, cross_products));
    assert_eq!(at(0.0, 0.0), (Distance::Length, cross_products));
    // Straight beams lose no digits by their normal.
    let mut straight = points(1e-5, 0.25);
    (straight.beam.t_xi, straight.bar.t_xi) = (Vector3::zeros(), Vector3::zeros());
    assert_eq!(Formulation::at(&straight, Held::default()).distance, normal(false));
    // A slow parametrization: the tangent is short relative to its change.
    let mut slow = points(1.5, 1e-2);
    slow.beam.t *= 1e-3;
    assert_eq!(Formulation::at(&slow, Held::default()).distance, Distance::Length);
    assert!(Squares::at(&points(1.5, 1e-9)).is_regular());
    assert!(!Squares::at(&points(1e-2, 0.25)).is_regular());
    assert!(!Squares::at(&slow).is_regular());
    let held = Formulation::at(&points(1e-2, 1e-5), Held { xi: true, xi_bar: false });
    assert_eq!((held.sign(), held.uses_cross_products()), (None, false));
}
