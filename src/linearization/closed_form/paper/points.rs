//! The variations of the closest points, of the tangents there, and of the vector d between them.

use super::FirstOrderOfBeam;
use crate::linearization::closed_form::PartialVariations;
use crate::number::{Formula, Real, Which, named};
use nalgebra::Vector3;

/// δᵤû, the variation of d at fixed parameters.
#[inline]
#[doc(alias = "Eq. (37)")]
pub fn delta_u_hat<T: Real>(u: &Vector3<T>, u_bar: &Vector3<T>) -> Vector3<T> {
    // Eq. (37): δᵤû = δᵤu_C − δᵤū_C
    named(Formula::UHat, "du", *u) - named(Formula::UHat, "du_bar", *u_bar)
}

/// δx_C.
#[inline]
#[doc(alias = "Eq. (24)")]
#[doc(alias = "Eq. (31)")]
pub fn delta_x<T: Real>(
    which: Which,
    beam: &PartialVariations<T>,
    u: &[Vector3<T>; 3],
    dxi: T,
) -> Vector3<T> {
    // Eq. (24), (31): δx_C = t δξ + δᵤu_C
    which.named(Formula::DeltaX, "t dxi", beam.geometry.t * dxi) + which.named(Formula::DeltaX, "du", u[0])
}

/// δt, of the vector.
#[inline]
#[doc(alias = "Eq. (28)")]
#[doc(alias = "Eq. (32)")]
pub fn delta_t<T: Real>(
    which: Which,
    beam: &PartialVariations<T>,
    u: &[Vector3<T>; 3],
    dxi: T,
) -> Vector3<T> {
    // Eq. (28), (31), (32): δt = t,ξ δξ + δᵤu_C,ξ   ((32) prints a stray −δξ̄ in δt̄)
    which.named(Formula::DeltaTVector, "t,xi dxi", beam.geometry.t_xi * dxi)
        + which.named(Formula::DeltaTVector, "du,xi", u[1])
}

/// δd, of the vector.
#[inline]
#[doc(alias = "Eq. (32)")]
pub fn delta_d<T: Real>(dx: &Vector3<T>, dx_bar: &Vector3<T>) -> Vector3<T> {
    // Eq. (32): δd = δx_C − δx̄_C
    named(Formula::DeltaDVector, "dx", *dx) - named(Formula::DeltaDVector, "dx_bar", *dx_bar)
}

/// Δδx_C without t Δδξ, from the first variations along delta and Delta.
#[inline]
#[doc(alias = "Eq. (27)")]
#[doc(alias = "Eq. (31)")]
pub fn second_x_rest<T: Real>(
    which: Which,
    beam: &PartialVariations<T>,
    [delta, linear]: [&FirstOrderOfBeam<T>; 2],
) -> Vector3<T> {
    // Eq. (26), (27), (31): Δδx_C = t,ξ δξΔξ + t Δδξ + δξ Δᵤu_C,ξ + δᵤu_C,ξ Δξ + Δᵤδᵤu_C
    which.named(Formula::SecondX, "t,xi dxi Dxi", beam.geometry.t_xi * (delta.xi * linear.xi))
        + which.named(Formula::SecondX, "dxi Du,xi", linear.u[1] * delta.xi)
        + which.named(Formula::SecondX, "du,xi Dxi", delta.u[1] * linear.xi)
        + which.named(Formula::SecondX, "Ddu", beam.second_u[0])
}

/// Δδt, of the vector, without t,ξ Δδξ, from the first variations along delta and Delta.
#[inline]
#[doc(alias = "Eq. (30)")]
#[doc(alias = "Eq. (32)")]
pub fn second_t_rest<T: Real>(
    which: Which,
    beam: &PartialVariations<T>,
    [delta, linear]: [&FirstOrderOfBeam<T>; 2],
) -> Vector3<T> {
    // Eq. (30), (31), (32): Δδt = t,ξξ δξΔξ + t,ξ Δδξ + δξ Δᵤu_C,ξξ + δᵤu_C,ξξ Δξ + Δᵤδᵤu_C,ξ
    // ((32) prints t̄,ξ̄ for t̄,ξ̄ξ̄ in the barred twin)
    which.named(Formula::SecondTVector, "t,xixi dxi Dxi", beam.geometry.t_xixi * (delta.xi * linear.xi))
        + which.named(Formula::SecondTVector, "dxi Du,xixi", linear.u[2] * delta.xi)
        + which.named(Formula::SecondTVector, "du,xixi Dxi", delta.u[2] * linear.xi)
        + which.named(Formula::SecondTVector, "Ddu,xi", beam.second_u[1])
}

/// Δδx_C from its rest and Δδξ.
#[inline]
#[doc(alias = "Eq. (27)")]
pub fn second_x<T: Real>(
    which: Which,
    beam: &PartialVariations<T>,
    rest: Vector3<T>,
    second_xi: T,
) -> Vector3<T> {
    which.named(Formula::SecondX, "t Ddxi", beam.geometry.t * second_xi)
        + which.named(Formula::SecondX, "rest", rest)
}

/// Δδt, of the vector, from its rest and Δδξ.
#[inline]
#[doc(alias = "Eq. (30)")]
pub fn second_t<T: Real>(
    which: Which,
    beam: &PartialVariations<T>,
    rest: Vector3<T>,
    second_xi: T,
) -> Vector3<T> {
    which.named(Formula::SecondTVector, "t,xi Ddxi", beam.geometry.t_xi * second_xi)
        + which.named(Formula::SecondTVector, "rest", rest)
}

/// Δδd, of the vector.
#[inline]
#[doc(alias = "Eq. (32)")]
pub fn second_d<T: Real>(second_x: &Vector3<T>, second_x_bar: &Vector3<T>) -> Vector3<T> {
    named(Formula::SecondDVector, "Dd x", *second_x)
        - named(Formula::SecondDVector, "Dd x_bar", *second_x_bar)
}
