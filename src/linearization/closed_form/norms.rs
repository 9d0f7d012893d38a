//! The lengths of vectors and the slips: section 4 of the paper, and what its section 2.2 makes of it.

use super::PartialVariations;
use super::first_order::First;
use super::formulation::unit_normal;
use super::second_order::Second;
use crate::linearization::Varied;
use crate::number::{Of, Real, named};
use nalgebra::Vector3;

/// d = |d| and its variations.
#[inline]
pub(super) fn by_length<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [delta, linear]: [&First<T>; 2],
    d: &Vector3<T>,
) -> Varied<T> {
    let (t, t_bar) = (beam.geometry.t, bar.geometry.t);
    let (linear_dxi, linear_dxi_bar) = (linear.beam.xi, linear.bar.xi);
    let (du_hat, linear_du_hat) = (&delta.u_hat, &linear.u_hat);
    // Eq. (4): d = ‖d‖
    let value = named("|d|: d.d", d.dot(d)).sqrt();
    // Eq. (37), from (36): δd = d·δᵤû/d
    let first = named("d|d|: d.du_hat", d.dot(du_hat)) / value;
    let linear_first = named("d|d|: d.du_hat", d.dot(linear_du_hat)) / value;
    // Eq. (40), (57), from (38) and (39), with Δᵤû where the paper prints Δû, and with the term of Δᵤδᵤû:
    // d Δδd = δᵤû·(t Δξ − t̄ Δξ̄) + d·(δᵤu,ξ Δξ − δᵤū,ξ̄ Δξ̄) + δᵤû·Δᵤû + d·Δᵤδᵤû − δd Δd
    // As (37) it holds at a held end too, where δξ = 0 takes the place of d·t = 0.
    let moved = named("Dd|d|: du_hat.t Dxi", t * linear_dxi)
        - named("Dd|d|: du_hat.t_bar Dxi_bar", t_bar * linear_dxi_bar);
    let turned = named("Dd|d|: d.du,xi Dxi", delta.beam.u[1] * linear_dxi)
        - named("Dd|d|: d.du_bar,xi Dxi_bar", delta.bar.u[1] * linear_dxi_bar);
    let second_u_hat = named("Dd|d|: d.Ddu", beam.second_u[0]) - named("Dd|d|: d.Ddu_bar", bar.second_u[0]);
    let second = (named("Dd|d|: du_hat.moved", du_hat.dot(&moved))
        + named("Dd|d|: d.turned", d.dot(&turned))
        + named("Dd|d|: du_hat.Du_hat", du_hat.dot(linear_du_hat))
        + named("Dd|d|: d.Ddu_hat", d.dot(&second_u_hat))
        - named("Dd|d|: dd Dd", first * linear_first))
        / value;
    Varied { value, delta: first, linear: linear_first, second }
}

/// d = n . d and its variations, where n is the common normal of the tangents: no division by d.
#[inline]
pub(super) fn along_normal<T: Real>(
    [beam, bar]: [&PartialVariations<T>; 2],
    [delta, linear]: [&First<T>; 2],
    [second, second_bar]: [&Second<T>; 2],
    d: &Vector3<T>,
    sign: T,
) -> Varied<T> {
    let (t, t_bar) = (&beam.geometry.t, &bar.geometry.t);
    // n = ± c/|c| with c = t × t̄
    let c = named("n: t x t_bar", t.cross(t_bar));
    let n = unit_normal(&(c * sign));
    let value = named("|d|: n.d", n.dot(d));
    // Eq. (37): δd = n·δᵤû
    let first = |of: &First<T>| named("d|d|: n.du_hat", n.dot(&of.u_hat));
    // δn = −[(n·δt) t̄ × c + (n·δt̄) c × t]/(c·c), from n·t = n·t̄ = 0
    let turned = |of: &First<T>| {
        let by = named("dn: n.dt", t_bar.cross(&c) * n.dot(&of.beam.t))
            + named("dn: n.dt_bar", c.cross(t) * n.dot(&of.bar.t));
        -by / named("dn: c.c", c.dot(&c))
    };
    // Δδd = n·Δδd + Δn·δd with the vector d = d n, so that Δn·δd = d Δn·δn; n is normal to what Δδξ multiplies
    let along = named("Dd|d|: n.rest of Dd x", n.dot(&second.rest_x))
        - named("Dd|d|: n.rest of Dd x_bar", n.dot(&second_bar.rest_x))
        + named("Dd|d|: d dn.Dn", value * turned(delta).dot(&turned(linear)));
    Varied { value, delta: first(delta), linear: first(linear), second: along }
}

/// The length of a tangent and its variations.
#[inline]
pub(super) fn length<T: Real>(
    of: Of,
    t: &Vector3<T>,
    dt: &Vector3<T>,
    linear_dt: &Vector3<T>,
    second_t: &Vector3<T>,
) -> Varied<T> {
    // Eq. (9): t = ‖t‖
    let value = of.named("|t|: t.t", t.dot(t)).sqrt();
    // Eq. (33), (41): δt = t·δt/t
    let delta = of.named("d|t|: t.dt", t.dot(dt)) / value;
    let linear = of.named("d|t|: t.dt", t.dot(linear_dt)) / value;
    // Eq. (35), (42), (58) corrected: Δδt = (t·Δδt + Δt·δt − δt Δt)/t, the last of lengths
    let second = (of.named("Dd|t|: t.Ddt", t.dot(second_t)) + of.named("Dd|t|: Dt.dt", linear_dt.dot(dt))
        - of.named("Dd|t|: dt Dt", delta * linear))
        / value;
    Varied { value, delta, linear, second }
}

/// g_T = t (xi_C - xi_C0) and its variations.
#[inline]
pub(super) fn slip<T: Real>(of: Of, t: &Varied<T>, xi: &Varied<T>, xi_0: f64) -> Varied<T> {
    let slip = xi.value - T::from(xi_0);
    // Eq. (20): δg_T = δt (ξ_C − ξ_C₀) + t δξ_C
    let first = |dt: T, dxi: T| of.named("dg_T: dt slip", dt * slip) + of.named("dg_T: t dxi", t.value * dxi);
    Varied {
        // Eq. (14), (15): g_T = t (ξ_C − ξ_C₀)
        value: of.named("g_T: t slip", t.value * slip),
        delta: first(t.delta, xi.delta),
        linear: first(t.linear, xi.linear),
        // Eq. (21): Δδg_T = Δδt (ξ_C − ξ_C₀) + δt Δξ_C + Δt δξ_C + t Δδξ_C
        second: of.named("Ddg_T: Ddt slip", t.second * slip)
            + of.named("Ddg_T: dt Dxi", t.delta * xi.linear)
            + of.named("Ddg_T: Dt dxi", t.linear * xi.delta)
            + of.named("Ddg_T: t Ddxi", t.value * xi.second),
    }
}
