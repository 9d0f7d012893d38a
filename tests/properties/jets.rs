//! What [`Curve::jet`] states in closed form is the derivative of what [`Curve::position`] computes.
//!
//! The derivatives come from num-dual; how far two results may differ is measured by the size of the terms of both,
//! which the same formulas over [`Magnitude`] yield.

use crate::strategies::{arc, helix, knots, parameter, vector, weighted_points, weights};
use beamgap::curve::{
    Arc, BSpline, Bezier, Cubic, Curve, CurveError, DofDerivatives, Helix, Hermite, Jet, Lagrange, Nurbs,
    NurbsWeighted, Quadratic, Segment,
};
use beamgap::number::{Dual, HyperDual, Magnitude, Real};
use nalgebra::{SVector, Vector3};
use num_dual::{Dual3, Dual64, DualNum, HyperDual64};
use proptest::prelude::*;

/// Rounding, relative to the size of the terms.
const TOLERANCE: f64 = 1e-13;

/// x, x,xi, x,xixi and x,xixixi by num-dual.
fn position_derivatives<T: DualNum<Primitive = f64> + Copy, const N: usize>(
    curve: &impl Curve<N>,
    q: &SVector<T, N>,
    xi: f64,
) -> [Vector3<T>; 4] {
    let constant = |value: T| Dual3::from_re(value);
    let mut xi = constant(<T as From<f64>>::from(xi));
    xi.v1 = T::one();
    let x = curve.position(&q.map(constant), xi);
    [x.map(|x| x.re), x.map(|x| x.v1), x.map(|x| x.v2), x.map(|x| x.v3)]
}

/// The same by the library's own dual numbers, three of them nested.
fn nested_derivatives<T: Real, const N: usize>(
    curve: &impl Curve<N>,
    q: &SVector<T, N>,
    xi: T,
) -> [Vector3<T>; 4] {
    let constant = |value| Dual::new(value, T::zero());
    let one = constant(T::one());
    let (zero, one_more) = (constant(T::zero()), Dual::new(one, constant(T::zero())));
    let xi = Dual::new(Dual::new(Dual::new(xi, T::one()), one), one_more);
    let nil = Dual::new(zero, zero);
    let x = curve.position(&q.map(|q| Dual::new(Dual::new(constant(q), zero), nil)), xi);
    [x.map(|x| x.re.re.re), x.map(|x| x.eps.re.re), x.map(|x| x.eps.eps.re), x.map(|x| x.eps.eps.eps)]
}

fn sizes<const N: usize>(v: &SVector<f64, N>) -> SVector<Magnitude, N> {
    v.map(Magnitude::from)
}

/// Equality up to rounding: `scales` holds the sizes of the terms of both sides.
fn assert_close(
    what: &str,
    actual: &Vector3<f64>,
    expected: &Vector3<f64>,
    scales: [Vector3<f64>; 2],
) -> Result<(), TestCaseError> {
    let tolerance = TOLERANCE * (scales[0].max() + scales[1].max());
    let error = (actual - expected).amax();
    prop_assert!(error <= tolerance, "{what}: {actual:?} is not {expected:?}; {error:e} > {tolerance:e}");
    Ok(())
}

/// Every part of the jet is the derivative of the position that its name says.
fn jet_is_derivative_of_position<C: Curve<N>, const N: usize>(
    curve: &C,
    q: &SVector<f64, N>,
    [dq, linear_dq]: [&SVector<f64, N>; 2],
    xi: f64,
) -> Result<(), TestCaseError> {
    let jet = curve.jet(q, xi);
    let jet_sizes: Jet<Magnitude, _> = curve.jet(&sizes(q), Magnitude::from(xi));
    let scale = |v: Vector3<Magnitude>| v.map(|v| v.scale);

    // The geometry.
    let g = &jet.geometry;
    let s = &jet_sizes.geometry;
    let expected = position_derivatives(curve, q, xi);
    let expected_sizes = nested_derivatives(curve, &sizes(q), Magnitude::from(xi)).map(scale);
    let actual =
        [("x", &g.x, s.x), ("t", &g.t, s.t), ("t_xi", &g.t_xi, s.t_xi), ("t_xixi", &g.t_xixi, s.t_xixi)];
    for (k, (name, actual, size)) in actual.into_iter().enumerate() {
        assert_close(name, actual, &expected[k], [expected_sizes[k], scale(size)])?;
    }

    // The first variations.
    let along = SVector::from_fn(|i, _| Dual64::new(q[i], dq[i]));
    let expected = position_derivatives(curve, &along, xi);
    let along = SVector::from_fn(|i, _| Dual::new(q[i].into(), dq[i].into()));
    let expected_sizes = nested_derivatives(curve, &along, Dual::<Magnitude>::from(xi));
    for k in 0..3 {
        let scales = [expected_sizes[k].map(|x| x.eps.scale), scale(jet_sizes.dofs.variation(k, &sizes(dq)))];
        let actual = jet.dofs.variation(k, dq);
        assert_close(&format!("variation {k}"), &actual, &expected[k].map(|x| x.eps), scales)?;
    }

    // The second variations.
    let along = SVector::from_fn(|i, _| HyperDual64::new(q[i], dq[i], linear_dq[i], 0.0));
    let expected = position_derivatives(curve, &along, xi);
    let along =
        SVector::from_fn(|i, _| HyperDual::new(q[i].into(), dq[i].into(), linear_dq[i].into(), 0.0.into()));
    let expected_sizes = nested_derivatives(curve, &along, HyperDual::<Magnitude>::from(xi));
    for k in 0..2 {
        let scales = [
            expected_sizes[k].map(|x| x.eps1eps2.scale),
            scale(jet_sizes.dofs.second_variation(k, &sizes(dq), &sizes(linear_dq))),
        ];
        let actual = jet.dofs.second_variation(k, dq, linear_dq);
        assert_close(&format!("second variation {k}"), &actual, &expected[k].map(|x| x.eps1eps2), scales)?;
        if C::Dofs::<f64>::LINEAR {
            prop_assert_eq!(actual, Vector3::zeros());
        }
    }
    Ok(())
}

