//! The formulas of [`Rewrite`] that replace one formula of the library.

use super::Rewrite;
use crate::closest_point::Held;
use crate::linearization::closed_form::{PartialVariations, Projection};
use crate::linearization::{Quantities, Varied};
use crate::number::Real;
use nalgebra::Vector3;

/// One formula replaced, all others unchanged.
#[expect(clippy::too_many_lines, reason = "a list of formulas, each of a few lines")]
pub(super) fn by_term<T: Real>(
    rewrite: Rewrite,
    [beam, bar]: [&PartialVariations<T>; 2],
    held: Held,
    unmodified: Quantities<Varied<T>>,
) -> Quantities<Varied<T>> {
    let mut all = unmodified;
    let (x, y) = (&beam.geometry, &bar.geometry);
    let [d, dd, linear_d, second_d] = parts(&unmodified.d_vector);
    let [t, dt, linear_t, second_t] = parts(&unmodified.t_vector);
    let (u_hat, linear_u_hat) = (beam.delta_u[0] - bar.delta_u[0], beam.linear_u[0] - bar.linear_u[0]);
    let second_u_hat = beam.second_u[0] - bar.second_u[0];
    let (xi, xi_bar) = (&unmodified.xi, &unmodified.xi_bar);
    let (dist, length) = (unmodified.d.value, unmodified.t.value);
    let one = T::one();
    // Eq. (40): the parts from motion and from rotation
    let moved = x.t * xi.linear - y.t * xi_bar.linear;
    let turned =
        d.dot(&(beam.delta_u[1] * xi.linear - bar.delta_u[1] * xi_bar.linear)) + d.dot(&second_u_hat);
    match rewrite {
        // Eq. (36)
        Rewrite::AllTermsOfD => {
            all.d.delta = d.dot(&dd) / dist;
            all.d.linear = d.dot(&linear_d) / dist;
        }
        // Eq. (35)
        Rewrite::SecondDAsNorm => {
            let cube = dist * dist * dist;
            all.d.second =
                (d.dot(&second_d) + linear_d.dot(&dd)) / dist - dd.dot(&d) * d.dot(&linear_d) / cube;
        }
        // Eq. (39)
        Rewrite::SecondDLinearized => {
            all.d.second = (u_hat.dot(&(moved + linear_u_hat)) + turned) / dist
                - u_hat.dot(&d) * d.dot(&linear_u_hat) / (dist * dist * dist);
        }
        Rewrite::SecondDSymmetric => {
            let Projection { a, b, a_bar, .. } = Projection::new(x, y, held);
            let bracket = b * (xi.delta * xi_bar.linear + xi_bar.delta * xi.linear)
                + a_bar * xi_bar.delta * xi_bar.linear
                - a * xi.delta * xi.linear;
            all.d.second = (bracket + u_hat.dot(&linear_u_hat) + d.dot(&second_u_hat)
                - unmodified.d.delta * unmodified.d.linear)
                / dist;
        }
        Rewrite::SecondDProjected | Rewrite::SecondDProjectedTwice => {
            let n = d / dist;
            let normal = |v: Vector3<T>| v - n * n.dot(&v);
            let moved = if rewrite == Rewrite::SecondDProjected { moved } else { normal(moved) };
            all.d.second = (u_hat.dot(&(moved + normal(linear_u_hat))) + turned) / dist;
        }
        Rewrite::System => solve(&mut all, [beam, bar], held, |p, r, r_bar| {
            let factor = p.b / p.a;
            let xi_bar = (r_bar - factor * r) / (p.a_bar + factor * p.b);
            ((r + p.b * xi_bar) / p.a, xi_bar)
        }),
        Rewrite::SymmetricMatrix => solve(&mut all, [beam, bar], held, |p, r, r_bar| {
            let (h, h_bar, rhs) = (p.a, -p.a_bar, -r_bar);
            let det = h * h_bar - p.b * p.b;
            ((h_bar * r + p.b * rhs) / det, (p.b * r + h * rhs) / det)
        }),
        Rewrite::UnitTangents => solve(&mut all, [beam, bar], held, |p, r, r_bar| {
            let (s, s_bar) = (one / unmodified.t.value, one / unmodified.t_bar.value);
            let (a, b, a_bar) = (p.a * s * s, p.b * s * s_bar, p.a_bar * s_bar * s_bar);
            let unit = Projection { a, b, a_bar, held, cross_products: None };
            let (xi, xi_bar) = unit.solve(r * s, r_bar * s_bar);
            (xi * s, xi_bar * s_bar)
        }),
        Rewrite::CrossProduct => solve(&mut all, [beam, bar], held, |p, r, r_bar| {
            // D = −|t × t̄|² + .., with the curvature terms separate
            let c = x.t.cross(&y.t);
            let (e, e_bar) = (d.dot(&x.t_xi), d.dot(&y.t_xi));
            let det = -c.dot(&c) + x.t.dot(&x.t) * e_bar - y.t.dot(&y.t) * e + e * e_bar;
            ((p.a_bar * r + p.b * r_bar) / det, (p.a * r_bar - p.b * r) / det)
        }),
        Rewrite::UnitTangentOfT => {
            let w = t / length;
            (all.t.delta, all.t.linear) = (w.dot(&dt), w.dot(&linear_t));
        }
        Rewrite::SecondTProjected => {
            let w = t / length;
            all.t.second = w.dot(&second_t) + dt.dot(&(linear_t - w * w.dot(&linear_t))) / length;
        }
        // Eq. (34)
        Rewrite::SecondTAsQuotient => {
            let product = length * (linear_t.dot(&dt) + t.dot(&second_t));
            all.t.second = (product - unmodified.t.linear * t.dot(&dt)) / (length * length);
        }
        // Eq. (58)
        Rewrite::SecondTCubed => {
            let cube = length * length * length;
            all.t.second =
                (second_t.dot(&t) + dt.dot(&linear_t)) / length - dt.dot(&t) * t.dot(&linear_t) / cube;
        }
        Rewrite::NormsOfNinths => {
            // Nine is a square, so that the root of its square is nine in every field.
            let nine = T::from(9.0);
            let norm = |v: Vector3<T>| (v / nine).dot(&(v / nine)).sqrt() * nine;
            (all.d.value, all.t.value) = (norm(d), norm(t));
        }
        Rewrite::SlipReordered => {
            let slip = unmodified.g_t.value / length;
            all.g_t.second = length * xi.second
                + (unmodified.t.linear * xi.delta + unmodified.t.delta * xi.linear)
                + slip * unmodified.t.second;
        }
        Rewrite::XBarFromD => {
            all.x_bar = unmodified.x.zip_map(&unmodified.d_vector, |x, d| Varied {
                value: x.value - d.value,
                delta: x.delta - d.delta,
                linear: x.linear - d.linear,
                second: x.second - d.second,
            });
        }
        _ => {}
    }
    all
}

/// delta xi and delta xi_bar by another solution of the system, where no end is held.
fn solve<T: Real>(
    all: &mut Quantities<Varied<T>>,
    [beam, bar]: [&PartialVariations<T>; 2],
    held: Held,
    by: impl Fn(&Projection<T>, T, T) -> (T, T),
) {
    if held != Held::default() {
        return;
    }
    let (x, y) = (&beam.geometry, &bar.geometry);
    let d = x.x - y.x;
    let projection = Projection::new(x, y, held);
    let u_hat = beam.delta_u[0] - bar.delta_u[0];
    // Eq. (50)
    let r = -u_hat.dot(&x.t) - beam.delta_u[1].dot(&d);
    let r_bar = -u_hat.dot(&y.t) - bar.delta_u[1].dot(&d);
    (all.xi.delta, all.xi_bar.delta) = by(&projection, r, r_bar);
}

/// Value, delta, Delta and Delta-delta of a vector.
pub(super) fn parts<T: Real>(v: &Vector3<Varied<T>>) -> [Vector3<T>; 4] {
    [v.map(|v| v.value), v.map(|v| v.delta), v.map(|v| v.linear), v.map(|v| v.second)]
}
