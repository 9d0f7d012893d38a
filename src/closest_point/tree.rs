//! The intervals of one curve, halved on demand, each with the curve at its centre and bounds over its width.

use super::{Centroid, ProjectionError, fault};
use crate::curve::Geometry;
use nalgebra::Vector3;

/// An interval of xi, with bounds of the distance of the curve from its Taylor polynomial about the centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) centre: f64,
    pub(super) half: f64,
    pub(super) geometry: Geometry<f64>,
    /// ‖t‖ and ‖t,xi‖ at the centre.
    pub(super) speed: f64,
    pub(super) bend: f64,
    /// Bounds of ‖x - x₀ - (xi - xi₀) t₀‖, ‖t - t₀‖, ‖t - t₀ - (xi - xi₀) t₀,xi‖ and ‖t,xi - t₀,xi‖.
    pub(super) sag: f64,
    pub(super) turn: f64,
    pub(super) twist: f64,
    pub(super) jerk: f64,
    /// The index of the first of the two halves; 0 if there are none.
    children: u32,
}

impl Node {
    /// A bound of the distance between a point of the interval and its centre.
    pub(super) fn reach(&self) -> f64 {
        self.half * self.speed + self.sag
    }
}

/// The intervals of a curve. The first is [-1, 1], the next two are its ends, with no width.
pub(super) struct Tree<'a> {
    curve: &'a dyn Centroid,
    bound: f64,
    nodes: Vec<Node>,
}

/// The whole of [-1, 1].
pub(super) const ROOT: u32 = 0;
/// The ends xi = -1 and xi = 1.
pub(super) const ENDS: [u32; 2] = [1, 2];

impl<'a> Tree<'a> {
    pub(super) fn new(curve: &'a dyn Centroid) -> Result<Self, ProjectionError> {
        let bound = fault::bound(curve.third_derivative_bound());
        if !(bound >= 0.0 && bound.is_finite()) {
            return Err(ProjectionError::NonFinite);
        }
        let mut tree = Self { curve, bound, nodes: Vec::with_capacity(64) };
        tree.push(0.0, 1.0)?;
        tree.push(-1.0, 0.0)?;
        tree.push(1.0, 0.0)?;
        Ok(tree)
    }

    pub(super) fn node(&self, index: u32) -> &Node {
        &self.nodes[index as usize]
    }

    /// The two halves of an interval.
    pub(super) fn halves(&mut self, index: u32) -> Result<[u32; 2], ProjectionError> {
        let Node { centre, half, children, .. } = *self.node(index);
        if children != 0 {
            return Ok([children, children + 1]);
        }
        let lower = self.push(centre - 0.5 * half, 0.5 * half)?;
        let upper = self.push(centre + 0.5 * half, 0.5 * half)?;
        self.nodes[index as usize].children = lower;
        Ok([lower, upper])
    }

    /// The size of the numbers of the curve.
    pub(super) fn size(&self) -> f64 {
        let Node { geometry, speed, bend, .. } = self.node(ROOT);
        geometry.x.amax().max(*speed).max(*bend).max(self.bound)
    }

    /// The number of points at which the curve was evaluated.
    pub(super) fn evaluations(&self) -> usize {
        self.nodes.len()
    }

    fn push(&mut self, centre: f64, half: f64) -> Result<u32, ProjectionError> {
        let node = self.node_over(centre, half)?;
        self.nodes.push(node);
        u32::try_from(self.nodes.len() - 1).map_err(|_| ProjectionError::NonFinite)
    }

    /// An interval that is not part of the tree.
    #[inline(always)]
    pub(super) fn node_over(&self, centre: f64, half: f64) -> Result<Node, ProjectionError> {
        let geometry = evaluate(self.curve, centre)?;
        let (speed, bend) = (geometry.t.norm(), geometry.t_xi.norm());
        let jerk = half * self.bound;
        let twist = 0.5 * half * jerk;
        Ok(Node {
            centre,
            half,
            geometry,
            speed,
            bend,
            sag: half * (0.5 * half * bend + twist / 3.0),
            turn: half * bend + twist,
            twist,
            jerk,
            children: 0,
        })
    }
}

/// The curve at `xi`, if it is finite there.
pub(super) fn evaluate(curve: &dyn Centroid, xi: f64) -> Result<Geometry<f64>, ProjectionError> {
    let geometry = curve.geometry(xi);
    let Geometry { x, t, t_xi, t_xixi } = &geometry;
    // The squares are tested, because all later computations use them.
    let sum: f64 = [x, t, t_xi, t_xixi].map(Vector3::norm_squared).iter().sum();
    if sum.is_finite() { Ok(geometry) } else { Err(ProjectionError::NonFinite) }
}

#[cfg(test)]
mod tests {
    use super::evaluate;
    use crate::closest_point::Centroid;
    use crate::curve::Geometry;

    struct Huge(Geometry<f64>);

    impl Centroid for Huge {
        fn geometry(&self, _: f64) -> Geometry<f64> {
            self.0
        }

        fn third_derivative_bound(&self) -> f64 {
            0.0
        }
    }

    #[test]
    fn finite_is_what_has_finite_squares() {
        let along = |x: f64| [x, 0.0, 0.0].into();
        let at = |[x, t, t_xi, t_xixi]: [f64; 4]| {
            let geometry = Geometry { x: along(x), t: along(t), t_xi: along(t_xi), t_xixi: along(t_xixi) };
            evaluate(&Huge(geometry), 0.0).is_ok()
        };
        let huge = [1e153, -0.9e153, 1e153, -1.1e153];
        assert!(at(huge));
        for i in 0..4 {
            for bad in [f64::NAN, f64::INFINITY, 1e155, -1e155] {
                let mut part = huge;
                part[i] = bad;
                assert!(!at(part), "{part:?}");
            }
        }
    }
}
