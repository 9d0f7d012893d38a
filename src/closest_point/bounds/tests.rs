//! Compares the bounds with numbers computed by hand, which are exact in binary.

use super::super::squared_distance::SquaredDistance;
use super::super::tree::{ROOT, Tree};
use super::super::{Centroid, Held};
use super::{Bounds, INFLATED, SINGULAR};
use crate::curve::Geometry;

/// The same geometry and bound at every parameter.
struct Fixed(Geometry<f64>, f64);

impl Centroid for Fixed {
    fn geometry(&self, _: f64) -> Geometry<f64> {
        self.0
    }

    fn third_derivative_bound(&self) -> f64 {
        self.1
    }
}

fn geometry(x: [f64; 3], t: [f64; 3], t_xi: [f64; 3]) -> Geometry<f64> {
    Geometry { x: x.into(), t: t.into(), t_xi: t_xi.into(), t_xixi: [1.0, 2.0, 3.0].into() }
}

/// d·t = 16, d·t_bar = 12.5, a = 33, b = 8, a_bar = -18.25.
fn curved() -> [Geometry<f64>; 2] {
    [
        geometry([0.0, 3.0, 4.0], [3.0, 0.0, 4.0], [0.0, 0.0, 2.0]),
        geometry([0.0; 3], [0.0, 1.5, 2.0], [3.0, -4.0, 0.0]),
    ]
}

/// Parallel lines, except that t,xi and t_bar,xi_bar are along d.
fn parallel(bend: f64, bend_bar: f64) -> SquaredDistance {
    let x = geometry([0.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 0.0, bend]);
    SquaredDistance::new(&x, &geometry([0.0; 3], [4.0, 0.0, 0.0], [0.0, 0.0, bend_bar]))
}

fn bounds(squared_distance: SquaredDistance) -> Bounds {
    Bounds { squared_distance, half: [0.5, 0.25], change: [0.0; 3], remainder: [2.0, 4.0], inverse: [0.0; 3] }
}

fn exact<const N: usize>(found: [f64; N], expected: [f64; N]) {
    assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{found:?}, {expected:?}");
}

#[test]
fn bounds_are_those_of_the_derivation() {
    let [x, x_bar] = curved();
    let (beam, bar) = (Fixed(x, 24.0), Fixed(x_bar, 96.0));
    let (mut tree, mut tree_bar) = (Tree::new(&beam).unwrap(), Tree::new(&bar).unwrap());
    let [half, _] = tree.halves(ROOT).unwrap();
    let [_, half_bar] = tree_bar.halves(ROOT).unwrap();
    let [quarter_bar, _] = tree_bar.halves(half_bar).unwrap();
    let (node, node_bar) = (tree.node(half), tree_bar.node(quarter_bar));
    exact([node.centre, node.half, node_bar.centre, node_bar.half], [-0.5, 0.5, 0.25, 0.25]);
    exact([node.sag, node.turn, node.twist, node.jerk], [0.75, 4.0, 3.0, 12.0]);
    exact([node_bar.sag, node_bar.turn, node_bar.twist, node_bar.jerk], [0.406_25, 4.25, 3.0, 24.0]);
    let bounds = Bounds::new(node, node_bar);
    exact(bounds.change, [172.6875, 43.75, 270.593_75]);
    exact(bounds.remainder, [48.640_625, 44.761_718_75]);
    let (det, [p, q, s]) = (538.25, bounds.inverse);
    exact([bounds.squared_distance.det], [det]);
    for (entry, expected) in [(p, 18.25), (q, 8.0), (s, 33.0)] {
        assert!((entry * det - expected).abs() < 1e-14, "{entry}");
    }
    assert!(tree.halves(ROOT).unwrap() == [half, half + 1] && tree.evaluations() == 5);
}

