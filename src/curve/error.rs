//! Why the fixed parameters of a curve family are rejected.

use thiserror::Error;

/// The parameters of a curve family define no curve.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CurveError {
    /// A span of degree p has 2 p local knots.
    #[error("{found} knots given, but one span of this degree has {expected}")]
    KnotCount {
        /// The number of knots given.
        found: usize,
        /// The number that the degree requires.
        expected: usize,
    },
    /// A knot is infinite or not a number.
    #[error("knot {index} is {knot}, which is not finite")]
    KnotNotFinite {
        /// The index of the knot, from 0.
        index: usize,
        /// The knot.
        knot: f64,
    },
    /// A knot is less than the one before it.
    #[error("knot {index} is less than the knot before it; knots must not decrease")]
    KnotsDecrease {
        /// The index of the smaller knot, from 0.
        index: usize,
    },
    /// The two knots in the middle coincide, or nearly so compared with the other knots.
    #[error("the span from {start} to {end} has no length")]
    EmptySpan {
        /// The knot where the span starts.
        start: f64,
        /// The knot where it ends.
        end: f64,
    },
    /// A weight is not positive and finite.
    #[error("weight {index} is {weight}, but weights must be positive and finite")]
    Weight {
        /// The index of the weight, from 0.
        index: usize,
        /// The weight.
        weight: f64,
    },
}
