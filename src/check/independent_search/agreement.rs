//! The minima and open regions that the library lists, compared with those of the independent search.

use super::IndependentSearch;
use super::branch::Minimum;
use super::enclosure::Sign;
use super::finding::{SearchFinding, SearchFindingKind, Searched};
use crate::check::candidate::CAREFUL;
use crate::closest_point::{ClosestPoint, ClosestPoints, Degeneracy, End, Unresolved};

/// The accuracy that is required of the parameters of a listed minimum, beside the rounding of the gradient.
const PARAMETER: f64 = 1e-12;
/// The relative error of the smallest distance of an open region, over the longest curve.
const OF_REGION: f64 = 1e-12;
/// The distance, in the parameters, at which a minimum belongs to an open region or box.
const NEAR: f64 = 1e-6;
/// The number of open regions of a pair of beams that are compared. A badly scaled pair may have hundreds.
const REGIONS: usize = 4;
/// The number of open boxes from which descents start.
const STARTS: usize = 8;

/// What is said of a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Claim {
    /// xi and xi_bar.
    pub(crate) at: [f64; 2],
    /// Which parameters are held at an end, and whether strictly.
    pub(crate) held: [Option<bool>; 2],
    /// The distance, if it is given.
    pub(crate) distance: Option<f64>,
    /// Whether it is said that rounding leaves the derivatives of the parameters undecided.
    pub(crate) is_uncertain: bool,
}

impl From<&ClosestPoint> for Claim {
    fn from(point: &ClosestPoint) -> Self {
        let held = [point.end, point.end_bar].map(|end| end.map(|End { strict, .. }| strict));
        let is_uncertain = matches!(
            point.degeneracy(),
            Some(
                Degeneracy::IllConditioned { .. } | Degeneracy::Singular { .. } | Degeneracy::WeakEnd { .. }
            )
        );
        Self { at: [point.xi, point.xi_bar], held, distance: Some(point.distance), is_uncertain }
    }
}

fn contains(within: [[f64; 2]; 2], at: [f64; 2], margin: f64) -> bool {
    within.iter().zip(at).all(|([low, high], at)| low - margin <= at && at <= high + margin)
}

