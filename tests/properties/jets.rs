//! [`Curve::jet`] returns in closed form the derivatives of [`Curve::position`].

use crate::strategies::{arc, helix, knots, parameter, vector, weighted_points, weights};
use beamgap::check;
use beamgap::curve::{
    Arc, BSpline, Bezier, Cubic, Curve, Helix, Hermite, Lagrange, Nurbs, NurbsWeighted, Quadratic, Segment,
};
use beamgap::number::RunningError;
use nalgebra::SVector;
use proptest::prelude::*;

/// The bound is not exceeded by x,xixixi at the sampled parameters.
fn bound_holds<const N: usize>(curve: &impl Curve<N>, q: &SVector<f64, N>) {
    let bound = curve.third_derivative_bound(q);
    for i in -10..=10 {
        let xi = 0.1 * f64::from(i);
        let third = curve.jet(&q.map(RunningError::from), RunningError::from(xi)).geometry.t_xixi;
        let [value, rounding] = [third.map(|x| x.value).norm(), third.map(|x| x.bound).norm()];
        assert!(value <= bound + rounding, "{value} > {bound} at {xi}");
    }
}

/// The properties of every family, over random dofs.
macro_rules! families {
    ($($name:ident: $curve:expr, $dofs:expr;)*) => {proptest! {$(
        #[test]
        fn $name(
            curve in $curve, q in $dofs, [dq, linear_dq] in [vector(), vector()], w in vector::<3>(), xi in parameter(),
        ) {
            let found = check::jet(&curve, &q, [&dq, &linear_dq], &w, xi);
            prop_assert!(found.is_empty(), "{}", found[0]);
            bound_holds(&curve, &q);
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