#[test]
fn a_box_without_zeros_is_told_by_components_or_by_newton() {
    let [x, x_bar] = curved();
    let at = bounds(SquaredDistance::new(&x, &x_bar));
    // (p, q, s) just inside and just outside the box, for a component of H⁻¹ grad F
    for (inverse, excluded) in [
        ([0.64, 0.5, 0.5], false),
        ([0.644, 0.5, 0.5], true),
        ([0.4, 0.5, 1.13], false),
        ([0.4, 0.5, 1.132], true),
    ] {
        assert_eq!(Bounds { inverse, ..at }.excludes_zero(), excluded, "{inverse:?}");
    }
    // |a| h + |b| k + r and its counterpart, just below and just above the gradient
    let holds = |half, remainder| {
        let at = Bounds { half, remainder, ..at };
        [at.keeps_sign(0), at.keeps_sign(1), at.excludes_zero()]
    };
    assert_eq!(holds([0.25, 0.5], [2.8, 4.0]), [true, false, true]);
    assert_eq!(holds([0.25, 0.5], [2.9, 4.0]), [false, false, false]);
    assert_eq!(holds([0.5, 0.25], [2.0, 3.2]), [false, true, true]);
    assert_eq!(holds([0.5, 0.25], [2.0, 3.3]), [false, false, false]);
}

#[test]
fn a_bound_that_is_reached_excludes_nothing() {
    // d·t = 17 = 17/16 of 16
    let [mut x, x_bar] = curved();
    x.x.z = 4.25;
    let at = Bounds { half: [0.0; 2], remainder: [16.0; 2], ..bounds(SquaredDistance::new(&x, &x_bar)) };
    for inverse in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
        assert!(!at.keeps_sign(0) && !Bounds { inverse, ..at }.excludes_zero(), "{inverse:?}");
    }
}

#[test]
fn contractions_are_those_of_the_maximum_norm() {
    let [x, x_bar] = curved();
    let at = Bounds {
        change: [1.0, 2.0, 3.0],
        inverse: [0.5, -0.25, 0.75],
        ..bounds(SquaredDistance::new(&x, &x_bar))
    };
    exact([at.contraction()], [INFLATED * 6.25]);
    exact([Bounds { half: [0.25, 0.5], ..at }.contraction()], [INFLATED * 4.5]);
    exact([at.contraction_along(0), at.contraction_along(1)], [INFLATED / 33.0, INFLATED * 3.0 / 18.25]);
}

#[test]
fn a_box_is_flat_if_all_of_it_is_singular_to_rounding() {
    let limits = [4.0, 8.0, 16.0].map(|scale| scale * SINGULAR);
    let at = Bounds { change: limits.map(|limit| 0.999 * limit), ..bounds(parallel(0.0, 0.0)) };
    assert!(at.is_flat());
    for i in 0..3 {
        let mut change = at.change;
        change[i] = 1.001 * limits[i];
        assert!(!Bounds { change, ..at }.is_flat(), "{change:?}");
    }
    let regular = parallel(0.1, 0.0);
    assert!(regular.smallest_magnitude(Held::default()) > SINGULAR);
    assert!(!Bounds { squared_distance: regular, ..at }.is_flat());
}

#[test]
fn an_interval_is_flat_if_its_curvature_is_rounding() {
    // a = 4 + bend and -a_bar = 16 - bend_bar
    let at = |curvatures: [f64; 2], factor: f64| Bounds {
        change: [4.0 * SINGULAR * factor, 0.0, 16.0 * SINGULAR * factor],
        ..bounds(parallel(curvatures[0] - 4.0, 16.0 - curvatures[1]))
    };
    let flat = |curvatures, factor| [0, 1].map(|i| at(curvatures, factor).is_flat_along(i));
    let within = [3.0 * SINGULAR, 12.0 * SINGULAR];
    assert_eq!(flat(within, 0.999), [true, true]);
    assert_eq!(flat(within, 1.001), [false, false]);
    assert_eq!(flat([5.0 * SINGULAR, 20.0 * SINGULAR], 0.999), [false, false]);
    assert_eq!(flat([-5.0 * SINGULAR, -20.0 * SINGULAR], 0.999), [false, false]);
}

#[test]
fn concave_is_what_has_a_negative_curvature_all_over() {
    let at = |change| Bounds { change, ..bounds(parallel(-5.0, 18.0)) };
    let concave = |change| [0, 1].map(|i| at(change).is_concave_along(i));
    assert_eq!(concave([0.99, 9.0, 1.99]), [true, true]);
    assert_eq!(concave([1.0, 0.0, 2.0]), [false, false]);
    let convex = bounds(parallel(0.0, 0.0));
    assert_eq!([0, 1].map(|i| convex.is_concave_along(i)), [false, false]);
}
