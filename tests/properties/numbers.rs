//! The scalars of the library compared with each other, over random expressions.

use crate::strategies::{Expression, expression};
use beamgap::number::{
    DoubleDouble, Dual, HyperDual, HyperDualRow, Real, RunningError, RunningErrorBy, TermScale,
};
use num_dual::{Dual64, HyperDual64};
use proptest::prelude::*;

/// The largest accepted error of a double-double, relative to its terms. In 200 000 samples the largest error is 8e-32.
const DOUBLE_DOUBLE: f64 = 2e-31;

fn double_double() -> impl Strategy<Value = DoubleDouble> {
    (-4.0..4.0, -1e-17..1e-17).prop_map(|(high, low)| DoubleDouble::from(high) + DoubleDouble::from(low))
}

fn pair() -> impl Strategy<Value = [f64; 2]> {
    proptest::array::uniform2(-2.0..2.0)
}

/// Whether the bits are equal; all NaNs are equal.
fn same_bits(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// |a - b|.
fn distance(a: DoubleDouble, b: DoubleDouble) -> f64 {
    (a - b).abs().value()
}

/// Two rounded results differ by at most a few times the error bound of one of them.
fn assert_near(what: &str, ours: RunningError, theirs: f64) -> Result<(), TestCaseError> {
    let error = (ours.value - theirs).abs();
    let conclusive = ours.value.is_finite() && ours.bound.is_finite() && theirs.is_finite();
    prop_assert!(!conclusive || error <= 16.0 * ours.bound, "{what}: {ours:?} is not {theirs:?}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn dual_is_the_dual_of_num_dual(f in expression(), x in pair(), dx in pair()) {
        let ours = f.evaluate([0, 1].map(|i| Dual::<RunningError>::new(x[i].into(), dx[i].into())));
        let theirs = f.evaluate([0, 1].map(|i| Dual64::new(x[i], dx[i])));
        assert_near("re", ours.re, theirs.re)?;
        assert_near("eps", ours.eps, theirs.eps)?;
        let plain = f.evaluate([0, 1].map(|i| Dual::new(x[i], dx[i])));
        prop_assert!(same_bits(plain.eps, ours.eps.value));
    }

    #[test]
    fn hyper_dual_is_the_hyper_dual_of_num_dual(
        f in expression(), x in pair(), p in proptest::array::uniform6(-2.0..2.0),
    ) {
        let parts = [[x[0], p[0], p[1], p[2]], [x[1], p[3], p[4], p[5]]];
        let ours = f.evaluate(parts.map(|p| {
            let [re, eps1, eps2, both] = p.map(RunningError::from);
            HyperDual::new(re, eps1, eps2, both)
        }));
        let theirs = f.evaluate(parts.map(|[re, eps1, eps2, both]| HyperDual64::new(re, eps1, eps2, both)));
        assert_near("re", ours.re, theirs.re)?;
        assert_near("eps1", ours.eps1, theirs.eps1)?;
        assert_near("eps2", ours.eps2, theirs.eps2)?;
        assert_near("eps1eps2", ours.eps1eps2, theirs.eps1eps2)?;
        let plain = f.evaluate(parts.map(|[re, eps1, eps2, both]| HyperDual::new(re, eps1, eps2, both)));
        prop_assert!(same_bits(plain.eps1eps2, ours.eps1eps2.value));
    }

    #[test]
    fn hyper_dual_row_is_a_row_of_hyper_duals(
        f in expression(), x in pair(), delta in pair(),
        linear in proptest::array::uniform2(proptest::array::uniform3(-2.0..2.0)),
        both in proptest::array::uniform2(proptest::array::uniform3(-2.0..2.0)),
    ) {
        let row = f.evaluate([0, 1].map(|i| {
            HyperDualRow { re: x[i], eps1: delta[i], eps2: linear[i], eps1eps2: both[i] }
        }));
        for j in 0..3 {
            let one = f.evaluate([0, 1].map(|i| {
                let [re, eps1, eps2, both] = [x[i], delta[i], linear[i][j], both[i][j]].map(RunningError::from);
                HyperDual::new(re, eps1, eps2, both)
            }));
            assert_near("re", one.re, row.re)?;
            assert_near("eps1", one.eps1, row.eps1)?;
            assert_near("eps2", one.eps2, row.eps2[j])?;
            assert_near("eps1eps2", one.eps1eps2, row.eps1eps2[j])?;
        }
    }

    #[test]
    fn bounded_has_the_bits_of_f64_and_bounds_its_error(f in expression(), x in pair()) {
        let bounded = f.evaluate(x.map(RunningError::from));
        prop_assert!(same_bits(bounded.value, f.evaluate(x)));
        let exact = f.evaluate(x.map(DoubleDouble::from));
        if bounded.value.is_finite() && exact.value().is_finite() {
            let error = distance(DoubleDouble::from(bounded.value), exact);
            prop_assert!(error <= bounded.bound, "{bounded:?} is {error:e} off");
        }
    }

    #[test]
    fn bounded_passes_on_the_errors_of_its_operands(
        f in expression(), x in pair(), bounds in pair(), size in -12..-2_i32,
    ) {
        let bounds = bounds.map(|bound| bound * 10_f64.powi(size));
        let bounded = f.evaluate([0, 1].map(|i| RunningError::new(x[i], bounds[i].abs())));
        let both = f.evaluate([0, 1].map(|i| RunningErrorBy::new(x[i], [0.0, bounds[i].abs()])));
        prop_assert!(same_bits(both.value, bounded.value));
        prop_assert!(same_bits(both.bound[0], f.evaluate(x.map(RunningError::from)).bound));
        prop_assert!(same_bits(both.bound[1], bounded.bound));
        let exact = f.evaluate([0, 1].map(|i| DoubleDouble::from(x[i]) + DoubleDouble::from(bounds[i])));
        if bounded.value.is_finite() && exact.value().is_finite() {
            let error = distance(DoubleDouble::from(bounded.value), exact);
            prop_assert!(error <= bounded.bound, "{bounded:?} is {error:e} off");
        }
    }

    #[test]
    fn magnitude_is_not_below_the_value(f in expression(), x in pair()) {
        let size = f.evaluate(x.map(TermScale::from));
        let value = f.evaluate(x);
        prop_assert!(same_bits(size.value, value));
        prop_assert!(value.is_nan() || size.scale >= value.abs());
    }

    #[test]
    fn double_double_is_a_field(a in double_double(), b in double_double(), c in double_double()) {
        let scale = a.abs().value();
        prop_assert!(distance(a / b * b, a) <= DOUBLE_DOUBLE * scale);
        prop_assert!(distance(a * b / b, a) <= DOUBLE_DOUBLE * scale);
        prop_assert!(distance((a + b) - b, a) <= DOUBLE_DOUBLE * (scale + b.abs().value()));
        let terms = ((a * b).abs() + (a * c).abs()).value();
        prop_assert!(distance(a * (b + c), a * b + a * c) <= DOUBLE_DOUBLE * (terms + scale));
    }

    #[test]
    fn double_double_root_squares_to_its_square(a in double_double()) {
        let square = a.abs();
        let root = square.sqrt();
        prop_assert!(distance(root * root, square) <= DOUBLE_DOUBLE * square.value());
    }

    #[test]
    fn double_double_sine_and_cosine_obey_pythagoras_and_addition(a in double_double(), b in double_double()) {
        let ((sin_a, cos_a), (sin_b, cos_b)) = (a.sin_cos(), b.sin_cos());
        prop_assert!(distance(sin_a * sin_a + cos_a * cos_a, DoubleDouble::from(1.0)) <= DOUBLE_DOUBLE);
        let (sin, cos) = (a + b).sin_cos();
        prop_assert!(distance(sin_a * cos_b + cos_a * sin_b, sin) <= DOUBLE_DOUBLE);
        prop_assert!(distance(cos_a * cos_b - sin_a * sin_b, cos) <= DOUBLE_DOUBLE);
    }

    #[test]
    fn double_double_refines_f64(x in -100.0..100.0_f64) {
        let (sin, cos) = DoubleDouble::from(x).sin_cos();
        prop_assert!((sin.value() - x.sin()).abs() <= f64::EPSILON);
        prop_assert!((cos.value() - x.cos()).abs() <= f64::EPSILON);
    }
}

#[test]
fn double_double_sine_and_cosine_of_one_are_those_of_the_tables() {
    // sin 1 = 0.84147098480789650665250232163030, cos 1 = 0.54030230586813971740093660744298
    let (sin, cos) = DoubleDouble::from(1.0).sin_cos();
    let table = |high: f64, low: f64| DoubleDouble::from(high) + DoubleDouble::from(low);
    assert!(distance(sin, table(0.841_470_984_807_896_5, 1.776_845_092_935_536e-18)) <= DOUBLE_DOUBLE);
    assert!(distance(cos, table(0.540_302_305_868_139_8, -4.760_954_612_604_417e-17)) <= DOUBLE_DOUBLE);
}

#[test]
fn root_of_negative_zero_has_a_bound() {
    let root = RunningError::new(-0.0, 1e-4).sqrt();
    assert!((1e-2..1e-2 + 1e-8).contains(&root.bound));
}

/// The equality of `num-dual` compares real parts only, so comparisons of dual numbers must not use it.
#[test]
fn equality_on_dual_numbers_of_num_dual_sees_the_real_part_only() {
    assert_eq!(Dual64::new(1.0, 2.0), Dual64::new(1.0, 3.0));
    assert_eq!(HyperDual64::new(1.0, 2.0, 3.0, 4.0), HyperDual64::new(1.0, 0.0, 0.0, 0.0));
    assert_ne!(Dual::new(1.0, 2.0), Dual::new(1.0, 3.0));
    assert_ne!(HyperDual::new(1.0, 2.0, 3.0, 4.0), HyperDual::new(1.0, 2.0, 3.0, 5.0));
}

#[test]
fn expressions_meet_every_operation() {
    let two = || Box::new(Expression::Variable(0));
    let one = || Box::new(Expression::Variable(1));
    let value = |f: Expression| f.evaluate([2.0, 1.0]);
    let close = |a: f64, b: f64| assert!((a - b).abs() <= f64::EPSILON);
    close(value(Expression::Constant(0.5)), 0.5);
    close(value(Expression::Sum(two(), one())), 3.0);
    close(value(Expression::Difference(two(), one())), 1.0);
    close(value(Expression::Product(two(), two())), 4.0);
    close(value(Expression::Quotient(one(), two())), 0.5);
    close(value(Expression::Root(two())), 2.0_f64.sqrt());
    close(value(Expression::Sine(one())), 1.0_f64.sin());
    close(value(Expression::Cosine(one())), 1.0_f64.cos());
}
