//! A case without the seed and the number that drew it: all its numbers.

use super::compare::{Compared, Costly, compare_beams};
use super::config::{CheckConfig, Oracles};
use super::evaluation_point::EvaluationPoint;
use super::independent_search::{Searched, pair_of, searched};
use super::verdict::Inconclusive;
use crate::closest_point::{ClosestPoint, Search, Unresolved, closest_points};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::Label;
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, TestBeam, TestBeamError};
use crate::variant::Variant;

/// A pair of beams written out as numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseData {
    /// Beam and bar beam.
    pub test_beams: [TestBeam; 2],
    /// Radii and reference parameters.
    pub contact: Contact,
}

/// The closed form at a closest point, term by term.
#[derive(Clone, Debug, PartialEq)]
pub struct ByTerm {
    /// All components with their variations, in the order of [`Quantities::components`].
    ///
    /// [`Quantities::components`]: crate::linearization::Quantities::components
    pub components: [Varied<f64>; COMPONENTS],
    /// The value of each term, with its fault, in the order of evaluation. The terms of a vector follow each other, those
    /// along delta come before those along Delta.
    pub terms: Vec<(Label, f64)>,
}

impl CaseData {
    /// The same with every length times 2^`power`: the same numbers in another unit.
    #[must_use]
    pub fn scaled(&self, power: i32) -> Self {
        let factor = 2.0_f64.powi(power);
        let Contact { radius, radius_bar, xi_0, xi_bar_0 } = self.contact;
        Self {
            test_beams: self.test_beams.each_ref().map(|test_beam| test_beam.scaled(power)),
            contact: Contact { radius: radius * factor, radius_bar: radius_bar * factor, xi_0, xi_bar_0 },
        }
    }

    /// Compares it with the oracles at each of its closest points.
    ///
    /// # Errors
    /// If the numbers define no beam.
    pub fn compare(&self, config: &CheckConfig) -> Result<Compared, TestBeamError> {
        let beams = self.beams()?;
        let costly = Costly { differences: config.oracles == Oracles::All, routes: true };
        Ok(compare_beams(config, costly, beams.each_ref().map(|beam| &**beam), &self.contact, &|_| {
            Vec::new()
        }))
    }

    /// The closed form at one of its closest points: all components with their variations, in the order of
    /// [`Quantities::components`](crate::linearization::Quantities::components).
    ///
    /// Only a reason if the point has no derivatives.
    ///
    /// # Errors
    /// If the numbers define no beam.
    pub fn vary(
        &self,
        variant: &Variant,
        point: &ClosestPoint,
    ) -> Result<Result<[Varied<f64>; COMPONENTS], Inconclusive>, TestBeamError> {
        let beams = self.beams()?;
        let evaluation = EvaluationPoint::new(beams.each_ref().map(|beam| &**beam), &self.contact, point);
        Ok(evaluation.map(|evaluation| evaluation.plain(variant)))
    }

    /// The same for several variants, with the values of all terms.
    ///
    /// # Errors
    /// If the numbers define no beam.
    pub fn by_term<const K: usize>(
        &self,
        variants: [&Variant; K],
        point: &ClosestPoint,
    ) -> Result<Result<[ByTerm; K], Inconclusive>, TestBeamError> {
        let beams = self.beams()?;
        let evaluation = EvaluationPoint::new(beams.each_ref().map(|beam| &**beam), &self.contact, point);
        Ok(evaluation.map(|evaluation| variants.map(|variant| evaluation.by_term(variant))))
    }

    /// The pair of beams, for the search alone, that the drawn case of this number brings, if it brings one.
    pub fn of_search(seed: u64, number: u64) -> Option<Self> {
        pair_of(seed, number)
    }

    /// Searches for its closest points in two independent ways, and compares what is found.
    ///
    /// # Errors
    /// If the numbers define no beam.
    pub fn searched(&self) -> Result<Searched, TestBeamError> {
        let beams = self.beams()?;
        Ok(searched(beams.each_ref().map(|beam| &**beam)))
    }

    /// The regions that the search for closest points leaves open; none if the search fails.
    pub fn open_regions(&self) -> Vec<Unresolved> {
        let Ok([beam, bar]) = self.beams() else { return Vec::new() };
        closest_points(&*beam, &*bar, &Search::default())
            .map_or_else(|_| Vec::new(), |found| found.unresolved)
    }

    pub(crate) fn beams(&self) -> Result<[Box<dyn AnyBeam>; 2], TestBeamError> {
        let [beam, bar] = &self.test_beams;
        Ok([beam.beam()?, bar.beam()?])
    }
}
