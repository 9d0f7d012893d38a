//! The variations of every quantity in two directions: sections 2 to 5 of the paper.

use super::{Frozen, Projection};
use crate::closest_point::Active;
use crate::curve::Geometry;
use crate::linearization::{Quantities, Varied};
use crate::number::Real;
use crate::pair::Contact;
use nalgebra::Vector3;

/// First and second variations of all quantities at a closest point.
///
/// `beam` and `bar` are the two curves at the parameters `xi` and `xi_bar` of the closest point, varied in two
/// directions; `active` says which parameters are held at an end. The result is total: at a singular projection or at
/// d = 0 its numbers are not finite.
///
/// Source: Zavarise (2007), eqs. (4)-(59), with the corrections named at each.
#[doc(alias = "Eq. (4)")]
#[doc(alias = "Eq. (5)")]
#[doc(alias = "Eq. (11)")]
#[doc(alias = "Eq. (15)")]
#[doc(alias = "Eq. (16)")]
#[doc(alias = "Eq. (18)")]
#[doc(alias = "Eq. (19)")]
#[doc(alias = "Eq. (20)")]
#[doc(alias = "Eq. (21)")]
#[doc(alias = "Eq. (22)")]
#[doc(alias = "Eq. (24)")]
#[doc(alias = "Eq. (27)")]
#[doc(alias = "Eq. (30)")]
#[doc(alias = "Eq. (31)")]
#[doc(alias = "Eq. (32)")]
#[doc(alias = "Eq. (35)")]
#[doc(alias = "Eq. (37)")]
#[doc(alias = "Eq. (40)")]
#[doc(alias = "Eq. (41)")]
#[doc(alias = "Eq. (42)")]
#[doc(alias = "Eq. (44)")]
#[doc(alias = "Eq. (47)")]
#[doc(alias = "Eq. (48)")]
#[doc(alias = "Eq. (49)")]
#[doc(alias = "Eq. (53)")]
#[doc(alias = "Eq. (54)")]
#[doc(alias = "Eq. (57)")]
#[doc(alias = "Eq. (58)")]
#[doc(alias = "Eq. (59)")]
pub fn variations<T: Real>(
    beam: &Frozen<T>,
    bar: &Frozen<T>,
    (xi, xi_bar): (T, T),
    active: Active,
    contact: &Contact,
) -> Quantities<Varied<T>> {
    let projection = Projection::new(&beam.geometry, &bar.geometry, active);

    // Eq. (5), (8): d = x_C − x̄_C
    let d_vector = beam.geometry.x - bar.geometry.x;
    // Eq. (37): δᵤû = δᵤu_C − δᵤū_C
    let delta_u_hat = beam.delta_u[0] - bar.delta_u[0];
    let linear_u_hat = beam.linear_u[0] - bar.linear_u[0];

    // Eq. (44), (50): first order
    let first = |u_hat: &Vector3<T>, u_xi: &Vector3<T>, u_bar_xi: &Vector3<T>| {
        // R_δ = −δᵤû·t − δᵤu,ξ·d   R̄_δ = −δᵤû·t̄ − δᵤū,ξ̄·d   Eq. (49) corrected in its second row
        let r = -u_hat.dot(&beam.geometry.t) - u_xi.dot(&d_vector);
        let r_bar = -u_hat.dot(&bar.geometry.t) - u_bar_xi.dot(&d_vector);
        projection.solve(r, r_bar)
    };
    let (delta_xi, delta_xi_bar) = first(&delta_u_hat, &beam.delta_u[1], &bar.delta_u[1]);
    let (linear_xi, linear_xi_bar) = first(&linear_u_hat, &beam.linear_u[1], &bar.linear_u[1]);

    let moving = Moving::new(beam, delta_xi, linear_xi);
    let moving_bar = Moving::new(bar, delta_xi_bar, linear_xi_bar);

    // Eq. (32): δd = δx_C − δx̄_C
    let delta_d = moving.delta_x - moving_bar.delta_x;
    let linear_d = moving.linear_x - moving_bar.linear_x;

    // Eq. (47), (53), (54): second order. The part of Δδd and Δδt that holds no Δδξ goes to the right-hand side, which
    // the paper never gives:
    // R_Δδ = −(δd·Δt + Δd·δt) − t·(rest of Δδd) − d·(rest of Δδt), barred likewise
    let rest_d = moving.rest_x - moving_bar.rest_x;
    let r = -(delta_d.dot(&moving.linear_t) + linear_d.dot(&moving.delta_t))
        - beam.geometry.t.dot(&rest_d)
        - d_vector.dot(&moving.rest_t);
    let r_bar = -(delta_d.dot(&moving_bar.linear_t) + linear_d.dot(&moving_bar.delta_t))
        - bar.geometry.t.dot(&rest_d)
        - d_vector.dot(&moving_bar.rest_t);
    // Eq. (55), (59); its twin Eq. (56) lacks a bar
    let (second_xi, second_xi_bar) = projection.solve(r, r_bar);

    let x = moving.position(second_xi);
    let x_bar = moving_bar.position(second_xi_bar);
    let t_vector = moving.tangent(second_xi);
    let t_bar_vector = moving_bar.tangent(second_xi_bar);
    let d_vector = difference(&x, &x_bar);

    // Eq. (4): d = ‖d‖
    let d = d_vector.value.dot(&d_vector.value).sqrt();
    // Eq. (37), from (36): δd = d·δᵤû/d
    let delta_dist = d_vector.value.dot(&delta_u_hat) / d;
    let linear_dist = d_vector.value.dot(&linear_u_hat) / d;
    // Eq. (40), (57), from (38) and (39), with Δᵤû where the paper prints Δû, and with the term of Δᵤδᵤû. As (37) it holds at an active
    // end too, where δξ = 0 takes the place of d·t = 0.
    let moved = beam.geometry.t * linear_xi - bar.geometry.t * linear_xi_bar;
    let turned = beam.delta_u[1] * linear_xi - bar.delta_u[1] * linear_xi_bar;
    let second_u_hat = beam.second_u[0] - bar.second_u[0];
    let second_dist = (delta_u_hat.dot(&moved)
        + d_vector.value.dot(&turned)
        + delta_u_hat.dot(&linear_u_hat)
        + d_vector.value.dot(&second_u_hat)
        - delta_dist * linear_dist)
        / d;
    let d = Varied { value: d, delta: delta_dist, linear: linear_dist, second: second_dist };

    // Eq. (41), (42), (58) corrected
    let t = norm(&t_vector);
    let t_bar = norm(&t_bar_vector);

    let xi = Varied { value: xi, delta: delta_xi, linear: linear_xi, second: second_xi };
    let xi_bar = Varied { value: xi_bar, delta: delta_xi_bar, linear: linear_xi_bar, second: second_xi_bar };

    // Eq. (11), (18), (19): g_N = d − (r + r̄)
    let g_n = Varied { value: d.value - (T::from(contact.radius) + T::from(contact.radius_bar)), ..d };

    Quantities {
        g_t: slip(&t, &xi, contact.xi_0),
        g_t_bar: slip(&t_bar, &xi_bar, contact.xi_bar_0),
        x: transposed(x),
        x_bar: transposed(x_bar),
        d_vector: transposed(d_vector),
        t_vector: transposed(t_vector),
        t_bar_vector: transposed(t_bar_vector),
        d,
        t,
        t_bar,
        xi,
        xi_bar,
        g_n,
    }
}

