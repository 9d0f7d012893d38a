//! The span of some vectors.

/// What is left of a vector over it, if it is in the span of the others.
const DEPENDENT: f64 = 1e-9;

/// An orthonormal basis.
#[derive(Debug, Default)]
pub(super) struct Span(Vec<Vec<f64>>);

impl Span {
    /// The span of these vectors.
    pub(super) fn of(vectors: &[Vec<f64>]) -> Self {
        let mut span = Self::default();
        for vector in vectors {
            let left = span.outside(vector);
            let length = norm(&left);
            if length > DEPENDENT * norm(vector) {
                span.0.push(left.into_iter().map(|of| of / length).collect());
            }
        }
        span
    }

    /// The part of a vector that is orthogonal to the span.
    pub(super) fn outside(&self, vector: &[f64]) -> Vec<f64> {
        let mut left = vector.to_vec();
        // Twice, because of rounding.
        for axis in self.0.iter().chain(&self.0) {
            let along: f64 = axis.iter().zip(&left).map(|(axis, of)| axis * of).sum();
            left.iter_mut().zip(axis).for_each(|(of, axis)| *of -= along * axis);
        }
        left
    }
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|of| of * of).sum::<f64>().sqrt()
}
