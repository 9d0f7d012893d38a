//! Beams of many elements: a contact that moves over a boundary of elements keeps its history.
//!
//! The residual is a function of the dofs of one element of each beam. So the start of the slips is expressed in the element
//! that owns the contact now, as if that element were longer than it is. The lengths of the tangents at the last converged step
//! are constants of the step, so the tangent of the contact element needs no term for the boundary.
//!
//! The centroid of a chain must have a continuous unit tangent. Its curvature may jump, and the tangent may change its length.

use super::{ContactError, History, Slips};
use crate::closest_point::{ClosestPoint, End, Side};
use crate::curve::Curve;
use nalgebra::SVector;

mod minima;

#[cfg(test)]
mod tests;

/// An element of a chain at the last converged step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// |t| at xi = -1, 0 and 1, lengths.
    pub tangents: [f64; 3],
    /// Whether the xi of the element runs against the chain.
    pub is_reversed: bool,
}

impl Link {
    /// The element of a curve.
    pub fn new<C: Curve<N>, const N: usize>(curve: &C, q: &SVector<f64, N>, is_reversed: bool) -> Self {
        let tangents = [-1.0, 0.0, 1.0].map(|xi| curve.jet(q, xi).geometry.t.norm());
        Self { tangents, is_reversed }
    }

    /// 1 if xi runs with the chain, else -1.
    fn direction(&self) -> f64 {
        if self.is_reversed { -1.0 } else { 1.0 }
    }

    /// |t| at the end xi = `end`, which is 1 or -1.
    fn tangent(&self, end: f64) -> f64 {
        self.tangents[if end > 0.0 { 2 } else { 0 }]
    }

    /// 2 |t(0)|, the length by one point.
    fn length(&self) -> f64 {
        2.0 * self.tangents[1]
    }
}

/// The elements of a beam in their running order.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    links: Vec<Link>,
}

/// The part of an element in which a minimum lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Inside,
    /// An end of the chain.
    End,
    /// The inner node at which the element begins, with a distance that is stationary there.
    Node,
    /// The same, with a distance that increases into the element.
    FirstEnd,
    /// The inner node at which the element ends, with a distance that increases into the element.
    LastEnd,
    /// The same, with a stationary distance: the next element has the minimum too.
    Other,
}

/// A point on a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The element, counted in running order.
    pub element: usize,
    /// xi in that element.
    pub xi: f64,
}

impl Chain {
    /// A chain of elements.
    ///
    /// # Errors
    /// [`ContactError::Parameter`] if a tangent has no length or is not finite.
    pub fn new(links: Vec<Link>) -> Result<Self, ContactError> {
        let invalid = |&t: &f64| !(t > 0.0 && t.is_finite());
        match links.iter().flat_map(|link| link.tangents).find(invalid) {
            Some(value) => Err(ContactError::Parameter { name: "|t| of a chain", value }),
            None => Ok(Self { links }),
        }
    }

    fn link(&self, element: usize) -> Result<&Link, ContactError> {
        let count = self.links.len();
        self.links.get(element).ok_or(ContactError::NoElement { element, count })
    }

    /// Whether the chain, and not only the element, ends there.
    fn is_end(&self, element: usize, end: f64) -> bool {
        let runs_out = self.links[element].direction() * end > 0.0;
        element == if runs_out { self.links.len() - 1 } else { 0 }
    }

    /// Whether a minimum of the distance to an element is one of the distance to the chain, and belongs to this element.
    ///
    /// An element owns its inside and the end at which it begins in running order; the last one owns both ends. A parameter
    /// is held at the ends of the chain only: at another end the distance decreases along the neighbour, unless the chain has
    /// a kink there (see [`Chains::minima`]). `end` is [`ClosestPoint::end`] of this beam.
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn owns(&self, place: Place, end: Option<&End>) -> Result<bool, ContactError> {
        Ok(matches!(self.part(place, end)?, Part::Inside | Part::End | Part::Node))
    }

    fn part(&self, place: Place, end: Option<&End>) -> Result<Part, ContactError> {
        let Place { element, xi } = place;
        let link = self.link(element)?;
        let side = match end {
            Some(End { side: Side::Lower, .. }) => -1.0,
            Some(End { side: Side::Upper, .. }) => 1.0,
            None if xi.abs() < 1.0 => return Ok(Part::Inside),
            None => xi.signum(),
        };
        let is_first = link.direction() * side < 0.0;
        Ok(match (is_first, end.is_some_and(|end| end.strict)) {
            _ if self.is_end(element, side) => Part::End,
            (true, false) => Part::Node,
            (true, true) => Part::FirstEnd,
            (false, false) => Part::Other,
            (false, true) => Part::LastEnd,
        })
    }

