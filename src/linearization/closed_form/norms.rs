//! The lengths of vectors and the slips: section 4 of the paper, and what its section 2.2 makes of it.

use super::Form;
use super::form::unit_normal;
use super::operands::{Formula, Operands};
use super::terms::Terms;
use crate::linearization::Varied;
use crate::number::Real;

/// d and its variations.
#[inline]
pub(super) fn distance<T: Real, F: Terms<T, Operands<T>>>(
    terms: &F,
    o: Operands<T>,
    form: Form,
) -> (Varied<T>, Operands<T>) {
    match form.sign() {
        None => by_length(terms, o),
        Some(sign) => along_normal(terms, o, T::from(sign)),
    }
}

/// d = |d| and its variations.
#[inline]
fn by_length<T: Real, F: Terms<T, Operands<T>>>(terms: &F, mut o: Operands<T>) -> (Varied<T>, Operands<T>) {
    // Eq. (4): d = ‖d‖
    o.distance = Formula::new(terms, &o).term("|d|: d.d", |o| o.d.dot(&o.d)).sqrt();
    // Eq. (37), from (36): δd = d·δᵤû/d
    let first = |o: &Operands<T>| {
        Formula::new(terms, o).term("d|d|: d.du_hat", |o| o.d.dot(&o.delta.u_hat)) / o.distance
    };
    (o.delta.distance, o.linear.distance) = (first(&o), first(&o.exchanged()));
    // Eq. (40), (57), from (38) and (39), with Δᵤû where the paper prints Δû, and with the term of Δᵤδᵤû. As (37) it
    // holds at an active end too, where δξ = 0 takes the place of d·t = 0.
    let of = Formula::new(terms, &o);
    let moved = of.term("Dd|d|: du_hat.t Dxi", |o| o.beam.geometry.t * o.beam.linear.xi)
        - of.term("Dd|d|: du_hat.t_bar Dxi_bar", |o| o.bar.geometry.t * o.bar.linear.xi);
    let turned = of.term("Dd|d|: d.du,xi Dxi", |o| o.beam.delta.u[1] * o.beam.linear.xi)
        - of.term("Dd|d|: d.du_bar,xi Dxi_bar", |o| o.bar.delta.u[1] * o.bar.linear.xi);
    let second_u_hat =
        of.term("Dd|d|: d.Ddu", |o| o.beam.second.u[0]) - of.term("Dd|d|: d.Ddu_bar", |o| o.bar.second.u[0]);
    let second = (of.term("Dd|d|: du_hat.moved", |o| o.delta.u_hat.dot(&moved))
        + of.term("Dd|d|: d.turned", |o| o.d.dot(&turned))
        + of.term("Dd|d|: du_hat.Du_hat", |o| o.delta.u_hat.dot(&o.linear.u_hat))
        + of.term("Dd|d|: d.Ddu_hat", |o| o.d.dot(&second_u_hat))
        - of.term("Dd|d|: dd Dd", |o| o.delta.distance * o.linear.distance))
        / o.distance;
    (Varied { value: o.distance, delta: o.delta.distance, linear: o.linear.distance, second }, o)
}

