//! Faults of the search, injected into the library's own code while it runs.
//!
//! The check must fail for each of them. Without the feature `check` this file is replaced by `faultless.rs`, whose functions
//! change nothing.

use super::tree::ENDS;
use super::{ClosestPoint, ClosestPoints, Kind};
use std::cell::Cell;

thread_local! {
    /// The fault of this thread.
    static INJECTED: Cell<Option<SearchFault>> = const { Cell::new(None) };
}

/// The result of `run` with this fault, if there is one.
pub(crate) fn with_search_fault<R>(fault: Option<SearchFault>, run: impl FnOnce() -> R) -> R {
    struct Reset(Option<SearchFault>);
    impl Drop for Reset {
        fn drop(&mut self) {
            INJECTED.set(self.0);
        }
    }
    let _reset = Reset(INJECTED.replace(fault));
    run()
}

/// The fault of this thread, or in a build with faults in the source the chosen one.
fn injected() -> Option<SearchFault> {
    #[cfg(beamgap_faults)]
    let chosen = SearchFault::ALL.into_iter().find(|fault| crate::source_fault::is_chosen(fault.name()));
    #[cfg(not(beamgap_faults))]
    let chosen = None;
    INJECTED.get().or(chosen)
}

/// Whether this fault is injected.
pub(crate) fn is_injected(fault: SearchFault) -> bool {
    injected() == Some(fault)
}

/// The bound of the third derivative.
pub(super) fn bound(bound: f64) -> f64 {
    if is_injected(SearchFault::BoundOfFifth) { 0.2 * bound } else { bound }
}

/// The Lipschitz constant that decides whether a box has at most one stationary point.
pub(super) fn contraction(contraction: f64) -> f64 {
    if is_injected(SearchFault::UniquenessLoosened) { 0.1 * contraction } else { contraction }
}

/// The start of Newton's method in a box.
pub(super) fn start((xi, xi_bar): (f64, f64)) -> (f64, f64) {
    if is_injected(SearchFault::BarStartsFromBeam) { (xi, xi) } else { (xi, xi_bar) }
}

/// Whether an edge is left out.
pub(super) fn skips_edge(free: usize, end: u32) -> bool {
    free == 1 && end == ENDS[1] && is_injected(SearchFault::EndForgotten)
}

/// Whether the corners are left out.
pub(super) fn skips_corners() -> bool {
    is_injected(SearchFault::CornersForgotten)
}

/// A point of an edge or a corner.
pub(super) fn of_edge(mut point: ClosestPoint) -> ClosestPoint {
    if is_injected(SearchFault::MultiplierIgnored) {
        for end in [&mut point.end, &mut point.end_bar].into_iter().flatten() {
            end.multiplier = end.multiplier.abs();
        }
        point.kind = Kind::Minimum;
    }
    point
}

/// The whole result.
pub(super) fn result(mut found: ClosestPoints) -> ClosestPoints {
    let Some(fault) = injected() else { return found };
    let ClosestPoints { minima, stationary, unresolved, .. } = &mut found;
    match fault {
        SearchFault::LastStepLeftOut => {
            for point in minima.iter_mut().filter(|point| point.is_interior()) {
                point.xi -= 1e-8;
            }
        }
        SearchFault::SaddlesListed => {
            minima.extend(stationary.iter().filter(|point| point.kind == Kind::Saddle));
            for point in minima.iter_mut() {
                point.kind = Kind::Minimum;
            }
            minima.sort_by(|p, q| p.distance.total_cmp(&q.distance));
        }
        SearchFault::ListedTwice => minima.extend(minima.last().copied()),
        SearchFault::OnlyNearest => minima.truncate(1),
        SearchFault::OrderReversed => minima.reverse(),
        SearchFault::DistanceSquared => {
            for point in minima {
                point.distance *= point.distance;
            }
        }
        SearchFault::RegionDistance => {
            for region in unresolved {
                region.point.distance *= 1.001;
            }
        }
        SearchFault::RegionsDropped => unresolved.clear(),
        _ => {}
    }
    found
}

enumeration! {
    /// A fault of the search.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum SearchFault {
        /// The bound of the third derivative reads the first dof at every place.
        BoundOfFirstDof => "bound-of-first-dof",
        /// The bound of the third derivative has a fifth of its size.
        BoundOfFifth => "bound-of-fifth",
        /// A box counts as one with at most one stationary point up to ten times the limit.
        UniquenessLoosened => "uniqueness-loosened",
        /// The end xi = 1 is not searched.
        EndForgotten => "end-forgotten",
        /// The four corners are not searched.
        CornersForgotten => "corners-forgotten",
        /// Newton's method starts from xi of the box in both parameters.
        BarStartsFromBeam => "bar-start-of-beam",
        /// The parameters are off by 1e-8, as if the last step was left out.
        LastStepLeftOut => "last-step-left-out",
        /// A point at an end is listed if the distance decreases into the beam.
        MultiplierIgnored => "multiplier-ignored",
        /// Saddles are listed as minima.
        SaddlesListed => "saddles-listed",
        /// The last minimum is listed twice.
        ListedTwice => "listed-twice",
        /// Only the nearest minimum is listed.
        OnlyNearest => "only-nearest",
        /// The farthest minimum is listed first.
        OrderReversed => "order-reversed",
        /// The distance of a minimum is squared.
        DistanceSquared => "distance-squared",
        /// The distance of an open region is too large by a thousandth.
        RegionDistance => "region-distance",
        /// Open regions are not listed.
        RegionsDropped => "regions-dropped",
    }
}

impl SearchFault {
    /// What is wrong, as a sentence about the search.
    pub fn what(self) -> &'static str {
        match self {
            Self::BoundOfFirstDof => {
                "reads the first dof at every place of the bound of the third derivative"
            }
            Self::BoundOfFifth => "takes a fifth of the bound of the third derivative",
            Self::UniquenessLoosened => {
                "takes a box for one with at most one stationary point up to ten times the limit"
            }
            Self::EndForgotten => "does not search the end xi = 1",
            Self::CornersForgotten => "does not search the corners",
            Self::BarStartsFromBeam => "starts Newton's method from xi of the box in both parameters",
            Self::LastStepLeftOut => "gives parameters that are off by 1e-8",
            Self::MultiplierIgnored => "lists a corner although the distance decreases from there",
            Self::SaddlesListed => "lists saddles as minima",
            Self::ListedTwice => "lists the last minimum twice",
            Self::OnlyNearest => "lists the nearest minimum alone",
            Self::OrderReversed => "lists the farthest minimum first",
            Self::DistanceSquared => "gives the square of the distance",
            Self::RegionDistance => "gives a distance of an open region that is too large by a thousandth",
            Self::RegionsDropped => "does not list open regions",
        }
    }
}
