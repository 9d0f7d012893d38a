//! Boxes that the search leaves open, gathered into regions.

use super::bounds::Bounds;
use super::nearest::{Nearest, nearest};
use super::search::Pair;
use super::tree::{Node, evaluate};
use super::{ClosestPoint, Continuum, Held, ProjectionError, SquaredDistance, Unresolved};
use crate::curve::Geometry;

/// The number of steps towards a point of a continuum. A few reach it, by quadratic convergence.
const STEPS: usize = 12;
/// Scaled eigenvalues below this may belong to a continuum.
const FLAT: f64 = 1e-6;
/// Distances may differ by this, in units of the rounding of the positions, along a continuum.
const EQUAL: f64 = 4.0;

/// A box, or the hull of touching boxes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    /// The smallest and the largest xi, xi_bar.
    pub(super) extent: [[f64; 2]; 2],
    pub(super) boxes: usize,
    /// The centre of the box that is nearest to contact, and the distance there.
    pub(super) nearest: (f64, f64),
    pub(super) distance: f64,
}

impl Region {
    pub(super) fn new([x, y]: [&Node; 2], distance: f64) -> Self {
        Self {
            extent: [x, y].map(|node| [node.centre - node.half, node.centre + node.half]),
            boxes: 1,
            nearest: (x.centre, y.centre),
            distance,
        }
    }

    /// Whether the two regions have a point in common.
    pub(super) fn touches(&self, other: &Self) -> bool {
        self.extent.iter().zip(&other.extent).all(|(mine, other)| mine[0] <= other[1] && other[0] <= mine[1])
    }

    /// Whether the other region lies in this one.
    pub(super) fn covers(&self, other: &Self) -> bool {
        self.extent.iter().zip(&other.extent).all(|(mine, other)| mine[0] <= other[0] && other[1] <= mine[1])
    }

    /// Whether a pair of parameters lies in the region.
    pub(super) fn contains(&self, xi: f64, xi_bar: f64) -> bool {
        self.extent.iter().zip([xi, xi_bar]).all(|(mine, at)| mine[0] <= at && at <= mine[1])
    }

    /// The smallest distance in the region, a point where it is attained, and why the region is open.
    ///
    /// Of a continuum of nearest points, one in its middle is chosen.
    pub(super) fn unresolved(&self, pair: &mut Pair, boxes: usize) -> Result<Unresolved, ProjectionError> {
        let nearest = nearest(pair, self.extent, self.nearest, boxes)?;
        let at = self.middle(pair, &nearest)?.unwrap_or(nearest.at);
        let [x, x_bar] = geometry(pair, at)?;
        let point = ClosestPoint::new(at, &SquaredDistance::new(&x, &x_bar), self.held());
        let [low, high] = nearest.distance;
        Ok(Unresolved {
            xi: self.extent[0],
            xi_bar: self.extent[1],
            boxes: self.boxes,
            distance: [low, high.max(point.distance)],
            continuum: self.continuum(pair, &point)?,
            point,
        })
    }

    /// The kind of continuum, at its point that Newton's method finds from `point` across the continuum.
    fn continuum(&self, pair: &Pair, point: &ClosestPoint) -> Result<Continuum, ProjectionError> {
        let at = self.across(pair, (point.xi, point.xi_bar))?;
        let [x, x_bar] = geometry(pair, at)?;
        Ok(Continuum::at(
            &ClosestPoint::new(at, &SquaredDistance::new(&x, &x_bar), self.held()),
            [&x, &x_bar],
        ))
    }

    /// The end of some steps of Newton's method across the continuum, in the region.
    fn across(&self, pair: &Pair, mut at: (f64, f64)) -> Result<(f64, f64), ProjectionError> {
        for _ in 0..STEPS {
            let [x, x_bar] = geometry(pair, at)?;
            let step = SquaredDistance::new(&x, &x_bar).valley_step(self.held());
            at = self.place((at.0 + step.0, at.1 + step.1));
        }
        Ok(at)
    }

