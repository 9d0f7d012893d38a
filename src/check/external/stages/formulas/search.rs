//! The change of the list that explains the answers.

use super::changes::{CHANGES, Change};
use super::edits::Class;
use super::evaluation::Changed;
use super::list::{FORMULAS, WITH_START};
use super::names::{Set, WAYS};
use super::outputs::{Output, RESULTS};
use super::point::{Point, points, probes};
use super::tree::Name;
use super::{matrices, pairs};
use crate::check::external::stages::point::Point as StagePoint;
use crate::check::external::stages::sample::{Along, Sample};
use crate::check::external::stages::sentences::scope;
use crate::check::external::stages::{Reading, Traced};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// The number of samples at which all changes are tried.
const PROBES: usize = 6;
/// A way of writing is used if it is valid at all samples but one in so many.
const LOST: usize = 8;
/// If more changes explain the answers, they do not tell which one is meant.
const TOLD: usize = 8;

/// The answers in the order in which they follow from each other, and how the first is called.
const STAGES: [(&[&str], &str); 4] = [
    (&["F_N"], "the normal force F_N"),
    (&["state", "F", "F_bar", "C", "C_bar"], "the friction force, or its state,"),
    (&["R"], "the residual"),
    (&["K"], "the tangent"),
];

/// What explains the answers to contact elements: one change for all of them, or one for the first that are wrong. Nothing if
/// all are right. `entries` are samples along single dofs.
pub(in crate::check::external::stages) fn found(
    samples: &[Sample],
    entries: &dyn Fn(Along) -> Vec<Sample>,
) -> Option<Traced> {
    let list = &*FORMULAS;
    let names = |stage: &[&str]| -> Set { stage.iter().map(|name| list.name(name)).collect() };
    let first: Vec<Point> = points(samples, Set::default());
    let cases = |among: Set| -> BTreeSet<usize> {
        first.iter().filter(|point| point.is_wrong(among)).map(|point| point.sample.case).collect()
    };
    let all = STAGES.iter().map(|(stage, _)| names(stage)).fold(Set::default(), Set::or);
    let (first_stage, words) = STAGES.iter().find(|(stage, _)| !cases(names(stage)).is_empty())?;
    let known: BTreeSet<_> = first.iter().map(|point| point.sample.case).collect();
    let wrong = cases(names(first_stage));
    let right: Vec<usize> = known.difference(&wrong).copied().collect();
    let wrong: Vec<usize> = wrong.into_iter().collect();
    let of_curves: Vec<_> = samples.iter().map(StagePoint::new).collect();
    let scope = scope(&of_curves, &wrong, &right);
    let mut traced = Traced {
        cases: known.len(),
        place: format!("{words} is wrong{scope}"),
        is_of_formulas: true,
        ..Traced::default()
    };
    let mut stages = vec![readings(&explained(&first, all, Set::default(), &|_| true))];
    if stages[0].is_empty() {
        stages = of_stages(samples, entries, &first, &names);
    }
    let mut stages = stages.into_iter();
    traced.causes = stages.next().unwrap_or_default();
    traced.leaves_some = traced.causes.is_empty();
    if !traced.leaves_some {
        stages.for_each(|causes| traced.go_beyond(&causes));
    }
    Some(traced)
}

/// One change that explains all answers, those of the geometry among them.
pub(in crate::check::external::stages) fn of_all(samples: &[Sample]) -> Vec<Reading> {
    let names = STAGES.iter().flat_map(|(stage, _)| *stage).map(|name| FORMULAS.name(name));
    let of_penalty = ["R_p", "K_p"].map(|name| FORMULAS.name(name));
    let all = names.chain(RESULTS.iter().copied()).chain(of_penalty).collect();
    readings(&explained(&points(samples, Set::default()), all, Set::default(), &|_| true))
}

/// What explains the answers of each stage that is wrong. They follow from those of the stages before, or from right ones. A
/// stage that follows from what explains an earlier one is left out, and so is a cause that would change an earlier one.
fn of_stages(
    samples: &[Sample],
    entries: &dyn Fn(Along) -> Vec<Sample>,
    first: &[Point],
    names_of: &(dyn Fn(&[&str]) -> Set + Sync),
) -> Vec<Vec<Reading>> {
    let mut given = Set::default();
    let mut stages = Vec::new();
    let (mut known, mut wrong): (Vec<Change>, Set) = (Vec::new(), Set::default());
    for (place, (stage, _)) in STAGES.iter().enumerate() {
        let names = names_of(stage);
        let is_given = first.iter().any(|point| point.among(given).next().is_some());
        let from_given = is_given.then(|| points(samples, given));
        let both: Vec<&[Point]> = from_given.as_deref().into_iter().chain([first]).collect();
        let is_wrong = both.iter().all(|points| points.iter().any(|point| point.is_wrong(names)));
        let follows = |change: &Change| both.iter().any(|points| yields(change, points, names));
        if is_wrong && !known.iter().any(follows) {
            let before = FORMULAS.needed(wrong);
            let (from_all, right) = (OnceLock::new(), OnceLock::new());
            let from_all = || from_all.get_or_init(|| points(samples, given.or(names))).as_slice();
            let right = || right.get_or_init(|| right_stages([first, from_all()], place, names_of));
            let keeps =
                |change: &Change| right().iter().all(|(points, names)| yields(change, points, *names));
            let found = |points: &&[Point]| explained(points, names, before, &keeps);
            let found = both.iter().map(found).find(|found| !found.is_empty());
            let of_matrix = || matrices::reading(samples, entries).filter(|_| *stage == ["K"]);
            // Two effects add up where the answer is a sum.
            let is_sum = (*stage == ["R"] || *stage == ["K"]) && wrong.is_empty();
            let of_two = || if is_sum { readings(&pairs::found(both[0], names)) } else { Vec::new() };
            stages.push(match &found {
                Some(found) => readings(found),
                None => of_matrix().map_or_else(of_two, |reading| vec![reading]),
            });
            known.extend(found.unwrap_or_default());
            wrong = wrong.or(names);
        }
        given = given.or(names);
    }
    stages
}

