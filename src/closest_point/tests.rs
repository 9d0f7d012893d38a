//! Tests of points with few correct digits, and of steps that do not converge. Each case has its own result.

use super::{Centroid, ClosestPoints, Held, ProjectionError, Search, Side, closest_points, refine};
use crate::curve::Geometry;
use crate::number::Which;
use nalgebra::Vector3;

/// scale (x + t s + c s²/2), a parabola.
struct Parabola {
    x: Vector3<f64>,
    t: Vector3<f64>,
    c: Vector3<f64>,
    scale: f64,
}

impl Centroid for Parabola {
    fn geometry(&self, s: f64) -> Geometry<f64> {
        let Self { x, t, c, scale } = self;
        Geometry {
            x: (x + t * s + c * (0.5 * s * s)) * *scale,
            t: (t + c * s) * *scale,
            t_xi: c * *scale,
            t_xixi: Vector3::zeros(),
        }
    }

    fn third_derivative_bound(&self) -> f64 {
        0.0
    }

    fn is_cubic(&self) -> bool {
        true
    }
}

fn line(x: [f64; 3], t: [f64; 3], scale: f64) -> Parabola {
    Parabola { x: x.into(), t: t.into(), c: Vector3::zeros(), scale }
}

/// The parabola (s, 0, s²/2) and the line (0, s, h): d² = h² + (1 - h) s² + s⁴/4 + s_bar².
fn fold(h: f64, scale: f64, swapped: bool) -> ClosestPoints {
    let parabola = Parabola { c: Vector3::z(), ..line([0.0; 3], [1.0, 0.0, 0.0], scale) };
    let line = line([0.0, 0.0, h], [0.0, 1.0, 0.0], scale);
    let [beam, bar] = if swapped { [&line, &parabola] } else { [&parabola, &line] };
    closest_points(beam, bar, &Search::default()).unwrap()
}

#[test]
fn a_minimum_of_fourth_order_is_one_point_without_derivatives() {
    for (scale, swapped) in [(1.0, false), (1.0, true), (1024.0, false), (f64::exp2(-20.0), true)] {
        for e in [0.0, 1e-14, -1e-14, 1e-13, 1e-12, -1e-12, 1e-11, 1e-10] {
            let found = fold(1.0 + e, scale, swapped);
            let count = found.minima.iter().filter(|point| point.is_interior()).count();
            assert!(count <= 1 || e >= 1e-11, "{count} minima at {e:e}: {:?}", found.minima);
            // Below 1 the minimum s = 0 is symmetric. Rounding does not move it while its eigenvalue exceeds rounding.
            let refused = (e < -1e-13)
                | matches!(
                    found.interior(),
                    Err(ProjectionError::Singular { .. } | ProjectionError::IllConditioned { .. })
                );
            assert!(refused, "{e:e}: {:?}", found.interior());
        }
    }
}

#[test]
fn the_error_of_gradients_is_told_before_it_is_large() {
    // At h = 1 + e the minima are s = ± sqrt(2e), the smallest eigenvalue is 2e/(1 + 2e).
    for exponent in 2..=32 {
        let e = f64::exp2(-f64::from(exponent));
        let found = fold(1.0 + e, 1.0, false);
        let s = (2.0 * e).sqrt();
        match found.interior() {
            Ok(point) => {
                assert!(e > 4e-7 && point.degeneracy().is_none(), "{e:e}");
                assert!((point.xi.abs() - s).abs() < 1e-14 / e, "{e:e}");
                // The eigenvalue is 1/(1 + s²) d²F/ds², and the gradient of xi has the same relative error.
                let exact = 2.0 * e / (1.0 + 2.0 * e);
                assert!((point.conditioning - exact).abs() < 1e-6 * exact, "{} at {e:e}", point.conditioning);
            }
            Err(ProjectionError::IllConditioned { conditioning, gradient_error }) => {
                let off = (conditioning - 2.0 * e / (1.0 + 2.0 * e)).abs() / conditioning;
                assert!(
                    e < 1e-5 && off <= gradient_error + 1e-14 / e,
                    "{off:e}, {gradient_error:e} at {e:e}"
                );
            }
            Err(error) => panic!("{error} at {e:e}"),
        }
    }
}

#[test]
fn straight_beams_keep_their_derivatives_at_small_angles() {
    for exponent in 1..=17 {
        let angle = f64::exp2(-f64::from(exponent));
        let beam = line([0.125, 0.0, 0.25], [1.0, 0.0, 0.0], 1.0);
        let bar = line([0.125, 0.0, 0.0], [angle.cos(), angle.sin(), 0.0], 1.0);
        let found = closest_points(&beam, &bar, &Search::default()).unwrap();
        assert!(found.interior().unwrap().degeneracy().is_none(), "{angle:e}");
    }
}

#[test]
fn a_start_that_no_step_leaves_is_no_minimum() {
    for exponent in 24..=40 {
        let angle = f64::exp2(-f64::from(exponent));
        let beam = line([0.5, 0.0, 1.0], [1.0, 0.0, 0.0], 1.0);
        let bar = line([0.0; 3], [angle.cos(), angle.sin(), 0.0], 1.0);
        for start in [(0.25, 0.5), (0.1, -0.3), (-0.5, 0.5), (0.3, 0.1)] {
            match refine(&beam, &bar, start, Held::default()) {
                Ok(point) => assert!(point.residual < 1e-7, "{point:?} at {angle:e}"),
                Err(error) => assert!(!matches!(error, ProjectionError::NonFinite), "{error}"),
            }
        }
    }
}

#[test]
fn an_end_in_the_way_is_named() {
    let beam = line([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], 1.0);
    for (y, side) in [(3.0, Side::Lower), (-3.0, Side::Upper)] {
        let bar = line([0.0, y, 0.0], [0.0, 1.0, 0.0], 1.0);
        let inside = Held::default();
        let error = refine(&beam, &bar, (0.1, 0.2), inside).unwrap_err();
        assert_eq!(error, ProjectionError::AtEnd { which: Which::Bar, side });
        let swapped = refine(&bar, &beam, (0.2, 0.1), inside).unwrap_err();
        assert_eq!(swapped, ProjectionError::AtEnd { which: Which::Beam, side });
        let held = Held { xi_bar: true, ..inside };
        let at_end = refine(&beam, &bar, (0.1, side.parameter()), held).unwrap();
        assert_eq!((at_end.xi, at_end.end_bar.unwrap().side), (0.0, side));
    }
    assert_eq!(
        ProjectionError::AtEnd { which: Which::Bar, side: Side::Lower }.to_string(),
        "Newton's method leads out of the bar beam at xi = -1"
    );
}
