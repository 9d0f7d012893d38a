//! The variations of every quantity in two directions: sections 2 to 5 of the paper.

use super::norms::{distance, length, slip};
use super::operands::{Formula, Operands, Side};
use super::projection::{Crossed, Points, System};
use super::terms::{Sound, Terms};
use super::{Form, Frozen, Projection};
use crate::closest_point::Active;
use crate::linearization::{Quantities, Varied};
use crate::number::Real;
use crate::pair::Contact;
use nalgebra::Vector3;

/// First and second variations of all quantities at a closest point.
///
/// `beam` and `bar` are the two curves at the parameters `xi` and `xi_bar` of the closest point, varied in two
/// directions; `active` says which parameters are held at an end. The result is total: at a singular projection or at
/// d = 0 its numbers are not finite. The formulas are the paper's ([`Form::paper`]).
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
    at: (T, T),
    active: Active,
    contact: &Contact,
) -> Quantities<Varied<T>> {
    variations_with(&Sound, beam, bar, at, Form::paper(active), contact)
}

/// The same through [`Terms`], in the form asked for.
pub(crate) fn variations_with<T: Real, F>(
    terms: &F,
    beam: &Frozen<T>,
    bar: &Frozen<T>,
    (xi, xi_bar): (T, T),
    form: Form,
    contact: &Contact,
) -> Quantities<Varied<T>>
where
    F: Terms<T, Operands<T>> + Terms<T, Points<T>> + Terms<T, System<T>>,
{
    let mut o = Operands::new(beam, bar);
    // Eq. (5), (8): d = x_C − x̄_C
    let of = Formula::new(terms, &o);
    o.d = of.term("d: x", |o| o.beam.geometry.x) - of.term("d: x_bar", |o| o.bar.geometry.x);
    let points = Points { beam: o.beam.geometry, bar: o.bar.geometry, d: o.d };
    let projection = Projection::with(terms, &points, form);

    // First order, in both directions.
    let linear = first_order(terms, &projection, o.exchanged());
    o = first_order(terms, &projection, o);
    (o.linear, o.beam.linear, o.bar.linear) = (linear.delta, linear.beam.delta, linear.bar.delta);

    // Second order.
    for bar in [false, true] {
        let (x, t) = rest(&Formula::of_side(terms, &o, bar));
        (o.side_mut(bar).second.rest_x, o.side_mut(bar).second.rest_t) = (x, t);
    }
    (o.beam.second.xi, o.bar.second.xi) = second_parameters(terms, &projection, &o);
    for bar in [false, true] {
        let (x, t) = second_order(&Formula::of_side(terms, &o, bar));
        (o.side_mut(bar).second.x, o.side_mut(bar).second.t) = (x, t);
    }

    // Norms and slips.
    let of = Formula::new(terms, &o);
    let second_d = of.term("Dd d: Dd x", |o| o.beam.second.x) - of.term("Dd d: Dd x_bar", |o| o.bar.second.x);
    let (d, t, t_bar);
    (d, o) = distance(terms, o, form);
    (t, o) = length(terms, o, false);
    (t_bar, o) = length(terms, o, true);
    let of = Formula::new(terms, &o);
    // Eq. (11), (18), (19): g_N = d − (r + r̄)
    let radii = of.term("g_N: r", |_| T::from(contact.radius))
        + of.term("g_N: r_bar", |_| T::from(contact.radius_bar));
    let g_n = Varied { value: d.value - radii, ..d };
    (o.beam.slip, o.bar.slip) = (xi - T::from(contact.xi_0), xi_bar - T::from(contact.xi_bar_0));

    let Operands { beam, bar, .. } = &o;
    let parameter = |value, side: &Side<T>| Varied {
        value,
        delta: side.delta.xi,
        linear: side.linear.xi,
        second: side.second.xi,
    };
    Quantities {
        x: transposed(beam.geometry.x, beam.delta.x, beam.linear.x, beam.second.x),
        x_bar: transposed(bar.geometry.x, bar.delta.x, bar.linear.x, bar.second.x),
        d_vector: transposed(o.d, o.delta.d, o.linear.d, second_d),
        t_vector: transposed(beam.geometry.t, beam.delta.t, beam.linear.t, beam.second.t),
        t_bar_vector: transposed(bar.geometry.t, bar.delta.t, bar.linear.t, bar.second.t),
        d,
        t,
        t_bar,
        xi: parameter(xi, beam),
        xi_bar: parameter(xi_bar, bar),
        g_n,
        g_t: slip(terms, &o, false),
        g_t_bar: slip(terms, &o, true),
    }
}

