//! Closest points compared with published values and with values computed with fifty digits.

use crate::centroids::{Winding, apart, close, ellipse, line, over_pieces};
use beamgap::closest_point::{Centroid, ClosestPoint};
use beamgap::closest_point::{Held, Kind, Search, SquaredDistance, closest_points, refine};
use beamgap::curve::{Arc, Geometry, Hermite};
use beamgap::pair::{DofVector, Pair};
use nalgebra::{Rotation3, SVector, Vector3};
use std::f64::consts::PI;

fn unit_circle() -> Winding {
    ellipse([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).over(-PI, PI)
}

/// a, b, a_bar and D per unit of the sources' parameters. A piece extends `half` of this parameter to either side.
fn projection(curve: &Winding, bar: &Winding, point: &ClosestPoint) -> SquaredDistance {
    SquaredDistance::new(&curve.geometry(point.xi), &bar.geometry(point.xi_bar))
}

#[test]
fn a_beam_tells_of_its_curve() {
    let q = SVector::from([0.0, 0.0, 0.0, 3.0, 1.0, 0.0, 2.0, 1.0, 0.0, 0.0, 4.0, 1.0]);
    let of_arc = SVector::from([0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    let (pair, q) = (Pair::new(Hermite::new(), Arc::new(1.0)), DofVector { beam: q, bar: of_arc });
    let (hermite, arc) = pair.centroids(&q);
    close(hermite.third_derivative_bound(), 1.5 * 18.0_f64.sqrt(), 1e-15);
    assert!(hermite.is_cubic());
    assert!(!arc.is_cubic());
}

#[test]
fn skew_lines() {
    let x = line([0.0; 3], [1.0, 0.0, 0.0], -1.0, 1.0);
    let bar = line([0.5, 0.0, 0.25], [0.6, 0.8, 0.0], -1.0, 1.0);
    let found = closest_points(&x, &bar, &Search::default()).unwrap();
    let point = found.interior().unwrap();
    close(point.xi, 0.5, 1e-15);
    assert!(point.xi_bar.abs() < 1e-15);
    close(point.distance, 0.25, 1e-15);
    let p = projection(&x, &bar, point);
    close(p.a, 1.0, 1e-15);
    close(p.a_bar, -1.0, 1e-15);
    close(p.b, 0.6, 1e-15);
    close(p.determinant(), -0.64, 1e-14);
    close(point.conditioning, 0.4, 1e-14);
    assert_eq!((found.minima.len(), found.stationary.len()), (1, 0));
}

#[test]
fn line_against_circle() {
    let third = 1.0 / 3.0;
    let x = line([1.5, -0.25, 0.5], [third, 2.0 * third, 2.0 * third], -4.0, 4.0);
    // The saddle has eta = -3.63, which is the angle 2.65 on the circle.
    let found = over_pieces(&x, &unit_circle(), [1, 2]);
    assert_eq!(found.len(), 2, "{found:?}");
    let [minimum, saddle] = [found[0], found[1]];
    assert_eq!((minimum.kind, saddle.kind), (Kind::Minimum, Kind::Saddle));
    close(minimum.xi, -0.707_813_971_810_151_2, 1e-14);
    close(minimum.xi_bar, -0.518_880_590_598_702_5, 1e-14);
    close(minimum.distance, 0.456_531_100_811_247_9, 1e-14);
    close(saddle.xi, -0.648_235_184_664_646_1, 1e-14);
    assert!(apart(saddle.xi_bar, -3.629_971_211_512_871) < 1e-14);
    close(saddle.distance, 2.454_826_435_356_576, 1e-14);
    let [at, at_bar] =
        [(x, minimum.xi), (unit_circle(), minimum.xi_bar)].map(|(curve, s)| unit_speed(&curve, s));
    close(SquaredDistance::new(&at, &at_bar).determinant(), -0.901_801_550_299_113_9, 1e-14);
}

/// The geometry with respect to the parameter of the source.
fn unit_speed(curve: &Winding, s: f64) -> Geometry<f64> {
    curve.over(s - 1.0, s + 1.0).geometry(0.0)
}

#[test]
fn two_circles_have_two_minima_a_maximum_and_three_saddles() {
    let bar = ellipse([1.2, 0.3, 0.4], [0.48, 0.0, 0.64], [0.0, 0.8, 0.0]).over(-PI, PI);
    for counts in [[2, 2], [3, 4], [8, 5]] {
        let found = over_pieces(&unit_circle(), &bar, counts);
        let of = |kind| found.iter().filter(move |point| point.kind == kind);
        let count = |kind| of(kind).count();
        assert_eq!([count(Kind::Minimum), count(Kind::Maximum), count(Kind::Saddle)], [2, 1, 3]);
        let expected = [
            (-0.360_272_297_851_034_5, -2.203_543_336_006_708, 0.030_076_459_504_132_73),
            (0.740_506_228_934_199_6, 2.581_237_834_519_492, 0.160_648_289_100_202_9),
        ];
        for (point, (xi, xi_bar, distance)) in of(Kind::Minimum).zip(expected) {
            close(point.xi, xi, 3e-14);
            close(point.xi_bar, xi_bar, 3e-14);
            close(point.distance, distance, 1e-13);
        }
        close(of(Kind::Maximum).next().unwrap().distance, 2.924_816_121_311_37, 1e-14);
    }
}

#[test]
fn helix_against_line() {
    let helix = Winding { w: Vector3::new(0.0, 0.0, 0.25), ..unit_circle() };
    let bar = line([1.6, 0.0, 0.1], [0.0, 0.8, 0.6], -4.0, 4.0);
    let found = over_pieces(&helix.over(-2.0, 9.0), &bar, [4, 1]);
    let minima: Vec<_> = found.into_iter().filter(|point| point.kind == Kind::Minimum).collect();
    let expected = [
        (-0.042_026_070_572_861_63, -0.099_914_871_111_347_05, 0.604_197_151_636_359_2),
        (6.764_381_420_368_294, 1.324_929_046_081_899_2, 1.224_554_293_392_717_4),
    ];
    for (xi, xi_bar, distance) in expected {
        let point = minima.iter().find(|point| (point.xi - xi).abs() < 0.1).unwrap();
        close(point.xi, xi, 3e-14);
        close(point.xi_bar, xi_bar, 3e-14);
        close(point.distance, distance, 1e-14);
    }
}

#[test]
fn two_segments() {
    let between = |from: [f64; 3], to: [f64; 3]| {
        let (from, to) = (Vector3::from(from), Vector3::from(to));
        Winding { centre: (from + to) / 2.0, w: (to - from) / 2.0, from: -1.0, to: 1.0, ..Winding::default() }
    };
    let x = between([-1.0, 0.0, 0.0], [1.0, 0.25, 0.125]);
    let bar = between([-0.5, -1.0, 0.5], [0.75, 1.0, 0.625]);
    let found = closest_points(&x, &bar, &Search::default()).unwrap();
    let point = found.interior().unwrap();
    close(point.xi, 0.243_598_912_887_998_86, 1e-15);
    close(point.xi_bar, 0.142_898_011_729_366_33, 1e-15);
    close(point.distance, 0.494_733_384_199_867_6, 1e-15);
    assert!(point.residual < 1e-15);
    let again = refine(&x, &bar, (0.9, -0.9), Held::default()).unwrap();
    assert_eq!((again.xi, again.xi_bar), (point.xi, point.xi_bar));
}

/// A curve whose points are accurate to ten digits only.
struct Rough(Winding);

impl Centroid for Rough {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        let Geometry { x, t, t_xi, t_xixi } = self.0.geometry(xi);
        Geometry { x: x.map(|c| (c * 1e10).round() * 1e-10), t, t_xi, t_xixi }
    }

    fn third_derivative_bound(&self) -> f64 {
        self.0.third_derivative_bound()
    }
}

#[test]
fn newtons_method_ends_at_the_rounding_of_the_points() {
    let x = Rough(ellipse([0.1, 0.2, 0.3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).over(-1.0, 1.0));
    let bar = Rough(ellipse([2.3, 0.4, 0.1], [-0.9, 0.0, 0.3], [0.0, 0.8, 0.7]).over(-1.0, 1.0));
    let point = refine(&x, &bar, (0.1, 0.2), Held::default()).unwrap();
    let exact = refine(&x.0, &bar.0, (0.1, 0.2), Held::default()).unwrap();
    assert!(point.residual > 1e-12, "{}", point.residual);
    assert!((point.xi - exact.xi).abs().max((point.xi_bar - exact.xi_bar).abs()) < 1e-8);
}

/// The ellipse with the elements (a, e, ω, Ω, i), angles in degrees, as a function of the eccentric anomaly.
fn orbit([a, e, perihelion, node, inclination]: [f64; 5]) -> Winding {
    let turn = |axis, degrees: f64| Rotation3::from_axis_angle(&axis, degrees.to_radians());
    let frame = turn(Vector3::z_axis(), node)
        * turn(Vector3::x_axis(), inclination)
        * turn(Vector3::z_axis(), perihelion);
    let (p, q) = (frame * Vector3::x(), frame * Vector3::y());
    let u = p * a;
    Winding {
        centre: -u * e,
        u,
        v: q * (a * (1.0 - e * e).sqrt()),
        from: 0.0,
        to: 2.0 * PI,
        ..Winding::default()
    }
}

#[test]
fn orbits_of_asteroids() {
    let ceres = orbit([2.769_165_2, 0.076_009_1, 73.597_64, 80.305_53, 10.594_07]);
    let others = [
        ([2.554_113_6, 0.072_695_6, 63.363_19, 356.341_76, 6.082_52], 0.156_774_634_527_37),
        ([2.365_572_2, 0.127_581, 87.426_05, 307.468_72, 2.095_75], 0.245_214_406_558_32),
        ([2.648_793_9, 0.285_985_6, 200.080_54, 173.528_74, 2.838_22], 0.089_347_340_261_05),
        ([2.365_835_4, 0.067_559_4, 2.580_53, 175.978_5, 9.977_18], 0.359_726_784_607_06),
    ];
    for (elements, distance) in others {
        let found = over_pieces(&ceres, &orbit(elements), [4, 4]);
        assert_eq!(found.len(), 6);
        assert_eq!(found.iter().filter(|point| point.kind == Kind::Minimum).count(), 2);
        close(found[0].distance, distance, 3e-13);
    }
}
