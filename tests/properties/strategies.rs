//! Random inputs. The tests below verify their properties.

use beamgap::number::Real;
use nalgebra::{SVector, Vector4};
use proptest::prelude::*;

/// Any parameter, including the ends.
pub(crate) fn parameter() -> impl Strategy<Value = f64> {
    prop_oneof![6 => -1.0..=1.0, 1 => Just(-1.0), 1 => Just(1.0), 1 => Just(0.0)]
}

/// A vector with entries in [-2, 2].
pub(crate) fn vector<const N: usize>() -> impl Strategy<Value = SVector<f64, N>> {
    proptest::array::uniform::<_, N>(-2.0..=2.0).prop_map(SVector::from)
}

/// The local knots of a span of a B-spline of degree `P` - 1, some of them multiple.
pub(crate) fn knots<const P: usize>() -> impl Strategy<Value = Vec<f64>> {
    let step = prop_oneof![2 => 0.1..1.0, 1 => Just(0.0)];
    let steps = proptest::collection::vec(step, 2 * P - 3);
    (-3.0..3.0, steps, 0.1..1.0).prop_map(|(start, mut steps, span)| {
        steps[P - 2] = span;
        let mut knots = vec![start];
        knots.extend(steps.into_iter().scan(start, |knot, step| {
            *knot += step;
            Some(*knot)
        }));
        knots
    })
}

/// Weights of a rational curve.
pub(crate) fn weights<const P: usize>() -> impl Strategy<Value = [f64; P]> {
    proptest::array::uniform::<_, P>(0.2..5.0)
}

/// Control points with weights, node-major: `N` = 4 `P`.
pub(crate) fn weighted_points<const P: usize, const N: usize>() -> impl Strategy<Value = SVector<f64, N>> {
    (vector::<N>(), weights::<P>()).prop_map(|(mut points, weights)| {
        for (i, weight) in weights.into_iter().enumerate() {
            points[4 * i + 3] = weight;
        }
        points
    })
}

/// A quaternion away from zero, of any length.
pub(crate) fn quaternion() -> impl Strategy<Value = Vector4<f64>> {
    vector::<4>().prop_filter("away from zero", |p| p.norm() > 0.3)
}

/// The dofs of an arc: centre, radius, quaternion, phase.
pub(crate) fn arc() -> impl Strategy<Value = SVector<f64, 9>> {
    (vector::<9>(), 0.1..3.0, quaternion()).prop_map(|(mut q, radius, p)| {
        q[3] = radius;
        q.fixed_rows_mut::<4>(4).copy_from(&p);
        q
    })
}

/// The dofs of a helix: centre, quaternion, radius, pitch, phase.
pub(crate) fn helix() -> impl Strategy<Value = SVector<f64, 10>> {
    (vector::<10>(), 0.1..3.0, quaternion()).prop_map(|(mut q, radius, p)| {
        q[7] = radius;
        q.fixed_rows_mut::<4>(3).copy_from(&p);
        q
    })
}

/// A formula in two variables.
#[derive(Clone, Debug)]
pub(crate) enum Expression {
    Variable(usize),
    Constant(f64),
    Sum(Box<Self>, Box<Self>),
    Difference(Box<Self>, Box<Self>),
    Product(Box<Self>, Box<Self>),
    Quotient(Box<Self>, Box<Self>),
    Root(Box<Self>),
    Sine(Box<Self>),
    Cosine(Box<Self>),
}

impl Expression {
    pub(crate) fn evaluate<T: Real>(&self, x: [T; 2]) -> T {
        match self {
            Self::Variable(i) => x[*i],
            Self::Constant(value) => T::from(*value),
            Self::Sum(a, b) => a.evaluate(x) + b.evaluate(x),
            Self::Difference(a, b) => a.evaluate(x) - b.evaluate(x),
            Self::Product(a, b) => a.evaluate(x) * b.evaluate(x),
            Self::Quotient(a, b) => a.evaluate(x) / b.evaluate(x),
            Self::Root(a) => a.evaluate(x).sqrt(),
            Self::Sine(a) => a.evaluate(x).sin_cos().0,
            Self::Cosine(a) => a.evaluate(x).sin_cos().1,
        }
    }
}

/// Any formula, including ill-conditioned ones, divisions by zero and roots of negative numbers.
pub(crate) fn expression() -> impl Strategy<Value = Expression> {
    let leaf = prop_oneof![
        4 => (0..2_usize).prop_map(Expression::Variable),
        1 => (-3.0..3.0).prop_map(Expression::Constant),
    ];
    leaf.prop_recursive(5, 24, 2, |inner| {
        let one = || inner.clone().prop_map(Box::new);
        let two = || (one(), one());
        prop_oneof![
            two().prop_map(|(a, b)| Expression::Sum(a, b)),
            two().prop_map(|(a, b)| Expression::Difference(a, b)),
            two().prop_map(|(a, b)| Expression::Product(a, b)),
            two().prop_map(|(a, b)| Expression::Quotient(a, b)),
            one().prop_map(Expression::Root),
            one().prop_map(Expression::Sine),
            one().prop_map(Expression::Cosine),
        ]
    })
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

#[test]
fn knots_are_sorted_and_some_are_multiple_but_never_those_of_the_span() {
    let mut multiple = 0;
    for knots in samples(knots::<4>()) {
        assert_eq!(knots.len(), 6);
        assert!(knots.is_sorted() && knots[3] - knots[2] > 0.09);
        multiple += usize::from(knots.windows(2).any(|pair| pair[1] <= pair[0]));
    }
    assert!((50..200).contains(&multiple));
}

#[test]
fn weights_are_positive_and_in_their_places() {
    for q in samples(weighted_points::<3, 12>()) {
        assert!([3, 7, 11].iter().all(|&i| (0.2..5.0).contains(&q[i])));
    }
}

#[test]
fn quaternions_are_away_from_zero_and_in_their_places() {
    assert!(samples(quaternion()).iter().all(|p| p.norm() > 0.3));
    for q in samples(arc()) {
        assert!(q.fixed_rows::<4>(4).norm() > 0.3 && q[3] > 0.0);
    }
    for q in samples(helix()) {
        assert!(q.fixed_rows::<4>(3).norm() > 0.3 && q[7] > 0.0);
    }
}

#[test]
fn most_expressions_have_a_value() {
    let values: Vec<f64> = samples(expression()).iter().map(|f| f.evaluate([0.7, -1.3])).collect();
    assert!(values.iter().filter(|value| value.is_finite()).count() > 140);
}

fn samples<S: Strategy>(strategy: S) -> Vec<S::Value> {
    use proptest::{strategy::ValueTree, test_runner::TestRunner};
    let mut runner = TestRunner::deterministic();
    (0..200).map(|_| strategy.new_tree(&mut runner).unwrap().current()).collect()
}
