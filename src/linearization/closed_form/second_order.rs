//! The second variations of the parameters, points and tangents.

use super::PartialVariations;
use super::first_order::{First, FirstOfBeam};
use super::projection::Projection;
use crate::number::{Of, Real, named};
use nalgebra::Vector3;

/// Second variations of one beam.
pub(super) struct Second<T> {
    /// Δδx_C less its term in Δδξ.
    pub(super) rest_x: Vector3<T>,
    /// Δδξ.
    pub(super) xi: T,
    /// Δδx_C.
    pub(super) x: Vector3<T>,
    /// Δδt, of the vector.
    pub(super) t: Vector3<T>,
}

/// The second variations of both beams, along delta and Delta.
#[inline]
pub(super) fn second_order<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [delta, linear]: [&First<T>; 2],
    d: &Vector3<T>,
    projection: &Projection<T>,
) -> [Second<T>; 2] {
    let (rest_x, rest_t) = rest(Of::BEAM, beam, &delta.beam, &linear.beam);
    let (rest_x_bar, rest_t_bar) = rest(Of::BAR, bar, &delta.bar, &linear.bar);
    // Eq. (47), (53), (54): the part of Δδd and Δδt that holds no Δδξ goes to the right-hand side, which the paper never
    // gives: R_Δδ = −(δd·Δt + Δd·δt) − t·(rest of Δδd) − d·(rest of Δδt), barred likewise
    let rest_d = named("R2: rest of Dd x", rest_x) - named("R2: rest of Dd x_bar", rest_x_bar);
    let r = -(named("R2: dd.Dt", delta.d.dot(&linear.beam.t))
        + named("R2: Dd.dt", linear.d.dot(&delta.beam.t)))
        - named("R2: d.rest", d.dot(&rest_t));
    let r_bar = -(named("R2_bar: dd.Dt_bar", delta.d.dot(&linear.bar.t))
        + named("R2_bar: Dd.dt_bar", linear.d.dot(&delta.bar.t)))
        - named("R2_bar: d.rest", d.dot(&rest_t_bar));
    // Eq. (55), (59); its twin Eq. (56) lacks a bar
    let (xi, xi_bar) = match projection.cross_products {
        None => {
            let r = r - named("R2: t.rest", rest_d.dot(&beam.geometry.t));
            let r_bar = r_bar - named("R2_bar: t_bar.rest", rest_d.dot(&bar.geometry.t));
            projection.solve(r, r_bar)
        }
        Some(cross_products) => {
            let (xi, xi_bar) = projection.solve(r, r_bar);
            let [u, u_bar] = cross_products.u;
            let along = named("Ddxi: u.rest", u.dot(&rest_d));
            let along_bar = named("Ddxi_bar: u_bar.rest", u_bar.dot(&rest_d));
            (xi + along, xi_bar + along_bar)
        }
    };
    [
        Second::new(Of::BEAM, beam, (rest_x, rest_t), xi),
        Second::new(Of::BAR, bar, (rest_x_bar, rest_t_bar), xi_bar),
    ]
}

/// Δδx_C and Δδt, less their terms in Δδξ.
#[inline]
fn rest<T: Real>(
    of: Of,
    beam: &PartialVariations<T>,
    delta: &FirstOfBeam<T>,
    linear: &FirstOfBeam<T>,
) -> (Vector3<T>, Vector3<T>) {
    let (dxi, linear_dxi) = (delta.xi, linear.xi);
    // Eq. (26), (27), (31): Δδx_C = t,ξ δξΔξ + t Δδξ + δξ Δᵤu_C,ξ + δᵤu_C,ξ Δξ + Δᵤδᵤu_C
    let x = of.named("Dd x: t,xi dxi Dxi", beam.geometry.t_xi * (dxi * linear_dxi))
        + of.named("Dd x: dxi Du,xi", linear.u[1] * dxi)
        + of.named("Dd x: du,xi Dxi", delta.u[1] * linear_dxi)
        + of.named("Dd x: Ddu", beam.second_u[0]);
    // Eq. (30), (31), (32): Δδt = t,ξξ δξΔξ + t,ξ Δδξ + δξ Δᵤu_C,ξξ + δᵤu_C,ξξ Δξ + Δᵤδᵤu_C,ξ
    // ((32) prints t̄,ξ̄ for t̄,ξ̄ξ̄ in the barred twin)
    let t = of.named("Dd t: t,xixi dxi Dxi", beam.geometry.t_xixi * (dxi * linear_dxi))
        + of.named("Dd t: dxi Du,xixi", linear.u[2] * dxi)
        + of.named("Dd t: du,xixi Dxi", delta.u[2] * linear_dxi)
        + of.named("Dd t: Ddu,xi", beam.second_u[1]);
    (x, t)
}

impl<T: Real> Second<T> {
    #[inline]
    fn new(of: Of, beam: &PartialVariations<T>, (rest_x, rest_t): (Vector3<T>, Vector3<T>), xi: T) -> Self {
        let x = of.named("Dd x: t Ddxi", beam.geometry.t * xi) + of.named("Dd x: rest", rest_x);
        let t = of.named("Dd t: t,xi Ddxi", beam.geometry.t_xi * xi) + of.named("Dd t: rest", rest_t);
        Self { rest_x, xi, x, t }
    }
}
