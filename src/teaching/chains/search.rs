//! The closest point of two chains: which elements own it, and the history there.

use super::Chain;
use crate::closest_point::{ClosestPoint, Held, ProjectionError};
use crate::contact::History;
use crate::curve::Hermite;
use crate::number::Real;
use crate::pair::{Contact, DofVector, Pair};
use crate::teaching::DOFS;
use nalgebra::{DVector, Vector3};

/// The elements of both chains that own a contact point.
pub type Owner = [usize; 2];

/// The closest point of two chains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The elements.
    pub owner: Owner,
    /// The closest point in them.
    pub point: ClosestPoint,
}

/// The curves of an element of each chain, with their radii.
pub(super) fn pair(chains: &[Chain; 2]) -> Pair<Hermite, Hermite, DOFS, DOFS> {
    let [radius, radius_bar] = chains.each_ref().map(|chain| chain.material.radius);
    let contact = Contact { radius, radius_bar, ..Contact::default() };
    let [curve, curve_bar] = chains.each_ref().map(Chain::curve);
    Pair::new(curve, curve_bar).with_contact(contact)
}

/// The dofs of two elements.
pub(super) fn dofs<T: Real>(chains: &[Chain; 2], u: &DVector<T>, owner: Owner) -> DofVector<T, DOFS, DOFS> {
    DofVector { beam: chains[0].element(u, owner[0]), bar: chains[1].element(u, owner[1]) }
}

/// The nearest closest point of two chains.
///
/// An element owns its first end, so a point at an inner node belongs to the element that starts there.
///
/// # Errors
/// Those of the search in two elements, and [`ProjectionError::NoInteriorMinimum`] if there is no minimum.
pub(super) fn nearest(chains: &[Chain; 2], u: &DVector<f64>) -> Result<Place, ProjectionError> {
    let pair = pair(chains);
    let spheres = chains.each_ref().map(|chain| spheres(chain, u));
    let mut bounds = Vec::new();
    for (i, (x, r)) in spheres[0].iter().enumerate() {
        for (j, (x_bar, r_bar)) in spheres[1].iter().enumerate() {
            bounds.push(((x - x_bar).norm() - r - r_bar, [i, j]));
        }
    }
    bounds.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut best: Option<Place> = None;
    for (bound, owner) in bounds {
        if best.is_some_and(|best| bound > best.point.distance) {
            break;
        }
        for &point in &pair.closest_points(&dofs(chains, u, owner))?.minima {
            if best.is_none_or(|best| point.distance < best.point.distance) {
                best = Some(Place { owner, point });
            }
        }
    }
    at_node(chains, u, best.ok_or(ProjectionError::NoInteriorMinimum)?)
}

/// The same point with parameters free that are held at an inner node, in the element that owns it.
fn at_node(chains: &[Chain; 2], u: &DVector<f64>, place: Place) -> Result<Place, ProjectionError> {
    let Place { mut owner, point } = place;
    let (mut at, mut held) = ([point.xi, point.xi_bar], [point.end.is_some(), point.end_bar.is_some()]);
    let mut inner = [false; 2];
    for k in [0, 1] {
        let last = chains[k].elements - 1;
        if at[k] >= 1.0 && owner[k] < last {
            (owner[k], at[k]) = (owner[k] + 1, -1.0);
        }
        inner[k] = at[k] <= -1.0 && owner[k] > 0;
        held[k] &= !inner[k];
    }
    if !inner[0] && !inner[1] {
        return Ok(place);
    }
    let pair = pair(chains);
    let mut found = Err(ProjectionError::NoInteriorMinimum);
    // The elements on both sides share the tangent, so one of them contains the point.
    for lower in [[false, false], [true, false], [false, true], [true, true]] {
        if found.is_ok() || (lower[0] && !inner[0]) || (lower[1] && !inner[1]) {
            continue;
        }
        let (mut owner, mut at) = (owner, at);
        for k in [0, 1] {
            if lower[k] {
                (owner[k], at[k]) = (owner[k] - 1, 1.0);
            }
        }
        let held = Held { xi: held[0], xi_bar: held[1] };
        let refined = pair.refine(&dofs(chains, u, owner), (at[0], at[1]), held);
        found = refined.map(|point| Place { owner, point });
    }
    found
}

/// A sphere around each element: center and radius, from the control points of the cubic.
fn spheres(chain: &Chain, u: &DVector<f64>) -> Vec<(Vector3<f64>, f64)> {
    let sphere = |element| {
        let q = chain.element(u, element);
        let [x1, t1, x2, t2] = [0, 3, 6, 9].map(|i| q.fixed_rows::<3>(i).into_owned());
        let third = chain.element_length() / 3.0;
        let center = (x1 + x2) * 0.5;
        let control = [x1, x1 + t1 * third, x2 - t2 * third, x2];
        (center, control.iter().map(|x| (x - center).norm()).fold(0.0, f64::max))
    };
    (0..chain.elements).map(sphere).collect()
}

/// The history of a contact in the elements `from`, for the elements `to`: xi_n is moved along the chain.
///
/// `u` is the last converged state, so the moved parameters are constants of the step.
pub(super) fn carried(
    chains: &[Chain; 2],
    u: &DVector<f64>,
    history: History,
    from: Owner,
    to: Owner,
) -> History {
    let along = |k: usize, xi: f64| {
        let length = |element, xi| chains[k].geometry(u, element, xi).t.norm();
        let (i, j) = (from[k], to[k]);
        if i == j {
            return xi;
        }
        // The end that is left, and the end that is entered.
        let (leaves, enters, between) = if i < j { (1.0, -1.0, i + 1..j) } else { (-1.0, 1.0, j + 1..i) };
        let unit = length(j, enters);
        // ξₙ⁽ʲ⁾ = s_j (1 + (1 − s_i ξₙ) |t_i|/|t_j| + Σ 2 |t_k|/|t_j|)
        let first = (1.0 - leaves * xi) * length(i, leaves) / unit;
        enters * (1.0 + first + between.map(|k| 2.0 * length(k, 0.0) / unit).sum::<f64>())
    };
    let slips = history.slips.map(|mut slips| {
        (slips.xi, slips.xi_bar) = (along(0, slips.xi), along(1, slips.xi_bar));
        slips
    });
    History { slips, ..history }
}
