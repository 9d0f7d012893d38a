//! Other beams from whose variations those of the given beams follow: moved, rotated, or in another unit.

use super::Rewrite;
use super::rewrites::parts;
use crate::closest_point::Held;
use crate::curve::Geometry;
use crate::linearization::closed_form::{Formulation, PartialVariations};
use crate::linearization::{Quantities, Varied};
use crate::number::Real;
use crate::pair::Contact;
use nalgebra::{Matrix3, Vector3};

/// A function that evaluates the variations of two beams.
pub(crate) type Variations<'a, T> =
    dyn Fn([PartialVariations<T>; 2], (T, T), Formulation, &Contact) -> Quantities<Varied<T>> + 'a;

/// Evaluates the variations of other beams, and derives those of the given beams.
pub(crate) fn by_invariance<T: Real>(
    rewrite: Rewrite,
    variations: &Variations<'_, T>,
    [beam, bar]: [&PartialVariations<T>; 2],
    (xi, xi_bar): (T, T),
    form: Formulation,
    contact: &Contact,
) -> Option<Quantities<Varied<T>>> {
    let (three, nine) = (T::from(3.0), T::from(9.0));
    let of = |beam: PartialVariations<T>, bar: PartialVariations<T>| {
        variations([beam, bar], (xi, xi_bar), form, contact)
    };
    Some(match rewrite {
        Rewrite::DirectionsExchanged => of(beam.exchanged(), bar.exchanged()).map(exchanged),
        Rewrite::Symmetrized => {
            let (one, other) = (of(*beam, *bar), of(beam.exchanged(), bar.exchanged()));
            let half = T::from(0.5);
            let mut others = other.components().into_iter();
            one.map(|v| {
                let second = others.next().map_or(v.second, |other| (v.second + other.second) * half);
                Varied { second, ..v }
            })
        }
        Rewrite::BeamsExchanged => {
            let contact = Contact {
                radius: contact.radius_bar,
                radius_bar: contact.radius,
                xi_0: contact.xi_bar_0,
                xi_bar_0: contact.xi_0,
            };
            // Both d and t × t̄ change their sign, and n changes it too.
            let held = Held { xi: form.held.xi_bar, xi_bar: form.held.xi };
            let other = variations([*bar, *beam], (xi_bar, xi), Formulation { held, ..form }, &contact);
            Quantities {
                x: other.x_bar,
                x_bar: other.x,
                d_vector: other.d_vector.map(|v| times(v, -T::one())),
                t_vector: other.t_bar_vector,
                t_bar_vector: other.t_vector,
                t: other.t_bar,
                t_bar: other.t,
                xi: other.xi_bar,
                xi_bar: other.xi,
                g_t: other.g_t_bar,
                g_t_bar: other.g_t,
                ..other
            }
        }
        Rewrite::Ninths => {
            let [beam, bar] = [beam, bar].map(|partial| partial.map(|v| v * nine));
            let contact =
                Contact { radius: 9.0 * contact.radius, radius_bar: 9.0 * contact.radius_bar, ..*contact };
            let other = variations([beam, bar], (xi, xi_bar), form, &contact);
            let ninth = T::one() / nine;
            Quantities { xi: other.xi, xi_bar: other.xi_bar, ..other.map(|v| times(v, ninth)) }
        }
        Rewrite::Moved => {
            let by = beam.geometry.x * T::from(0.5);
            let mut both = [*beam, *bar];
            for partial in &mut both {
                partial.geometry.x += by;
            }
            let other = of(both[0], both[1]);
            let back = |x: Vector3<Varied<T>>| x.zip_map(&by, |x, by| Varied { value: x.value - by, ..x });
            Quantities { x: back(other.x), x_bar: back(other.x_bar), ..other }
        }
        Rewrite::Turned => {
            // Columns (2, 1, 2), (-2, 2, 1), (-1, -2, 2), over 3: orthonormal.
            let entries = [2.0, 1.0, 2.0, -2.0, 2.0, 1.0, -1.0, -2.0, 2.0].map(|e| T::from(e) / three);
            let turn = Matrix3::from_column_slice(&entries);
            let [beam, bar] = [beam, bar].map(|partial| partial.map(|v| turn * v));
            let other = of(beam, bar);
            let back = |v: Vector3<Varied<T>>| {
                let [value, delta, linear, second] = parts(&v).map(|part| turn.tr_mul(&part));
                Vector3::from_fn(|i, _| Varied {
                    value: value[i],
                    delta: delta[i],
                    linear: linear[i],
                    second: second[i],
                })
            };
            Quantities {
                x: back(other.x),
                x_bar: back(other.x_bar),
                d_vector: back(other.d_vector),
                t_vector: back(other.t_vector),
                t_bar_vector: back(other.t_bar_vector),
                ..other
            }
        }
        Rewrite::Reversed => stretched(-1.0, variations, [beam, bar], (xi, xi_bar), form, contact),
        Rewrite::Reparametrized => stretched(0.5, variations, [beam, bar], (xi, xi_bar), form, contact),
        Rewrite::LongDirections => {
            let long = |partial: &PartialVariations<T>| PartialVariations {
                delta_u: partial.delta_u.map(|v| v * three),
                second_u: partial.second_u.map(|v| v * three),
                ..*partial
            };
            of(long(beam), long(bar)).map(|v| Varied {
                delta: v.delta / three,
                second: v.second / three,
                ..v
            })
        }
        _ => return None,
    })
}

/// With the beam's parameter in another unit, xi = factor * other. Only signs and lengths of tangents change.
fn stretched<T: Real>(
    unit: f64,
    variations: &Variations<'_, T>,
    [beam, bar]: [&PartialVariations<T>; 2],
    (xi, xi_bar): (T, T),
    form: Formulation,
    contact: &Contact,
) -> Quantities<Varied<T>> {
    let factor = T::from(unit);
    let square = factor * factor;
    let Geometry { x, t, t_xi, t_xixi } = beam.geometry;
    let [u, linear_u] =
        [beam.delta_u, beam.linear_u].map(|[u, u_xi, u_xixi]| [u, u_xi * factor, u_xixi * square]);
    let other = PartialVariations {
        geometry: Geometry { x, t: t * factor, t_xi: t_xi * square, t_xixi: t_xixi * (square * factor) },
        delta_u: u,
        linear_u,
        second_u: [beam.second_u[0], beam.second_u[1] * factor],
    };
    let contact = Contact { xi_0: contact.xi_0 / unit, ..*contact };
    let form = if unit < 0.0 { form.reversed() } else { form };
    let other = variations([other, *bar], (xi / factor, xi_bar), form, &contact);
    let (back, size) = (T::one() / factor, T::one() / T::from(unit.abs()));
    Quantities {
        t_vector: other.t_vector.map(|v| times(v, back)),
        t: times(other.t, size),
        xi: times(other.xi, factor),
        // The slip is t ξ. The units cancel, and the sign remains.
        g_t: times(other.g_t, T::from(unit.signum())),
        ..other
    }
}

fn times<T: Real>(v: Varied<T>, factor: T) -> Varied<T> {
    Varied {
        value: v.value * factor,
        delta: v.delta * factor,
        linear: v.linear * factor,
        second: v.second * factor,
    }
}

fn exchanged<T: Real>(v: Varied<T>) -> Varied<T> {
    Varied { delta: v.linear, linear: v.delta, ..v }
}
