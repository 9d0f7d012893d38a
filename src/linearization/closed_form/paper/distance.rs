//! The distance d = |d| and its variations, as a length and along the common normal.

use super::{FirstOrder, SecondOrderOfBeam};
use crate::linearization::closed_form::PartialVariations;
use crate::number::{Formula, Real, named};
use nalgebra::Vector3;

/// δd, of a distance that is not zero.
#[inline]
#[doc(alias = "Eq. (36)")]
#[doc(alias = "Eq. (37)")]
pub fn delta_distance<T: Real>(d: &Vector3<T>, distance: T, u_hat: &Vector3<T>) -> T {
    // Eq. (37), from (36): δd = d·δᵤû/d
    named(Formula::DeltaD, "d.du_hat", d.dot(u_hat)) / distance
}

/// Δδd, of a distance that is not zero, from its first variations `first` along delta and Delta.
#[inline]
#[doc(alias = "Eq. (40)")]
#[doc(alias = "Eq. (57)")]
pub fn second_distance<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [delta, linear]: [&FirstOrder<T>; 2],
    d: &Vector3<T>,
    distance: T,
    first: [T; 2],
) -> T {
    // Eq. (40), (57), from (38) and (39), with Δᵤû where the paper prints Δû, and with the term of Δᵤδᵤû:
    // d Δδd = δᵤû·(t Δξ − t̄ Δξ̄) + d·(δᵤu,ξ Δξ − δᵤū,ξ̄ Δξ̄) + δᵤû·Δᵤû + d·Δᵤδᵤû − δd Δd
    // Like (37), it is also valid at a held end, where δξ = 0 replaces d·t = 0.
    let moved = named(Formula::SecondD, "du_hat.t Dxi", beam.geometry.t * linear.beam.xi)
        - named(Formula::SecondD, "du_hat.t_bar Dxi_bar", bar.geometry.t * linear.bar.xi);
    let turned = named(Formula::SecondD, "d.du,xi Dxi", delta.beam.u[1] * linear.beam.xi)
        - named(Formula::SecondD, "d.du_bar,xi Dxi_bar", delta.bar.u[1] * linear.bar.xi);
    let second_u_hat = named(Formula::SecondD, "d.Ddu", beam.second_u[0])
        - named(Formula::SecondD, "d.Ddu_bar", bar.second_u[0]);
    (named(Formula::SecondD, "du_hat.moved", delta.u_hat.dot(&moved))
        + named(Formula::SecondD, "d.turned", d.dot(&turned))
        + named(Formula::SecondD, "du_hat.Du_hat", delta.u_hat.dot(&linear.u_hat))
        + named(Formula::SecondD, "d.Ddu_hat", d.dot(&second_u_hat))
        - named(Formula::SecondD, "dd Dd", first[0] * first[1]))
        / distance
}

/// δd along the unit normal n of both tangents: no division by d.
#[inline]
#[doc(alias = "Eq. (37)")]
pub fn delta_distance_along_normal<T: Real>(n: &Vector3<T>, u_hat: &Vector3<T>) -> T {
    // Eq. (37): δd = n·δᵤû
    named(Formula::DeltaD, "n.du_hat", n.dot(u_hat))
}

/// δn of the common normal n = ± c/|c| with c = t × t̄.
#[inline]
pub fn delta_normal<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [c, n]: [&Vector3<T>; 2],
    first: &FirstOrder<T>,
) -> Vector3<T> {
    // δn = −[(n·δt) t̄ × c + (n·δt̄) c × t]/(c·c), from n·t = n·t̄ = 0
    let by = named(Formula::DeltaNormal, "n.dt", bar.geometry.t.cross(c) * n.dot(&first.beam.t))
        + named(Formula::DeltaNormal, "n.dt_bar", c.cross(&beam.geometry.t) * n.dot(&first.bar.t));
    -by / named(Formula::DeltaNormal, "c.c", c.dot(c))
}

/// Δδd along the common normal n, with its first variations `delta_n` along delta and Delta.
#[inline]
pub fn second_distance_along_normal<T: Real>(
    n: &Vector3<T>,
    distance: T,
    [second, second_bar]: [&SecondOrderOfBeam<T>; 2],
    delta_n: [Vector3<T>; 2],
) -> T {
    // Δδd = n·Δδd + Δn·δd with the vector d = d n, so that Δn·δd = d Δn·δn; n is normal to what Δδξ multiplies
    named(Formula::SecondD, "n.rest of Dd x", n.dot(&second.rest_x))
        - named(Formula::SecondD, "n.rest of Dd x_bar", n.dot(&second_bar.rest_x))
        + named(Formula::SecondD, "d dn.Dn", distance * delta_n[0].dot(&delta_n[1]))
}