/// The first variations of parameters, points and tangents along delta.
#[inline]
fn first_order<T: Real, F>(terms: &F, projection: &Projection<T>, mut o: Operands<T>) -> Operands<T>
where
    F: Terms<T, Operands<T>> + Terms<T, System<T>>,
{
    // Eq. (37): δᵤû = δᵤu_C − δᵤū_C
    let of = Formula::new(terms, &o);
    o.delta.u_hat =
        of.term("u_hat: du", |o| o.beam.delta.u[0]) - of.term("u_hat: du_bar", |o| o.bar.delta.u[0]);
    // Eq. (44), (50): R_δ = −δᵤû·t − δᵤu,ξ·d   R̄_δ = −δᵤû·t̄ − δᵤū,ξ̄·d   Eq. (49) corrected in its second row
    let of = Formula::new(terms, &o);
    let rest = [
        -of.term("R: du,xi.d", |o| o.beam.delta.u[1].dot(&o.d)),
        -of.term("R_bar: du_bar,xi.d", |o| o.bar.delta.u[1].dot(&o.d)),
    ];
    let names = ["R: du_hat.t", "R_bar: du_hat.t_bar", "dxi: u.du_hat", "dxi_bar: u_bar.du_hat"];
    (o.beam.delta.xi, o.bar.delta.xi) = solve(terms, projection, &o, rest, names, |o| o.delta.u_hat);
    for bar in [false, true] {
        let of = Formula::of_side(terms, &o, bar);
        // Eq. (24), (31): δx_C = t δξ + δᵤu_C
        let x = of.own("dx: t dxi", |s| s.geometry.t * s.delta.xi) + of.own("dx: du", |s| s.delta.u[0]);
        // Eq. (28), (31), (32): δt = t,ξ δξ + δᵤu_C,ξ   ((32) prints a stray −δξ̄ in δt̄)
        let t =
            of.own("dt: t,xi dxi", |s| s.geometry.t_xi * s.delta.xi) + of.own("dt: du,xi", |s| s.delta.u[1]);
        (o.side_mut(bar).delta.x, o.side_mut(bar).delta.t) = (x, t);
    }
    // Eq. (32): δd = δx_C − δx̄_C
    let of = Formula::new(terms, &o);
    o.delta.d = of.term("dd: dx", |o| o.beam.delta.x) - of.term("dd: dx_bar", |o| o.bar.delta.x);
    o
}

/// The second variations of a contact point and its tangent, less their terms in Delta-delta xi.
#[inline]
fn rest<T: Real, F: Terms<T, Operands<T>>>(of: &Formula<'_, F, T>) -> (Vector3<T>, Vector3<T>) {
    // Eq. (26), (27), (31): Δδx_C = t,ξ δξΔξ + t Δδξ + δξ Δᵤu_C,ξ + δᵤu_C,ξ Δξ + Δᵤδᵤu_C
    let x = of.own("Dd x: t,xi dxi Dxi", |s| s.geometry.t_xi * (s.delta.xi * s.linear.xi))
        + of.own("Dd x: dxi Du,xi", |s| s.linear.u[1] * s.delta.xi)
        + of.own("Dd x: du,xi Dxi", |s| s.delta.u[1] * s.linear.xi)
        + of.own("Dd x: Ddu", |s| s.second.u[0]);
    // Eq. (30), (31), (32): Δδt = t,ξξ δξΔξ + t,ξ Δδξ + δξ Δᵤu_C,ξξ + δᵤu_C,ξξ Δξ + Δᵤδᵤu_C,ξ
    // ((32) prints t̄,ξ̄ for t̄,ξ̄ξ̄ in the barred twin)
    let t = of.own("Dd t: t,xixi dxi Dxi", |s| s.geometry.t_xixi * (s.delta.xi * s.linear.xi))
        + of.own("Dd t: dxi Du,xixi", |s| s.linear.u[2] * s.delta.xi)
        + of.own("Dd t: du,xixi Dxi", |s| s.delta.u[2] * s.linear.xi)
        + of.own("Dd t: Ddu,xi", |s| s.second.u[1]);
    (x, t)
}

