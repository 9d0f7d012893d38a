//! Two beams over the prime field, at a point that is stationary by construction.

use super::{AnyBeam, ExactBeam};
use crate::closest_point::{Held, Side};
use crate::linearization::closed_form::formulation::{Distance, System, unit_normal};
use crate::linearization::closed_form::{Formulation, Points};
use crate::number::{PrimeField, Real};
use nalgebra::Vector3;
use num_traits::Zero;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Two beams and the parameters of their stationary point.
type Stationary = ([Box<dyn ExactBeam<PrimeField>>; 2], (PrimeField, PrimeField));

/// Draws dofs until d, t and t_bar have square roots, and moves the first beam so that the point is stationary. Held
/// parameters are at a random end.
pub(crate) fn stationary(models: &[Box<dyn AnyBeam>; 2], held: Held, rng: &mut ChaCha8Rng) -> Stationary {
    drawn(models, held, rng, |_, is_lower| if is_lower { Side::Lower } else { Side::Upper })
}

/// The same with parameters held at these ends.
pub(crate) fn stationary_at(
    models: &[Box<dyn AnyBeam>; 2],
    ends: [Option<Side>; 2],
    rng: &mut ChaCha8Rng,
) -> Stationary {
    let held = Held { xi: ends[0].is_some(), xi_bar: ends[1].is_some() };
    drawn(models, held, rng, |i, _| ends[i].unwrap_or(Side::Upper))
}

/// `side` chooses the end of a held parameter from its index and a random number.
fn drawn(
    models: &[Box<dyn AnyBeam>; 2],
    held: Held,
    rng: &mut ChaCha8Rng,
    side: impl Fn(usize, bool) -> Side,
) -> Stationary {
    let random = |rng: &mut ChaCha8Rng| PrimeField::new(rng.random());
    loop {
        let mut beams = models.each_ref().map(|model| model.residues(&mut || random(rng)));
        let end = |i: usize, held: bool, rng: &mut ChaCha8Rng| match (held, rng.random()) {
            (false, _) => random(rng),
            (true, is_lower) => PrimeField::from(side(i, is_lower).parameter()),
        };
        let at = (end(0, held.xi, rng), end(1, held.xi_bar, rng));
        let (x, x_bar) = (beams[0].geometry(at.0), beams[1].geometry(at.1));
        let (t, t_bar): (Vector3<PrimeField>, Vector3<PrimeField>) = (x.t, x_bar.t);
        let d = normal_to_free(held, &t, &t_bar, &Vector3::from_fn(|_, _| random(rng)));
        let squares = [&d, &t, &t_bar].map(|v| v.dot(v));
        if squares.iter().all(|v| v.is_square() && !v.is_zero()) {
            beams[0].translate(&(d - (x.x - x_bar.x)));
            return (beams, at);
        }
    }
}

/// A vector d, computed from `w`, that is normal to the tangents of the free parameters.
pub(crate) fn normal_to_free(
    held: Held,
    t: &Vector3<PrimeField>,
    t_bar: &Vector3<PrimeField>,
    w: &Vector3<PrimeField>,
) -> Vector3<PrimeField> {
    let normal_to = |t: &Vector3<PrimeField>| w - t * (w.dot(t) / t.dot(t));
    match (held.xi, held.xi_bar) {
        (false, false) => t.cross(t_bar) * w.x,
        (true, false) => normal_to(t_bar),
        (false, true) => normal_to(t),
        (true, true) => *w,
    }
}

/// The robust formulation. The sign of n makes n·d the root that the field chooses for d·d.
pub(crate) fn robust(
    beams: &[Box<dyn ExactBeam<PrimeField>>; 2],
    (xi, xi_bar): (PrimeField, PrimeField),
    held: Held,
) -> Formulation {
    let points = Points::new(&beams[0].geometry(xi), &beams[1].geometry(xi_bar));
    let along = unit_normal(&points.cross()).dot(&points.d);
    let reversed = along != points.d.dot(&points.d).sqrt();
    Formulation { held, distance: Distance::Normal { reversed }, system: System::CrossProducts }
}
