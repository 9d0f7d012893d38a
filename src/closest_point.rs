//! Closest points of two centroids: the minima of the distance over the square of both parameters.
//!
//! The square [-1, 1]² is closed, so a minimum may lie inside it, on an edge (one parameter held at an end of its
//! beam) or in a corner. [`closest_points`] finds all of them, [`refine`] finds one. The geometry iterates, branches
//! and fails in this module only. All of it is computed in `f64`, and no test depends on the unit of length.
//!
//! # What is guaranteed
//! A region is discarded only if Taylor's theorem, with [`Centroid::third_derivative_bound`], excludes a stationary
//! point in it. One point settles a region only if the theorem excludes a second one. So if
//! [`ClosestPoints::is_complete`], every minimum is listed, and every saddle and maximum inside. Otherwise the missing
//! ones lie in [`ClosestPoints::unresolved`]. The bounds are computed in floating point with a margin of some percent,
//! without directed rounding. A point whose scaled eigenvalue is far above [`Search::resolution`] is resolved.

mod bounds;
mod continuum;
mod ends;
mod error;
#[cfg_attr(not(feature = "check"), path = "closest_point/faultless.rs")]
mod fault;
mod found;
mod held;
mod nearest;
mod newton;
mod point;
mod search;
mod squared_distance;
mod tree;
mod unit;
mod unresolved;

pub use continuum::Continuum;
pub use error::ProjectionError;
#[cfg(feature = "check")]
pub use fault::SearchFault;
#[cfg(feature = "check")]
pub(crate) use fault::{is_injected, with_search_fault};
pub use found::{ClosestPoints, Statistics, Unresolved};
pub use held::Held;
pub use newton::refine;
pub use point::{ClosestPoint, Degeneracy, End, Kind, Side};
pub use squared_distance::SquaredDistance;

use crate::curve::{Curve, Geometry};
use crate::number::Which;
use crate::pair::{self, DofVector};
use ends::Rim;
use nalgebra::SVector;
use search::{Band, Inside, Pair};
use tree::{ROOT, Tree};
use unresolved::{Region, gather};

/// A curve with fixed degrees of freedom, as the search uses it.
pub trait Centroid {
    /// The point and its derivatives at `xi`, which lies in [-1, 1].
    fn geometry(&self, xi: f64) -> Geometry<f64>;

    /// An upper bound of ‖x,xixixi‖ over [-1, 1].
    fn third_derivative_bound(&self) -> f64;

    /// Whether the curve is a polynomial of third degree at most.
    fn is_cubic(&self) -> bool {
        false
    }
}

/// A [`Curve`] with its degrees of freedom.
#[derive(Clone, Copy, Debug)]
struct Beam<'a, C, const N: usize> {
    curve: &'a C,
    q: &'a SVector<f64, N>,
}

impl<C: Curve<N>, const N: usize> Centroid for Beam<'_, C, N> {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        self.curve.jet(self.q, xi).geometry
    }

    fn third_derivative_bound(&self) -> f64 {
        self.curve.third_derivative_bound(self.q)
    }

    fn is_cubic(&self) -> bool {
        self.curve.is_cubic()
    }
}

impl<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize> pair::Pair<A, B, N, M> {
    /// All minima of the distance between the two curves: [`closest_points`] with the default limits.
    ///
    /// # Errors
    /// Those of [`closest_points`].
    #[doc(alias = "closest point projection")]
    #[doc(alias = "CPP")]
    pub fn closest_points(&self, q: &DofVector<f64, N, M>) -> Result<ClosestPoints, ProjectionError> {
        self.closest_points_with(q, &Search::default())
    }

    /// All minima of the distance between the two curves: [`closest_points`] with these limits.
    ///
    /// # Errors
    /// Those of [`closest_points`].
    pub fn closest_points_with(
        &self,
        q: &DofVector<f64, N, M>,
        options: &Search,
    ) -> Result<ClosestPoints, ProjectionError> {
        let (beam, bar) = self.centroids(q);
        closest_points(&beam, &bar, options)
    }

    /// One stationary point by Newton's method from nearby: [`refine`].
    ///
    /// # Errors
    /// Those of [`refine`].
    pub fn refine(
        &self,
        q: &DofVector<f64, N, M>,
        start: (f64, f64),
        held: Held,
    ) -> Result<ClosestPoint, ProjectionError> {
        let (beam, bar) = self.centroids(q);
        refine(&beam, &bar, start, held)
    }

    /// Both curves as the search uses them.
    pub fn centroids<'a>(
        &'a self,
        q: &'a DofVector<f64, N, M>,
    ) -> (impl Centroid + use<'a, A, B, N, M>, impl Centroid + use<'a, A, B, N, M>) {
        let beam = Beam { curve: &self.curve, q: &q.beam };
        (beam, Beam { curve: &self.curve_bar, q: &q.bar })
    }
}

/// The limits of the search. At a limit it leaves a region unresolved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Search {
    /// The maximum number of boxes.
    pub boxes: usize,
    /// The half-width, in the parameters, below which a box is no longer divided.
    pub resolution: f64,
    /// Pairs of parameters with |xi - `xi_bar`| below this are left out: see [`Search::without_diagonal`].
    pub diagonal: f64,
}

impl Default for Search {
    fn default() -> Self {
        Self { boxes: 1 << 14, resolution: 1.0 / f64::from(1 << 20), diagonal: 0.0 }
    }
}

impl Search {
    /// These limits with another number of boxes.
    #[must_use]
    pub fn with_boxes(self, boxes: usize) -> Self {
        Self { boxes, ..self }
    }

