//! The variations of the parameters: the two-by-two system of the orthogonality conditions, solved twice.

use super::FirstOrder;
use crate::linearization::closed_form::{PartialVariations, Projection};
use crate::number::{Formula, Real, named};
use crate::source_fault::source_fault;
use nalgebra::Vector3;

/// (δξ, δξ̄), from the variations `u` at fixed parameters of the beam and of the bar beam.
///
/// Replace δ by Δ for (Δξ, Δξ̄).
#[inline]
#[doc(alias = "Eq. (44)")]
#[doc(alias = "Eq. (48)")]
#[doc(alias = "Eq. (49)")]
#[doc(alias = "Eq. (52)")]
pub fn delta_xi<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [u, u_bar]: [&[Vector3<T>; 3]; 2],
    u_hat: &Vector3<T>,
    d: &Vector3<T>,
    projection: &Projection<T>,
) -> (T, T) {
    // Eq. (44), (50): R_δ = −δᵤû·t − δᵤu,ξ·d   R̄_δ = −δᵤû·t̄ − δᵤū,ξ̄·d   Eq. (49) corrected in its second row
    let r = -named(Formula::R, "du,xi.d", u[1].dot(d));
    let r_bar = -named(Formula::RBar, "du_bar,xi.d", u_bar[1].dot(d));
    let Some(cross_products) = projection.cross_products else {
        let r = r - named(Formula::R, "du_hat.t", u_hat.dot(&beam.geometry.t));
        let r_bar = r_bar - named(Formula::RBar, "du_hat.t_bar", u_hat.dot(&bar.geometry.t));
        return projection.solve(r, r_bar);
    };
    // δᵤû in the solution, in cross products: the terms δᵤû·t and δᵤû·t̄ cancel at small angles.
    let (xi, xi_bar) = projection.solve(r, r_bar);
    let [along, along_bar] = cross_products.u.map(|u| u.dot(u_hat));
    (
        xi + named(Formula::DeltaXi, "u.du_hat", along),
        xi_bar + named(Formula::DeltaXiBar, "u_bar.du_hat", along_bar),
    )
}

/// (Δδξ, Δδξ̄), from the first variations along delta and Delta, and from the parts of Δδx and Δδt without Δδξ.
#[inline]
#[doc(alias = "Eq. (47)")]
#[doc(alias = "Eq. (53)")]
#[doc(alias = "Eq. (54)")]
#[doc(alias = "Eq. (59)")]
pub fn second_xi<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [delta, linear]: [&FirstOrder<T>; 2],
    [(rest_x, rest_t), (rest_x_bar, rest_t_bar)]: [&(Vector3<T>, Vector3<T>); 2],
    d: &Vector3<T>,
    projection: &Projection<T>,
) -> (T, T) {
    // Eq. (47), (53), (54): the part of Δδd and Δδt without Δδξ goes to the right-hand side, which the paper does not
    // give: R_Δδ = −(δd·Δt + Δd·δt) − t·(rest of Δδd) − d·(rest of Δδt), barred likewise
    let rest_d = named(Formula::SecondR, "rest of Dd x", *rest_x)
        - named(Formula::SecondR, "rest of Dd x_bar", *rest_x_bar);
    let exchanged = linear.d.dot(&delta.beam.t);
    let exchanged = source_fault!("sign-in-53": -exchanged, exchanged);
    let r = -(named(Formula::SecondR, "dd.Dt", delta.d.dot(&linear.beam.t))
        + named(Formula::SecondR, "Dd.dt", exchanged))
        - named(Formula::SecondR, "d.rest", d.dot(rest_t));
    let r_bar = -(named(Formula::SecondRBar, "dd.Dt_bar", delta.d.dot(&linear.bar.t))
        + named(Formula::SecondRBar, "Dd.dt_bar", linear.d.dot(&delta.bar.t)))
        - named(Formula::SecondRBar, "d.rest", d.dot(rest_t_bar));
    // Eq. (55), (59); its twin Eq. (56) lacks a bar
    let Some(cross_products) = projection.cross_products else {
        let r = r - named(Formula::SecondR, "t.rest", rest_d.dot(&beam.geometry.t));
        let r_bar = r_bar - named(Formula::SecondRBar, "t_bar.rest", rest_d.dot(&bar.geometry.t));
        return projection.solve(r, r_bar);
    };
    // The rest of Δδd in the solution, in cross products.
    let (xi, xi_bar) = projection.solve(r, r_bar);
    let [along, along_bar] = cross_products.u.map(|u| u.dot(&rest_d));
    (
        xi + named(Formula::SecondXi, "u.rest", along),
        xi_bar + named(Formula::SecondXiBar, "u_bar.rest", along_bar),
    )
}
