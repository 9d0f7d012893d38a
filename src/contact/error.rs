//! Why the contact element has no result.

use crate::number::Which;
use thiserror::Error;

/// The reasons why the contact element has no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ContactError {
    /// A parameter is out of range.
    #[error("the parameter {name} = {value} is out of range")]
    Parameter {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number of the history is out of range.
    #[error("the history has {name} = {value}, which is out of range")]
    History {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A dof, a point or a derivative of a curve is infinite or not a number.
    #[error("the {which} has {name} = {value}")]
    NotFinite {
        /// The beam.
        which: Which,
        /// The first such quantity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A result is infinite or not a number, or a law pulls: F_N must not be negative.
    #[error("the contact has {name} = {value}, which is out of range")]
    Result {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The tangent of a beam has no length.
    #[error("the tangent of the {which} has the length {length:e}")]
    ZeroTangent {
        /// The beam.
        which: Which,
        /// The length of the tangent.
        length: f64,
    },
    /// The beams are parallel, or the closest point is not isolated: a point contact is not defined.
    #[error(
        "the beams are parallel or the closest point is not isolated: the smallest scaled eigenvalue is {conditioning:e}"
    )]
    Parallel {
        /// The smallest eigenvalue of the Hessian of d²/2 for unit tangents.
        conditioning: f64,
    },
    /// The centroids meet at an end of a beam: there is no normal.
    #[error("the contact at an end of a beam has no normal: d = {distance:e}")]
    NoNormal {
        /// d.
        distance: f64,
    },
    /// The normal has turned too far within a step to tell on which side the beam is.
    #[error("the normal has turned too far within the step: its cosine with the previous normal is {cosine}")]
    NormalTurned {
        /// n·n_prev.
        cosine: f64,
    },
    /// Both parameters are held, and a state with friction was required.
    #[error("a contact of two ends, xi = {xi} and xi_bar = {xi_bar}, has no friction")]
    BothHeld {
        /// xi.
        xi: f64,
        /// xi_bar.
        xi_bar: f64,
    },
    /// An element of a chain was named that the chain does not have.
    #[error("the element {element} of a chain of {count} elements")]
    NoElement {
        /// Its number, from 0.
        element: usize,
        /// The number of elements.
        count: usize,
    },
}
