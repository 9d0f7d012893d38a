//! Sums of shape functions times control vectors.

use crate::curve::Geometry;
use crate::linearization::closed_form::PartialVariations;
use crate::test_beam::{AnyBeam, RunningError2};
use nalgebra::Vector3;

/// A control vector with its shape function.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Node {
    /// The control vector and its variations in both directions.
    pub(in crate::check::external::stages) vectors: [Vector3<f64>; 3],
    /// The shape function and its derivatives.
    pub(in crate::check::external::stages) shape: [f64; 4],
    /// Its coefficients, if it is a cubic.
    pub(in crate::check::external::stages) coefficients: Option<[f64; 4]>,
}

/// Adds the rounding of sums of shape functions times control vectors, along both directions too.
pub(super) fn widen(
    partial: &mut PartialVariations<RunningError2>,
    [of_q, of_dq, of_linear_dq]: &[Vector3<f64>; 3],
) {
    let widen = |vector: &mut Vector3<RunningError2>, by: &Vector3<f64>| {
        for (number, by) in vector.iter_mut().zip(by) {
            number.bound = number.bound.map(|bound| bound + by);
        }
    };
    let Geometry { x, t, t_xi, t_xixi } = &mut partial.geometry;
    for vector in [x, t, t_xi, t_xixi] {
        widen(vector, of_q);
    }
    for vector in &mut partial.delta_u {
        widen(vector, of_dq);
    }
    for vector in &mut partial.linear_u {
        widen(vector, of_linear_dq);
    }
}

/// The control vectors of a beam that is a sum of shape functions times control vectors.
pub(super) fn nodes(beam: &dyn AnyBeam, xi: f64, along: [&[f64]; 2]) -> Vec<Node> {
    let [q, ..] = beam.numbers();
    let zero = vec![0.0; q.len()];
    let node = |k: usize| {
        let unit = (0..q.len()).map(|i| if i == 3 * k { 1.0 } else { 0.0 }).collect();
        let alone = beam.with_numbers(&[unit, zero.clone(), zero.clone()]);
        let at = |xi: f64| {
            let Geometry { x, t, t_xi, t_xixi } = alone.geometry(xi);
            [x, t, t_xi, t_xixi].map(|v| v.x)
        };
        let [n, slope, bend, third] = at(0.0);
        let coefficients = [n, slope, bend / 2.0, third / 6.0];
        let shape = at(xi);
        let half = at(0.5);
        let sum = coefficients.iter().rev().fold(0.0, |sum, c| sum * 0.5 + c);
        let is_cubic = (sum - half[0]).abs() < 1e-12 && (half[3] - third).abs() < 1e-12;
        let vector = |of: &[f64]| Vector3::from_fn(|c, _| of[3 * k + c]);
        Node {
            vectors: [vector(q), vector(along[0]), vector(along[1])],
            shape,
            coefficients: is_cubic.then_some(coefficients),
        }
    };
    (0..q.len() / 3).map(node).collect()
}
