//! Random inputs. What they promise is tested below.

use nalgebra::SVector;
use proptest::prelude::*;

/// Any parameter, the ends among them.
pub(crate) fn parameter() -> impl Strategy<Value = f64> {
    prop_oneof![6 => -1.0..=1.0, 1 => Just(-1.0), 1 => Just(1.0), 1 => Just(0.0)]
}

/// A vector with entries in [-2, 2].
pub(crate) fn vector<const N: usize>() -> impl Strategy<Value = SVector<f64, N>> {
    proptest::array::uniform::<_, N>(-2.0..=2.0).prop_map(SVector::from)
}

#[test]
fn parameters_cover_the_ends_and_stay_between_them() {
    let mut ends = 0;
    for xi in samples(parameter()) {
        assert!((-1.0..=1.0).contains(&xi));
        ends += usize::from(xi.abs() >= 1.0);
    }
    assert!(ends > 10);
}

fn samples<S: Strategy>(strategy: S) -> Vec<S::Value> {
    use proptest::{strategy::ValueTree, test_runner::TestRunner};
    let mut runner = TestRunner::deterministic();
    (0..200).map(|_| strategy.new_tree(&mut runner).unwrap().current()).collect()
}
