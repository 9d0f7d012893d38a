//! The two-by-two system as two lines in the plane of the unknowns.

use super::{dot, path, svg, text};
use crate::closest_point::ProjectionError;
use crate::curve::{Curve, Hermite};
use crate::equations::StandardCase;
use crate::linearization::closed_form::{PartialVariations, Projection};

const SIZE: f64 = 380.0;

/// Both rows of (51) as lines in the plane of delta xi and delta xi_bar. They intersect at the solution.
pub(in super::super) fn two_lines() -> Result<String, ProjectionError> {
    let case = StandardCase::default();
    let point = case.closest_point()?;
    let StandardCase { q, dq, linear_dq, .. } = &case;
    let (jet, jet_bar) = (Hermite::new().jet(&q.beam, point.xi), Hermite::new().jet(&q.bar, point.xi_bar));
    let projection = Projection::new(&jet.geometry, &jet_bar.geometry, point.held());
    let beam = PartialVariations::new(&jet, &dq.beam, &linear_dq.beam);
    let bar = PartialVariations::new(&jet_bar, &dq.bar, &linear_dq.bar);
    let (d, hat) = (jet.geometry.x - jet_bar.geometry.x, beam.delta_u[0] - bar.delta_u[0]);
    let r = -hat.dot(&jet.geometry.t) - d.dot(&beam.delta_u[1]);
    let r_bar = -hat.dot(&jet_bar.geometry.t) - d.dot(&bar.delta_u[1]);
    let (xi, xi_bar) = projection.solve(r, r_bar);
    let reach = 1.8 * xi.abs().max(xi_bar.abs());
    let at = |u: f64, v: f64| {
        let half = SIZE / 2.0;
        [half + 20.0 + u / reach * half, half + 16.0 - v / reach * half]
    };
    let ends = |a: f64, b: f64, r: f64| {
        // a u + b v = r, along its longer direction.
        let ends = [-reach, reach];
        if a.abs() > b.abs() {
            ends.map(|v| at((r - b * v) / a, v))
        } else {
            ends.map(|u| at(u, (r - a * u) / b))
        }
    };
    let clipped = |class: &str, line: [[f64; 2]; 2]| path(class, line);
    let mut body =
        path("grid", [at(-reach, 0.0), at(reach, 0.0)]) + &path("grid", [at(0.0, -reach), at(0.0, reach)]);
    body += &clipped("curve b", ends(projection.a, -projection.b, r));
    body += &clipped("curve r", ends(projection.b, projection.a_bar, r_bar));
    // Curves of equal distance: H = [[a, -b], [-b, -a_bar]] about the solution.
    for level in [0.15, 0.3] {
        let (p, m, s) = (projection.a, -projection.b, -projection.a_bar);
        let ring = (0..=72).map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 72.0).sin_cos();
            let size =
                level * reach * (p.max(s) / (p * cos * cos + 2.0 * m * cos * sin + s * sin * sin)).sqrt();
            at(xi + size * cos, xi_bar + size * sin)
        });
        body += &path("ring d", ring);
    }
    body += &dot("d", at(xi, xi_bar));
    body += &text([SIZE - 16.0, SIZE / 2.0 + 36.0], "letter b", "δξ");
    body += &text([SIZE / 2.0 + 28.0, 30.0], "letter r", "δξ̄");
    body += &text([30.0, SIZE + 40.0], "small b", "blue: row 1, δ(d·t) = 0");
    body += &text([30.0, SIZE + 62.0], "small r", "orange: row 2, δ(d·t̄) = 0");
    body +=
        &text([30.0, SIZE + 84.0], "small d", "rings: equal distance in the varied state, to second order");
    Ok(svg(SIZE + 60.0, SIZE + 100.0, "Two lines that cross at the variations of both parameters", &body))
}
