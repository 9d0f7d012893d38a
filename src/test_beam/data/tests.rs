//! Tests of numbers that define a beam, and of numbers that do not.

use super::{Family, TestBeam, TestBeamError, Unit};
use crate::test_beam::Target;
use nalgebra::{Matrix3, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// One of every family.
fn all() -> Vec<TestBeam> {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let target = Target {
        point: Vector3::zeros(),
        frame: Matrix3::identity(),
        length: 1.0,
        bend: 1.0,
        hand: 1.0,
        xi: 0.0,
    };
    Family::ALL.map(|family| family.draw(&target, &mut rng)).into()
}

#[test]
fn parameters_have_names() {
    for test_beam in all() {
        let mut parameters = Vec::new();
        for &(name, count) in test_beam.family.parameters() {
            assert_eq!(test_beam.parameter(name).len(), count);
            parameters.extend_from_slice(test_beam.parameter(name));
        }
        assert_eq!(parameters, test_beam.parameters);
        assert!(test_beam.parameter("none such").is_empty());
        let cut = TestBeam { parameters: Vec::new(), ..test_beam };
        assert!(cut.family.parameters().iter().all(|(name, _)| cut.parameter(name).is_empty()));
    }
}

#[test]
fn only_lengths_have_a_unit() {
    for test_beam in all() {
        let scaled = test_beam.scaled(3);
        for (numbers, by) in [
            (&test_beam.q, &scaled.q),
            (&test_beam.dq, &scaled.dq),
            (&test_beam.linear_dq, &scaled.linear_dq),
        ] {
            for ((number, by), unit) in numbers.iter().zip(by).zip(test_beam.family.units()) {
                let factor = if unit == Unit::Pure { 1.0 } else { 8.0 };
                assert_eq!((number * factor).to_bits(), by.to_bits(), "{test_beam:?}");
            }
        }
        let factor = if test_beam.family == Family::HermiteScaled { 8.0 } else { 1.0 };
        let parameters: Vec<f64> = test_beam.parameters.iter().map(|number| number * factor).collect();
        assert_eq!(parameters, scaled.parameters);
        assert_eq!(scaled.scaled(-3), test_beam);
        // Its points are at the same places, in the other unit.
        let [x, by] = [&test_beam, &scaled].map(|beam| beam.drawn().geometry_at(0.25.into()).x);
        assert!((0..3).all(|c| (8.0 * x[c].value - by[c].value).abs() < 1e-13), "{test_beam:?}");
    }
}

#[test]
fn a_beam_is_moved_as_a_whole() {
    let by = Vector3::new(1.0, -2.0, 4.0);
    for test_beam in all() {
        let mut moved = test_beam.clone();
        moved.translate(&by);
        for xi in [-1.0, 0.3, 1.0] {
            let [x, to] = [&test_beam, &moved].map(|beam| beam.drawn().geometry_at(xi.into()).x);
            assert!((0..3).all(|c| (x[c].value + by[c] - to[c].value).abs() < 1e-13), "{test_beam:?}");
        }
        assert_eq!((&moved.dq, &moved.parameters), (&test_beam.dq, &test_beam.parameters));
    }
}

#[test]
fn what_is_wrong_with_numbers_is_named() {
    for test_beam in all() {
        assert_eq!(test_beam.validate(), Ok(()));
        let family = test_beam.family;
        let expected = test_beam.dq.len();
        let long = TestBeam { dq: [&test_beam.dq[..], &[1.0]].concat(), ..test_beam.clone() };
        let count = TestBeamError::Count { what: "dq", expected, found: expected + 1, family };
        assert_eq!(long.validate(), Err(count));
        let mut infinite = test_beam.clone();
        infinite.q[1] = f64::INFINITY;
        let not_finite = TestBeamError::NotFinite { what: "q", index: 1, value: f64::INFINITY };
        assert_eq!(infinite.validate(), Err(not_finite));
        if test_beam.family.parameters().iter().any(|&(name, _)| name == "knots") {
            let falling =
                TestBeam { parameters: test_beam.parameters.iter().rev().copied().collect(), ..test_beam };
            assert!(matches!(falling.validate(), Err(TestBeamError::Curve(_))), "{falling:?}");
        }
    }
}
