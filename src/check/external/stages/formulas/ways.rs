//! The ways in which a program may have written its formulas.

use super::change::Change;
use super::evaluation::Changed;
use super::list::{FORMULAS, WITH_START};
use super::names::{Set, WAYS};
use super::outputs::Output;
use super::point::Point;
use std::collections::{BTreeMap, BTreeSet};

/// A way of writing is used if it is valid at all samples but one in so many.
const LOST: usize = 8;

/// The ways in which a program may have written the formulas of each of its results.
pub(super) struct Ways {
    among: Set,
    /// The names that the results follow from.
    pub(super) needed: Set,
    /// Those that are not the same as another one.
    distinct: Vec<usize>,
    /// For each result, in their order.
    left: Left,
}

/// A result, and which parameters are held: a program may have formulas of their own for the ends.
type Answered = (Output, [bool; 2]);

/// The ways that are left for each result.
type Left = Vec<(Answered, [bool; WAYS])>;

impl Ways {
    pub(super) fn of(points: &[Point], among: Set) -> Self {
        let mut lost: BTreeMap<Output, [usize; WAYS]> = BTreeMap::new();
        let mut all: BTreeSet<Answered> = BTreeSet::new();
        for (point, answer) in points.iter().flat_map(|point| point.among(among).map(move |of| (point, of))) {
            let of = lost.entry(answer.output).or_default();
            (0..WAYS).for_each(|way| of[way] += usize::from(!answer.ways[way]));
            all.insert((answer.output, point.sample.held));
        }
        let start = FORMULAS.name("tau_n");
        let has_start = points.iter().any(|point| !point.values[0][start].is_zero());
        let is_left =
            |way: usize, lost: usize| LOST * lost <= points.len() && (way != WITH_START || has_start);
        let left = all.into_iter().map(|answered| {
            let lost = &lost[&answered.0];
            (answered, std::array::from_fn(|way| is_left(way, lost[way])))
        });
        let needed = FORMULAS.needed(among);
        Self { among, needed, distinct: FORMULAS.distinct_ways(needed), left: left.collect() }
    }

    /// Whether a change yields the answers at all these samples.
    pub(super) fn yield_answers<'a>(
        &self,
        change: &Change,
        mut points: impl Iterator<Item = &'a Point<'a>>,
    ) -> bool {
        if !self.may_be(change) {
            return false;
        }
        let mut left = self.left.clone();
        let needed = self.needed.or(change.needed());
        points.all(|point| self.keep(&mut left, point, (change, needed)))
    }

    /// The ways in which a result may be written, if it is among these.
    pub(super) fn of_answer(&self, answered: Answered) -> Option<[bool; WAYS]> {
        let at = self.left.binary_search_by_key(&answered, |(of, _)| *of).ok()?;
        Some(std::array::from_fn(|way| self.left[at].1[way] && self.distinct.contains(&way)))
    }

    /// Whether the change may be one of this program: some results follow from it, and its formulas are written so.
    pub(super) fn may_be(&self, change: &Change) -> bool {
        self.are_needed(change) && self.are_right(&change.ways)
    }

    /// Whether some of the results follow from what is changed.
    pub(super) fn are_needed(&self, change: &Change) -> bool {
        !change.names().and(self.needed).is_empty()
    }

    /// Whether the formulas are right, without a change, in some of these ways.
    pub(super) fn are_right(&self, ways: &[bool; WAYS]) -> bool {
        (0..WAYS).any(|way| ways[way] && self.left.iter().all(|(_, left)| left[way]))
    }

    /// Keeps the ways that yield the answers at this sample; whether each result has one.
    fn keep(&self, left: &mut Left, point: &Point, (change, needed): (&Change, Set)) -> bool {
        let mut known: Vec<Changed> = Vec::new();
        for &way in &self.distinct {
            if !left.iter().any(|(_, left)| left[way]) {
                continue;
            }
            let same = known.iter().position(|of| of.is_same(point, way, (change, needed)));
            let place = same.unwrap_or_else(|| {
                known.push(point.changed(way, change, needed));
                known.len() - 1
            });
            let changed = &known[place];
            let mut others = Set::default();
            for answer in point.among(self.among).filter(|answer| answer.ways[way]) {
                let answered = (answer.output, point.sample.held);
                if let Ok(at) = left.binary_search_by_key(&answered, |(of, _)| *of)
                    && left[at].1[way]
                {
                    left[at].1[way] = point.is_explained(answer, way, changed);
                    if !left[at].1[way] {
                        others.add(answer.output.name);
                    }
                }
            }
            // What follows from another number than the one that is answered is not that of this program.
            let after = FORMULAS.relations[way].following(others);
            for (_, left) in left
                .iter_mut()
                .filter(|((output, held), _)| *held == point.sample.held && after.has(output.name))
            {
                left[way] = false;
            }
        }
        left.iter().all(|(_, left)| self.distinct.iter().any(|way| left[*way]))
    }
}
