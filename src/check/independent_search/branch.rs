//! Branch and bound over the square of both parameters: every local minimum of the distance, with certainty.
//!
//! A box is a pair of pieces. At a local minimum no component of the gradient leads down into the square. So if a component
//! is positive in a whole box, a minimum in it has this parameter at the lower end: the box shrinks to that end, or is
//! discarded. If F has no minimum inside a box, because the gradient vanishes nowhere or a second derivative or the
//! determinant of the Hessian is negative, the box shrinks to the ends that it touches. If F is convex in a box, the box has
//! at most one minimum, which Newton's method finds. All other boxes are halved.

use super::enclosure::{Enclosure, Sign};
use super::piece::{LOWER, Piece, Pieces, UPPER, WHOLE};
use std::collections::{BTreeSet, VecDeque};

/// The largest number of boxes.
const BOXES: usize = 6000;
/// The half-width below which a piece is not halved.
const FINEST: f64 = 1.0 / (1 << 20) as f64;
/// The largest number of steps of Newton's method.
const STEPS: usize = 30;

/// A local minimum in a box in which F is convex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minimum {
    pub(super) at: [f64; 2],
    /// Bounds on the errors of the parameters.
    pub(super) error: [f64; 2],
    /// The distance, and the bound on its rounding.
    pub(super) distance: [f64; 2],
    /// Whether a parameter is at an end at which the gradient vanishes up to rounding, or the library takes it for zero.
    pub(super) is_weak: bool,
    /// The smallest and the largest parameters of the box.
    pub(super) within: [[f64; 2]; 2],
}

impl Minimum {
    /// Whether a stationary point at these parameters is this one: F has only one in the box.
    pub(super) fn is_at(&self, at: [f64; 2]) -> bool {
        (0..2).all(|i| {
            let [low, high] = self.within[i];
            let off = 1e-9 + self.error[i];
            (low - off <= at[i] && at[i] <= high + off) || (at[i] - self.at[i]).abs() <= off
        })
    }
}

/// A box in which the number of minima is not known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open {
    pub(super) within: [[f64; 2]; 2],
    /// A lower bound of the distance in it.
    pub(super) least: f64,
}

/// The results.
#[derive(Debug, Default)]
pub(super) struct Survey {
    pub(super) minima: Vec<Minimum>,
    pub(super) open: Vec<Open>,
    pub(super) boxes: usize,
}

/// What Newton's method finds in a box in which F is convex.
enum Settled {
    Minimum(Minimum),
    Elsewhere,
    NotConverged,
}

fn is_end(index: u32) -> bool {
    index == LOWER || index == UPPER
}

fn end_of(index: u32) -> f64 {
    if index == LOWER { -1.0 } else { 1.0 }
}

/// All local minima.
pub(super) fn survey(curves: &mut [Pieces; 2]) -> Survey {
    let mut survey = Survey::default();
    let mut queue = VecDeque::from([[WHOLE, WHOLE]]);
    let mut known = BTreeSet::new();
    while let Some(at) = queue.pop_front() {
        // An edge or a corner is reached from several boxes.
        if at.into_iter().any(is_end) && !known.insert(at) {
            continue;
        }
        let pieces = [0, 1].map(|i| curves[i].piece(at[i]));
        let enclosure = Enclosure::new(pieces[0], pieces[1]);
        survey.boxes += 1;
        if survey.boxes > BOXES {
            survey.open.push(Open::new(pieces, &enclosure));
            continue;
        }
        let free = at.map(|index| !is_end(index));
        let signs = [0, 1].map(|i| enclosure.sign(i));
        let leads_in = |i: usize| match signs[i] {
            Sign::Positive => at[i] == UPPER,
            Sign::Negative => at[i] == LOWER,
            Sign::Unknown => false,
        };
        if (0..2).any(leads_in) {
            continue;
        }
        if let Some(i) = (0..2).find(|&i| free[i] && signs[i] != Sign::Unknown) {
            let end = if signs[i] == Sign::Positive { LOWER } else { UPPER };
            queue.extend(at_end(at, pieces, i, end));
            continue;
        }
        let curvatures = [0, 1].map(|i| enclosure.curvature(i));
        let is_concave = (0..2).any(|i| free[i] && curvatures[i] == Sign::Negative);
        let is_convex = (0..2).all(|i| !free[i] || curvatures[i] == Sign::Positive);
        let both = free == [true; 2];
        let determinant = if both && is_convex { enclosure.determinant() } else { Sign::Unknown };
        if is_concave || determinant == Sign::Negative || (both && enclosure.excludes_stationary_points()) {
            for i in (0..2).filter(|&i| free[i]) {
                queue.extend([LOWER, UPPER].into_iter().filter_map(|end| at_end(at, pieces, i, end)));
            }
            continue;
        }
        if is_convex && (!both || determinant == Sign::Positive) {
            match settled(curves, pieces, free) {
                Settled::Minimum(minimum) => {
                    survey.add(minimum);
                    continue;
                }
                Settled::Elsewhere => continue,
                Settled::NotConverged => {}
            }
        }
        let length = |i: usize| pieces[i].half * (pieces[i].size[0] + pieces[i].half * pieces[i].size[1]);
        let wider = usize::from(length(1) > length(0));
        let side = [wider, 1 - wider].into_iter().find(|&i| free[i] && pieces[i].half > FINEST);
        let Some(side) = side else {
            survey.open.push(Open::new(pieces, &enclosure));
            continue;
        };
        for half in curves[side].halves(at[side]) {
            let mut part = at;
            part[side] = half;
            queue.push_back(part);
        }
    }
    survey
}