/// The matrices of the jet hold, entry by entry, the variations in unit directions.
fn matrices_hold_the_variations<C: Curve<N>, const N: usize>(
    curve: &C,
    q: &SVector<f64, N>,
    w: &Vector3<f64>,
    xi: f64,
) -> Result<(), TestCaseError> {
    let dofs = curve.jet(q, xi).dofs;
    let dof_sizes = curve.jet(&sizes(q), Magnitude::from(xi)).dofs;
    let unit = |i: usize| SVector::<f64, N>::from_fn(|j, _| f64::from(u8::from(i == j)));
    let size = |v: Vector3<Magnitude>| sizes(w).dot(&v).scale;
    for i in 0..N {
        for k in 0..3 {
            let error = dofs.gradient(k, w)[i] - w.dot(&dofs.variation(k, &unit(i)));
            let scale = size(dof_sizes.variation(k, &sizes(&unit(i))));
            prop_assert!(error.abs() <= TOLERANCE * scale, "gradient {k}, entry {i}: {error:e} of {scale:e}");
        }
        for (j, k) in (0..N).flat_map(|j| [(j, 0), (j, 1)]) {
            let error = dofs.hessian(k, w)[(i, j)] - w.dot(&dofs.second_variation(k, &unit(i), &unit(j)));
            let scale = size(dof_sizes.second_variation(k, &sizes(&unit(i)), &sizes(&unit(j))));
            prop_assert!(
                error.abs() <= TOLERANCE * scale,
                "hessian {k}, entry {i}, {j}: {error:e} of {scale:e}"
            );
        }
    }
    Ok(())
}

/// The bound holds wherever x,xixixi is sampled.
fn bound_holds<const N: usize>(curve: &impl Curve<N>, q: &SVector<f64, N>) -> Result<(), TestCaseError> {
    let bound = curve.third_derivative_bound(q);
    for i in -10..=10 {
        let xi = 0.1 * f64::from(i);
        let third = curve.jet(q, xi).geometry.t_xixi.norm();
        let rounding = curve.jet(&sizes(q), Magnitude::from(xi)).geometry.t_xixi.map(|x| x.scale).norm();
        prop_assert!(third <= bound + TOLERANCE * rounding, "{third} > {bound} at {xi}");
    }
    Ok(())
}

/// The three properties that every family has, over random dofs.
macro_rules! families {
    ($($name:ident: $curve:expr, $dofs:expr;)*) => {$(
        mod $name {
            use super::*;

            proptest! {
                #[test]
                fn jet_is_derivative_of_position(
                    curve in $curve, q in $dofs, dq in vector(), linear_dq in vector(), xi in parameter(),
                ) {
                    super::jet_is_derivative_of_position(&curve, &q, [&dq, &linear_dq], xi)?;
                }

                #[test]
                fn bound_holds(curve in $curve, q in $dofs) {
                    super::bound_holds(&curve, &q)?;
                }
            }

            proptest! {
                #![proptest_config(ProptestConfig::with_cases(16))]
                #[test]
                fn matrices_hold_the_variations(
                    curve in $curve, q in $dofs, w in vector::<3>(), xi in parameter(),
                ) {
                    super::matrices_hold_the_variations(&curve, &q, &w, xi)?;
                }
            }
        }
    )*};
}

families! {
    segment: Just(Segment::new()), vector::<6>();
    quadratic: Just(Quadratic::new()), vector::<9>();
    cubic: Just(Cubic::new()), vector::<12>();
    quintic: Just(Lagrange::<6>::new()), vector::<18>();
    hermite: prop_oneof![Just(Hermite::new()), (0.1..10.0).prop_map(Hermite::scaled_by)], vector::<12>();
    bezier_line: Just(Bezier::<2>::new()), vector::<6>();
    bezier_parabola: Just(Bezier::<3>::new()), vector::<9>();
    bezier_quintic: Just(Bezier::<6>::new()), vector::<18>();
    bspline_linear: knots::<2>().prop_map(|k| BSpline::<2>::new(&k).unwrap()), vector::<6>();
    bspline_cubic: knots::<4>().prop_map(|k| BSpline::<4>::new(&k).unwrap()), vector::<12>();
    bspline_quartic: knots::<5>().prop_map(|k| BSpline::<5>::new(&k).unwrap()), vector::<15>();
    nurbs_linear: (knots::<2>(), weights()).prop_map(|(k, w)| Nurbs::<2>::new(&k, w).unwrap()), vector::<6>();
    nurbs_cubic: (knots::<4>(), weights()).prop_map(|(k, w)| Nurbs::<4>::new(&k, w).unwrap()), vector::<12>();
    nurbs_weighted_linear: knots::<2>().prop_map(|k| NurbsWeighted::<2>::new(&k).unwrap()),
        weighted_points::<2, 8>();
    nurbs_weighted_cubic: knots::<4>().prop_map(|k| NurbsWeighted::<4>::new(&k).unwrap()),
        weighted_points::<4, 16>();
    arc_of_a_circle: (-3.0..3.0).prop_map(Arc::new), arc();
    screw_line: (-6.0..6.0).prop_map(Helix::new), helix();
}

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
        // A cubic over simple knots is twice continuously differentiable; xi runs faster over a longer span.
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
        // From xi = -1 to xi = 1 it winds through 2 alpha: one turn.
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
