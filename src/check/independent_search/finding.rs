//! What the comparison of the two searches says.

use crate::check::serialized::{by_name, number};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A difference between the library's search and the independent one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SearchFinding {
    /// What differs.
    pub kind: SearchFindingKind,
    /// xi and xi_bar of the point.
    pub at: [f64; 2],
    /// The library's number: the distance, or what the kind names.
    #[serde(with = "number")]
    pub listed: f64,
    /// The number of the independent search.
    #[serde(with = "number")]
    pub independent: f64,
}

enumeration! {
    /// The kinds of these differences.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum SearchFindingKind {
        /// A minimum that the independent search found is not listed.
        NotListed => "not-listed",
        /// A nearer point exists, and no region that contains it was left open.
        Nearer => "nearer",
        /// The gradient of the distance does not vanish at a listed minimum.
        NotStationary => "not-stationary",
        /// A listed minimum is a saddle or a maximum.
        NotMinimum => "not-minimum",
        /// A listed parameter is held at an end, but the distance decreases from there into the beam.
        HeldInward => "held-inward",
        /// A listed minimum is none of the minima that the independent search found.
        Unknown => "unknown",
        /// A minimum is listed twice.
        Twice => "twice",
        /// The listed minima are not in the order of their distances.
        Order => "order",
        /// The distance of a listed minimum is wrong.
        Distance => "distance",
        /// The smallest distance of an open region is wrong.
        RegionDistance => "region-distance",
    }
}

by_name!(SearchFindingKind);

impl fmt::Display for SearchFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, at: [xi, xi_bar], listed, independent } = self;
        write!(f, "xi = {xi:e}, xi_bar = {xi_bar:e}: ")?;
        match kind {
            SearchFindingKind::NotListed => {
                write!(
                    f,
                    "the independent search finds a minimum, d = {independent:e}; the library does not list it"
                )
            }
            SearchFindingKind::Nearer => write!(
                f,
                "the independent search finds d = {independent:e}; the nearest point of the library has d = {listed:e}"
            ),
            SearchFindingKind::NotStationary => write!(
                f,
                "the library lists a minimum, but the gradient is {listed:.1e}; rounding explains {independent:.1e}"
            ),
            SearchFindingKind::NotMinimum => {
                write!(
                    f,
                    "the library lists a minimum, d = {listed:e}; by the independent search it is a saddle or a maximum"
                )
            }
            SearchFindingKind::HeldInward => write!(
                f,
                "the library lists a minimum with a parameter held at an end, d = {listed:e}; the distance decreases from there"
            ),
            SearchFindingKind::Unknown => {
                write!(
                    f,
                    "the library lists a minimum, d = {listed:e}; the independent search finds none there"
                )
            }
            SearchFindingKind::Twice => write!(f, "the library lists this minimum twice, d = {listed:e}"),
            SearchFindingKind::Order => write!(
                f,
                "the library lists this minimum, d = {listed:e}, after one that is farther away, d = {independent:e}"
            ),
            SearchFindingKind::Distance => write!(
                f,
                "the library lists a minimum with d = {listed:e}; the independent search has d = {independent:e} there"
            ),
            SearchFindingKind::RegionDistance => write!(
                f,
                "the library gives d = {listed:e} as the smallest distance of an open region; the independent search finds {independent:e}"
            ),
        }
    }
}

/// The comparison of both searches for one pair of beams.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Searched {
    /// The number of minima that both searches found.
    pub minima: u64,
    /// The number of compared open regions.
    pub regions: u64,
    /// Whether the searches were compared. They are not if the library's search ended in an error.
    pub is_compared: bool,
    /// Whether no box was left open, so that the comparison is certain.
    pub is_certain: bool,
    /// The differences.
    pub findings: Vec<SearchFinding>,
}