    /// These limits with another resolution.
    #[must_use]
    pub fn with_resolution(self, resolution: f64) -> Self {
        Self { resolution, ..self }
    }

    /// These limits without the pairs of parameters with |xi - `xi_bar`| < `width`.
    ///
    /// A curve touches itself where its distance to itself has a minimum apart from the diagonal xi = `xi_bar`. Each such
    /// minimum is listed twice, with the parameters exchanged. A pair with |xi - `xi_bar`| = `width` is no minimum, unless
    /// the distance is stationary there.
    #[must_use]
    pub fn without_diagonal(self, width: f64) -> Self {
        Self { diagonal: width, ..self }
    }
}

/// Finds all minima of the distance between two curves over the square [-1, 1]², and all interior stationary points.
///
/// # Errors
/// [`ProjectionError::NonFinite`], or [`ProjectionError::ZeroTangent`] if a curve is a single point. Parallel or
/// crossing centroids and the lack of an interior minimum are not errors of the search but properties of its result:
/// see [`ClosestPoint::degeneracy`], [`ClosestPoints::unresolved`] and [`ClosestPoints::interior`].
#[doc(alias = "closest point projection")]
#[doc(alias = "CPP")]
pub fn closest_points(
    beam: &dyn Centroid,
    bar: &dyn Centroid,
    options: &Search,
) -> Result<ClosestPoints, ProjectionError> {
    match search_unscaled([beam, bar], options, unit::is_usual) {
        Ok(Some(found)) => Ok(found),
        Ok(None) | Err(ProjectionError::NonFinite) => {
            let ([beam, bar], unit) = unit::scaled([beam, bar])?;
            let found = search_unscaled([&beam, &bar], options, |_| true)?;
            Ok(found.ok_or(ProjectionError::NonFinite)?.in_unit(unit))
        }
        Err(error) => Err(error),
    }
}

/// The search in the unit of the curves; nothing if they do not have the size that is required.
fn search_unscaled(
    [beam, bar]: [&dyn Centroid; 2],
    options: &Search,
    has_size: impl Fn(f64) -> bool,
) -> Result<Option<ClosestPoints>, ProjectionError> {
    let band = Band { width: options.diagonal };
    let mut pair = Pair { curves: [beam, bar], trees: [Tree::new(beam)?, Tree::new(bar)?], band };
    let [size, size_bar] = pair.trees.each_ref().map(Tree::size);
    if !has_size(size.max(size_bar)) {
        return Ok(None);
    }
    for (tree, which) in pair.trees.iter().zip([Which::Beam, Which::Bar]) {
        let root = tree.node(ROOT);
        if root.speed == 0.0 && root.turn == 0.0 {
            return Err(ProjectionError::ZeroTangent { which });
        }
    }
    let inside = search::inside(&mut pair, options)?;
    let rim = ends::rim(&mut pair, options)?;
    let statistics = Statistics {
        boxes: inside.boxes,
        intervals: rim.intervals,
        evaluations: pair.trees.iter().map(Tree::evaluations).sum(),
    };
    let found = assemble(&mut pair, inside, rim, statistics, options.boxes)?;
    Ok(Some(fault::result(found)))
}

/// Collects all results, each point once.
fn assemble(
    pair: &mut Pair,
    mut inside: Inside,
    rim: Rim,
    statistics: Statistics,
    boxes: usize,
) -> Result<ClosestPoints, ProjectionError> {
    let mut unresolved = Vec::new();
    let mut points: Vec<ClosestPoint> = Vec::new();
    let mut open = Vec::with_capacity(inside.open.len());
    for region in inside.open {
        if !region.is_corner(pair)? {
            open.push(region);
        }
    }
    // The open region of an edge may extend beyond the region inside that touches it.
    let beyond = |region: &&Region| open.iter().any(|known| known.touches(region) && !known.covers(region));
    let beyond: Vec<Region> = rim.open.iter().filter(beyond).copied().collect();
    inside.open = if beyond.is_empty() { open } else { gather([open, beyond].concat()) };
    for zero in inside.zeros {
        let zero = ends::at_end(pair, &zero).unwrap_or(zero);
        if !zero.leads_inward() {
            add(&mut points, zero);
        }
    }
    for region in &inside.open {
        unresolved.push(region.unresolved(pair, boxes)?);
    }
    for region in &rim.open {
        // An open region inside that touches an edge already covers the open region of the edge.
        if !inside.open.iter().any(|known| known.touches(region)) {
            unresolved.push(region.unresolved(pair, boxes)?);
        }
    }
    for point in rim.minima {
        // Where a continuum of points meets an edge, the edge has a weak minimum, which is not a separate point.
        let part = inside.open.iter().any(|region| region.contains(point.xi, point.xi_bar));
        if point.is_strict() || !part {
            add(&mut points, ends::at_end(pair, &point).unwrap_or(point));
        }
    }
    points.retain(|point| pair.band.contains((point.xi, point.xi_bar)));
    points.sort_by(|p, q| p.distance.total_cmp(&q.distance));
    let (minima, stationary) = points.into_iter().partition(|point| point.kind == Kind::Minimum);
    Ok(ClosestPoints { minima, stationary, unresolved, statistics })
}

/// Adds a point unless it is known, also from the other side of an end. Of equal points a minimum is kept.
fn add(points: &mut Vec<ClosestPoint>, point: ClosestPoint) {
    match points.iter_mut().find(|known| known.is_same(&point)) {
        Some(known) if known.kind != Kind::Minimum => *known = point,
        Some(_) => {}
        None => points.push(point),
    }
}

#[cfg(test)]
mod tests;
