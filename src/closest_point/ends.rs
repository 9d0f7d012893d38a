//! Minima with one or both parameters held at an end of a beam: the edges and the corners of the square.

use super::bounds::{Bounds, INFLATION, NEXT_DOOR};
use super::search::{CERTAIN, Pair, UNIQUE};
use super::tree::{ENDS, ROOT};
use super::unresolved::{Region, gather};
use super::{ClosestPoint, End, Held, Kind, ProjectionError, Search, SquaredDistance, fault};

/// The results for the edges and corners.
#[derive(Default)]
pub(super) struct Rim {
    pub(super) minima: Vec<ClosestPoint>,
    pub(super) open: Vec<Region>,
    pub(super) intervals: usize,
}

/// Finds the minima on the edges and in the corners of the square.
pub(super) fn rim(pair: &mut Pair, search: &Search) -> Result<Rim, ProjectionError> {
    let mut rim = Rim::default();
    for free in [1, 0] {
        for end in ENDS {
            if !fault::skips_edge(free, end) {
                edge(pair, search, free, end, &mut rim)?;
            }
        }
    }
    let both = Held { xi: true, xi_bar: true };
    for end in ENDS.into_iter().filter(|_| !fault::skips_corners()) {
        for end_bar in ENDS {
            let [x, y] = pair.nodes([end, end_bar]);
            let at = (x.centre, y.centre);
            let p = SquaredDistance::new(&x.geometry, &y.geometry);
            rim.accept(ClosestPoint::new(at, &p, both));
        }
    }
    rim.open = gather(std::mem::take(&mut rim.open));
    Ok(rim)
}

/// The search of the square, along parameter `free` alone, with the other one held at `end`.
fn edge(
    pair: &mut Pair,
    search: &Search,
    free: usize,
    end: u32,
    rim: &mut Rim,
) -> Result<(), ProjectionError> {
    let held = Held { xi: free == 1, xi_bar: free == 0 };
    let mut zeros: Vec<f64> = Vec::new();
    let mut queue = vec![ROOT];
    let mut next = 0;
    while next < queue.len() {
        let index = queue[next];
        next += 1;
        let at = if free == 0 { [index, end] } else { [end, index] };
        let nodes = pair.nodes(at);
        let interval = nodes[free];
        if pair.band.excludes(nodes) {
            continue;
        }
        let bounds = Bounds::new(nodes[0], nodes[1]);
        let across = 1 - free;
        // No minimum: the gradient along the edge keeps its sign, or that across it points inward, or F is concave.
        if bounds.keeps_sign(free)
            || (bounds.keeps_sign(across)
                && bounds.squared_distance.gradient[across] * nodes[across].centre > 0.0
                && !bounds.squared_distance.is_weak(across))
            || bounds.is_concave_along(free)
        {
            continue;
        }
        let contraction = fault::contraction(bounds.contraction_along(free));
        if contraction < UNIQUE {
            let within = |xi: f64, factor: f64| (xi - interval.centre).abs() <= factor * interval.half;
            if zeros.iter().any(|&zero| within(zero, INFLATION)) {
                continue;
            }
            let parameter = |point: &ClosestPoint| if free == 0 { point.xi } else { point.xi_bar };
            match pair.refine((nodes[0].centre, nodes[1].centre), held) {
                Err(ProjectionError::NonFinite) => return Err(ProjectionError::NonFinite),
                Ok(point) if within(parameter(&point), INFLATION) => {
                    if !zeros.iter().any(|&zero| within(zero, NEXT_DOOR)) {
                        zeros.push(parameter(&point));
                        rim.accept(point);
                    }
                    continue;
                }
                _ if contraction <= CERTAIN => continue,
                _ => {}
            }
        }
        let hopeless = bounds.is_flat_along(free) || interval.half <= search.resolution;
        if hopeless || next > search.boxes / 8 {
            rim.open.push(Region::new(nodes, bounds.squared_distance.distance));
        } else {
            queue.extend(pair.trees[free].halves(index)?);
        }
    }
    rim.intervals += next;
    Ok(())
}

impl Rim {
    /// Takes a point that is stationary along its edge if the gradient across points outward.
    ///
    /// If it points inward, however slightly, the zero is inside the square and is found there.
    fn accept(&mut self, point: ClosestPoint) {
        let point = fault::of_edge(point);
        let outward = [point.end, point.end_bar].into_iter().flatten().all(|end| end.multiplier >= 0.0);
        if outward && point.kind == Kind::Minimum {
            self.minima.push(point);
        }
    }
}

/// The point with more parameters held that equals a stationary point up to rounding, if there is one.
pub(super) fn at_end(pair: &Pair, zero: &ClosestPoint) -> Option<ClosestPoint> {
    const NEAR: f64 = 1e-7;
    let now = zero.held();
    let [error, error_bar] = zero.uncertainty;
    let near = Held {
        xi: zero.xi.abs() > 1.0 - NEAR.max(error),
        xi_bar: zero.xi_bar.abs() > 1.0 - NEAR.max(error_bar),
    };
    let candidates = [near, Held { xi_bar: now.xi_bar, ..near }, Held { xi: now.xi, ..near }];
    candidates.into_iter().filter(|&held| held != now).find_map(|held| {
        let point = pair.refine((zero.xi, zero.xi_bar), held).ok()?;
        let close = (point.xi - zero.xi).abs() < (10.0 * NEAR).max(error)
            && (point.xi_bar - zero.xi_bar).abs() < (10.0 * NEAR).max(error_bar);
        let strict = |end: Option<End>| end.is_some_and(|end| end.strict);
        // At an end with a tangent of no length the gradient vanishes, although the end is strictly held.
        let weak = (now.xi || !strict(point.end) || zero.xi.abs() >= 1.0)
            && (now.xi_bar || !strict(point.end_bar) || zero.xi_bar.abs() >= 1.0);
        (close && weak).then_some(point)
    })
}