impl IndependentSearch<'_> {
    /// Why the point is no local minimum of the square, if it is none.
    pub(crate) fn judged(&self, claim: &Claim) -> Option<SearchFinding> {
        let Claim { at, held, distance, is_uncertain } = *claim;
        let here = self.at(at);
        let unit = self.factor;
        let length = distance.unwrap_or(here.distance() / unit);
        let finding = |kind, listed, independent| Some(SearchFinding { kind, at, listed, independent });
        for i in 0..2 {
            // A curve as a sum of shape functions rounds by its largest length.
            let of_sums = f64::EPSILON * self.scale * here.reach[i];
            let rest = CAREFUL * (here.rest[i] + of_sums);
            let gradient = here.gradient[i];
            let size = self.curves[i].at(at[i]).size[0];
            match held[i] {
                Some(strict) if at[i].abs() >= 1.0 => {
                    let weak = if strict { 0.0 } else { here.weak[i] };
                    if gradient * at[i] > rest + weak {
                        return finding(SearchFindingKind::HeldInward, length, here.distance() / unit);
                    }
                }
                _ if is_uncertain => {}
                _ => {
                    let slope = here.hessian[2 * i].abs() + here.hessian[1].abs();
                    let explained = rest + PARAMETER * slope;
                    if gradient.is_nan() || gradient.abs() > explained {
                        let [gradient, explained] = [gradient.abs(), explained].map(|g| g / size / unit);
                        return finding(SearchFindingKind::NotStationary, gradient, explained);
                    }
                }
            }
        }
        let free = held.map(|held| held.is_none());
        let is_concave = (0..2).any(|i| free[i] && here.curvature(i) == Sign::Negative);
        if is_concave || (free == [true; 2] && here.determinant() == Sign::Negative) {
            return finding(SearchFindingKind::NotMinimum, length, here.distance() / unit);
        }
        let apart = distance.map_or(0.0, |distance| (distance * unit - here.distance()).abs());
        let of_sums = f64::EPSILON * self.scale;
        if apart > CAREFUL * (here.distance_error() + of_sums) {
            return finding(SearchFindingKind::Distance, length, here.distance() / unit);
        }
        None
    }

    /// Compares the library's result.
    pub(crate) fn compared(&mut self, found: &ClosestPoints) -> Searched {
        let mut findings = Vec::new();
        let mut wrong = Vec::new();
        let mut met = vec![false; self.survey.minima.len()];
        let mut listed: Vec<[f64; 2]> = Vec::new();
        for point in &found.minima {
            let claim = Claim::from(point);
            if let Some(finding) = self.judged(&claim) {
                wrong.push(claim.at);
                findings.push(finding);
                continue;
            }
            let of =
                |kind| SearchFinding { kind, at: claim.at, listed: point.distance, independent: f64::NAN };
            let is_twice = listed.iter().any(|&known| contains(known.map(|x| [x, x]), claim.at, 1e-10));
            let place = self.survey.minima.iter().position(|minimum| minimum.is_at(claim.at));
            match place {
                _ if is_twice => findings.push(of(SearchFindingKind::Twice)),
                Some(i) if met[i] && !self.survey.minima[i].is_weak => {
                    findings.push(of(SearchFindingKind::Twice));
                }
                Some(i) => met[i] = true,
                None if self.is_open(claim.at) || self.is_almost(point) || claim.is_uncertain => {}
                None => findings.push(of(SearchFindingKind::Unknown)),
            }
            listed.push(claim.at);
        }
        for pair in found.minima.windows(2).filter(|pair| pair[0].distance > pair[1].distance) {
            let (listed, independent) = (pair[1].distance, pair[0].distance);
            let at = [pair[1].xi, pair[1].xi_bar];
            findings.push(SearchFinding { kind: SearchFindingKind::Order, at, listed, independent });
        }
        let regions: Vec<_> = found.unresolved.iter().map(|region| [region.xi, region.xi_bar]).collect();
        let is_covered = |at: [f64; 2]| regions.iter().any(|&region| contains(region, at, NEAR));
        for (minimum, is_met) in self.survey.minima.iter().zip(&met) {
            let is_wrong = wrong.iter().any(|&at| minimum.is_at(at));
            if !(*is_met || minimum.is_weak || is_wrong || is_covered(minimum.at)) {
                findings.push(self.not_listed(minimum.at, minimum.distance[0]));
            }
        }
        for region in found.unresolved.iter().take(REGIONS) {
            findings.extend(self.of_region(region));
        }
        let distances = found.minima.iter().map(|point| point.distance);
        let nearest = distances.chain(found.unresolved.iter().map(|region| region.distance[0]));
        let nearest = nearest.fold(f64::INFINITY, f64::min) * self.factor;
        listed.extend(&wrong);
        findings.extend(self.nearer(nearest, &listed, &is_covered));
        Searched {
            minima: met.iter().filter(|is_met| **is_met).count() as u64,
            regions: regions.len().min(REGIONS) as u64,
            is_compared: true,
            is_certain: self.survey.open.is_empty(),
            findings,
        }
    }

    fn not_listed(&self, at: [f64; 2], distance: f64) -> SearchFinding {
        let independent = distance / self.factor;
        SearchFinding { kind: SearchFindingKind::NotListed, at, listed: f64::NAN, independent }
    }

    fn is_open(&self, at: [f64; 2]) -> bool {
        self.survey.open.iter().any(|open| contains(open.within, at, NEAR))
    }

    /// Whether a weakly held point is a minimum that lies inside by rounding.
    fn is_almost(&self, point: &ClosestPoint) -> bool {
        let near = |minimum: &Minimum| contains(minimum.at.map(|x| [x, x]), [point.xi, point.xi_bar], NEAR);
        !point.is_strict() && self.survey.minima.iter().any(near)
    }

    /// The point and the smallest distance of an open region.
    fn of_region(&mut self, region: &Unresolved) -> Option<SearchFinding> {
        let point = &region.point;
        let at = [point.xi, point.xi_bar];
        let finding =
            |kind, at, independent| Some(SearchFinding { kind, at, listed: point.distance, independent });
        let unit = self.factor;
        let (listed, here) = (point.distance * unit, self.at(at));
        let tolerance = OF_REGION * self.scale + CAREFUL * here.distance_error();
        if (listed - here.distance()).abs() > tolerance {
            return finding(SearchFindingKind::Distance, at, here.distance() / unit);
        }
        let smallest = self.smallest([region.xi, region.xi_bar], at);
        // An interval may be given in the place of the smallest distance.
        if region.distance[0] * unit > smallest.high + tolerance {
            return finding(SearchFindingKind::RegionDistance, smallest.at, smallest.high / unit);
        }
        if listed < smallest.low - tolerance {
            return finding(SearchFindingKind::RegionDistance, at, smallest.low / unit);
        }
        None
    }

    /// A point that is nearer than all listed ones, or a minimum that is not listed, from the open boxes.
    fn nearer(
        &self,
        nearest: f64,
        listed: &[[f64; 2]],
        is_covered: &dyn Fn([f64; 2]) -> bool,
    ) -> Option<SearchFinding> {
        let mut open: Vec<_> = self.survey.open.iter().collect();
        open.sort_by(|one, other| one.least.total_cmp(&other.least));
        for open in open.iter().step_by(open.len() / STARTS + 1) {
            let start = open.within.map(|[low, high]| 0.5 * (low + high));
            let reached = self.descend(start, [[-1.0, 1.0]; 2]);
            let tolerance = OF_REGION * self.scale + CAREFUL * self.at(reached.at).distance_error();
            if reached.distance < nearest - tolerance {
                return Some(SearchFinding {
                    kind: SearchFindingKind::Nearer,
                    at: reached.at,
                    listed: nearest / self.factor,
                    independent: reached.distance / self.factor,
                });
            }
            let is_listed = listed.iter().any(|&known| contains(known.map(|x| [x, x]), reached.at, NEAR));
            if reached.is_clear && !is_listed && !is_covered(reached.at) {
                let is_known = self.survey.minima.iter().any(|minimum| minimum.is_at(reached.at));
                // A minimum that the survey found is compared already.
                if !is_known {
                    return Some(self.not_listed(reached.at, reached.distance));
                }
            }
        }
        None
    }
}
