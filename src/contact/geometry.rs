//! The gap and the trial state of friction, from points and tangents.

use super::Start;
use crate::closest_point::Held;
use crate::linearization::closed_form::formulation::unit_normal;
use crate::linearization::closed_form::{Formulation, Points};
use crate::number::Real;
use crate::pair::Contact;
use nalgebra::Vector3;

/// The gap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap<T> {
    /// n, the unit normal to the side of the beam.
    pub(super) n: Vector3<T>,
    /// g_N.
    pub(super) g_n: T,
}

impl<T: Real> Gap<T> {
    pub(super) fn new(points: &Points<T>, form: Formulation, is_crossed: bool, contact: Contact) -> Self {
        let side = T::from(if is_crossed { -1.0 } else { 1.0 });
        let d = &points.d;
        let (n, distance) = if let Some(sign) = form.sign() {
            let n = unit_normal(&(points.cross() * (T::from(sign) * side)));
            (n, n.dot(d))
        } else {
            let distance = d.dot(d).sqrt() * side;
            (d / distance, distance)
        };
        // n = σ d/|d|   d_s = n·d   g_N = d_s − (r + r̄)
        let radii = T::from(contact.radius) + T::from(contact.radius_bar);
        Self { n, g_n: distance - radii }
    }
}

/// The trial state of friction: slips as if the beams stuck.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial<T> {
    /// |t| and |t̄|.
    pub(super) t: T,
    pub(super) t_bar: T,
    /// τ and τ̄, the unit tangents.
    pub(super) tau: Vector3<T>,
    pub(super) tau_bar: Vector3<T>,
    /// c = τ·τ̄.
    pub(super) c: T,
    /// ξ − ξₙ and its twin; 0 if held.
    pub(super) u: T,
    pub(super) u_bar: T,
    /// The elastic slips.
    pub(super) e: T,
    pub(super) e_bar: T,
    /// sₑ = e τ − ē τ̄ and γ = |sₑ|.
    pub(super) s: Vector3<T>,
    pub(super) gamma: T,
}

impl<T: Real> Trial<T> {
    pub(super) fn new(points: &Points<T>, (xi, xi_bar): (T, T), held: Held, start: &Start) -> Self {
        let length = |t: &Vector3<T>| t.dot(t).sqrt();
        let (t, t_bar) = (length(&points.beam.t), length(&points.bar.t));
        let (tau, tau_bar) = (points.beam.t / t, points.bar.t / t_bar);
        let slip = |xi: T, start: f64, held: bool| if held { T::zero() } else { xi - T::from(start) };
        let (u, u_bar) = (slip(xi, start.xi, held.xi), slip(xi_bar, start.xi_bar, held.xi_bar));
        // Eq. (15): g_T = t (ξ − ξₙ). Its trial value is e = eₙ + g_T.
        let (e, e_bar) = (T::from(start.e) + t * u, T::from(start.e_bar) + t_bar * u_bar);
        let s = tau * e - tau_bar * e_bar;
        Self { t, t_bar, tau, tau_bar, c: tau.dot(&tau_bar), u, u_bar, e, e_bar, s, gamma: length(&s) }
    }
}
