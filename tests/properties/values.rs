//! The linearization compared with independent numbers: published values, and differences of values.

use crate::centroids::Winding;
use crate::pairs::{Contacting, Movable, any_helix, contacting, hermite, nurbs, refined};
use beamgap::closest_point::{Centroid, Held, SquaredDistance};
use beamgap::curve::Segment;
use beamgap::linearization::closed_form;
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

fn close(ours: f64, theirs: f64) {
    assert!((ours - theirs).abs() <= 1e-14 * theirs.abs(), "{ours:.17}, not {theirs:.17}");
}

/// The reference values were computed elsewhere with 40 digits.
#[test]
#[expect(clippy::excessive_precision, reason = "the digits of the source")]
fn two_lines_have_the_known_derivatives() {
    let pair = Pair { curve: Segment::new(), curve_bar: Segment::new(), contact: Contact::default() };
    let q = DofVector {
        beam: SVector::from([-1.0, 0.0, 0.0, 1.0, 0.25, 0.125]),
        bar: SVector::from([-0.5, -1.0, 0.5, 0.75, 1.0, 0.625]),
    };
    let point = refined(&pair, &q, (0.0, 0.0), Held::default()).unwrap();
    let l = pair.linearize(&q, &point);
    close(l.xi.value, 0.243_598_912_887_998_86);
    close(l.xi_bar.value, 0.142_898_011_729_366_33);
    close(l.d.value, 0.494_733_384_199_867_6);
    close(l.xi.gradient.entry(0), -0.385_269_320_971_989_223);
    close(l.xi.gradient.entry(11), -0.191_264_404_541_949_341);
    close(l.d.gradient.entry(2), -0.377_415_304_422_621_746);
    close(l.xi.hessian.entry(0, 7), -0.170_708_523_304_900_16);
    close(l.xi.hessian.entry(2, 8), -0.503_334_826_477_612_629);
    close(l.d.hessian.entry(4, 11), 0.333_967_227_689_172_845);
    close(l.d.hessian.entry(8, 11), 0.148_535_989_330_797_648);
}

/// The closest point is solved for again at points along one direction. Fourth-order central differences of the values
/// give the first variation, and those of the first variations give the second variation.
fn differences_agree<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    case: &Contacting<A, B, N, M>,
) {
    let Contacting { pair, q, point, dq, linear_dq } = case;
    let at = (point.xi, point.xi_bar);
    let along = |h: f64| {
        let q = q.plus(h, linear_dq);
        let point = refined(pair, &q, at, point.held()).expect("stays regular");
        closed_form::vary(pair, &q, &point, dq, linear_dq).components()
    };
    // The step moves the parameters by 1e-4.
    let first = closed_form::vary(pair, q, point, dq, linear_dq);
    let h = 1e-4 / first.xi.linear.abs().max(first.xi_bar.linear.abs()).max(1.0);
    let [two, one, minus_one, minus_two] = [2.0, 1.0, -1.0, -2.0].map(|k| along(k * h));
    let closed = along(0.0);
    let size =
        closed.iter().fold(1.0_f64, |size, v| v.parts().into_iter().fold(size, |size, x| size.max(x.abs())));
    for i in 0..closed.len() {
        let difference = |part: usize| {
            let of = |row: &[beamgap::linearization::Varied<f64>; 23]| row[i].parts()[part];
            (8.0 * (of(&one) - of(&minus_one)) - (of(&two) - of(&minus_two))) / (12.0 * h)
        };
        let limit = 1e-6 * size * size;
        prop_close(closed[i].linear, difference(0), limit, i);
        prop_close(closed[i].second, difference(1), limit, i);
    }
}

fn prop_close(ours: f64, theirs: f64, limit: f64, component: usize) {
    assert!((ours - theirs).abs() <= limit, "component {component}: {ours:e}, not {theirs:e}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn differences_of_two_hermites(case in contacting(hermite(), hermite())) {
        prop_assume!(case.point.conditioning.abs() > 0.1);
        differences_agree(&case);
    }

    #[test]
    fn differences_of_weighted_nurbs_and_helix(case in contacting(nurbs(), any_helix())) {
        prop_assume!(case.point.conditioning.abs() > 0.1);
        differences_agree(&case);
    }
}

/// Two circles that curve towards each other with curvatures k and k_bar, at distance h and angle alpha. In arc length
/// D = cos² alpha - (1 - h k)(1 - h k_bar).
#[test]
fn the_local_theory_gives_the_determinant() {
    for (h, k, k_bar, alpha) in [(0.3, 0.7, -0.4, 0.6_f64), (0.05, 2.0, 3.0, 1.2), (1.5, -0.2, 0.1, 0.3)] {
        // The bar beam is above. Each circle passes its point at phase 0, along its tangent.
        let circle = |height: f64, along: Vector3<f64>, towards: f64, k: f64| {
            let radius = 1.0 / k;
            Winding {
                centre: Vector3::z() * (height + towards * radius),
                u: Vector3::z() * (-towards * radius),
                v: along * radius,
                from: -1.0,
                to: 1.0,
                ..Winding::default()
            }
        };
        let beam = circle(0.0, Vector3::x(), 1.0, k);
        let bar = circle(h, Vector3::new(alpha.cos(), alpha.sin(), 0.0), -1.0, k_bar);
        let (x, y) = (beam.geometry(0.0), bar.geometry(0.0));
        let at = SquaredDistance::new(&x, &y);
        let scaled = at.determinant() / (x.t.norm_squared() * y.t.norm_squared());
        let expected = alpha.cos().powi(2) - (1.0 - h * k) * (1.0 - h * k_bar);
        assert!((scaled - expected).abs() < 1e-14, "{scaled}, not {expected}");
    }
}