/// The part of a box at an end of parameter `i`, if the box touches it.
fn at_end(mut at: [u32; 2], pieces: [&Piece; 2], i: usize, end: u32) -> Option<[u32; 2]> {
    at[i] = end;
    pieces[i].touches(end_of(end)).then_some(at)
}

/// The minimum of F in a box in which it is convex, if it is a minimum in the square too.
fn settled(curves: &[Pieces; 2], pieces: [&Piece; 2], free: [bool; 2]) -> Settled {
    let within = pieces.map(Piece::extent);
    let mut at = pieces.map(|piece| piece.centre);
    for _ in 0..STEPS {
        let there = [0, 1].map(|i| curves[i].at(at[i]));
        let enclosure = Enclosure::new(&there[0], &there[1]);
        // A parameter at a side of the box is held there if F decreases outward.
        let is_held = |i: usize| {
            !free[i]
                || (at[i] <= within[i][0] && enclosure.gradient[i] > 0.0)
                || (at[i] >= within[i][1] && enclosure.gradient[i] < 0.0)
        };
        let moves = [!is_held(0), !is_held(1)];
        let step = enclosure.step(moves);
        if step.into_iter().any(f64::is_nan) {
            return Settled::NotConverged;
        }
        let next = [0, 1].map(|i| (at[i] + step[i]).clamp(within[i][0], within[i][1]));
        let is_zero = |i: usize| !moves[i] || enclosure.gradient[i].abs() <= enclosure.rest[i];
        let is_small = (0..2).all(|i| (next[i] - at[i]).abs() <= f64::EPSILON);
        if !(is_small || (0..2).all(is_zero)) {
            at = next;
            continue;
        }
        let is_clear = |i: usize| enclosure.gradient[i].abs() > enclosure.rest[i];
        let at_square = |i: usize| at[i].abs() >= 1.0;
        if (0..2).any(|i| free[i] && !moves[i] && is_clear(i) && !at_square(i)) {
            return Settled::Elsewhere;
        }
        let leads_in =
            |i: usize| at_square(i) && !free[i] && is_clear(i) && enclosure.gradient[i] * at[i] > 0.0;
        if (0..2).any(leads_in) {
            return Settled::Elsewhere;
        }
        return Settled::Minimum(Minimum {
            at,
            error: enclosure.parameter_errors(moves),
            distance: [enclosure.distance(), enclosure.distance_error()],
            is_weak: (0..2).any(|i| {
                at_square(i) && enclosure.gradient[i].abs() <= enclosure.rest[i] + enclosure.weak[i]
            }),
            within,
        });
    }
    Settled::NotConverged
}

impl Open {
    pub(super) fn new(pieces: [&Piece; 2], enclosure: &Enclosure) -> Self {
        let least = enclosure.least_distance();
        Self { within: pieces.map(Piece::extent), least: if least.is_nan() { 0.0 } else { least } }
    }
}

impl Survey {
    /// Adds a minimum, once if it lies on the side of two boxes.
    fn add(&mut self, minimum: Minimum) {
        let is_same = |known: &Minimum| {
            (0..2).all(|i| (known.at[i] - minimum.at[i]).abs() <= 1e-9 + known.error[i] + minimum.error[i])
        };
        match self.minima.iter_mut().find(|known| is_same(known)) {
            Some(known) => known.is_weak &= minimum.is_weak,
            None => self.minima.push(minimum),
        }
    }
}
