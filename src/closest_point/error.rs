//! Why a projection of one centroid onto the other can fail. No reason depends on the unit of length.

use super::Side;
use crate::number::Which;
use thiserror::Error;

/// The reasons why there is no usable closest point.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ProjectionError {
    /// A position, a derivative, a bound or a start is infinite or not a number, or a length is so large or so small, by
    /// itself or next to the other curve, that its square has not all digits: beyond about 1e150 or 1e-150.
    #[error("a curve, its bound or the start is not finite, or too large or too small to be squared")]
    NonFinite,
    /// All points of one curve coincide, so that it has no tangent.
    #[error("the curve of the {which} is a single point")]
    ZeroTangent {
        /// The beam of the curve.
        which: Which,
    },
    /// The closest point is not isolated, or not within rounding: parallel or coaxial centroids.
    #[error("the closest point is not unique: the smallest scaled eigenvalue is {conditioning:e}")]
    Singular {
        /// The smallest eigenvalue of the Hessian for unit tangents.
        conditioning: f64,
    },
    /// Every minimum has a parameter at an end of its beam.
    #[error("no minimum of the distance lies inside both beams")]
    NoInteriorMinimum,
    /// The closest point is too near a fold, where it splits or vanishes, for derivatives of its parameters.
    #[error(
        "the closest point is ill-conditioned: the smallest scaled eigenvalue is {conditioning:e}, \
         gradients of its parameters may be off by {gradient_error:e} of their size"
    )]
    IllConditioned {
        /// The smallest eigenvalue of the Hessian for unit tangents.
        conditioning: f64,
        /// The relative error of the gradients of xi and xi_bar.
        gradient_error: f64,
    },
    /// Newton's method leads out of a beam: a minimum may lie at this end, with the parameter held.
    #[error("Newton's method leads out of the {which} at xi = {}", side.parameter())]
    AtEnd {
        /// The beam.
        which: Which,
        /// Its end.
        side: Side,
    },
    /// Newton's method found no stationary point from the given start.
    #[error("Newton's method did not converge: the residual is {residual:e}")]
    NotConverged {
        /// The largest |cos| of the angles between d and the tangents where it stopped.
        residual: f64,
    },
}
