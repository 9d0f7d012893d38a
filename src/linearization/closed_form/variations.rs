//! The variations of every quantity in two directions: sections 2 to 5 of the paper.

use super::first_order::{First, FirstOfBeam};
use super::norms::{along_normal, by_length, length, slip};
use super::second_order::{Second, second_order};
use super::{Formulation, PartialVariations, Points, Projection};
use crate::closest_point::Held;
use crate::linearization::{Quantities, Varied};
use crate::number::{Of, Real, named};
use crate::pair::Contact;
use nalgebra::Vector3;

/// First and second variations of all quantities at a closest point.
///
/// `beam` and `bar` are the two curves at the parameters `xi` and `xi_bar` of the closest point, varied in two
/// directions; `held` says which parameters are held at an end. The result is total: at a singular projection or at
/// d = 0 its numbers are not finite. The formulas are the paper's ([`Formulation::paper`]).
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
    beam: &PartialVariations<T>,
    bar: &PartialVariations<T>,
    at: (T, T),
    held: Held,
    contact: &Contact,
) -> Quantities<Varied<T>> {
    variations_in(Formulation::paper(held), beam, bar, at, contact)
}

/// The same in the form asked for.
pub fn variations_in<T: Real>(
    form: Formulation,
    beam: &PartialVariations<T>,
    bar: &PartialVariations<T>,
    (xi, xi_bar): (T, T),
    contact: &Contact,
) -> Quantities<Varied<T>> {
    let (x, y) = (&beam.geometry, &bar.geometry);
    // Eq. (5), (8): d = x_C − x̄_C
    let d = named("d: x", x.x) - named("d: x_bar", y.x);
    let projection = Projection::in_formulation(&Points { beam: *x, bar: *y, d }, form);
    let beams = [beam, bar];
    let delta = First::new(beams, [&beam.delta_u, &bar.delta_u], &d, &projection);
    let linear = First::new(beams, [&beam.linear_u, &bar.linear_u], &d, &projection);
    let firsts = [&delta, &linear];
    let [second, second_bar] = second_order(beams, firsts, &d, &projection);
    let second_d = named("Dd d: Dd x", second.x) - named("Dd d: Dd x_bar", second_bar.x);

    let distance = match form.sign() {
        None => by_length(beams, firsts, &d),
        Some(sign) => along_normal(beams, firsts, [&second, &second_bar], &d, T::from(sign)),
    };
    let t = length(Of::BEAM, &x.t, &delta.beam.t, &linear.beam.t, &second.t);
    let t_bar = length(Of::BAR, &y.t, &delta.bar.t, &linear.bar.t, &second_bar.t);
    // Eq. (11), (18), (19): g_N = d − (r + r̄)
    let radii = named("g_N: r", T::from(contact.radius)) + named("g_N: r_bar", T::from(contact.radius_bar));
    let of_xi = |value, delta: &FirstOfBeam<T>, linear: &FirstOfBeam<T>, second: &Second<T>| Varied {
        value,
        delta: delta.xi,
        linear: linear.xi,
        second: second.xi,
    };
    let xi = of_xi(xi, &delta.beam, &linear.beam, &second);
    let xi_bar = of_xi(xi_bar, &delta.bar, &linear.bar, &second_bar);
    Quantities {
        x: by_component(x.x, delta.beam.x, linear.beam.x, second.x),
        x_bar: by_component(y.x, delta.bar.x, linear.bar.x, second_bar.x),
        d_vector: by_component(d, delta.d, linear.d, second_d),
        t_vector: by_component(x.t, delta.beam.t, linear.beam.t, second.t),
        t_bar_vector: by_component(y.t, delta.bar.t, linear.bar.t, second_bar.t),
        d: distance,
        t,
        t_bar,
        xi,
        xi_bar,
        g_n: Varied { value: distance.value - radii, ..distance },
        g_t: slip(Of::BEAM, &t, &xi, contact.xi_0),
        g_t_bar: slip(Of::BAR, &t_bar, &xi_bar, contact.xi_bar_0),
    }
}

/// The variations of a vector, component by component.
#[inline]
fn by_component<T: Real>(
    value: Vector3<T>,
    delta: Vector3<T>,
    linear: Vector3<T>,
    second: Vector3<T>,
) -> Vector3<Varied<T>> {
    Vector3::from_fn(|i, _| Varied { value: value[i], delta: delta[i], linear: linear[i], second: second[i] })
}
