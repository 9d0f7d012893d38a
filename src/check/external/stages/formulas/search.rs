//! The change of the list that explains the answers.

use super::change::Change;
use super::explained::Searched;
use super::list::FORMULAS;
use super::names::Set;
use super::outputs::RESULTS;
use super::point::{Point, points, with_given};
use super::tree::Name;
use super::ways::Ways;
use super::{matrices, pairs};
use crate::check::external::stages::point::Point as StagePoint;
use crate::check::external::stages::sample::{Along, Sample};
use crate::check::external::stages::sentences::scope;
use crate::check::external::stages::{Reading, Traced};
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// Samples along single dofs.
type Entries<'a> = &'a dyn Fn(Along) -> Vec<Sample>;
/// What explains the entries of some beams alone.
type InBlocks<'a> = &'a dyn Fn() -> Vec<Reading>;

/// The answers in the order in which they follow from each other, and how the first is called.
const STAGES: [(&[&str], &str); 4] = [
    (&["F_N"], "the normal force F_N"),
    (&["state", "F", "F_bar", "C", "C_bar"], "the friction force, or its state,"),
    (&["R"], "the residual"),
    (&["K"], "the tangent"),
];

/// What explains the answers to contact elements: one change for all of them, or one for the first that are wrong. Nothing if
/// all are right.
pub(in crate::check::external::stages) fn found(
    samples: &[Sample],
    entries: Entries,
    in_blocks: InBlocks,
) -> Option<Traced> {
    let list = &*FORMULAS;
    let names = |stage: &[&str]| -> Set { stage.iter().map(|name| list.name(name)).collect() };
    let own: Vec<Point> = points(samples);
    let first = Searched::new(&own);
    let cases = |among: Set| -> BTreeSet<usize> {
        own.iter().filter(|point| point.is_wrong(among)).map(|point| point.sample.case).collect()
    };
    let all = STAGES.iter().map(|(stage, _)| names(stage)).fold(Set::default(), Set::or);
    let (first_stage, words) = STAGES.iter().find(|(stage, _)| !cases(names(stage)).is_empty())?;
    let known: BTreeSet<_> = own.iter().map(|point| point.sample.case).collect();
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
    let mut stages = vec![readings(&first.explained(all, Set::default(), &|_| true))];
    if stages[0].is_empty() {
        stages = of_stages((entries, in_blocks), &first, &names);
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
    let points = points(samples);
    readings(&Searched::new(&points).explained(all_results(), Set::default(), &|_| true))
}

/// Whether some of the gradients, or values, and some of the Hessians are wrong.
pub(in crate::check::external::stages) fn are_wrong(samples: &[Sample]) -> [bool; 2] {
    let points = points(samples);
    [false, true].map(|is_hessian| {
        let is_meant = |name: &Name| (FORMULAS.kinds[*name].varies == [true; 2]) == is_hessian;
        let names = all_results().names().filter(is_meant).collect();
        points.iter().any(|point| point.is_wrong(names))
    })
}

/// The names of all that is answered.
fn all_results() -> Set {
    let names = STAGES.iter().flat_map(|(stage, _)| *stage).map(|name| FORMULAS.name(name));
    let of_penalty = ["R_p", "K_p"].map(|name| FORMULAS.name(name));
    names.chain(RESULTS.iter().copied()).chain(of_penalty).collect()
}

/// What explains the answers of each stage that is wrong. They follow from those of the stages before, or from right ones. A
/// stage that follows from what explains an earlier one is left out, and so is a cause that would change an earlier one.
fn of_stages(
    (entries, in_blocks): (Entries, InBlocks),
    first: &Searched,
    names_of: &(dyn Fn(&[&str]) -> Set + Sync),
) -> Vec<Vec<Reading>> {
    let own = first.points;
    let mut given = Set::default();
    let mut stages = Vec::new();
    let (mut known, mut wrong): (Vec<Change>, Set) = (Vec::new(), Set::default());
    for (place, (stage, _)) in STAGES.iter().enumerate() {
        let names = names_of(stage);
        // What follows from right answers is what the formulas yield.
        let is_given = own.iter().any(|point| point.is_wrong(given));
        let from_given = is_given.then(|| with_given(own, given));
        let both: Vec<&[Point]> = from_given.as_deref().into_iter().chain([own]).collect();
        let is_wrong = both.iter().all(|points| points.iter().any(|point| point.is_wrong(names)));
        let follows = |change: &Change| both.iter().any(|points| yields(change, points, names));
        if is_wrong && !known.iter().any(follows) {
            let before = FORMULAS.needed(wrong);
            let (from_all, right) = (OnceLock::new(), OnceLock::new());
            let from_all = || from_all.get_or_init(|| with_given(own, given.or(names))).as_slice();
            let right = || right.get_or_init(|| right_stages([own, from_all()], place, names_of));
            let keeps =
                |change: &Change| right().iter().all(|(points, names)| yields(change, points, *names));
            let from_given = from_given.as_deref().map(Searched::new);
            let found = |of: &Searched| of.explained(names, before, &keeps);
            let found = from_given.iter().chain([first]).map(found).find(|found| !found.is_empty());
            let of_matrix = || matrices::reading(own, entries).filter(|_| *stage == ["K"]);
            // Two effects add up where the answer is a sum.
            let is_sum = (*stage == ["R"] || *stage == ["K"]) && wrong.is_empty();
            let of_two = || if is_sum { readings(&pairs::found(both[0], names)) } else { Vec::new() };
            let of_matrix = if found.is_none() { of_matrix() } else { None };
            // One error in the code of a block is told before two errors.
            let of_blocks =
                if found.is_none() && of_matrix.is_none() && is_sum { in_blocks() } else { Vec::new() };
            if !of_blocks.is_empty() {
                stages.push(of_blocks);
                break;
            }
            stages.push(match &found {
                Some(found) => readings(found),
                None => of_matrix.map_or_else(of_two, |reading| vec![reading]),
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
    let reading = |words: String| Reading::new(vec![words.clone()], words);
    changes.iter().map(Change::words).map(reading).collect()
}
