//! Tests that the drawn pairs lie on both sides of every symmetry.

use super::{Coverage, Symmetry, geometry};
use crate::check::{Case, Regime, Selection};
use crate::closest_point::{Search, closest_points};
use crate::curve::Geometry;
use crate::test_beam::Family;
use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;

/// The smallest share of either side.
const LEAST: f64 = 0.35;

/// The closest points of the first cases of a regime, with their counts by family.
fn covered(regime: Regime, cases: u64) -> (Coverage, BTreeMap<Family, Coverage>) {
    let (mut all, mut families) = (Coverage::default(), BTreeMap::<Family, Coverage>::new());
    for number in (Selection { regimes: vec![regime], family: None, cases }).numbers() {
        let case = Case::draw(0x5eed, number);
        let [beam, bar] = case.beams();
        let Ok(found) = closest_points(beam, bar, &Search::default()) else { continue };
        for point in found.minima.iter().filter(|point| point.degeneracy().is_none()) {
            all.add(&case, point);
            for family in case.families {
                families.entry(family).or_default().add(&case, point);
            }
        }
    }
    (all, families)
}

fn assert_balanced(coverage: &Coverage, of: &str, least: f64) {
    for (symmetry, counts) in &coverage.counts {
        let share = coverage.share(*symmetry).unwrap();
        assert!(share >= least, "{of}: {} is {counts:?}", symmetry.name());
    }
}

#[test]
fn every_regime_and_family_lies_on_both_sides_of_every_symmetry() {
    let mut families = BTreeMap::<Family, Coverage>::new();
    for regime in Regime::ALL {
        let (all, of_families) = covered(regime, 5 * 121);
        assert_eq!(all.counts.len(), Symmetry::ALL.len(), "{}: {:?}", regime.name(), all.counts);
        assert_balanced(&all, regime.name(), LEAST);
        for (family, coverage) in of_families {
            families.entry(family).or_default().merge(&coverage);
        }
    }
    assert_eq!(families.len(), Family::ALL.len());
    for (family, coverage) in &families {
        // Straight beams have no curvature, but their partners do: so every symmetry occurs.
        assert_eq!(coverage.counts.len(), Symmetry::ALL.len(), "{}", family.name());
        assert_balanced(coverage, family.name(), LEAST);
    }
}

/// A beam and a bar beam with all signs positive but those of xi, slip and gap, which depend on the point.
fn positive() -> [Geometry<f64>; 2] {
    let vector = |x: [f64; 3]| Vector3::from(x);
    let beam = Geometry {
        x: vector([0.1, 0.2, 1.0]),
        t: vector([1.0, -0.05, -0.09]),
        t_xi: vector([0.1, 0.3, 0.2]),
        t_xixi: vector([0.0, -0.2, 0.4]),
    };
    let bar = Geometry {
        x: vector([0.0; 3]),
        t: vector([0.3, 0.8, -0.19]),
        t_xi: vector([0.2, 0.2, -0.3]),
        t_xixi: vector([-0.5, 0.2, -0.3]),
    };
    [beam, bar]
}

/// The signs of the products, which no parameter enters.
fn signs(at: &[Geometry<f64>; 2]) -> [Option<bool>; 12] {
    use Symmetry::{
        Crossing, Curvature, CurvatureBar, Length, Side, Speed, SpeedBar, Torsion, TorsionBar, X, Y, Z,
    };
    let case = Case::draw(1, 0);
    let [beam, bar] = case.beams();
    let point = closest_points(beam, bar, &Search::default()).unwrap().minima[0];
    [Side, Crossing, Speed, SpeedBar, Curvature, CurvatureBar, Torsion, TorsionBar, Length, X, Y, Z]
        .map(|symmetry| symmetry.is_positive(at, &point, &case.contact))
}

fn transformed(at: [Geometry<f64>; 2], by: &Matrix3<f64>) -> [Geometry<f64>; 2] {
    at.map(|Geometry { x, t, t_xi, t_xixi }| {
        let [x, t, t_xi, t_xixi] = [x, t, t_xi, t_xixi].map(|v| by * v);
        Geometry { x, t, t_xi, t_xixi }
    })
}