/// One contact point and its tangent, moving with the dofs and along the curve.
struct Moving<'a, T> {
    beam: &'a Frozen<T>,
    delta_x: Vector3<T>,
    linear_x: Vector3<T>,
    /// Delta-delta x_C less its term in Delta-delta xi.
    rest_x: Vector3<T>,
    delta_t: Vector3<T>,
    linear_t: Vector3<T>,
    /// Delta-delta t less its term in Delta-delta xi.
    rest_t: Vector3<T>,
}

impl<'a, T: Real> Moving<'a, T> {
    fn new(beam: &'a Frozen<T>, delta_xi: T, linear_xi: T) -> Self {
        let Frozen { geometry, delta_u, linear_u, second_u } = beam;
        Self {
            beam,
            // Eq. (24), (31): δx_C = t δξ + δᵤu_C
            delta_x: geometry.t * delta_xi + delta_u[0],
            linear_x: geometry.t * linear_xi + linear_u[0],
            // Eq. (26), (27), (31): Δδx_C = t,ξ δξΔξ + t Δδξ + δξ Δᵤu_C,ξ + δᵤu_C,ξ Δξ + Δᵤδᵤu_C
            rest_x: geometry.t_xi * (delta_xi * linear_xi)
                + linear_u[1] * delta_xi
                + delta_u[1] * linear_xi
                + second_u[0],
            // Eq. (28), (31), (32): δt = t,ξ δξ + δᵤu_C,ξ
            delta_t: geometry.t_xi * delta_xi + delta_u[1],
            linear_t: geometry.t_xi * linear_xi + linear_u[1],
            // Eq. (30), (31), (32): Δδt = t,ξξ δξΔξ + t,ξ Δδξ + δξ Δᵤu_C,ξξ + δᵤu_C,ξξ Δξ + Δᵤδᵤu_C,ξ
            // ((32) prints t̄,ξ̄ for t̄,ξ̄ξ̄ in the barred twin, and a stray −δξ̄ in δt̄)
            rest_t: geometry.t_xixi * (delta_xi * linear_xi)
                + linear_u[2] * delta_xi
                + delta_u[2] * linear_xi
                + second_u[1],
        }
    }

