//! The first variations of the parameters, points and tangents, along one direction.

use super::PartialVariations;
use super::projection::Projection;
use crate::number::{Of, Real, named};
use nalgebra::Vector3;

/// First variations along one direction.
#[derive(Clone, Copy)]
pub(super) struct First<T> {
    /// δᵤû = δᵤu_C − δᵤū_C.
    pub(super) u_hat: Vector3<T>,
    /// δd, of the vector.
    pub(super) d: Vector3<T>,
    /// Of the beam.
    pub(super) beam: FirstOfBeam<T>,
    /// Of the bar beam.
    pub(super) bar: FirstOfBeam<T>,
}

/// First variations of one beam.
#[derive(Clone, Copy)]
pub(super) struct FirstOfBeam<T> {
    /// At a fixed parameter: δᵤu, δᵤu,ξ and δᵤu,ξξ.
    pub(super) u: [Vector3<T>; 3],
    /// δξ.
    pub(super) xi: T,
    /// δx_C.
    pub(super) x: Vector3<T>,
    /// δt, of the vector.
    pub(super) t: Vector3<T>,
}

impl<T: Real> First<T> {
    /// From the variations `u` and `u_bar` at fixed parameters.
    #[inline]
    pub(super) fn new(
        [beam, bar]: [&PartialVariations<T>; 2],
        [u, u_bar]: [&[Vector3<T>; 3]; 2],
        d: &Vector3<T>,
        projection: &Projection<T>,
    ) -> Self {
        // Eq. (37): δᵤû = δᵤu_C − δᵤū_C
        let u_hat = named("u_hat: du", u[0]) - named("u_hat: du_bar", u_bar[0]);
        // Eq. (44), (50): R_δ = −δᵤû·t − δᵤu,ξ·d   R̄_δ = −δᵤû·t̄ − δᵤū,ξ̄·d   Eq. (49) corrected in its second row
        let r = -named("R: du,xi.d", u[1].dot(d));
        let r_bar = -named("R_bar: du_bar,xi.d", u_bar[1].dot(d));
        let (xi, xi_bar) = match projection.cross_products {
            None => {
                let r = r - named("R: du_hat.t", u_hat.dot(&beam.geometry.t));
                let r_bar = r_bar - named("R_bar: du_hat.t_bar", u_hat.dot(&bar.geometry.t));
                projection.solve(r, r_bar)
            }
            Some(cross_products) => {
                let (xi, xi_bar) = projection.solve(r, r_bar);
                let [u, u_bar] = cross_products.u;
                let along = named("dxi: u.du_hat", u.dot(&u_hat));
                let along_bar = named("dxi_bar: u_bar.du_hat", u_bar.dot(&u_hat));
                (xi + along, xi_bar + along_bar)
            }
        };
        let beam = FirstOfBeam::new(Of::BEAM, beam, u, xi);
        let bar = FirstOfBeam::new(Of::BAR, bar, u_bar, xi_bar);
        // Eq. (32): δd = δx_C − δx̄_C
        let d = named("dd: dx", beam.x) - named("dd: dx_bar", bar.x);
        Self { u_hat, d, beam, bar }
    }
}

impl<T: Real> FirstOfBeam<T> {
    #[inline]
    fn new(of: Of, beam: &PartialVariations<T>, u: &[Vector3<T>; 3], xi: T) -> Self {
        let (t, t_xi) = (beam.geometry.t, beam.geometry.t_xi);
        Self {
            u: *u,
            xi,
            // Eq. (24), (31): δx_C = t δξ + δᵤu_C
            x: of.named("dx: t dxi", t * xi) + of.named("dx: du", u[0]),
            // Eq. (28), (31), (32): δt = t,ξ δξ + δᵤu_C,ξ   ((32) prints a stray −δξ̄ in δt̄)
            t: of.named("dt: t,xi dxi", t_xi * xi) + of.named("dt: du,xi", u[1]),
        }
    }
}
