//! The smallest distance over a rectangle of parameters, by descent from above and by branch and bound from below.

use super::bounds::Bounds;
use super::search::Pair;
use super::tree::{ENDS, ROOT, evaluate};
use super::{ProjectionError, SquaredDistance};
use nalgebra::Vector3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The maximum number of steps of a descent. Each step is a Newton step or reduces the radius of trust.
const STEPS: usize = 100;
/// The interval of the smallest distance may have this width, in units of the rounding of the positions.
const WIDTH: f64 = 256.0;
/// A box of this half-width, in the parameters, is not divided.
const NARROW: f64 = 1e-12;

/// The smallest distance over a rectangle.
pub(super) struct Nearest {
    /// Parameters in the rectangle at which the distance is the upper end of the interval.
    pub(super) at: (f64, f64),
    /// An interval that contains the smallest distance.
    pub(super) distance: [f64; 2],
}

/// Finds the smallest distance over `extent`, by at most `boxes` boxes. The search starts at `start`.
///
/// # Derivation
/// F = d²/2 differs from its Taylor polynomial of second degree at the centre of a box by the integral of the
/// gradient's remainder along a ray. The remainder grows at least quadratically, so the integral is at most a third of
/// it at the end of the ray. Between straight curves the plane normal to the shortest d bounds d without cancellation.
pub(super) fn nearest(
    pair: &mut Pair,
    extent: [[f64; 2]; 2],
    start: (f64, f64),
    boxes: usize,
) -> Result<Nearest, ProjectionError> {
    let band = pair.band;
    let mut best = Descent::from(pair, start, extent)?;
    let root = [0, 1].map(|i| match extent[i] {
        [low, high] if low < high => ROOT,
        [low, _] => ENDS[usize::from(low > 0.0)],
    });
    let mut queue = BinaryHeap::from([Reverse((0, root))]);
    let mut low = f64::INFINITY;
    let mut count = 0;
    while let Some(Reverse((bits, at))) = queue.pop() {
        let bound = f64::from_bits(bits);
        if count >= boxes || bound >= best.distance() - WIDTH * best.p.rounding() {
            low = low.min(bound);
            break;
        }
        let nodes = pair.nodes(at);
        let side = usize::from(nodes[1].reach() > nodes[0].reach());
        let halves = nodes.map(|node| node.half);
        let Some(side) = [side, 1 - side].into_iter().find(|&side| halves[side] > NARROW) else {
            low = low.min(bound);
            continue;
        };
        for half in pair.trees[side].halves(at[side])? {
            count += 1;
            let mut part = at;
            part[side] = half;
            let nodes = pair.nodes(part);
            // The part of the box in the rectangle, relative to the centre of the box.
            let within = [0, 1].map(|i| {
                let (centre, half) = (nodes[i].centre, nodes[i].half);
                extent[i].map(|end| (end - centre).clamp(-half, half))
            });
            let outside = |i: usize| {
                let (centre, half) = (nodes[i].centre, nodes[i].half);
                centre + half < extent[i][0] || extent[i][1] < centre - half
            };
            if outside(0) || outside(1) || band.excludes(nodes) {
                continue;
            }
            let bounds = Bounds::new(nodes[0], nodes[1]);
            let (offset, least) = bounds.least();
            if least < best.p.distance {
                let inside = |i: usize| (nodes[i].centre + offset[i]).clamp(extent[i][0], extent[i][1]);
                let found = Descent::from(pair, (inside(0), inside(1)), extent)?;
                if found.distance() < best.distance() && band.contains(found.at) {
                    best = found;
                }
            }
            let least = bounds.smallest_distance(pair.nodes(part), within, &best.p.d);
            queue.push(Reverse((least.max(bound).to_bits(), part)));
        }
    }
    let distance = best.distance();
    Ok(Nearest { at: best.at, distance: [low.min(distance), distance] })
}

