//! The linearization compared with independent numbers: published values, and differences of values.

use crate::centroids::Winding;
use crate::pairs::{Contacting, Movable, any_helix, contacting, hermite, least_eigenvalue, nurbs, refined};
use beamgap::closest_point::{Centroid, ClosestPoint, Held, SquaredDistance};
use beamgap::curve::{Hermite, Segment};
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
    let Contacting { pair, q, dq, linear_dq, .. } = case;
    let (h, points) = steps(case);
    let along = |k: usize| {
        let q = q.plus(AT[k] * h, linear_dq);
        closed_form::vary(pair, &q, &points[k], dq, linear_dq).components()
    };
    let [minus_two, minus_one, closed, one, two] = [0, 1, 2, 3, 4].map(along);
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

/// The points of the differences, in steps.
const AT: [f64; 5] = [-2.0, -1.0, 0.0, 1.0, 2.0];

/// The step of the differences, and the closest points there. The step moves the parameters by 1e-4, or by less next to a
/// fold.
///
/// At the distance R from a fold the eigenvalue of least size is as the root of R. If it changes by less than 1/64 over
/// two steps, h / R is less than 1/64 too. The parameters are as the same root. Their fourth-order differences are then wrong
/// by 59/30 (h / R)^4 < 1.2e-7 of the second variation, and by less of the first. Rounding divided by the step is smaller.
fn steps<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    Contacting { pair, q, point, dq, linear_dq }: &Contacting<A, B, N, M>,
) -> (f64, [ClosestPoint; 5]) {
    let first = closed_form::vary(pair, q, point, dq, linear_dq);
    let mut h = 1e-4 / first.xi.linear.abs().max(first.xi_bar.linear.abs()).max(1.0);
    let least = least_eigenvalue(pair, q, point);
    for _ in 0..8 {
        let found = AT.map(|k| {
            let q = q.plus(k * h, linear_dq);
            let found = refined(pair, &q, (point.xi, point.xi_bar), point.held())?;
            let change = (least_eigenvalue(pair, &q, &found) / least - 1.0).abs();
            // Infinite eigenvalues are those of two ends.
            (change.is_nan() || change < 1.0 / 64.0).then_some(found)
        });
        if let [Some(a), Some(b), Some(c), Some(d), Some(e)] = found {
            return (h, [a, b, c, d, e]);
        }
        h *= 0.25;
    }
    panic!("the closest point is singular: {point:?}");
}

fn prop_close(ours: f64, theirs: f64, limit: f64, component: usize) {
    assert!((ours - theirs).abs() <= limit, "component {component}: {ours:e}, not {theirs:e}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn differences_of_two_hermites(case in contacting(hermite(), hermite())) {
        differences_agree(&case);
    }

    #[test]
    fn differences_of_weighted_nurbs_and_helix(case in contacting(nurbs(), any_helix())) {
        differences_agree(&case);
    }
}

/// A saddle whose eigenvalues are -1.03 and 1.3e-3. In steps that move its parameters by 1e-4, it meets a minimum at
/// -1.95 steps, by 40 digits, and beyond that neither of the two is there.
#[test]
fn next_to_a_fold_the_steps_are_small() {
    let of = |beam: [f64; 12], bar: [f64; 12]| DofVector { beam: beam.into(), bar: bar.into() };
    let pair = Pair::new(Hermite::new(), Hermite::new());
    let q = of(
        [
            -1.057_231_643_372_102_3,
            -1.049_030_563_960_820_6,
            -0.787_114_035_545_807_7,
            -1.194_686_846_823_165_3,
            0.744_193_400_690_905_8,
            -0.661_520_932_504_923_7,
            -1.187_209_819_165_310_4,
            -2.495_210_106_257_707,
            -0.761_176_728_144_579_4,
            -1.503_656_073_812_384_5,
            -0.563_281_289_533_068_9,
            1.647_492_429_975_912_8,
        ],
        [
            -1.281_120_517_383_715_5,
            -0.858_142_409_509_365_7,
            0.040_786_289_167_454_79,
            1.156_353_505_433_224,
            -0.393_235_460_144_022_66,
            1.205_689_904_069_539,
            -1.211_962_067_641_581_4,
            -1.576_142_406_333_516,
            0.210_135_967_386_150_92,
            1.137_342_037_216_527_5,
            1.934_961_257_505_030_1,
            0.193_820_743_881_711_8,
        ],
    );
    let linear_dq = of(
        [
            0.463_465_176_934_721_7,
            -1.680_223_512_105_495_4,
            -1.285_788_061_816_765_4,
            1.664_386_486_998_618_2,
            0.690_008_921_402_745_5,
            -1.389_011_877_127_061_2,
            -0.148_956_854_925_939_52,
            -0.544_246_644_829_83,
            1.758_146_039_287_033,
            1.135_248_092_777_538_8,
            0.079_850_812_718_461_69,
            1.317_759_603_531_599_5,
        ],
        [
            0.280_398_958_099_492_95,
            -1.965_091_387_413_803_6,
            0.183_637_526_635_145_02,
            0.042_923_332_337_895_59,
            0.605_606_577_931_577_2,
            1.376_913_783_003_648,
            1.845_847_902_394_155_6,
            -1.377_715_371_092_196,
            0.507_149_073_846_806_9,
            -0.457_462_468_315_623_87,
            0.715_772_624_834_108_4,
            0.839_152_100_880_204_5,
        ],
    );
    let at = (-0.000_287_889_836_399_606_6, 0.154_194_329_628_369_18);
    let point = refined(&pair, &q, at, Held::default()).unwrap();
    assert!(point.conditioning < -1.0 && least_eigenvalue(&pair, &q, &point) < 1.4e-3, "{point:?}");
    let case = Contacting { pair, q, point, dq: linear_dq, linear_dq };
    let first = closed_form::vary(&pair, &q, &point, &linear_dq, &linear_dq);
    let far = -2e-4 / first.xi_bar.linear.abs();
    assert!(first.xi_bar.linear.abs() > first.xi.linear.abs());
    assert_eq!(refined(&pair, &q.plus(far, &linear_dq), at, Held::default()), None);
    let (h, [minus_two, minus_one, _, one, two]) = steps(&case);
    let difference = |of: fn(&ClosestPoint) -> f64| {
        (8.0 * (of(&one) - of(&minus_one)) - (of(&two) - of(&minus_two))) / (12.0 * h)
    };
    let near = |ours: f64, theirs: f64| assert!((ours / theirs - 1.0).abs() < 1e-6, "{ours}, not {theirs}");
    near(first.xi.linear, difference(|point| point.xi));
    near(first.xi_bar.linear, difference(|point| point.xi_bar));
    differences_agree(&case);
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