/// The other stages whose answers are right, with their points. Those of an earlier stage have the formulas' own numbers, those
/// of a later one follow from the answers of this one. A change that would spoil them is not the error.
fn right_stages<'a>(
    [own, from_answers]: [&'a [Point<'a>]; 2],
    place: usize,
    names_of: &(dyn Fn(&[&str]) -> Set + Sync),
) -> Vec<(&'a [Point<'a>], Set)> {
    let of_stage = |(i, (stage, _)): (usize, &(&[&str], &str))| {
        let names = names_of(stage);
        let points = if i < place { own } else { from_answers };
        let is_right = i != place && !points.iter().any(|point| point.is_wrong(names));
        is_right.then_some((points, names))
    };
    STAGES.iter().enumerate().filter_map(of_stage).collect()
}

/// Whether a change yields all these answers.
fn yields(change: &Change, points: &[Point], among: Set) -> bool {
    let ways = Ways::of(points, among);
    // A change of something else leaves right answers as they are.
    let has_effect = ways.are_needed(change);
    if has_effect {
        ways.yield_answers(change, points.iter())
    } else {
        !points.iter().any(|of| of.is_wrong(among))
    }
}

fn readings(changes: &[Change]) -> Vec<Reading> {
    let reading = |words: String| Reading { names: vec![words.clone()], words, coefficient: None };
    changes.iter().map(Change::words).map(reading).collect()
}

/// The simplest changes that explain these answers.
///
/// A program may write each formula in its own way. So each result must be that of the changed formulas in one of the ways,
/// which is the same at all samples. The formulas `before` are not changed, and a change `keeps` the answers that are right.
fn explained(
    points: &[Point],
    among: Set,
    before: Set,
    keeps: &(dyn Fn(&Change) -> bool + Sync),
) -> Vec<Change> {
    let probes = probes(points.iter(), among, PROBES);
    if probes.is_empty() {
        return Vec::new();
    }
    // Most changes are seen to be others at one result that is wrong: that which follows from the fewest names.
    let is_wrong = |name: &Name| probes.iter().any(|point| point.is_wrong(Set::from_iter([*name])));
    let names_before = |name: &Name| FORMULAS.needed(Set::from_iter([*name])).names().count();
    let first: Set = among.names().filter(is_wrong).min_by_key(names_before).into_iter().collect();
    let [of_first, of_all] = [first, among].map(|among| Ways::of(points, among));
    let explains = |change: &&Change| {
        (before.is_empty() || change.names().and(before).is_empty())
            && of_first.yield_answers(change, probes.iter().copied())
            && of_all.yield_answers(change, probes.iter().copied().chain(points))
            // A name without a value is no part of this program.
            && change.uses(points[0].needed).without(points[0].needed).is_empty()
            && keeps(change)
    };
    let mut found: Vec<Change> = Vec::new();
    for class in Class::ALL {
        if !found.iter().any(|change| change.cost <= Class::SIMPLE) {
            let tried = CHANGES.of(of_first.needed, class).into_par_iter();
            found.par_extend(tried.filter(explains).cloned());
        }
    }
    let least = found.iter().map(|change| change.cost).min();
    found.retain(|change| Some(change.cost) == least);
    // The formula that is next to the answers is meant.
    found.sort_by_key(|change| Reverse(change.new.iter().map(|(name, _)| *name).max()));
    let mut told = BTreeSet::new();
    found.retain(|change| told.insert(change.words()));
    // Of many, those of the last formula are as good as the others.
    if found.len() > TOLD {
        let last = |change: &Change| change.new.iter().map(|(name, _)| *name).max();
        let name = last(&found[0]);
        found.retain(|change| last(change) == name);
    }
    if found.len() > TOLD { Vec::new() } else { found }
}

/// The ways in which a program may have written the formulas of each of its results.
struct Ways {
    among: Set,
    /// The names that the results follow from.
    needed: Set,
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
    fn of(points: &[Point], among: Set) -> Self {
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
    fn yield_answers<'a>(&self, change: &Change, mut points: impl Iterator<Item = &'a Point<'a>>) -> bool {
        if !self.are_needed(change) || !self.are_right(change) {
            return false;
        }
        let mut left = self.left.clone();
        points.all(|point| self.keep(&mut left, point, change))
    }

    /// Whether some of the results follow from what is changed.
    fn are_needed(&self, change: &Change) -> bool {
        !change.names().and(self.needed).is_empty()
    }

    /// Whether the formulas are right before the change, in some way in which they are written so.
    fn are_right(&self, change: &Change) -> bool {
        (0..WAYS).any(|way| change.ways[way] && self.left.iter().all(|(_, left)| left[way]))
    }

    /// Keeps the ways that yield the answers at this sample; whether each result has one.
    fn keep(&self, left: &mut Left, point: &Point, change: &Change) -> bool {
        let mut known: Vec<Changed> = Vec::new();
        for &way in &self.distinct {
            if !left.iter().any(|(_, left)| left[way]) {
                continue;
            }
            let same = known.iter().position(|of| of.is_same(point, way, (change, self.needed)));
            let place = same.unwrap_or_else(|| {
                known.push(point.changed(way, change, self.needed));
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
            let follows = &FORMULAS.relations[way].follows;
            let after = others.names().fold(Set::default(), |after, name| after.or(follows[name]));
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