    /// The parameters, limited to the region.
    fn place(&self, (xi, xi_bar): (f64, f64)) -> (f64, f64) {
        let [[low, high], [low_bar, high_bar]] = self.extent;
        (xi.clamp(low, high), xi_bar.clamp(low_bar, high_bar))
    }

    /// The parameters without width are held.
    fn held(&self) -> Held {
        let [xi, xi_bar] = self.extent.map(|[low, high]| low >= high);
        Held { xi, xi_bar }
    }

    /// A point in the middle of the continuum through the nearest point, if there is one that is as near.
    fn middle(&self, pair: &Pair, nearest: &Nearest) -> Result<Option<(f64, f64)>, ProjectionError> {
        let [x, x_bar] = geometry(pair, nearest.at)?;
        let p = SquaredDistance::new(&x, &x_bar);
        let held = self.held();
        if held != Held::default() || p.smallest_magnitude(held).is_nan() || p.smallest_magnitude(held) > FLAT
        {
            return Ok(None);
        }
        let from = [nearest.at.0, nearest.at.1];
        let valley = p.valley();
        let direction = [valley[0] / x.t.norm(), valley[1] / x_bar.t.norm()];
        // The part of the line from + s direction in the region.
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..2 {
            let [one, other] = self.extent[i].map(|end| (end - from[i]) / direction[i]);
            low = low.max(one.min(other));
            high = high.min(one.max(other));
        }
        let mut part = 0.5 * (low + high);
        if !part.is_finite() {
            return Ok(None);
        }
        for _ in 0..STEPS {
            let aside = self.place((from[0] + part * direction[0], from[1] + part * direction[1]));
            let at = self.across(pair, aside)?;
            let [x, x_bar] = geometry(pair, at)?;
            let there = SquaredDistance::new(&x, &x_bar);
            if there.distance <= nearest.distance[1] + EQUAL * there.rounding() && pair.band.contains(at) {
                return Ok(Some(at));
            }
            part *= 0.5;
        }
        Ok(None)
    }

    /// Whether the region contains no stationary point except a corner of the square.
    ///
    /// It does not if the gradient, in the directions that lead from the corner into the square, is not negative at the
    /// corner and increases in the whole region. Two beams that meet end to end on one line are such a case.
    pub(super) fn is_corner(&self, pair: &Pair) -> Result<bool, ProjectionError> {
        let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]];
        let [x, y] = [0, 1].map(|i| {
            let [low, high] = self.extent[i];
            pair.trees[i].node_over(0.5 * (low + high), 0.5 * (high - low))
        });
        let bounds = Bounds::new(&x?, &y?);
        for [end, end_bar] in corners.into_iter().filter(|&[end, end_bar]| self.contains(end, end_bar)) {
            let [x, x_bar] = geometry(pair, (end, end_bar))?;
            let p = SquaredDistance::new(&x, &x_bar);
            let outward = |i: usize, end: f64| p.is_weak(i) || p.gradient[i] * end < 0.0;
            if outward(0, end) && outward(1, end_bar) && bounds.increases(end * end_bar) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn absorb(&mut self, other: &Self) {
        for (mine, other) in self.extent.iter_mut().zip(&other.extent) {
            *mine = [mine[0].min(other[0]), mine[1].max(other[1])];
        }
        self.boxes += other.boxes;
        if other.distance < self.distance {
            (self.nearest, self.distance) = (other.nearest, other.distance);
        }
    }
}

/// Both curves at a pair of parameters.
fn geometry(pair: &Pair, at: (f64, f64)) -> Result<[Geometry<f64>; 2], ProjectionError> {
    Ok([evaluate(pair.curves[0], at.0)?, evaluate(pair.curves[1], at.1)?])
}

/// Merges boxes that touch each other into their hulls, and hulls that touch each other too.
pub(super) fn gather(boxes: Vec<Region>) -> Vec<Region> {
    let mut regions: Vec<Region> = Vec::new();
    for mut region in boxes {
        while let Some(i) = regions.iter().position(|known| known.touches(&region)) {
            region.absorb(&regions.swap_remove(i));
        }
        regions.push(region);
    }
    regions
}

#[cfg(test)]
mod tests;