/// A pair of parameters from which the distance decreases in no direction of the rectangle.
struct Descent {
    at: (f64, f64),
    p: SquaredDistance,
}

impl Descent {
    /// Descends by minimizing the Taylor polynomial of second degree of F over the rectangle and a radius of trust.
    fn from(pair: &Pair, start: (f64, f64), extent: [[f64; 2]; 2]) -> Result<Self, ProjectionError> {
        let at = |at: (f64, f64)| -> Result<Self, ProjectionError> {
            let (x, x_bar) = (evaluate(pair.curves[0], at.0)?, evaluate(pair.curves[1], at.1)?);
            Ok(Self { at, p: SquaredDistance::new(&x, &x_bar) })
        };
        let mut current = at(start)?;
        let mut radius = 2.0;
        for _ in 0..STEPS {
            let now = [current.at.0, current.at.1];
            let low = [0, 1].map(|i| (extent[i][0] - now[i]).max(-radius));
            let high = [0, 1].map(|i| (extent[i][1] - now[i]).min(radius));
            let (step, change) = current.p.least_in(low, high);
            if change >= 0.0 || radius < 1e-16 {
                break;
            }
            let inside = |i: usize| (now[i] + step[i]).clamp(extent[i][0], extent[i][1]);
            let next = at((inside(0), inside(1)))?;
            if next.p.distance < current.p.distance {
                radius *= 2.0;
                current = next;
            } else {
                radius = 0.125 * radius.min(step[0].abs().max(step[1].abs()));
            }
        }
        Ok(current)
    }

    fn distance(&self) -> f64 {
        self.p.distance
    }
}

impl Bounds {
    /// The minimum of the Taylor polynomial of second degree in the box, and the distance according to it.
    fn least(&self) -> ([f64; 2], f64) {
        let p = &self.squared_distance;
        let (offset, change) = p.least_in(self.half.map(|half| -half), self.half);
        (offset, (p.distance * p.distance + 2.0 * change).max(0.0).sqrt())
    }

    /// A lower bound of the distance in the part `within` the box. `normal` is a vector along the shortest d.
    fn smallest_distance(
        &self,
        [x, y]: [&super::tree::Node; 2],
        within: [[f64; 2]; 2],
        normal: &Vector3<f64>,
    ) -> f64 {
        let p = &self.squared_distance;
        let [h, k] = self.half;
        let (_, change) = p.least_in(within.map(|[low, _]| low), within.map(|[_, high]| high));
        let remainder = (self.remainder[0] * h + self.remainder[1] * k) * (1.0 + 1.0 / 16.0) / 3.0;
        let size = p.distance + (x.speed + x.bend * h) * h + (y.speed + y.bend * k) * k + x.sag + y.sag;
        let square = p.distance * p.distance + 2.0 * (change - remainder) - 4.0 * p.rounding() * size;
        let by_square = square.max(0.0).sqrt();
        let by_plane = |normal: Vector3<f64>| {
            let length = normal.norm();
            if length == 0.0 {
                return 0.0;
            }
            let along = |v: &Vector3<f64>| normal.dot(v) / length;
            let least = |slope: f64, [low, high]: [f64; 2]| (slope * low).min(slope * high);
            along(&p.d) + least(along(&x.geometry.t), within[0]) + least(-along(&y.geometry.t), within[1])
                - (x.sag + y.sag) * (1.0 + 1.0 / 16.0)
                - 2.0 * p.rounding()
        };
        // A short d has few digits and is not normal to parallel tangents, but for what is normal to them of it.
        let t = x.geometry.t;
        let square = t.norm_squared();
        let across = if square > 0.0 { normal - t * (normal.dot(&t) / square) } else { Vector3::zeros() };
        by_square.max(by_plane(*normal)).max(by_plane(across))
    }
}

