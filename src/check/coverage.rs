//! The symmetries of the problem, and how often the compared points lie on either side of each.
//!
//! Mirror images, reversed parameters, exchanged beams and rotations are as likely as the original pair. A fault that acts
//! on one side only is therefore detected as surely as one on the other side. [`Symmetry`] lists quantities that change
//! their sign under these operations, and [`Coverage`] counts the signs.

use super::draw::Case;
use super::serialized::by_name;
use crate::closest_point::{ClosestPoint, End, Side};
use crate::curve::Geometry;
use crate::pair::Contact;
use crate::test_beam::Family;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

enumeration! {
    /// A quantity whose two signs must both occur, because some symmetry of the problem exchanges them.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Symmetry {
        /// d·(t × t_bar): mirror image; the side of the bar beam on which the beam lies; reversal of one parameter.
        Side => "side",
        /// t·t_bar: acute or obtuse crossing; reversal of one parameter.
        Crossing => "crossing",
        /// xi: the half of the beam; reversal of xi.
        Xi => "xi",
        /// xi_bar: the half of the bar beam; reversal of xi_bar.
        XiBar => "xi_bar",
        /// t·t,xi: the tangent becomes longer or shorter along xi; reversal of xi.
        Speed => "speed",
        /// t_bar·t_bar,xi_bar, the same for the bar beam.
        SpeedBar => "speed_bar",
        /// d·t,xi: the beam curves away from the bar beam or towards it.
        Curvature => "curvature",
        /// -d·t_bar,xi_bar, the same for the bar beam.
        CurvatureBar => "curvature_bar",
        /// (t × t,xi)·t,xixi, the torsion of the beam; mirror image.
        Torsion => "torsion",
        /// The torsion of the bar beam.
        TorsionBar => "torsion_bar",
        /// t - t_bar: the beam has the longer tangent, or the bar beam; exchange of the beams.
        Length => "length",
        /// r - r_bar: the beam is thicker, or the bar beam; exchange of the beams.
        Radius => "radius",
        /// xi - xi_C0: the slip is forward or backward.
        Slip => "slip",
        /// xi_bar - xi_bar_C0, the same for the bar beam.
        SlipBar => "slip_bar",
        /// g_N: the gap is open or closed.
        Gap => "gap",
        /// The end at which xi is held, +1 or -1; reversal of xi.
        End => "end",
        /// The end at which xi_bar is held.
        EndBar => "end_bar",
        /// The first component of d; mirror image.
        X => "x",
        /// The second component of d.
        Y => "y",
        /// The third component of d.
        Z => "z",
    }
}

by_name!(Symmetry);

/// Products below this part of the product of the lengths are zero: rounding decides their sign.
const ZERO: f64 = 1e-9;

impl Symmetry {
    /// The quantity, and what a positive and a negative sign mean.
    pub fn sides(self) -> [&'static str; 3] {
        match self {
            Self::Side => ["d·(t × t̄)", "d along t × t̄", "d against t × t̄"],
            Self::Crossing => ["t·t̄", "acute crossing", "obtuse crossing"],
            Self::Xi => ["ξ", "upper half of the beam", "lower half of the beam"],
            Self::XiBar => ["ξ̄", "upper half of the bar beam", "lower half of the bar beam"],
            Self::Speed => ["t·t,ξ", "tangent becomes longer", "tangent becomes shorter"],
            Self::SpeedBar => ["t̄·t̄,ξ̄", "bar tangent becomes longer", "bar tangent becomes shorter"],
            Self::Curvature => ["d·t,ξ", "beam curves away", "beam curves towards the bar beam"],
            Self::CurvatureBar => ["-d·t̄,ξ̄", "bar beam curves away", "bar beam curves towards the beam"],
            Self::Torsion => ["(t × t,ξ)·t,ξξ", "right-handed torsion", "left-handed torsion"],
            Self::TorsionBar => {
                ["(t̄ × t̄,ξ̄)·t̄,ξ̄ξ̄", "right-handed torsion of the bar", "left-handed torsion of the bar"]
            }
            Self::Length => ["|t| - |t̄|", "beam has the longer tangent", "bar beam has the longer tangent"],
            Self::Radius => ["r - r̄", "beam is thicker", "bar beam is thicker"],
            Self::Slip => ["ξ - ξ₀", "slip forward", "slip backward"],
            Self::SlipBar => ["ξ̄ - ξ̄₀", "slip of the bar forward", "slip of the bar backward"],
            Self::Gap => ["g_N", "open gap", "closed gap"],
            Self::End => ["ξ held", "held at ξ = 1", "held at ξ = -1"],
            Self::EndBar => ["ξ̄ held", "held at ξ̄ = 1", "held at ξ̄ = -1"],
            Self::X => ["d₁", "d along x", "d against x"],
            Self::Y => ["d₂", "d along y", "d against y"],
            Self::Z => ["d₃", "d along z", "d against z"],
        }
    }