    /// The parameter of a place in another element, by the lengths of the tangents at the ends on the way; and the sign of a
    /// slip there, -1 if one of the two elements is reversed. It lies outside [-1, 1].
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn carry(&self, from: Place, to: usize) -> Result<(f64, f64), ContactError> {
        let Place { element, xi } = from;
        let (left, entered) = (self.link(element)?, self.link(to)?);
        if element == to {
            return Ok((xi, 1.0));
        }
        let forward = if to > element { 1.0 } else { -1.0 };
        let (s_i, s_j) = (forward * left.direction(), -forward * entered.direction());
        let between = &self.links[element.min(to) + 1..element.max(to)];
        let way = (1.0 - s_i * xi) * left.tangent(s_i) + between.iter().map(Link::length).sum::<f64>();
        // ξₙ⁽ʲ⁾ = s_j (1 + ((1 − s_i ξₙ) |t_i(s_i)| + Σ 2 |t_k(0)|)/|t_j(s_j)|)
        Ok((s_j * (1.0 + way / entered.tangent(s_j)), left.direction() * entered.direction()))
    }

    /// A length that is small beside the element of a place.
    fn small(&self, place: Place) -> Result<f64, ContactError> {
        Ok(1e-6 * self.link(place.element)?.length())
    }

    /// The length of the way between two places.
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn distance(&self, from: Place, to: Place) -> Result<f64, ContactError> {
        let (xi, _) = self.carry(from, to.element)?;
        let link = self.link(to.element)?;
        // Within an element the tangent in its middle is used, as between two elements.
        let t = if from.element == to.element { link.tangents[1] } else { link.tangent(xi) };
        Ok((to.xi - xi).abs() * t)
    }
}

/// The chains of two beams.
#[derive(Clone, Copy, Debug)]
pub struct Chains<'a> {
    /// The elements of the beam.
    pub beam: &'a Chain,
    /// The elements of the bar beam.
    pub bar: &'a Chain,
}

/// The elements that own a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Owners {
    /// The element of the beam.
    pub beam: usize,
    /// The element of the bar beam.
    pub bar: usize,
}

/// A contact of two chains at the last converged step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Owned {
    /// Its elements.
    pub owners: Owners,
    /// Its parameters xi and xi_bar there. An open contact has no other place.
    pub at: (f64, f64),
    /// Its history.
    pub history: History,
}

impl Chains<'_> {
    /// Whether a minimum of the distance of two elements is one of the chains, and belongs to these elements.
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn own(&self, owners: Owners, point: &ClosestPoint) -> Result<bool, ContactError> {
        let place = Place { element: owners.beam, xi: point.xi };
        let place_bar = Place { element: owners.bar, xi: point.xi_bar };
        Ok(self.beam.owns(place, point.end.as_ref())? && self.bar.owns(place_bar, point.end_bar.as_ref())?)
    }

    /// The history of a contact in the elements that own it now.
    ///
    /// The elastic slips are lengths and are kept. Between elements that run in different directions they change their signs,
    /// and so does c_n.
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn carry(&self, of: &Owned, to: Owners) -> Result<History, ContactError> {
        let Some(slips) = of.history.slips else { return Ok(of.history) };
        let (xi, sign) = self.beam.carry(Place { element: of.owners.beam, xi: slips.xi }, to.beam)?;
        let (xi_bar, sign_bar) =
            self.bar.carry(Place { element: of.owners.bar, xi: slips.xi_bar }, to.bar)?;
        let (e, e_bar, cosine) = (sign * slips.e, sign_bar * slips.e_bar, sign * sign_bar * slips.cosine);
        Ok(History { slips: Some(Slips { xi, xi_bar, e, e_bar, cosine, ..slips }), ..of.history })
    }

    /// The histories of the minima of this step, each in the elements that own it.
    ///
    /// The nearest pairs of a contact before and a minimum now are matched first, by the length of the way along both chains.
    /// A minimum farther than `reach` from every contact that is left is a first contact: its history is empty. A contact that
    /// is open keeps its normal, so that a beam that passes through the other one in a step is pushed back.
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn hand_on(
        &self,
        before: &[Owned],
        now: &[(Owners, ClosestPoint)],
        reach: f64,
    ) -> Result<Vec<Owned>, ContactError> {
        let mut ways = Vec::new();
        for (i, of) in before.iter().enumerate() {
            for (j, (owners, point)) in now.iter().enumerate() {
                let way = self.beam.distance(
                    Place { element: of.owners.beam, xi: of.at.0 },
                    Place { element: owners.beam, xi: point.xi },
                )?;
                let way_bar = self.bar.distance(
                    Place { element: of.owners.bar, xi: of.at.1 },
                    Place { element: owners.bar, xi: point.xi_bar },
                )?;
                ways.push((way.hypot(way_bar), i, j));
            }
        }
        ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = |&(owners, point): &(Owners, ClosestPoint)| {
            let at = (point.xi, point.xi_bar);
            Owned { owners, at, history: History::default() }
        };
        let mut owned: Vec<_> = now.iter().map(first).collect();
        let (mut given, mut has) = (vec![false; before.len()], vec![false; now.len()]);
        for (_, i, j) in ways.into_iter().take_while(|&(way, ..)| way <= reach) {
            if !given[i] && !has[j] {
                owned[j].history = self.carry(&before[i], owned[j].owners)?;
                (given[i], has[j]) = (true, true);
            }
        }
        Ok(owned)
    }
}
