//! The minima of the distance of two chains.

use super::{Chains, Owners, Part, Place};
use crate::closest_point::{ClosestPoint, Held};
use crate::contact::ContactError;

impl Chains<'_> {
    /// The minima of the distance of two chains, from those of all pairs of elements in running order: each once,
    /// in the elements that own it.
    ///
    /// At an inner node where the distance is stationary the parameter is free, so the point has no end there. [`Pair::refine`]
    /// with these free parameters gives its conditioning. At a kink that points to the other beam both neighbours hold the
    /// parameter. It stays held, and the contact belongs to the element that begins there.
    ///
    /// [`Pair::refine`]: crate::pair::Pair::refine
    ///
    /// # Errors
    /// [`ContactError::NoElement`].
    pub fn minima(
        &self,
        all: &[(Owners, ClosestPoint)],
    ) -> Result<Vec<(Owners, ClosestPoint)>, ContactError> {
        let places = |&(owners, point): &(Owners, ClosestPoint)| {
            [Place { element: owners.beam, xi: point.xi }, Place { element: owners.bar, xi: point.xi_bar }]
        };
        let chains = [self.beam, self.bar];
        let parts = |of: &(Owners, ClosestPoint)| {
            let [place, place_bar] = places(of);
            Ok([self.beam.part(place, of.1.end.as_ref())?, self.bar.part(place_bar, of.1.end_bar.as_ref())?])
        };
        let mut found: Vec<(Owners, ClosestPoint)> = Vec::new();
        for of in all {
            let own = parts(of)?;
            let mut is_minimum = own.iter().all(|part| !matches!(part, Part::LastEnd | Part::Other));
            for k in (0..2).filter(|&k| own[k] == Part::FirstEnd) {
                let mut is_kink = false;
                for other in all {
                    let [here, there] = [places(of), places(other)];
                    let is_neighbour =
                        there[k].element + 1 == here[k].element && parts(other)?[k] == Part::LastEnd;
                    let chain = chains[1 - k];
                    let is_same =
                        || Ok(chain.distance(there[1 - k], here[1 - k])? <= chain.small(here[1 - k])?);
                    is_kink |= is_neighbour && is_same()?;
                }
                is_minimum &= is_kink;
            }
            if is_minimum {
                let (owners, mut point) = *of;
                let [xi, xi_bar] = own.map(|part| part == Part::Node);
                point.free(Held { xi, xi_bar });
                found.push((owners, point));
            }
        }
        // Within rounding of a node, both of its elements may have the minimum.
        let mut once = Vec::new();
        for (i, of) in found.iter().enumerate() {
            let here = places(of);
            let mut is_twice = false;
            for other in &found[i + 1..] {
                let there = places(other);
                let mut is_same = true;
                for k in 0..2 {
                    is_same &= chains[k].distance(there[k], here[k])? <= chains[k].small(here[k])?;
                }
                is_twice |= is_same;
            }
            if !is_twice {
                once.push(*of);
            }
        }
        Ok(once)
    }
}