    /// Whether the quantity can differ from zero, if one of the beams is of this family.
    pub fn has_sign_with(self, family: Family) -> bool {
        let is_planar = matches!(family, Family::Segment | Family::Quadratic | Family::Nurbs | Family::Arc);
        match self {
            // Arcs and helices have a constant speed.
            Self::Speed | Self::SpeedBar => !matches!(family, Family::Segment | Family::Arc | Family::Helix),
            Self::Curvature | Self::CurvatureBar => family != Family::Segment,
            Self::Torsion | Self::TorsionBar => !is_planar,
            _ => true,
        }
    }

    /// Whether the sign is positive; nothing if it is zero to rounding, or if the symmetry does not apply to the point.
    pub fn is_positive(
        self,
        [beam, bar]: &[Geometry<f64>; 2],
        point: &ClosestPoint,
        contact: &Contact,
    ) -> Option<bool> {
        let d = beam.x - bar.x;
        // The product relative to the lengths of its factors.
        let relative = |product: f64, lengths: &[&Vector3<f64>]| {
            let relative = lengths.iter().fold(product, |product, v| product / v.norm());
            (relative.abs() > ZERO).then_some(relative > 0.0)
        };
        let dot = |v: &Vector3<f64>, w: &Vector3<f64>| relative(v.dot(w), &[v, w]);
        let torsion =
            |g: &Geometry<f64>| relative(g.t.cross(&g.t_xi).dot(&g.t_xixi), &[&g.t, &g.t_xi, &g.t_xixi]);
        let difference = |x: f64| (x != 0.0).then_some(x > 0.0);
        let at_end = |end: Option<End>| end.map(|end| end.side == Side::Upper);
        match self {
            Self::Side => relative(d.dot(&beam.t.cross(&bar.t)), &[&d, &beam.t, &bar.t]),
            Self::Crossing => dot(&beam.t, &bar.t),
            Self::Xi => difference(point.xi),
            Self::XiBar => difference(point.xi_bar),
            Self::Speed => dot(&beam.t, &beam.t_xi),
            Self::SpeedBar => dot(&bar.t, &bar.t_xi),
            Self::Curvature => dot(&d, &beam.t_xi),
            Self::CurvatureBar => dot(&-d, &bar.t_xi),
            Self::Torsion => torsion(beam),
            Self::TorsionBar => torsion(bar),
            Self::Length => difference(beam.t.norm() - bar.t.norm()),
            Self::Radius => difference(contact.radius - contact.radius_bar),
            Self::Slip => difference(point.xi - contact.xi_0),
            Self::SlipBar => difference(point.xi_bar - contact.xi_bar_0),
            Self::Gap => difference(point.distance - contact.radius - contact.radius_bar),
            Self::End => at_end(point.end),
            Self::EndBar => at_end(point.end_bar),
            Self::X | Self::Y | Self::Z => difference(d[self as usize - Self::X as usize]),
        }
    }
}

/// The numbers of points with a positive and with a negative sign, by symmetry.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Coverage {
    /// The counts.
    pub counts: BTreeMap<Symmetry, [u64; 2]>,
}

impl Coverage {
    /// Counts a closest point of a case.
    pub(super) fn add(&mut self, case: &Case, point: &ClosestPoint) {
        self.add_point(&geometry(case, point), point, &case.contact);
    }

    /// Counts a closest point.
    pub(super) fn add_point(&mut self, at: &[Geometry<f64>; 2], point: &ClosestPoint, contact: &Contact) {
        for symmetry in Symmetry::ALL {
            if let Some(is_positive) = symmetry.is_positive(at, point, contact) {
                self.counts.entry(symmetry).or_default()[usize::from(!is_positive)] += 1;
            }
        }
    }

    /// Adds the counts of the other.
    pub fn merge(&mut self, other: &Self) {
        for (symmetry, counts) in &other.counts {
            let sum = self.counts.entry(*symmetry).or_default();
            for (sum, count) in sum.iter_mut().zip(counts) {
                *sum += count;
            }
        }
    }

    /// The smaller of the two shares of a symmetry; nothing if no point has a sign.
    #[expect(clippy::cast_precision_loss, reason = "a share")]
    pub fn share(&self, symmetry: Symmetry) -> Option<f64> {
        let [positive, negative] = *self.counts.get(&symmetry)?;
        Some(positive.min(negative) as f64 / (positive + negative) as f64)
    }

    /// The sides that no point is on, each with its symmetry and in words. A symmetry without any point counts as two.
    pub fn unseen(&self) -> Vec<(Symmetry, &'static str)> {
        let of = |symmetry: Symmetry| {
            let counts = self.counts.get(&symmetry).copied().unwrap_or_default();
            let [_, sides @ ..] = symmetry.sides();
            let unseen = counts.into_iter().zip(sides).filter(|(count, _)| *count == 0);
            unseen.map(move |(_, side)| (symmetry, side))
        };
        Symmetry::ALL.into_iter().flat_map(of).collect()
    }
}

/// Both beams at a closest point.
pub(crate) fn geometry(case: &Case, point: &ClosestPoint) -> [Geometry<f64>; 2] {
    let [beam, bar] = case.beams();
    [beam.geometry(point.xi), bar.geometry(point.xi_bar)]
}

#[cfg(test)]
mod tests;
