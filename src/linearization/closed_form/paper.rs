//! The equations of the paper, one function for each group. [`variations()`](super::variations()) evaluates them in order.
//!
//! | file | computes | equations |
//! |---|---|---|
//! | `points` | δx, δt, δd and Δδx, Δδt, Δδd, the vectors | (24)-(32), (37) |
//! | `parameters` | δξ, Δδξ | (44)-(59) |
//! | `distance` | δd, Δδd, the length | (4), (36)-(40), (57) |
//! | `lengths` | δt, Δδt, the length, and the slips | (9), (15), (20), (21), (33)-(35), (41), (42), (58) |
//!
//! A formula that serves both beams takes the beam as its first argument. δ is `delta` in names, Δ is `linear`, and Δδ is
//! `second`.

pub mod distance;
pub mod lengths;
pub mod parameters;
pub mod points;

pub use distance::{
    delta_distance, delta_distance_along_normal, delta_normal, second_distance, second_distance_along_normal,
};
pub use lengths::{delta_length, delta_slip, length, second_length, second_slip, slip};
pub use parameters::{delta_xi, second_xi};
pub use points::{
    delta_d, delta_t, delta_u_hat, delta_x, second_d, second_t, second_t_rest, second_x, second_x_rest,
};

use super::{PartialVariations, Projection};
use crate::number::{Real, Which};
use nalgebra::Vector3;

/// First variations along one direction.
#[derive(Clone, Copy, Debug)]
pub struct FirstOrder<T> {
    /// δᵤû = δᵤu_C − δᵤū_C.
    pub u_hat: Vector3<T>,
    /// δd, of the vector.
    pub d: Vector3<T>,
    /// First variations of the beam.
    pub beam: FirstOrderOfBeam<T>,
    /// First variations of the bar beam.
    pub bar: FirstOrderOfBeam<T>,
}

/// First variations of one beam.
#[derive(Clone, Copy, Debug)]
pub struct FirstOrderOfBeam<T> {
    /// At a fixed parameter: δᵤu, δᵤu,ξ and δᵤu,ξξ.
    pub u: [Vector3<T>; 3],
    /// δξ.
    pub xi: T,
    /// δx_C.
    pub x: Vector3<T>,
    /// δt, of the vector.
    pub t: Vector3<T>,
}

/// Second variations of one beam.
#[derive(Clone, Copy, Debug)]
pub struct SecondOrderOfBeam<T> {
    /// Δδx_C without its term in Δδξ.
    pub rest_x: Vector3<T>,
    /// Δδξ.
    pub xi: T,
    /// Δδx_C.
    pub x: Vector3<T>,
    /// Δδt, of the vector.
    pub t: Vector3<T>,
}

impl<T: Real> FirstOrder<T> {
    /// Computes them from the variations `u` at fixed parameters, of the beam and of the bar beam.
    #[inline]
    pub fn new(
        [beam, bar]: [&PartialVariations<T>; 2],
        [u, u_bar]: [&[Vector3<T>; 3]; 2],
        d: &Vector3<T>,
        projection: &Projection<T>,
    ) -> Self {
        let u_hat = delta_u_hat(&u[0], &u_bar[0]);
        let (xi, xi_bar) = delta_xi([beam, bar], [u, u_bar], &u_hat, d, projection);
        let of = |which, beam, u: &[Vector3<T>; 3], xi| FirstOrderOfBeam {
            u: *u,
            xi,
            x: delta_x(which, beam, u, xi),
            t: delta_t(which, beam, u, xi),
        };
        let (beam, bar) = (of(Which::Beam, beam, u, xi), of(Which::Bar, bar, u_bar, xi_bar));
        Self { u_hat, d: delta_d(&beam.x, &bar.x), beam, bar }
    }
}

/// The second variations of both beams, along delta and Delta.
#[inline]
pub fn second_order<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [delta, linear]: [&FirstOrder<T>; 2],
    d: &Vector3<T>,
    projection: &Projection<T>,
) -> [SecondOrderOfBeam<T>; 2] {
    let rest = |which, beam, firsts: [&FirstOrderOfBeam<T>; 2]| {
        (second_x_rest(which, beam, firsts), second_t_rest(which, beam, firsts))
    };
    let rest_beam = rest(Which::Beam, beam, [&delta.beam, &linear.beam]);
    let rest_bar = rest(Which::Bar, bar, [&delta.bar, &linear.bar]);
    let (xi, xi_bar) = second_xi([beam, bar], [delta, linear], [&rest_beam, &rest_bar], d, projection);
    let of = |which, beam, (rest_x, rest_t): (Vector3<T>, Vector3<T>), xi| SecondOrderOfBeam {
        rest_x,
        xi,
        x: second_x(which, beam, rest_x, xi),
        t: second_t(which, beam, rest_t, xi),
    };
    [of(Which::Beam, beam, rest_beam, xi), of(Which::Bar, bar, rest_bar, xi_bar)]
}
