//! The measure of errors in the benches. The benches verify every method with it before they time the method.

#[path = "../../benches/linearization/scenario/error.rs"]
mod of;

use beamgap::number::DoubleDouble;
use of::{Error, Exact};

fn error(numbers: [f64; 2]) -> Error {
    let exact = |value: f64, tolerance| Exact { value: DoubleDouble::from(value), tolerance };
    Error::of(&vec![numbers.to_vec()], &[vec![exact(8.0, 1e-12), exact(0.0, 0.0)]], |_| 0.0)
}

#[test]
fn an_error_is_relative_to_the_largest_and_a_share_of_what_is_allowed() {
    let one_ulp = 8.0 * f64::EPSILON;
    assert_eq!(error([8.0 + one_ulp, 0.0]), Error { relative: f64::EPSILON, share: one_ulp / 1e-12 });
    assert!(error([8.0 + 0.9e-12, 0.0]).share < 1.0 && error([8.0 + 1.1e-12, 0.0]).share > 1.0);
}

#[test]
fn where_nothing_is_allowed_nothing_may_be_off_and_what_is_no_number_is_infinitely_off() {
    assert!(error([8.0, 1e-300]).share > 1.0);
    assert!(error([f64::NAN, 0.0]).share.is_infinite() && error([8.0, f64::INFINITY]).share.is_infinite());
}
