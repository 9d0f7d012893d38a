//! Known properties of each family of curves: its ends, its circles, its limits and the inputs it rejects.

use crate::strategies::{arc, helix, knots, parameter, vector, weighted_points, weights};
use beamgap::curve::{Arc, BSpline, Bezier, Cubic, Curve, CurveError, Helix, Hermite, Nurbs, NurbsWeighted};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

/// The rounding error, relative to the size of the dofs.
const TOLERANCE: f64 = 1e-13;

proptest! {
    #[test]
    fn lagrange_passes_through_its_nodes(q in vector::<12>()) {
        for (i, xi) in [-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0].into_iter().enumerate() {
            let node = q.fixed_rows::<3>(3 * i);
            prop_assert!((Cubic::new().position(&q, xi) - node).amax() <= TOLERANCE * q.amax());
        }
    }

    #[test]
    fn lagrange_and_hermite_reproduce_their_bounds_exactly(q in vector::<12>(), xi in parameter()) {
        let third = Cubic::new().jet(&q, xi).geometry.t_xixi.norm();
        prop_assert!((Cubic::new().third_derivative_bound(&q) - third).abs() <= 100.0 * TOLERANCE * q.amax());
        let third = Hermite::new().jet(&q, xi).geometry.t_xixi.norm();
        prop_assert!((Hermite::new().third_derivative_bound(&q) - third).abs() <= 100.0 * TOLERANCE * q.amax());
    }

    #[test]
    fn hermite_has_its_dofs_at_the_ends(q in vector::<12>(), length in 0.1..10.0) {
        for (curve, c) in [(Hermite::new(), 1.0), (Hermite::scaled_by(length), 0.5 * length)] {
            for (node, xi) in [(0, -1.0), (6, 1.0)] {
                let g = curve.jet(&q, xi).geometry;
                prop_assert!((g.x - q.fixed_rows::<3>(node)).amax() <= TOLERANCE * q.amax());
                prop_assert!((g.t - q.fixed_rows::<3>(node + 3) * c).amax() <= TOLERANCE * c * q.amax());
            }
        }
    }
}

/// The knots of a Bezier curve of degree `P` - 1 as those of a B-spline.
fn clamped<const P: usize>() -> Vec<f64> {
    [vec![0.0; P - 1], vec![1.0; P - 1]].concat()
}

proptest! {
    #[test]
    fn bezier_starts_and_ends_in_its_control_points(q in vector::<15>()) {
        let curve = Bezier::<5>::new();
        prop_assert_eq!(curve.position(&q, -1.0), q.fixed_rows::<3>(0));
        prop_assert_eq!(curve.position(&q, 1.0), q.fixed_rows::<3>(12));
        let (start, end) = (curve.jet(&q, -1.0).geometry.t, curve.jet(&q, 1.0).geometry.t);
        prop_assert!((start - (q.fixed_rows::<3>(3) - q.fixed_rows::<3>(0)) * 2.0).amax() <= TOLERANCE * q.amax());
        prop_assert!((end - (q.fixed_rows::<3>(12) - q.fixed_rows::<3>(9)) * 2.0).amax() <= TOLERANCE * q.amax());
    }

    #[test]
    fn clamped_bspline_is_bezier(q in vector::<12>(), xi in parameter()) {
        let (spline, bezier) = (BSpline::<4>::new(&clamped::<4>()).unwrap(), Bezier::<4>::new());
        prop_assert!((spline.position(&q, xi) - bezier.position(&q, xi)).amax() <= TOLERANCE * q.amax());
        let bounds = [spline.third_derivative_bound(&q), bezier.third_derivative_bound(&q)];
        prop_assert!((bounds[0] - bounds[1]).abs() <= 100.0 * TOLERANCE * q.amax());
    }

    #[test]
    fn neighbouring_spans_meet_smoothly(q in vector::<15>(), start in -2.0..2.0, steps in weights::<6>()) {
        // A cubic over simple knots is twice continuously differentiable. Over a longer span xi runs faster.
        let mut knots = vec![start];
        knots.extend(steps.iter().scan(start, |knot, step| {
            *knot += step;
            Some(*knot)
        }));
        let before = BSpline::<4>::new(&knots[..6]).unwrap();
        let after = BSpline::<4>::new(&knots[1..]).unwrap();
        let before = before.jet(&q.fixed_rows::<12>(0).into_owned(), 1.0).geometry;
        let after = after.jet(&q.fixed_rows::<12>(3).into_owned(), -1.0).geometry;
        let ratio = steps[3] / steps[2];
        let scale = 1e4 * TOLERANCE * q.amax();
        prop_assert!((after.x - before.x).amax() <= scale);
        prop_assert!((after.t - before.t * ratio).amax() <= scale * ratio);
        prop_assert!((after.t_xi - before.t_xi * ratio * ratio).amax() <= scale * ratio * ratio);
    }

    #[test]
    fn equal_weights_are_no_weights(k in knots::<4>(), w in 0.2..5.0, q in vector::<12>(), xi in parameter()) {
        let (spline, nurbs) = (BSpline::<4>::new(&k).unwrap(), Nurbs::<4>::new(&k, [w; 4]).unwrap());
        prop_assert!((spline.position(&q, xi) - nurbs.position(&q, xi)).amax() <= TOLERANCE * q.amax());
        let bounds = [spline.third_derivative_bound(&q), nurbs.third_derivative_bound(&q)];
        prop_assert!((bounds[0] - bounds[1]).abs() <= 1e-11 * bounds[0] + 1e-8 * q.amax());
    }

    #[test]
    fn weights_as_dofs_are_the_weights(k in knots::<4>(), q in weighted_points::<4, 16>(), xi in parameter()) {
        let weights = std::array::from_fn(|i| q[4 * i + 3]);
        let points = SVector::<f64, 12>::from_fn(|i, _| q[4 * (i / 3) + i % 3]);
        let (fixed, free) = (Nurbs::<4>::new(&k, weights).unwrap(), NurbsWeighted::<4>::new(&k).unwrap());
        prop_assert_eq!(fixed.position(&points, xi), free.position(&q, xi));
        let bounds = [fixed.third_derivative_bound(&points), free.third_derivative_bound(&q)];
        prop_assert_eq!(bounds[0].to_bits(), bounds[1].to_bits());
    }

    #[test]
    fn rational_parabola_is_an_exact_circle(xi in parameter()) {
        let curve = Nurbs::<3>::new(&clamped::<3>(), [1.0, 0.5_f64.sqrt(), 1.0]).unwrap();
        let x = curve.position(&SVector::from([1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]), xi);
        prop_assert!((x.norm() - 1.0).abs() <= 4.0 * f64::EPSILON);
    }

    #[test]
    fn arc_keeps_its_radius_and_speed(q in arc(), alpha in -3.0..3.0, xi in parameter()) {
        let curve = Arc::new(alpha);
        let distance = (curve.position(&q, xi) - q.fixed_rows::<3>(0)).norm();
        prop_assert!((distance - q[3]).abs() <= TOLERANCE * (q[3] + q.amax()));
        let g = curve.jet(&q, xi).geometry;
        prop_assert!((g.t.norm() - q[3] * alpha.abs()).abs() <= TOLERANCE * q[3]);
        prop_assert!((g.t_xixi.norm() - curve.third_derivative_bound(&q)).abs() <= 100.0 * TOLERANCE * q[3]);
    }

    #[test]
    fn length_of_the_quaternion_has_no_effect(q in helix(), factor in 0.1..10.0, xi in parameter()) {
        let mut longer = q;
        longer.fixed_rows_mut::<4>(3).scale_mut(factor);
        let curve = Helix::new(2.0);
        prop_assert!((curve.position(&q, xi) - curve.position(&longer, xi)).amax() <= TOLERANCE * q.amax());
    }

    #[test]
    fn helix_rises_by_its_pitch_in_a_turn(q in helix()) {
        // From xi = -1 to xi = 1 the helix turns by 2 alpha, which is one turn.
        let curve = Helix::new(std::f64::consts::PI);
        let [w, i, j, k] = [q[3], q[4], q[5], q[6]];
        let axis = nalgebra::UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, i, j, k)) * Vector3::z();
        let rise = curve.position(&q, 1.0) - curve.position(&q, -1.0);
        prop_assert!((rise - axis * q[8]).amax() <= 10.0 * TOLERANCE * q.amax());
    }
}

