//! The search over the inside of the square: boxes are discarded, solved or halved, the widest first.

use super::bounds::{Bounds, INFLATION, NEXT_DOOR};
use super::tree::{Node, ROOT, Tree};
use super::unresolved::{Region, gather};
use super::{Centroid, ClosestPoint, Degeneracy, Held, ProjectionError, Search, fault, refine};

/// Below this Lipschitz constant Newton's method finds the zero of a box, if it has one. Below 1 it has at most one.
pub(super) const CERTAIN: f64 = 0.25;
/// Below 1, with a margin for the rounding of the Hessian's inverse.
pub(super) const UNIQUE: f64 = 0.75;

/// The maximum number of open boxes from which Newton's method starts.
const SAMPLES: usize = 64;

/// The results for the boxes of the square.
pub(super) struct Inside {
    pub(super) zeros: Vec<ClosestPoint>,
    pub(super) open: Vec<Region>,
    pub(super) boxes: usize,
}

/// The two curves, as the search uses them.
pub(super) struct Pair<'a> {
    pub(super) curves: [&'a dyn Centroid; 2],
    pub(super) trees: [Tree<'a>; 2],
    pub(super) band: Band,
}

/// The pairs of parameters that are searched: |xi - xi_bar| >= width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Band {
    pub(super) width: f64,
}

impl Band {
    /// Whether the pair is searched.
    pub(super) fn contains(self, (xi, xi_bar): (f64, f64)) -> bool {
        (xi - xi_bar).abs() >= self.width
    }

    /// Whether no pair of the box is searched.
    pub(super) fn excludes(self, [x, y]: [&Node; 2]) -> bool {
        (x.centre - y.centre).abs() + x.half + y.half < self.width
    }
}

impl Pair<'_> {
    pub(super) fn nodes(&self, at: [u32; 2]) -> [&Node; 2] {
        [self.trees[0].node(at[0]), self.trees[1].node(at[1])]
    }

    pub(super) fn refine(&self, start: (f64, f64), held: Held) -> Result<ClosestPoint, ProjectionError> {
        refine(self.curves[0], self.curves[1], start, held)
    }
}

/// Finds the zeros of the gradient in the square.
///
/// A box is discarded if the gradient provably has no zero in it. If it provably has at most one, Newton's method
/// decides. Either it converges to the zero, or there is none, because the first map contracts so strongly that the
/// method would have converged to it. All other boxes are halved, up to the limits of `search`.
pub(super) fn inside(pair: &mut Pair, search: &Search) -> Result<Inside, ProjectionError> {
    let mut zeros: Vec<ClosestPoint> = Vec::new();
    let mut queue = vec![[ROOT, ROOT]];
    let mut open = Vec::new();
    let mut next = 0;
    while next < queue.len() && next < search.boxes {
        let at = queue[next];
        next += 1;
        let [x, y] = pair.nodes(at);
        if pair.band.excludes([x, y]) {
            continue;
        }
        let bounds = Bounds::new(x, y);
        if bounds.excludes_zero() {
            continue;
        }
        if bounds.is_flat() {
            open.push(Region::new([x, y], bounds.squared_distance.distance));
            continue;
        }
        let contraction = fault::contraction(bounds.contraction());
        if contraction < UNIQUE {
            let within = |point: &ClosestPoint, factor: f64| {
                (point.xi - x.centre).abs() <= factor * x.half
                    && (point.xi_bar - y.centre).abs() <= factor * y.half
            };
            if zeros.iter().any(|zero| within(zero, INFLATION)) {
                continue;
            }
            match pair.refine(fault::start((x.centre, y.centre)), Held::default()) {
                Err(ProjectionError::NonFinite) => return Err(ProjectionError::NonFinite),
                Ok(zero) if within(&zero, INFLATION) => {
                    if !zeros.iter().any(|known| within(known, NEXT_DOOR)) {
                        zeros.push(zero);
                    }
                    continue;
                }
                _ if contraction <= CERTAIN => continue,
                _ => {}
            }
        }
        let side = usize::from(y.reach() > x.reach());
        let halves = [x.half, y.half];
        match [side, 1 - side].into_iter().find(|&side| halves[side] > search.resolution) {
            Some(side) => {
                for half in pair.trees[side].halves(at[side])? {
                    let mut part = at;
                    part[side] = half;
                    queue.push(part);
                }
            }
            None => open.push(Region::new([x, y], bounds.squared_distance.distance)),
        }
    }
    for &at in &queue[next..] {
        let nodes = pair.nodes(at);
        let bounds = Bounds::new(nodes[0], nodes[1]);
        if !bounds.excludes_zero() && !pair.band.excludes(nodes) {
            open.push(Region::new(nodes, bounds.squared_distance.distance));
        }
    }
    sample(pair, &open, &mut zeros);
    Ok(Inside { zeros, open: gather(open), boxes: next })
}

/// Adds the regular zeros that Newton's method finds from some of the open boxes.
fn sample(pair: &Pair, open: &[Region], zeros: &mut Vec<ClosestPoint>) {
    for region in open.iter().step_by(open.len() / SAMPLES + 1) {
        if let Ok(zero) = pair.refine(region.nearest, Held::default())
            && zero.degeneracy().is_none_or(|degeneracy| !matches!(degeneracy, Degeneracy::Singular { .. }))
            && !zeros.iter().any(|known| known.is_same(&zero))
        {
            zeros.push(zero);
        }
    }
}
