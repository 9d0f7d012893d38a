//! The variations of every quantity in two directions: sections 2 to 5 of the paper.

use super::formulation::unit_normal;
use super::paper::{self, FirstOrder, SecondOrderOfBeam};
use super::{Formulation, PartialVariations, Points, Projection};
use crate::closest_point::Held;
use crate::linearization::{Quantities, Varied};
use crate::number::{Formula, Real, Which, named};
use crate::pair::Contact;
use nalgebra::Vector3;

/// First and second variations of all quantities at a closest point.
///
/// `beam` and `bar` are the two curves at the parameters `xi` and `xi_bar` of the closest point, varied in two
/// directions. `held` says which parameters are held at an end. At a singular projection or at d = 0, the numbers of
/// the result are not finite. The formulas are the paper's ([`Formulation::paper`]), each a function of [`paper`].
///
/// Source: Zavarise (2007), eqs. (4)-(59), with the corrections named at each.
pub fn variations<T: Real>(
    beam: &PartialVariations<T>,
    bar: &PartialVariations<T>,
    at: (T, T),
    held: Held,
    contact: &Contact,
) -> Quantities<Varied<T>> {
    variations_in(Formulation::paper(held), beam, bar, at, contact)
}

/// The same in the given formulation.
#[doc(alias = "Eq. (5)")]
#[doc(alias = "Eq. (11)")]
#[doc(alias = "Eq. (16)")]
#[doc(alias = "Eq. (18)")]
#[doc(alias = "Eq. (19)")]
#[doc(alias = "Eq. (22)")]
pub fn variations_in<T: Real>(
    form: Formulation,
    beam: &PartialVariations<T>,
    bar: &PartialVariations<T>,
    (xi, xi_bar): (T, T),
    contact: &Contact,
) -> Quantities<Varied<T>> {
    let (x, y) = (&beam.geometry, &bar.geometry);
    // Eq. (5), (8): d = x_C − x̄_C
    let d = named(Formula::DVector, "x", x.x) - named(Formula::DVector, "x_bar", y.x);

    let projection = Projection::in_formulation(&Points { beam: *x, bar: *y, d }, form);
    let beams = [beam, bar];
    let delta = FirstOrder::new(beams, [&beam.delta_u, &bar.delta_u], &d, &projection);
    let linear = FirstOrder::new(beams, [&beam.linear_u, &bar.linear_u], &d, &projection);
    let firsts = [&delta, &linear];
    let [second, second_bar] = paper::second_order(beams, firsts, &d, &projection);
    let second_d = paper::second_d(&second.x, &second_bar.x);

    let distance = match form.sign() {
        None => by_length(beams, firsts, &d),
        Some(sign) => along_normal(beams, firsts, [&second, &second_bar], &d, T::from(sign)),
    };
    let t = length(Which::Beam, &x.t, [&delta.beam.t, &linear.beam.t, &second.t]);
    let t_bar = length(Which::Bar, &y.t, [&delta.bar.t, &linear.bar.t, &second_bar.t]);
    // Eq. (11), (18), (19): g_N = d − (r + r̄)
    let radii = named(Formula::GN, "r", T::from(contact.radius))
        + named(Formula::GN, "r_bar", T::from(contact.radius_bar));

    let xi = Varied { value: xi, delta: delta.beam.xi, linear: linear.beam.xi, second: second.xi };
    let xi_bar = Varied { value: xi_bar, delta: delta.bar.xi, linear: linear.bar.xi, second: second_bar.xi };
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
        g_t: slip(Which::Beam, &t, &xi, contact.xi_0),
        g_t_bar: slip(Which::Bar, &t_bar, &xi_bar, contact.xi_bar_0),
    }
}

/// d as a length.
#[inline]
fn by_length<T: Real>(
    beams: [&PartialVariations<T>; 2],
    [delta, linear]: [&FirstOrder<T>; 2],
    d: &Vector3<T>,
) -> Varied<T> {
    // Eq. (4): d = ‖d‖
    let value = named(Formula::D, "d.d", d.dot(d)).sqrt();

    let first = [delta, linear].map(|of| paper::delta_distance(d, value, &of.u_hat));
    let second = paper::second_distance(beams, [delta, linear], d, value, first);
    Varied { value, delta: first[0], linear: first[1], second }
}

/// d = n . d, where n is the common normal of the tangents: no division by d.
#[inline]
fn along_normal<T: Real>(
    beams: [&PartialVariations<T>; 2],
    firsts: [&FirstOrder<T>; 2],
    seconds: [&SecondOrderOfBeam<T>; 2],
    d: &Vector3<T>,
    sign: T,
) -> Varied<T> {
    let [t, t_bar] = beams.map(|beam| &beam.geometry.t);
    // n = ± c/|c| with c = t × t̄
    let c = named(Formula::Normal, "t x t_bar", t.cross(t_bar));
    let n = unit_normal(&(c * sign));
    let value = named(Formula::D, "n.d", n.dot(d));
    let [delta, linear] = firsts.map(|of| paper::delta_distance_along_normal(&n, &of.u_hat));
    let delta_n = firsts.map(|of| paper::delta_normal(beams, [&c, &n], of));
    let second = paper::second_distance_along_normal(&n, value, seconds, delta_n);
    Varied { value, delta, linear, second }
}

/// The length of a tangent, from the first variations and the second of the vector.
#[inline]
fn length<T: Real>(which: Which, t: &Vector3<T>, varied: [&Vector3<T>; 3]) -> Varied<T> {
    let value = paper::length(which, t);
    let [delta, linear] = [0, 1].map(|i| paper::delta_length(which, t, value, varied[i]));
    let second = paper::second_length(which, t, value, [delta, linear], varied);
    Varied { value, delta, linear, second }
}

/// g_T = t (xi_C - xi_C0).
#[inline]
fn slip<T: Real>(which: Which, t: &Varied<T>, xi: &Varied<T>, xi_0: f64) -> Varied<T> {
    let slip = xi.value - T::from(xi_0);
    Varied {
        value: paper::slip(which, t.value, slip),
        delta: paper::delta_slip(which, t.value, slip, [t.delta, xi.delta]),
        linear: paper::delta_slip(which, t.value, slip, [t.linear, xi.linear]),
        second: paper::second_slip(which, t, slip, xi),
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
