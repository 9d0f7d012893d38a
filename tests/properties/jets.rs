//! What [`Curve::jet`] states in closed form is the derivative of what [`Curve::position`] computes.
//!
//! The derivatives come from num-dual; how far two results may differ is measured by the size of the terms of both,
//! which the same formulas over [`TermScale`] yield.

use crate::strategies::{arc, helix, knots, parameter, vector, weighted_points, weights};
use beamgap::curve::{
    Arc, BSpline, Bezier, Cubic, Curve, DofDerivatives, Helix, Hermite, Jet, Lagrange, Nurbs, NurbsWeighted,
    Quadratic, Segment,
};
use beamgap::number::{Dual, HyperDual, Real, TermScale};
use nalgebra::{SVector, Vector3};
use num_dual::{Dual3, Dual64, DualNum, HyperDual64};
use proptest::prelude::*;

/// Rounding, relative to the size of the terms.
pub(crate) const TOLERANCE: f64 = 1e-13;

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

fn sizes<const N: usize>(v: &SVector<f64, N>) -> SVector<TermScale, N> {
    v.map(TermScale::from)
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
    let jet_sizes: Jet<TermScale, _> = curve.jet(&sizes(q), TermScale::from(xi));
    let scale = |v: Vector3<TermScale>| v.map(|v| v.scale);

    // The geometry.
    let g = &jet.geometry;
    let s = &jet_sizes.geometry;
    let expected = position_derivatives(curve, q, xi);
    let expected_sizes = nested_derivatives(curve, &sizes(q), TermScale::from(xi)).map(scale);
    let actual =
        [("x", &g.x, s.x), ("t", &g.t, s.t), ("t_xi", &g.t_xi, s.t_xi), ("t_xixi", &g.t_xixi, s.t_xixi)];
    for (k, (name, actual, size)) in actual.into_iter().enumerate() {
        assert_close(name, actual, &expected[k], [expected_sizes[k], scale(size)])?;
    }

    // The first variations.
    let along = SVector::from_fn(|i, _| Dual64::new(q[i], dq[i]));
    let expected = position_derivatives(curve, &along, xi);
    let along = SVector::from_fn(|i, _| Dual::new(q[i].into(), dq[i].into()));
    let expected_sizes = nested_derivatives(curve, &along, Dual::<TermScale>::from(xi));
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
    let expected_sizes = nested_derivatives(curve, &along, HyperDual::<TermScale>::from(xi));
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
    let dof_sizes = curve.jet(&sizes(q), TermScale::from(xi)).dofs;
    let unit = |i: usize| SVector::<f64, N>::from_fn(|j, _| f64::from(u8::from(i == j)));
    let size = |v: Vector3<TermScale>| sizes(w).dot(&v).scale;
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
        let rounding = curve.jet(&sizes(q), TermScale::from(xi)).geometry.t_xixi.map(|x| x.scale).norm();
        prop_assert!(third <= bound + TOLERANCE * rounding, "{third} > {bound} at {xi}");
    }
    Ok(())
}

/// The three properties that every family has, over random dofs; that of the matrices, which are many, in one case of 16.
macro_rules! families {
    ($($name:ident: $curve:expr, $dofs:expr;)*) => {proptest! {$(
        #[test]
        fn $name(
            curve in $curve, q in $dofs, [dq, linear_dq] in [vector(), vector()], w in vector::<3>(), xi in parameter(),
            matrices in 0..16_u8,
        ) {
            jet_is_derivative_of_position(&curve, &q, [&dq, &linear_dq], xi)?;
            bound_holds(&curve, &q)?;
            if matrices == 0 {
                matrices_hold_the_variations(&curve, &q, &w, xi)?;
            }
        }
    )*}};
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
