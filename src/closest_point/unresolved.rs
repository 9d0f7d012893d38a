//! Boxes that the search leaves open, gathered into regions.

use super::search::Pair;
use super::tree::{Node, evaluate};
use super::{ClosestPoint, Held, ProjectionError, SquaredDistance, Unresolved};

/// The number of steps towards the representative of a region. A few reach a continuum, by quadratic convergence.
const STEPS: usize = 12;

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

    /// Whether a pair of parameters lies in the region.
    pub(super) fn contains(&self, xi: f64, xi_bar: f64) -> bool {
        self.extent.iter().zip([xi, xi_bar]).all(|(mine, at)| mine[0] <= at && at <= mine[1])
    }

    /// A point of the region near the smallest distance, where the gradient vanishes up to rounding.
    pub(super) fn point(&self, pair: &Pair) -> Result<ClosestPoint, ProjectionError> {
        let thin = self.extent.map(|[low, high]| low >= high);
        let held = Held { xi: thin[0], xi_bar: thin[1] };
        let (mut xi, mut xi_bar) = self.nearest;
        for _ in 0..STEPS {
            let (x, x_bar) = (evaluate(pair.curves[0], xi)?, evaluate(pair.curves[1], xi_bar)?);
            let (step, step_bar) = SquaredDistance::new(&x, &x_bar).valley_step(held);
            xi = (xi + step).clamp(self.extent[0][0], self.extent[0][1]);
            xi_bar = (xi_bar + step_bar).clamp(self.extent[1][0], self.extent[1][1]);
        }
        let (x, x_bar) = (evaluate(pair.curves[0], xi)?, evaluate(pair.curves[1], xi_bar)?);
        let p = SquaredDistance::new(&x, &x_bar);
        Ok(ClosestPoint::new((xi, xi_bar), &p, held))
    }

    pub(super) fn unresolved(&self, point: ClosestPoint) -> Unresolved {
        Unresolved { xi: self.extent[0], xi_bar: self.extent[1], boxes: self.boxes, point }
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