    fn position(&self, second_xi: T) -> Varied<Vector3<T>> {
        let Geometry { x, t, .. } = self.beam.geometry;
        Varied { value: x, delta: self.delta_x, linear: self.linear_x, second: t * second_xi + self.rest_x }
    }

    fn tangent(&self, second_xi: T) -> Varied<Vector3<T>> {
        let Geometry { t, t_xi, .. } = self.beam.geometry;
        Varied {
            value: t,
            delta: self.delta_t,
            linear: self.linear_t,
            second: t_xi * second_xi + self.rest_t,
        }
    }
}

/// The norm of a vector and its variations.
fn norm<T: Real>(v: &Varied<Vector3<T>>) -> Varied<T> {
    // Eq. (9): v = ‖v‖
    let value = v.value.dot(&v.value).sqrt();
    // Eq. (33): δv = v·δv/v
    let delta = v.value.dot(&v.delta) / value;
    let linear = v.value.dot(&v.linear) / value;
    // Eq. (35): Δδv = (v·Δδv + Δv·δv)/v − (δv·v)(v·Δv)/v³
    let second = (v.value.dot(&v.second) + v.linear.dot(&v.delta) - delta * linear) / value;
    Varied { value, delta, linear, second }
}

/// g_T = t (xi_C - xi_C0) and its variations.
fn slip<T: Real>(t: &Varied<T>, xi: &Varied<T>, xi_0: f64) -> Varied<T> {
    let slip = xi.value - T::from(xi_0);
    Varied {
        // Eq. (14), (15): g_T = t (ξ_C − ξ_C₀)
        value: t.value * slip,
        // Eq. (20): δg_T = δt (ξ_C − ξ_C₀) + t δξ_C
        delta: t.delta * slip + t.value * xi.delta,
        linear: t.linear * slip + t.value * xi.linear,
        // Eq. (21): Δδg_T = Δδt (ξ_C − ξ_C₀) + δt Δξ_C + Δt δξ_C + t Δδξ_C
        second: t.second * slip + t.delta * xi.linear + t.linear * xi.delta + t.value * xi.second,
    }
}

fn difference<T: Real>(x: &Varied<Vector3<T>>, y: &Varied<Vector3<T>>) -> Varied<Vector3<T>> {
    Varied {
        value: x.value - y.value,
        delta: x.delta - y.delta,
        linear: x.linear - y.linear,
        second: x.second - y.second,
    }
}

/// From the variations of a vector to a vector of variations.
fn transposed<T: Real>(v: Varied<Vector3<T>>) -> Vector3<Varied<T>> {
    Vector3::from_fn(|i, _| Varied {
        value: v.value[i],
        delta: v.delta[i],
        linear: v.linear[i],
        second: v.second[i],
    })
}