/// The second variations of xi and xi_bar.
#[inline]
fn second_parameters<T: Real, F>(terms: &F, projection: &Projection<T>, o: &Operands<T>) -> (T, T)
where
    F: Terms<T, Operands<T>> + Terms<T, System<T>>,
{
    let of = Formula::new(terms, o);
    // Eq. (47), (53), (54): the part of Δδd and Δδt that holds no Δδξ goes to the right-hand side, which the paper never
    // gives: R_Δδ = −(δd·Δt + Δd·δt) − t·(rest of Δδd) − d·(rest of Δδt), barred likewise
    let rest_d = of.term("R2: rest of Dd x", |o| o.beam.second.rest_x)
        - of.term("R2: rest of Dd x_bar", |o| o.bar.second.rest_x);
    let rest = [
        -(of.term("R2: dd.Dt", |o| o.delta.d.dot(&o.beam.linear.t))
            + of.term("R2: Dd.dt", |o| o.linear.d.dot(&o.beam.delta.t)))
            - of.term("R2: d.rest", |o| o.d.dot(&o.beam.second.rest_t)),
        -(of.term("R2_bar: dd.Dt_bar", |o| o.delta.d.dot(&o.bar.linear.t))
            + of.term("R2_bar: Dd.dt_bar", |o| o.linear.d.dot(&o.bar.delta.t)))
            - of.term("R2_bar: d.rest", |o| o.d.dot(&o.bar.second.rest_t)),
    ];
    // Eq. (55), (59); its twin Eq. (56) lacks a bar
    let names = ["R2: t.rest", "R2_bar: t_bar.rest", "Ddxi: u.rest", "Ddxi_bar: u_bar.rest"];
    solve(terms, projection, o, rest, names, |_| rest_d)
}

/// Solves for the variations of xi and xi_bar, of first or of second order, with R = r - t.w and R_bar = r_bar - t_bar.w.
#[inline]
fn solve<T: Real, F>(
    terms: &F,
    projection: &Projection<T>,
    o: &Operands<T>,
    [r, r_bar]: [T; 2],
    [in_r, in_r_bar, in_xi, in_xi_bar]: [&'static str; 4],
    w: impl Fn(&Operands<T>) -> Vector3<T>,
) -> (T, T)
where
    F: Terms<T, Operands<T>> + Terms<T, System<T>>,
{
    let of = Formula::new(terms, o);
    if let Some(Crossed { u: [u, u_bar], .. }) = projection.crossed {
        let (xi, xi_bar) = projection.solve_with(terms, r, r_bar);
        (xi + of.term(in_xi, |o| u.dot(&w(o))), xi_bar + of.term(in_xi_bar, |o| u_bar.dot(&w(o))))
    } else {
        let r = r - of.term(in_r, |o| w(o).dot(&o.beam.geometry.t));
        let r_bar = r_bar - of.term(in_r_bar, |o| w(o).dot(&o.bar.geometry.t));
        projection.solve_with(terms, r, r_bar)
    }
}

/// The second variations of a contact point and its tangent.
#[inline]
fn second_order<T: Real, F: Terms<T, Operands<T>>>(of: &Formula<'_, F, T>) -> (Vector3<T>, Vector3<T>) {
    let x =
        of.own("Dd x: t Ddxi", |s| s.geometry.t * s.second.xi) + of.own("Dd x: rest", |s| s.second.rest_x);
    let t = of.own("Dd t: t,xi Ddxi", |s| s.geometry.t_xi * s.second.xi)
        + of.own("Dd t: rest", |s| s.second.rest_t);
    (x, t)
}

/// The variations of a vector, component by component.
#[inline]
fn transposed<T: Real>(
    value: Vector3<T>,
    delta: Vector3<T>,
    linear: Vector3<T>,
    second: Vector3<T>,
) -> Vector3<Varied<T>> {
    Vector3::from_fn(|i, _| Varied { value: value[i], delta: delta[i], linear: linear[i], second: second[i] })
}
