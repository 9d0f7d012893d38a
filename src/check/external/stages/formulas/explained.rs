//! The changes of the list that explain answers.

use super::change::Change;
use super::changes::CHANGES;
use super::effects::Effects;
use super::kinds::Class;
use super::list::{FORMULAS, Formula};
use super::names::Set;
use super::outputs::RESULTS;
use super::point::{Point, probes};
use super::tree::Name;
use super::ways::Ways;
use crate::parallel;
use std::cell::RefCell;
use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::sync::Arc;

/// The number of samples at which all changes are tried.
const PROBES: usize = 6;
/// The number of those at which the effect of a change is estimated.
const QUICK: usize = 3;
/// If more changes explain the answers, they do not tell which one is meant.
const TOLD: usize = 8;

/// Points at which changes are looked for.
pub(super) struct Searched<'a> {
    pub(super) points: &'a [Point<'a>],
    /// The changes that yield the first wrong result at some of them, which are looked for once.
    possible: RefCell<Vec<(Tried, Arc<Vec<Change>>)>>,
}

/// The class of changes, the result, those that must stay right, and the addresses of the points.
type Tried = (Class, Set, Set, Vec<usize>);

impl<'a> Searched<'a> {
    pub(super) fn new(points: &'a [Point<'a>]) -> Self {
        Self { points, possible: RefCell::default() }
    }

    /// The simplest changes that explain these answers.
    ///
    /// A program may write each formula in its own way. So each result must be that of the changed formulas in one of the
    /// ways, which is the same at all samples. The formulas `before` are not changed, and a change `keeps` the answers that are
    /// right.
    pub(super) fn explained(
        &self,
        among: Set,
        before: Set,
        keeps: &(dyn Fn(&Change) -> bool + Sync),
    ) -> Vec<Change> {
        let points = self.points;
        let wrong = probes(points.iter(), among, PROBES);
        let is_wrong = |name: &Name| wrong.iter().any(|point| point.is_wrong(Set::from_iter([*name])));
        let names_before = |name: &Name| FORMULAS.needed(Set::from_iter([*name])).names().count();
        // One result is looked at first: that which follows from the fewest names.
        let first: Set = among.names().filter(is_wrong).min_by_key(names_before).into_iter().collect();
        let probes = probes(points.iter(), first, PROBES);
        if probes.is_empty() {
            return Vec::new();
        }
        let ways = Ways::of(points, among);
        let explains = |change: &Change| {
            (before.is_empty() || change.names().and(before).is_empty())
                && ways.yield_answers(change, probes.iter().copied().chain(points))
                // A name without a value is no part of this program.
                && change.uses(points[0].needed).without(points[0].needed).is_empty()
                && keeps(change)
        };
        let mut found: Vec<Change> = Vec::new();
        let tangent = Set::from_iter([FORMULAS.name("K")]).and(among);
        let has_tangent = points.iter().any(|point| point.among(tangent).next().is_some());
        for class in Class::ALL {
            let is_tried = match class {
                Class::Simple => true,
                Class::Other => !found.iter().any(|change| change.cost <= Class::SIMPLE),
                Class::Tangent => has_tangent && found.is_empty(),
                Class::Expanded => found.is_empty(),
            };
            if is_tried {
                let tried = self.possible(class, (first, among), &probes);
                found.extend(parallel::filter_map(&tried, |of| explains(of).then(|| of.clone())));
            }
        }
        simplest(found)
    }

    /// The changes that yield the first of the results that are wrong at some points.
    fn possible(
        &self,
        class: Class,
        (first, among): (Set, Set),
        probes: &[&'a Point<'a>],
    ) -> Arc<Vec<Change>> {
        let ways = Ways::of(self.points, first);
        let right = self.right_before(ways.needed, among);
        let addresses = probes.iter().map(|point| std::ptr::from_ref(*point).addr()).collect();
        let tried = (class, first, right, addresses);
        if let Some((_, known)) = self.possible.borrow().iter().find(|(known, _)| *known == tried) {
            return Arc::clone(known);
        }
        let right = Ways::of(self.points, right);
        let effects = Effects::new(&probes[..probes.len().min(QUICK)], &ways, &right);
        let yields = |change: &Change| {
            ways.may_be(change)
                && effects.may_yield(change)
                && ways.yield_answers(change, probes.iter().copied())
        };
        let found = if class == Class::Expanded {
            parallel::flat_map(&self.suspected(ways.needed), |formula| {
                let mut all = FORMULAS.expanded_changes(formula, |of| ways.are_right(of));
                all.retain(yields);
                all
            })
        } else {
            let all = CHANGES.of(ways.needed, class, |of| ways.are_right(of));
            parallel::filter_map(&all, |change| yields(change).then(|| (*change).clone()))
        };
        let found = Arc::new(found);
        self.possible.borrow_mut().push((tried, Arc::clone(&found)));
        found
    }

    /// The results that are right at all samples, and follow from these names alone. A contact element may have a geometry of
    /// its own.
    fn right_before(&self, needed: Set, among: Set) -> Set {
        let is_before = |name: &Name| {
            let alone = Set::from_iter([*name]);
            FORMULAS.needed(alone).without(needed.or(alone)).is_empty()
        };
        let is_kept = |name: &Name| among.has(*name) || !RESULTS.contains(name);
        self.right().names().filter(is_kept).filter(is_before).collect()
    }

    /// The results that are right at all samples.
    fn right(&self) -> Set {
        let answered: Set =
            self.points.iter().flat_map(|point| &point.answers).map(|answer| answer.output.name).collect();
        let is_right = |name: &Name| !self.points.iter().any(|point| point.is_wrong(Set::from_iter([*name])));
        answered.names().filter(is_right).collect()
    }

    /// The formulas that some of these names follow from, and no right answer in every way of writing.
    fn suspected(&self, needed: Set) -> Vec<&'static Formula> {
        let right = self.right();
        let is_right = |formula: &Formula| {
            FORMULAS.relations.iter().all(|of| !of.follows[formula.name].and(right).is_empty())
        };
        let is_needed = |formula: &Formula| !FORMULAS.names_of_changes(formula).and(needed).is_empty();
        FORMULAS.all.iter().filter(|formula| is_needed(formula) && !is_right(formula)).collect()
    }
}

/// The simplest of the changes that explain the same answers.
fn simplest(mut found: Vec<Change>) -> Vec<Change> {
    let least = found.iter().map(|change| change.cost).min();
    found.retain(|change| Some(change.cost) == least);
    // The formula that is next to the answers is meant.
    found.sort_by_key(|change| Reverse(change.last()));
    let mut told = BTreeSet::new();
    found.retain(|change| told.insert(change.words()));
    // Of many, those of the last formula are as good as the others.
    if found.len() > TOLD {
        let name = found[0].last();
        found.retain(|change| change.last() == name);
    }
    if found.len() > TOLD { Vec::new() } else { found }
}
