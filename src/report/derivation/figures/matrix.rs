//! The Hessian of d as a picture of its entries.

use super::{path, svg, text};
use crate::closest_point::ProjectionError;
use crate::curve::{Curve, DofDerivatives, Hermite};
use crate::equations::StandardCase;
use nalgebra::{SMatrix, SVector};
use std::fmt::Write;

const CELL: f64 = 11.0;
const DOFS: usize = 24;

/// G'G on the left, with one number for each pair of shape functions, and the whole Hessian of d on the right.
pub(in super::super) fn blocks() -> Result<String, ProjectionError> {
    let case = StandardCase::default();
    let point = case.closest_point()?;
    let hessian = case.pair.linearize(&case.q, &point).d.hessian;
    let jacobian =
        |q: &SVector<f64, 12>, xi: f64| -> SMatrix<f64, 3, 12> { Hermite::new().jet(q, xi).dofs.jacobian(0) };
    let (a, b) = (jacobian(&case.q.beam, point.xi), jacobian(&case.q.bar, point.xi_bar));
    let column = |i: usize| if i < 12 { a.column(i).into_owned() } else { -b.column(i - 12) };
    let product = |i: usize, j: usize| column(i).dot(&column(j));
    let left = panel(20.0, "GᵀG", product);
    let right = panel(330.0, "Hess d", |i, j| hessian.entry(i, j));
    Ok(svg(
        614.0,
        332.0,
        "The entries of G transposed times G, and of the Hessian of d, by size",
        &(left + &right),
    ))
}

/// A matrix. Each square is darker for a larger entry, in steps of ten.
fn panel(left: f64, name: &str, entry: impl Fn(usize, usize) -> f64) -> String {
    let largest = (0..DOFS * DOFS).map(|k| entry(k / DOFS, k % DOFS).abs()).fold(0.0, f64::max);
    let mut body = String::new();
    let mut place = (left, 36.0);
    for k in 0..DOFS * DOFS {
        let (i, j) = (k / DOFS, k % DOFS);
        let share = entry(i, j).abs() / largest;
        let level = if share < 1e-12 {
            0
        } else {
            [1e-3, 1e-2, 1e-1].iter().filter(|&&limit| share > limit).count() + 1
        };
        let class = match (i < 12, j < 12) {
            (true, true) => "b",
            (false, false) => "r",
            _ => "d",
        };
        if level > 0 {
            let (u, v) = place;
            let _ = write!(
                body,
                "<rect class=\"{class} l{level}\" x=\"{u:.0}\" y=\"{v:.0}\" width=\"10\" height=\"10\"/>"
            );
        }
        place = if j + 1 < DOFS { (place.0 + CELL, place.1) } else { (left, place.1 + CELL) };
    }
    body.push('\n');
    let (size, half) = (24.0 * CELL, 12.0 * CELL);
    let frame = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size], [0.0, 0.0]];
    let at = |[u, v]: [f64; 2]| [left + u - 0.5, 36.0 + v - 0.5];
    body += &path("grid", frame.map(at));
    body += &path("grid", [[half, 0.0], [half, size]].map(at));
    body += &path("grid", [[0.0, half], [size, half]].map(at));
    body += &text([left, 24.0], "small", name);
    body += &text([left + half / 2.0, 36.0 + size + 20.0], "small middle b", "beam");
    body += &text([left + 1.5 * half, 36.0 + size + 20.0], "small middle r", "bar beam");
    body
}
