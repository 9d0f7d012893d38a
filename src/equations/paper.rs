//! The equations of the paper, section by section: the print, and its formula over any scalar.
//!
//! G. Zavarise, "A generalized formulation for contact between beams: geometrical preliminaries", 2007. The LaTeX is
//! from a scan, so a misprint cannot always be attributed to the print. Every formula is written as it is printed,
//! not in the form best suited for computation.

mod conditions;
mod contact;
mod norms;
mod projection;
mod resume;
mod setup;
mod vectors;

use super::point::{Point, Side};
use super::table::Table;
use crate::number::Real;
use nalgebra::Vector3;

/// All 59 equations at a point.
pub(super) fn read<T: Real>(p: &Point<T>) -> Table<T> {
    let mut table = Table { equations: Vec::with_capacity(59) };
    setup::enter(p, &mut table);
    contact::enter(p, &mut table);
    vectors::enter(p, &mut table);
    norms::enter(p, &mut table);
    conditions::enter(p, &mut table);
    projection::enter(p, &mut table);
    resume::enter(p, &mut table);
    table
}

/// The length of a vector.
fn norm<T: Real>(v: &Vector3<T>) -> T {
    v.dot(v).sqrt()
}

/// δξ Δᵤu + δᵤu Δξ, of u,ξ (k = 1) or u,ξξ (k = 2).
fn mixed<T: Real>(s: &Side<T>, k: usize) -> Vector3<T> {
    s.jet.linear_u[k] * s.xi.delta + s.jet.delta_u[k] * s.xi.linear
}

/// δξ Δξ.
fn squared<T: Real>(s: &Side<T>) -> T {
    s.xi.delta * s.xi.linear
}
