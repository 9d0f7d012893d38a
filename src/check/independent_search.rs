//! A second search for closest points, which shares only the positions of the curves with
//! [`closest_points`](crate::closest_point::closest_points()).
//!
//! Two straight segments are solved exactly: the smallest of nine candidates, in double-double. For all other curves the square
//! of both parameters is searched by branch and bound. Each piece of a curve has a Taylor polynomial and a bound on its
//! remainder, both from the position alone, by power series in ball arithmetic. So every bound contains its rounding, and
//! the library's own derivatives, bounds and criteria are not used. What both searches find is then compared:
//!
//! - every local minimum of the independent search is listed, inside, on the edges and in the corners, or lies in a region
//!   that the library left open;
//! - every listed minimum is stationary up to rounding, is a minimum and not a saddle, is held at an end only if the distance
//!   increases from there, has the right distance, and is listed once;
//! - the smallest distance of every open region is right.
//!
//! # Certainty
//! The square is covered by boxes. In a box that is not discarded F is convex, and its minimum is found. The boxes that are
//! left at the limits are *open*: there the result is not certain, and is compared with a bound of the distance and with
//! descents from these boxes. Such cases are counted.

mod agreement;
mod branch;
mod enclosure;
mod finding;
mod pairs;
mod piece;
mod region;
mod straight;
mod tally;

pub use finding::{SearchFinding, SearchFindingKind, Searched};
pub(crate) use pairs::pair_of;
pub use tally::SearchTally;

use crate::closest_point::{ClosestPoints, ProjectionError, Search, closest_points};
use crate::number::DoubleDouble;
use crate::test_beam::AnyBeam;
use branch::Survey;
use piece::Pieces;

/// What the independent search finds for a pair of beams.
pub(crate) struct IndependentSearch<'a> {
    beams: [&'a dyn AnyBeam; 2],
    curves: [Pieces<'a>; 2],
    /// The power of two that multiplies all lengths.
    factor: f64,
    /// The largest length, in the scaled unit.
    scale: f64,
    survey: Survey,
    is_straight: bool,
}

impl<'a> IndependentSearch<'a> {
    /// Searches all minima. Nothing if a curve is not finite or is a point.
    pub(crate) fn new([beam, bar]: [&'a dyn AnyBeam; 2]) -> Option<Self> {
        let length = [beam, bar].map(|beam| Pieces::new(beam, 1.0).length());
        let longest = length[0].max(length[1]);
        if !(longest.is_finite() && longest > 0.0) {
            return None;
        }
        let factor = 2.0_f64.powf(-longest.log2().round());
        if !factor.is_normal() {
            return None;
        }
        let mut curves = [Pieces::new(beam, factor), Pieces::new(bar, factor)];
        let is_straight = Pieces::is_straight(beam) && Pieces::is_straight(bar);
        let survey = if is_straight {
            let zero = [DoubleDouble::from(0.0); 2];
            let (line, line_bar) = (beam.moved(zero), bar.moved(zero));
            let error = 4.0 * f64::EPSILON * longest * factor;
            straight::closest([&*line, &*line_bar], [[-1.0, 1.0]; 2])?.survey(factor, error)
        } else {
            branch::survey(&mut curves)
        };
        Some(Self { beams: [beam, bar], curves, factor, scale: longest * factor, survey, is_straight })
    }
}

/// Searches for the closest points of two beams in both ways, and compares what is found.
pub(crate) fn searched(beams: [&dyn AnyBeam; 2]) -> Searched {
    let [beam, bar] = beams;
    compared_with(beams, &closest_points(beam, bar, &Search::default()))
}

/// Compares what the library found with the independent search.
pub(crate) fn compared_with(
    beams: [&dyn AnyBeam; 2],
    found: &Result<ClosestPoints, ProjectionError>,
) -> Searched {
    match (found, IndependentSearch::new(beams)) {
        (Ok(found), Some(mut independent)) => independent.compared(found),
        _ => Searched::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::searched;
    use crate::check::Case;

    /// Ends at which a tangent is short and turns soon. By 40 digits the distance increases in the first case from the corner
    /// (-1, -1) up to xi = -1 + 3.3e-8. In the second it decreases from (-1, 1), which is no minimum.
    #[test]
    fn ends_where_the_tangent_turns_soon_are_listed_if_they_are_minima() {
        for number in [1_099_511_629_643, 1_099_511_628_339] {
            let searched = searched(Case::draw(6, number).beams());
            assert!(
                searched.is_compared && searched.findings.is_empty(),
                "{number}: {:?}",
                searched.findings
            );
        }
    }
}
