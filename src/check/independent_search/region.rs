//! The smallest distance in a part of the square, from below by branch and bound and from above by descent.

use super::IndependentSearch;
use super::enclosure::{Enclosure, Sign};
use super::piece::{Piece, WHOLE};
use super::straight;
use crate::number::DoubleDouble;
use std::collections::BinaryHeap;

/// The largest number of boxes.
const BOXES: usize = 800;
/// The largest number of steps of a descent.
const STEPS: usize = 50;
/// The number of descents.
const DESCENTS: usize = 4;

/// A point that a descent reached.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    pub(super) at: [f64; 2],
    pub(super) distance: f64,
    /// Whether the gradient vanishes there up to rounding and F is convex, in the parameters that are not held.
    pub(super) is_clear: bool,
}

/// Bounds of the smallest distance, and the point that has the upper one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Smallest {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) at: [f64; 2],
}

/// A box in the order of its lower bound, the smallest first.
#[derive(Clone, Copy, PartialEq)]
struct Bounded {
    least: f64,
    at: [u32; 2],
}

impl Eq for Bounded {}

impl PartialOrd for Bounded {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Bounded {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.least.total_cmp(&self.least).then(self.at.cmp(&other.at))
    }
}

impl IndependentSearch<'_> {
    /// The enclosure at one point.
    pub(super) fn at(&self, at: [f64; 2]) -> Enclosure {
        Enclosure::new(&self.curves[0].at(at[0]), &self.curves[1].at(at[1]))
    }

    /// Leads down from a point, within these parameters.
    pub(super) fn descend(&self, mut at: [f64; 2], within: [[f64; 2]; 2]) -> Reached {
        let clamped = |at: [f64; 2]| [0, 1].map(|i| at[i].clamp(within[i][0], within[i][1]));
        at = clamped(at);
        let mut here = self.at(at);
        for _ in 0..STEPS {
            let moves = here.moves(at, within);
            let steps = [here.descent_step(moves), here.slope_step(moves, self.sizes(at))];
            let mut is_moved = false;
            for step in steps {
                let mut part = 1.0;
                while part > 1e-3 && !is_moved {
                    let next = clamped([0, 1].map(|i| at[i] + part * step[i]));
                    let there = self.at(next);
                    if there.distance() < here.distance() {
                        (at, here, is_moved) = (next, there, true);
                    }
                    part *= 0.125;
                }
                if is_moved {
                    break;
                }
            }
            if !is_moved {
                break;
            }
        }
        let moves = here.moves(at, within);
        let is_settled = |i: usize| {
            if moves[i] { here.gradient[i].abs() <= here.rest[i] } else { here.sign(i) != Sign::Unknown }
        };
        let is_clear = here.is_convex(moves) && (0..2).all(is_settled);
        Reached { at, distance: here.distance(), is_clear }
    }

    /// ‖t‖² of both curves.
    fn sizes(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| self.curves[i].at(at[i]).size[0].powi(2))
    }

    /// The smallest distance within these parameters, in the scaled unit.
    pub(super) fn smallest(&mut self, within: [[f64; 2]; 2], start: [f64; 2]) -> Smallest {
        if self.is_straight
            && let Some(exact) = self.straight(within)
        {
            let distance = exact.distance * self.factor;
            return Smallest { low: distance, high: distance, at: exact.at };
        }
        let centre = within.map(|[low, high]| 0.5 * (low + high));
        let mut best = self.descend(start, within);
        let mut improve = |search: &Self, start: [f64; 2]| {
            let reached = search.descend(start, within);
            if reached.distance < best.distance {
                best = reached;
            }
            best.distance
        };
        let mut high = improve(self, centre);
        let mut heap = BinaryHeap::from([Bounded { least: 0.0, at: [WHOLE, WHOLE] }]);
        let mut low = 0.0;
        for count in 0..BOXES {
            let Some(Bounded { least, at }) = heap.pop() else { break };
            low = least;
            if least >= high {
                break;
            }
            let pieces = [0, 1].map(|i| self.curves[i].piece(at[i]));
            if count % (BOXES / DESCENTS) == 1 {
                high = improve(self, pieces.map(|piece| piece.centre));
            }
            let pieces = [0, 1].map(|i| self.curves[i].piece(at[i]));
            let length = |i: usize| pieces[i].half * (pieces[i].size[0] + pieces[i].half * pieces[i].size[1]);
            let side = usize::from(length(1) > length(0));
            for half in self.curves[side].halves(at[side]) {
                let mut part = at;
                part[side] = half;
                let pieces = [0, 1].map(|i| self.curves[i].piece(part[i]));
                let meets = |i: usize| meets(pieces[i], within[i]);
                let bound = Enclosure::new(pieces[0], pieces[1]).least_distance();
                if meets(0) && meets(1) && (bound < high || bound.is_nan()) {
                    heap.push(Bounded {
                        least: if bound.is_nan() { 0.0 } else { bound.max(least) },
                        at: part,
                    });
                }
            }
        }
        let low = if heap.is_empty() { high } else { low.min(high) };
        Smallest { low, high, at: best.at }
    }

    /// The exact smallest distance of two straight segments within these parameters.
    pub(super) fn straight(&self, within: [[f64; 2]; 2]) -> Option<straight::Straight> {
        let zero = [DoubleDouble::from(0.0); 2];
        let [line, line_bar] = self.beams.map(|beam| beam.moved(zero));
        straight::closest([&*line, &*line_bar], within)
    }
}

fn meets(piece: &Piece, [low, high]: [f64; 2]) -> bool {
    let [first, last] = piece.extent();
    first <= high && low <= last
}