impl SquaredDistance {
    /// The offset from `low` to `high` at which the Taylor polynomial of second degree of F is least, and its change.
    pub(super) fn least_in(&self, low: [f64; 2], high: [f64; 2]) -> ([f64; 2], f64) {
        let [g, g_bar] = self.gradient;
        let (a, b, c) = (self.a, -self.b, -self.a_bar);
        let change = |[u, v]: [f64; 2]| (g + 0.5 * a * u + b * v) * u + (g_bar + 0.5 * c * v) * v;
        let mut best = ([0.0; 2], 0.0);
        let mut consider = |at: [f64; 2]| {
            let at = [0, 1].map(|i| at[i].clamp(low[i], high[i]));
            if change(at) < best.1 {
                best = (at, change(at));
            }
        };
        // On an edge the polynomial is least at its zero slope or at a corner.
        let at_u = |u: f64| [u, if c > 0.0 { -(g_bar + b * u) / c } else { low[1] }];
        let at_v = |v: f64| [if a > 0.0 { -(g + b * v) / a } else { low[0] }, v];
        let [left, right] = [[low[0], high[1]], [high[0], low[1]]];
        for at in [low, at_u(low[0]), at_v(low[1]), left, at_v(high[1]), right, at_u(high[0]), high] {
            consider(at);
        }
        let (u, v) = self.step(super::Held::default());
        let inside = |u: f64, i: usize| low[i] <= u && u <= high[i];
        if a > 0.0 && self.det > 0.0 && inside(u, 0) && inside(v, 1) {
            consider([u, v]);
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::super::Centroid;
    use super::super::tree::{ROOT, Tree};
    use super::{Bounds, evaluate};
    use crate::curve::Geometry;
    use nalgebra::Vector3;

    /// x₀ + xi t + xi²/2 t,xi.
    struct Parabola([Vector3<f64>; 3]);

    impl Centroid for Parabola {
        fn geometry(&self, xi: f64) -> Geometry<f64> {
            let [x, t, t_xi] = self.0;
            Geometry { x: x + (t + t_xi * (0.5 * xi)) * xi, t: t + t_xi * xi, t_xi, t_xixi: Vector3::zeros() }
        }

        fn third_derivative_bound(&self) -> f64 {
            0.0
        }
    }

    /// Straight and bent curves, some of them parallel, with any vector as the normal.
    #[test]
    fn no_distance_is_below_its_bound() {
        let mut state = 1_u32;
        let mut number = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1 << 23) - 1.0
        };
        let mut near = 0;
        for k in 0..400 {
            let mut vector = || Vector3::from_fn(|_, _| number());
            let bend = [0.0, 1e-3, 0.5][k % 3];
            let (x, t) = (vector(), vector());
            let t_bar = if k % 2 == 0 { t * 1.5 } else { vector() };
            let curves = [[x, t, vector() * bend], [vector(), t_bar, vector() * bend]].map(Parabola);
            let normal = vector();
            let [mut tree, mut tree_bar] = curves.each_ref().map(|curve| Tree::new(curve).unwrap());
            let (half, half_bar) = (tree.halves(ROOT).unwrap()[0], tree_bar.halves(ROOT).unwrap()[1]);
            let nodes = [tree.node(half), tree_bar.node(half_bar)];
            let within = nodes.map(|node| [-node.half, node.half]);
            let at = |i: usize, step: i32| {
                let xi = nodes[i].centre + nodes[i].half * f64::from(step) / 20.0;
                evaluate(&curves[i], xi).unwrap().x
            };
            let steps = (-20..=20).flat_map(|i| (-20..=20).map(move |j| (i, j)));
            let least = steps.map(|(i, j)| (at(0, i) - at(1, j)).norm()).fold(f64::INFINITY, f64::min);
            for normal in [normal, nodes[0].geometry.x - nodes[1].geometry.x] {
                let bound = Bounds::new(nodes[0], nodes[1]).smallest_distance(nodes, within, &normal);
                assert!(bound <= least, "{k}: {bound} > {least}");
                near += usize::from(bound > 0.8 * least);
            }
        }
        assert!(near > 100, "{near}");
    }
}
