//! Numbers that make a beam, and numbers that do not.

use super::{Family, Specimen, SpecimenError, Unit};
use crate::specimen::Target;
use nalgebra::{Matrix3, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// One of every family.
fn all() -> Vec<Specimen> {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let target =
        Target { point: Vector3::zeros(), frame: Matrix3::identity(), length: 1.0, bend: 1.0, xi: 0.0 };
    Family::ALL.map(|family| family.draw(&target, &mut rng)).into()
}

#[test]
fn parameters_have_names() {
    for specimen in all() {
        let mut parameters = Vec::new();
        for &(name, count) in specimen.family.parameters() {
            assert_eq!(specimen.parameter(name).len(), count);
            parameters.extend_from_slice(specimen.parameter(name));
        }
        assert_eq!(parameters, specimen.parameters);
        assert!(specimen.parameter("none such").is_empty());
        let cut = Specimen { parameters: Vec::new(), ..specimen };
        assert!(cut.family.parameters().iter().all(|(name, _)| cut.parameter(name).is_empty()));
    }
}

#[test]
fn only_lengths_have_a_unit() {
    for specimen in all() {
        let scaled = specimen.scaled(3);
        for (numbers, by) in
            [(&specimen.q, &scaled.q), (&specimen.dq, &scaled.dq), (&specimen.linear_dq, &scaled.linear_dq)]
        {
            for ((number, by), unit) in numbers.iter().zip(by).zip(specimen.family.units()) {
                let factor = if unit == Unit::Pure { 1.0 } else { 8.0 };
                assert_eq!((number * factor).to_bits(), by.to_bits(), "{specimen:?}");
            }
        }
        let factor = if specimen.family == Family::HermiteScaled { 8.0 } else { 1.0 };
        let parameters: Vec<f64> = specimen.parameters.iter().map(|number| number * factor).collect();
        assert_eq!(parameters, scaled.parameters);
        assert_eq!(scaled.scaled(-3), specimen);
        // Its points are where they were, in the other unit.
        let [x, by] = [&specimen, &scaled].map(|beam| beam.drawn().geometry_at(0.25.into()).x);
        assert!((0..3).all(|c| (8.0 * x[c].value - by[c].value).abs() < 1e-13), "{specimen:?}");
    }
}

#[test]
fn a_beam_is_moved_as_a_whole() {
    let by = Vector3::new(1.0, -2.0, 4.0);
    for specimen in all() {
        let mut moved = specimen.clone();
        moved.translate(&by);
        for xi in [-1.0, 0.3, 1.0] {
            let [x, to] = [&specimen, &moved].map(|beam| beam.drawn().geometry_at(xi.into()).x);
            assert!((0..3).all(|c| (x[c].value + by[c] - to[c].value).abs() < 1e-13), "{specimen:?}");
        }
        assert_eq!((&moved.dq, &moved.parameters), (&specimen.dq, &specimen.parameters));
    }
}

#[test]
fn what_is_wrong_with_numbers_is_named() {
    for specimen in all() {
        assert_eq!(specimen.validate(), Ok(()));
        let family = specimen.family;
        let expected = specimen.dq.len();
        let long = Specimen { dq: [&specimen.dq[..], &[1.0]].concat(), ..specimen.clone() };
        let count = SpecimenError::Count { what: "dq", expected, found: expected + 1, family };
        assert_eq!(long.validate(), Err(count));
        let mut infinite = specimen.clone();
        infinite.q[1] = f64::INFINITY;
        let not_finite = SpecimenError::NotFinite { what: "q", index: 1, value: f64::INFINITY };
        assert_eq!(infinite.validate(), Err(not_finite));
        if specimen.family.parameters().iter().any(|&(name, _)| name == "knots") {
            let falling =
                Specimen { parameters: specimen.parameters.iter().rev().copied().collect(), ..specimen };
            assert!(matches!(falling.validate(), Err(SpecimenError::Curve(_))), "{falling:?}");
        }
    }
}