#[test]
fn unturned_arc_starts_on_the_x_axis_and_turns_towards_y() {
    let q = SVector::from([1.0, 2.0, 3.0, 0.5, 2.0, 0.0, 0.0, 0.0, 0.0]);
    let curve = Arc::new(std::f64::consts::FRAC_PI_2);
    assert_eq!(curve.position(&q, 0.0), Vector3::new(1.5, 2.0, 3.0));
    assert!((curve.position(&q, 1.0) - Vector3::new(1.0, 2.5, 3.0)).amax() <= f64::EPSILON);
}

#[test]
fn knots_that_make_no_span_are_rejected() {
    let reject = |knots: &[f64]| BSpline::<3>::new(knots).unwrap_err();
    assert_eq!(reject(&[0.0, 1.0]), CurveError::KnotCount { found: 2, expected: 4 });
    assert_eq!(
        reject(&[0.0, 0.0, f64::INFINITY, 2.0]),
        CurveError::KnotNotFinite { index: 2, knot: f64::INFINITY }
    );
    assert!(matches!(reject(&[f64::NAN, 0.0, 1.0, 2.0]), CurveError::KnotNotFinite { index: 0, .. }));
    assert_eq!(reject(&[0.0, 1.0, 2.0, 1.5]), CurveError::KnotsDecrease { index: 3 });
    assert_eq!(reject(&[0.0, 1.0, 1.0, 2.0]), CurveError::EmptySpan { start: 1.0, end: 1.0 });
    assert_eq!(reject(&[-1e300, 0.0, 1e-300, 1.0]), CurveError::EmptySpan { start: 0.0, end: 1e-300 });
    assert_eq!(reject(&[0.0, 1.0, 1.0, 2.0]).to_string(), "the span from 1 to 1 has no length");
    assert!(BSpline::<3>::new(&[-1e308, -1e308, 1e308, 1e308]).is_ok());
    assert_eq!(NurbsWeighted::<3>::new(&[]).unwrap_err(), CurveError::KnotCount { found: 0, expected: 4 });
}

#[test]
fn weights_that_are_not_positive_are_rejected() {
    let knots = clamped::<3>();
    for weight in [0.0, -1.0, f64::INFINITY] {
        let error = Nurbs::<3>::new(&knots, [1.0, weight, 1.0]).unwrap_err();
        assert_eq!(error, CurveError::Weight { index: 1, weight });
    }
    assert!(matches!(Nurbs::<3>::new(&knots, [f64::NAN; 3]), Err(CurveError::Weight { index: 0, .. })));
    let q = SVector::from([0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 1.0]);
    assert!(NurbsWeighted::<3>::new(&knots).unwrap().third_derivative_bound(&q).is_infinite());
}
