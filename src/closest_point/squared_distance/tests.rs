//! Compares the measures of a point with numbers computed by hand.

use super::{Held, ROUNDING, SquaredDistance, WEAK};
use crate::curve::Geometry;

const FREE: Held = Held { xi: false, xi_bar: false };
const HELD: [Held; 3] =
    [Held { xi: true, xi_bar: false }, Held { xi: false, xi_bar: true }, Held { xi: true, xi_bar: true }];

fn geometry(x: [f64; 3], t: [f64; 3], t_xi: [f64; 3]) -> Geometry<f64> {
    Geometry { x: x.into(), t: t.into(), t_xi: t_xi.into(), t_xixi: [0.0; 3].into() }
}

/// A beam along the first axis, `x` away from a bar along `t_bar` at the origin; both bend along the third axis.
fn point(x: [f64; 3], t_bar: [f64; 3], bends: [f64; 2]) -> SquaredDistance {
    let beam = geometry(x, [2.0, 0.0, 0.0], [0.0, 0.0, bends[0]]);
    SquaredDistance::new(&beam, &geometry([0.0; 3], t_bar, [0.0, 0.0, bends[1]]))
}

const ACROSS: [f64; 3] = [0.0, 4.0, 0.0];
const ALONG: [f64; 3] = [4.0, 0.0, 0.0];

#[test]
fn slopes_are_those_of_unit_tangents() {
    let beam = geometry([3.0, 1.0, 5.0], [4.0, 0.0, 0.0], [0.0; 3]);
    let at = SquaredDistance::new(&beam, &geometry([0.0; 3], [0.0, 0.25, 0.0], [0.0; 3]));
    let [held, other, _] = HELD.map(|held| at.slope(held));
    assert_eq!([at.slope(FREE), held, other].map(f64::to_bits), [3.0, 1.0, 3.0].map(f64::to_bits));
}

#[test]
fn eigenvalues_are_in_ascending_order_and_those_of_unit_tangents() {
    // a = 4 + bend and -a_bar = 16 - bend_bar
    let all = |bends| {
        let at = point([0.0, 0.0, 1.0], ACROSS, bends);
        assert_eq!(at.conditioning(FREE).to_bits(), at.eigenvalues(FREE)[0].to_bits());
        (at.eigenvalues(FREE), HELD.map(|held| at.conditioning(held)))
    };
    assert_eq!(all([4.0, 8.0]), ([0.5, 2.0], [0.5, 2.0, f64::INFINITY]));
    assert_eq!(all([-8.0, 24.0]), ([-1.0, -0.5], [-0.5, -1.0, f64::INFINITY]));
    assert_eq!(all([0.0, 32.0]), ([-1.0, 1.0], [-1.0, 1.0, f64::INFINITY]));
    assert_eq!(all([-8.0, 8.0]), ([-1.0, 0.5], [0.5, -1.0, f64::INFINITY]));
}

#[test]
fn residuals_are_cosines() {
    let at = point([1.0, 2.0, 2.0], ACROSS, [0.5, 0.5]);
    let of = |held| at.residual(held);
    let found = [of(FREE), of(HELD[0]), of(HELD[1]), of(HELD[2])];
    assert_eq!(found.map(f64::to_bits), [2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 0.0].map(f64::to_bits));
    // A short tangent has a direction, unless its length is rounding relative to its change.
    let short = geometry([1.0, 0.0, 1.0], [1e-7, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let cosine = SquaredDistance::new(&short, &geometry([0.0; 3], ACROSS, [0.0; 3])).cosine(0);
    assert!((cosine - 0.5_f64.sqrt()).abs() < 1e-15, "{cosine}");
}

#[test]
fn stationary_and_convex_is_what_is_so_in_the_free_parameters() {
    let stationary = |x: [f64; 3]| {
        let at = point(x, ACROSS, [0.0; 2]);
        [FREE, HELD[0], HELD[1], HELD[2]].map(|held| at.is_stationary(held))
    };
    assert_eq!(stationary([0.0, 0.0, 1.0]), [true; 4]);
    assert_eq!(stationary([1.0, 0.0, 1.0]), [false, true, false, true]);
    assert_eq!(stationary([0.0, 1.0, 1.0]), [false, false, true, true]);
    let convex = |t_bar, bends| {
        let at = point([0.0, 0.0, 1.0], t_bar, bends);
        [FREE, HELD[0], HELD[1], HELD[2]].map(|held| at.is_convex(held))
    };
    assert_eq!(convex(ACROSS, [0.0, 0.0]), [true; 4]);
    assert_eq!(convex(ALONG, [0.0, 0.0]), [false, true, true, true]);
    assert_eq!(convex(ACROSS, [-4.0, 0.0]), [false, true, false, true]);
    assert_eq!(convex(ACROSS, [0.0, 16.0]), [false, false, true, true]);
}

#[test]
fn a_gradient_is_weak_if_it_is_rounding() {
    // d·t for d of length 1.5 and t of length 2, without and with the rounding of far positions
    for far in [0.0, 1e6] {
        let at = |slope: f64| {
            let (x, x_bar) = ([0.5 * slope, 0.0, 1.5], [0.0, far, 0.0]);
            let beam = geometry([x[0], far, x[2]], [2.0, 0.0, 0.0], [0.0; 3]);
            SquaredDistance::new(&beam, &geometry(x_bar, ACROSS, [0.0; 3]))
        };
        let positions = (2.0 * far * far + 1.5 * 1.5 + 4.0 + 16.0_f64).sqrt();
        let limit = 2.0 * (WEAK * (1.5 + 2.0) + ROUNDING * positions);
        assert!(at(0.99 * limit).is_weak(0) && !at(1.01 * limit).is_weak(0), "{far}");
    }
    // A tangent of length 1 that turns within 1e-8 of the parameter.
    let at = |slope: f64| {
        let beam = geometry([slope, 0.0, 1.5], [1.0, 0.0, 0.0], [-1e8, 0.0, 0.0]);
        SquaredDistance::new(&beam, &geometry([0.0; 3], ACROSS, [0.0; 3]))
    };
    let limit = WEAK * 1.5 * 1e8;
    assert!(at(0.99 * limit).is_weak(0) && !at(1.01 * limit).is_weak(0));
}

#[test]
fn a_valley_is_crossed_and_not_followed() {
    let close = |(step, step_bar): (f64, f64), expected: [f64; 2]| {
        let error = (step - expected[0]).abs().max((step_bar - expected[1]).abs());
        assert!(error < 1e-6, "({step}, {step_bar}) is not {expected:?}");
    };
    let parallel = point([1.0, 0.0, 1.0], ALONG, [0.0; 2]);
    close(parallel.valley_step(FREE), [-0.25, 0.125]);
    close(parallel.valley_step(HELD[0]), [0.0, 0.25]);
    close(parallel.valley_step(HELD[1]), [-0.5, 0.0]);
    close(parallel.valley_step(HELD[2]), [0.0, 0.0]);
    // Along the valley the curvature is 1e-9 of that of unit tangents: half of the threshold.
    close(point([1.0, 0.0, 1.0], ALONG, [8e-9, 0.0]).valley_step(FREE), [-0.25, 0.125]);
    close(point([1.0, 1.0, 1.0], ACROSS, [0.0; 2]).valley_step(FREE), [-0.5, 0.25]);
    // Without curvature there is no step.
    close(point([1.0, 0.0, 1.0], ALONG, [0.0, 16.0]).valley_step(HELD[0]), [0.0, 0.0]);
    close(point([1.0, 1.0, 1.0], [0.0; 3], [0.0; 2]).valley_step(FREE), [0.0, 0.0]);
}