#[test]
fn a_symmetry_changes_the_signs_that_its_description_says() {
    let changed = |after: [Geometry<f64>; 2]| {
        let (before, after) = (signs(&positive()), signs(&after));
        std::array::from_fn::<_, 12, _>(|i| before[i].unwrap() != after[i].unwrap())
    };
    let [beam, bar] = positive();
    let reversed = |g: Geometry<f64>| Geometry { t: -g.t, t_xixi: -g.t_xixi, ..g };
    let list = |indices: &[usize]| std::array::from_fn::<_, 12, _>(|i| indices.contains(&i));
    // A mirror image in x: side, torsions, and the first component.
    let mirror = Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0));
    assert_eq!(changed(transformed([beam, bar], &mirror)), list(&[0, 6, 7, 9]));
    // Reversal of xi: side, crossing, speed.
    assert_eq!(changed([reversed(beam), bar]), list(&[0, 1, 2]));
    assert_eq!(changed([beam, reversed(bar)]), list(&[0, 1, 3]));
    // The other side of the bar beam: side, curvatures, the components of d.
    let other = Geometry { x: bar.x * 2.0 - beam.x, ..beam };
    assert_eq!(changed([other, bar]), list(&[0, 4, 5, 9, 10, 11]));
    // Exchange: the length, d; the other signs are those of the other beam, which differ in the curvatures here.
    let (before, after) = (signs(&[beam, bar]), signs(&[bar, beam]));
    let of_other = [0, 1, 3, 2, 5, 4, 7, 6].map(|i: usize| before[i]);
    assert_eq!(after[..8], of_other);
    assert_eq!(after[8..], before[8..].iter().map(|sign| sign.map(|sign| !sign)).collect::<Vec<_>>());
}

#[test]
fn a_sign_of_rounding_is_not_counted() {
    let [mut beam, bar] = positive();
    beam.t_xi = Vector3::zeros();
    assert_eq!(signs(&[beam, bar])[2], None);
    beam.t_xi = Vector3::new(1e-12, 1.0, 0.0);
    beam.t = Vector3::new(1.0, 0.0, 0.0);
    assert_eq!(signs(&[beam, bar])[2], None);
}

#[test]
fn sides_that_no_point_is_on_are_named() {
    let case = Case::draw(1, 0);
    let [beam, bar] = case.beams();
    let point = closest_points(beam, bar, &Search::default()).unwrap().minima[0];
    let mut coverage = Coverage::default();
    assert_eq!(coverage.unseen().len(), 2 * Symmetry::ALL.len());
    coverage.add(&case, &point);
    let seen = coverage.counts.len();
    assert!(seen >= 10);
    assert_eq!(coverage.unseen().len(), 2 * Symmetry::ALL.len() - seen);
    let [_, sides @ ..] = Symmetry::Side.sides();
    let is_positive = Symmetry::Side.is_positive(&geometry(&case, &point), &point, &case.contact).unwrap();
    assert!(coverage.unseen().contains(&(Symmetry::Side, sides[usize::from(is_positive)])));
    assert!(!coverage.unseen().contains(&(Symmetry::Side, sides[usize::from(!is_positive)])));
}

/// Among pairs of one family alone, the symmetries that no closest point has are those that the family cannot have.
#[test]
fn a_family_has_the_signs_that_its_curves_can_have() {
    for family in Family::ALL {
        let mut coverage = Coverage::default();
        for number in 0..40 {
            let case = Case::of(0x5eed, number, Regime::Generic, [family; 2]);
            let [beam, bar] = case.beams();
            let Ok(found) = closest_points(beam, bar, &Search::default()) else { continue };
            for point in found.minima.iter().filter(|point| point.degeneracy().is_none()) {
                coverage.add(&case, point);
            }
        }
        for symmetry in Symmetry::ALL {
            let (has, of) = (coverage.counts.contains_key(&symmetry), (family.name(), symmetry.name()));
            assert_eq!(has, symmetry.has_sign_with(family), "{of:?}");
        }
    }
}
