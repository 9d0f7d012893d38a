//! Tests that a drawn case has the properties of its regime.

use super::{
    BADLY_SCALED, Case, FAMILIES, REGIMES, Selection, families, orthonormal, place_in_regime, regime,
};
use crate::check::regime::Draw;
use crate::check::{Family, Regime};
use crate::curve::Geometry;
use crate::number::RunningError;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeSet;

const SEED: u64 = 7;

/// Repeats the first draw of the regime of a case.
fn drawn(number: u64) -> Draw {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    rng.set_stream(number);
    regime(number).draw(&mut rng)
}

/// Point and tangent of both beams at the intended crossing.
fn crossing(case: &Case, at: [f64; 2]) -> [[Vector3<f64>; 2]; 2] {
    [0, 1].map(|i| {
        let Geometry { x, t, .. } = case.beams()[i].geometry_at(RunningError::from(at[i]));
        [x, t].map(|v| v.map(|c| c.value))
    })
}

#[test]
fn beams_cross_as_their_regime_draws() {
    for number in (0..REGIMES * FAMILIES * FAMILIES).step_by(7) {
        let (case, draw) = (Case::draw(SEED, number), drawn(number));
        let [[x, t], [x_bar, t_bar]] = crossing(&case, draw.at);
        let (d, length) = (x - x_bar, draw.length);
        // An arc that is bent by 1e-6 is accurate to six digits less.
        let rounding = 1e-9 * length;
        assert!((d.norm() - draw.gap * length).abs() < rounding, "{number}: {d} at {draw:?}");
        assert!(d.dot(&t.normalize()).abs() < rounding && d.dot(&t_bar.normalize()).abs() < rounding);
        let along = d.dot(&t.cross(&t_bar));
        assert!(along * draw.side > 0.0 || draw.gap * length < rounding, "{number}: {d} at {draw:?}");
        assert!(x_bar.amax() < 3.0 * length, "{number}: {x_bar}, of {length}");
    }
}

#[test]
fn straight_beams_have_the_length_and_the_angle_that_are_drawn() {
    let straight = |&number: &u64| {
        regime(number) == Regime::NearlyStraight && families(number) == [Family::Segment, Family::Segment]
    };
    let numbers: Vec<u64> = (0..40 * REGIMES * FAMILIES * FAMILIES).filter(straight).collect();
    assert_eq!(numbers.len(), 40);
    let mut lengths = Vec::new();
    for number in numbers {
        let (case, draw) = (Case::draw(SEED, number), drawn(number));
        let [[_, t], [_, t_bar]] = crossing(&case, draw.at);
        assert!((t.angle(&t_bar) - draw.angle).abs() < 1e-2, "{number}: {draw:?}");
        lengths.extend([t, t_bar].map(|t| 2.0 * t.norm() / draw.length));
    }
    assert!(lengths.iter().all(|length| (0.79..1.26).contains(length)), "{lengths:?}");
    assert!(lengths.iter().any(|&length| length < 0.9) && lengths.iter().any(|&length| length > 1.15));
}

#[test]
fn surfaces_penetrate_where_the_gap_is_closed_and_references_lie_within_the_beams() {
    for number in 0..200 {
        let (contact, draw) = (Case::draw(SEED, number).contact, drawn(number));
        let (radii, gap) = (contact.radius + contact.radius_bar, draw.gap * draw.length);
        assert!(contact.radius > 0.05 * radii && contact.radius_bar > 0.05 * radii, "{number}: {contact:?}");
        if draw.closed {
            assert!((1.05 * gap..1.5 * gap + 0.1 * draw.length).contains(&radii), "{number}: {radii}");
        } else {
            assert!((0.1 * gap..0.9 * gap).contains(&radii), "{number}: {radii} of {gap}");
        }
        assert!([contact.xi_0, contact.xi_bar_0].iter().all(|xi| (-1.0..1.0).contains(xi)));
    }
}

#[test]
fn beams_bend_in_all_directions() {
    // The side of the middle of the first beam, seen along d: over all cases both sides occur.
    let strongly = |&number: &u64| regime(number) == Regime::StronglyCurved;
    let mut sides = [0.0_f64; 2];
    for number in (0..4000).filter(strongly) {
        let (case, draw) = (Case::draw(SEED, number), drawn(number));
        let [[x, t], [x_bar, _]] = crossing(&case, draw.at);
        let [[ahead, _], _] = crossing(&case, [draw.at[0] + 0.1, draw.at[1]]);
        let normal = (x - x_bar).normalize();
        let bent = (ahead - x - t * 0.1) / draw.length;
        for (side, along) in sides.iter_mut().zip([normal, normal.cross(&t.normalize())]) {
            *side = side.max(bent.dot(&along).abs() / bent.norm());
        }
    }
    assert!(sides.iter().all(|&side| side > 0.9), "{sides:?}");
}

#[test]
fn frames_are_orthonormal_and_right_handed() {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    for _ in 0..100 {
        let frame = orthonormal(&mut rng);
        assert!((frame.transpose() * frame - nalgebra::Matrix3::identity()).amax() < 1e-14);
        assert!((frame.determinant() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn all_pairs_of_families_take_turns_in_all_regimes() {
    let pairs = FAMILIES * FAMILIES;
    let all = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: pairs };
    let numbers = all.numbers();
    assert_eq!(numbers.iter().collect::<BTreeSet<_>>().len() as u64, (REGIMES + 1) * pairs);
    let is_badly_scaled = |number| (BADLY_SCALED..BADLY_SCALED + pairs).contains(&number);
    assert!(numbers.iter().all(|&number| number < REGIMES * pairs || is_badly_scaled(number)));
    let met: BTreeSet<_> = numbers.iter().map(|&number| (regime(number), families(number))).collect();
    assert_eq!(met.len() as u64, (REGIMES + 1) * pairs);
    assert_eq!((place_in_regime(BADLY_SCALED), place_in_regime(BADLY_SCALED + 13)), (0, 13));
    assert_eq!(
        (
            place_in_regime(0),
            place_in_regime(REGIMES - 1),
            place_in_regime(REGIMES),
            place_in_regime(5 * REGIMES + 2)
        ),
        (0, 0, 1, 5)
    );
}

#[test]
fn a_selection_has_its_regimes_and_its_family_only() {
    let (regimes, family) = (vec![Regime::Metres, Regime::Slender], Some(Family::Arc));
    let some = Selection { regimes: regimes.clone(), family, cases: 50 };
    let numbers = some.numbers();
    assert_eq!(numbers.len(), 100);
    assert!(numbers.iter().all(|&number| families(number).contains(&Family::Arc)));
    assert!(numbers[..50].iter().all(|&number| regime(number) == Regime::Metres));
    assert!(numbers[50..].iter().all(|&number| regime(number) == Regime::Slender));
}

#[test]
fn a_case_is_decided_by_its_seed_and_number() {
    let written = |seed, number| Case::draw(seed, number).data();
    assert_eq!(written(1, 17), written(1, 17));
    assert!(
        written(1, 17) != written(2, 17) && written(1, 17) != written(1, 17 + REGIMES * FAMILIES * FAMILIES)
    );
    let case = Case::draw(1, 17);
    assert_eq!((case.number, case.regime, case.families), (17, regime(17), families(17)));
}