/// d = n . d and its variations, where n is the common normal of the tangents: no division by d.
#[inline]
fn along_normal<T: Real, F: Terms<T, Operands<T>>>(
    terms: &F,
    mut o: Operands<T>,
    sign: T,
) -> (Varied<T>, Operands<T>) {
    // n = ± c/|c| with c = t × t̄
    let c = Formula::new(terms, &o).term("n: t x t_bar", |o| o.beam.geometry.t.cross(&o.bar.geometry.t));
    o.normal = unit_normal(&(c * sign));
    o.distance = Formula::new(terms, &o).term("|d|: n.d", |o| o.normal.dot(&o.d));
    // Eq. (37): δd = n·δᵤû
    let first =
        |o: &Operands<T>| Formula::new(terms, o).term("d|d|: n.du_hat", |o| o.normal.dot(&o.delta.u_hat));
    (o.delta.distance, o.linear.distance) = (first(&o), first(&o.exchanged()));
    // δn = −[(n·δt) t̄ × c + (n·δt̄) c × t]/(c·c), from n·t = n·t̄ = 0
    let turned = |o: &Operands<T>| {
        let of = Formula::new(terms, o);
        let by = of.term("dn: n.dt", |o| o.bar.geometry.t.cross(&c) * o.normal.dot(&o.beam.delta.t))
            + of.term("dn: n.dt_bar", |o| c.cross(&o.beam.geometry.t) * o.normal.dot(&o.bar.delta.t));
        -by / of.term("dn: c.c", |_| c.dot(&c))
    };
    (o.delta.normal, o.linear.normal) = (turned(&o), turned(&o.exchanged()));
    // Δδd = n·Δδd + Δn·δd with the vector d = d n, so that Δn·δd = d Δn·δn; n is normal to what Δδξ multiplies
    let of = Formula::new(terms, &o);
    let second = of.term("Dd|d|: n.rest of Dd x", |o| o.normal.dot(&o.beam.second.rest_x))
        - of.term("Dd|d|: n.rest of Dd x_bar", |o| o.normal.dot(&o.bar.second.rest_x))
        + of.term("Dd|d|: d dn.Dn", |o| o.distance * o.delta.normal.dot(&o.linear.normal));
    (Varied { value: o.distance, delta: o.delta.distance, linear: o.linear.distance, second }, o)
}

/// The length of a tangent and its variations.
#[inline]
pub(super) fn length<T: Real, F: Terms<T, Operands<T>>>(
    terms: &F,
    mut o: Operands<T>,
    bar: bool,
) -> (Varied<T>, Operands<T>) {
    // Eq. (9): t = ‖t‖
    let value = Formula::of_side(terms, &o, bar).own("|t|: t.t", |s| s.geometry.t.dot(&s.geometry.t)).sqrt();
    o.side_mut(bar).length = value;
    // Eq. (33), (41): δt = t·δt/t
    let first = |o: &Operands<T>| {
        Formula::of_side(terms, o, bar).own("d|t|: t.dt", |s| s.geometry.t.dot(&s.delta.t)) / value
    };
    let (delta, linear) = (first(&o), first(&o.exchanged()));
    (o.side_mut(bar).delta.length, o.side_mut(bar).linear.length) = (delta, linear);
    // Eq. (35), (42), (58) corrected: Δδt = (t·Δδt + Δt·δt − δt Δt)/t, the last of lengths
    let of = Formula::of_side(terms, &o, bar);
    let second = (of.own("Dd|t|: t.Ddt", |s| s.geometry.t.dot(&s.second.t))
        + of.own("Dd|t|: Dt.dt", |s| s.linear.t.dot(&s.delta.t))
        - of.own("Dd|t|: dt Dt", |s| s.delta.length * s.linear.length))
        / value;
    o.side_mut(bar).second.length = second;
    (Varied { value, delta, linear, second }, o)
}

/// g_T = t (xi_C - xi_C0) and its variations.
#[inline]
pub(super) fn slip<T: Real, F: Terms<T, Operands<T>>>(terms: &F, o: &Operands<T>, bar: bool) -> Varied<T> {
    // Eq. (20): δg_T = δt (ξ_C − ξ_C₀) + t δξ_C
    let first = |o: &Operands<T>| {
        let of = Formula::of_side(terms, o, bar);
        of.own("dg_T: dt slip", |s| s.delta.length * s.slip)
            + of.own("dg_T: t dxi", |s| s.length * s.delta.xi)
    };
    let of = Formula::of_side(terms, o, bar);
    Varied {
        // Eq. (14), (15): g_T = t (ξ_C − ξ_C₀)
        value: of.own("g_T: t slip", |s| s.length * s.slip),
        delta: first(o),
        linear: first(&o.exchanged()),
        // Eq. (21): Δδg_T = Δδt (ξ_C − ξ_C₀) + δt Δξ_C + Δt δξ_C + t Δδξ_C
        second: of.own("Ddg_T: Ddt slip", |s| s.second.length * s.slip)
            + of.own("Ddg_T: dt Dxi", |s| s.delta.length * s.linear.xi)
            + of.own("Ddg_T: Dt dxi", |s| s.linear.length * s.delta.xi)
            + of.own("Ddg_T: t Ddxi", |s| s.length * s.second.xi),
    }
}
