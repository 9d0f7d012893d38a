//! The change of the list that explains the answers.

use super::changes::{Change, changes};
use super::list::{FORMULAS, WAYS, WITH_START};
use super::point::{Point, points};
use super::tree::Name;
use super::{matrices, pairs};
use crate::check::external::stages::point::Point as StagePoint;
use crate::check::external::stages::sample::{Along, Sample};
use crate::check::external::stages::sentences::scope;
use crate::check::external::stages::{Reading, Traced};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BTreeSet;

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
    let names = |stage: &[&str]| stage.iter().map(|name| list.name(name)).collect::<Vec<_>>();
    let first = points(samples, 0, &[]);
    let cases = |among: &[Name]| -> BTreeSet<usize> {
        first.iter().filter(|point| point.is_wrong(among)).map(|point| point.sample.case).collect()
    };
    let all: Vec<Name> = STAGES.iter().flat_map(|(stage, _)| names(stage)).collect();
    let (first_stage, words) = STAGES.iter().find(|(stage, _)| !cases(&names(stage)).is_empty())?;
    let known: BTreeSet<_> = first.iter().map(|point| point.sample.case).collect();
    let wrong = cases(&names(first_stage));
    let right: Vec<usize> = known.difference(&wrong).copied().collect();
    let wrong: Vec<usize> = wrong.into_iter().collect();
    let of_curves: Vec<_> = samples.iter().map(StagePoint::new).collect();
    let scope = scope(&of_curves, &wrong, &right);
    let mut traced = Traced {
        cases: known.len(),
        place: format!("{words} is wrong{scope}"),
        is_of_element: true,
        ..Traced::default()
    };
    let mut stages = vec![readings(explained(samples, &all, &[]))];
    if stages[0].is_empty() {
        stages = of_stages(samples, entries, &names);
    }
    let mut stages = stages.into_iter();
    traced.causes = stages.next().unwrap_or_default();
    traced.leaves_some = traced.causes.is_empty();
    if !traced.leaves_some {
        stages.for_each(|causes| traced.go_beyond(&causes));
    }
    Some(traced)
}

/// What explains the answers of each stage that is wrong. They follow from those of the stages before, or from right ones.
fn of_stages(
    samples: &[Sample],
    entries: &dyn Fn(Along) -> Vec<Sample>,
    names: &dyn Fn(&[&str]) -> Vec<Name>,
) -> Vec<Vec<Reading>> {
    let mut given: Vec<Name> = Vec::new();
    let mut stages = Vec::new();
    for (stage, _) in STAGES {
        let names = names(stage);
        let is_wrong = |given: &[Name]| points(samples, 0, given).iter().any(|point| point.is_wrong(&names));
        if is_wrong(&given) && is_wrong(&[]) {
            let of_one =
                || [&given[..], &[]].into_iter().map(|given| readings(explained(samples, &names, given)));
            let of_matrix =
                || matrices::reading(samples, entries).filter(|_| stage == ["K"]).into_iter().collect();
            // Two effects add up where the answer is a sum.
            let is_sum = stage == ["R"] || stage == ["K"];
            let of_two = || if is_sum { readings(pairs::found(samples, &names, &given)) } else { Vec::new() };
            let is_some = |found: &Vec<Reading>| !found.is_empty();
            let causes =
                of_one().find(is_some).or_else(|| Some(of_matrix()).filter(is_some)).unwrap_or_else(of_two);
            stages.push(causes);
        }
        given.extend(names);
    }
    stages
}

fn readings(changes: Vec<Change>) -> Vec<Reading> {
    let reading = |of: Change| Reading { names: vec![of.words.clone()], words: of.words, coefficient: None };
    changes.into_iter().map(reading).collect()
}

/// The simplest changes that explain these answers.
fn explained(samples: &[Sample], among: &[Name], given: &[Name]) -> Vec<Change> {
    let mut found: Vec<Change> = Vec::new();
    for way in 0..WAYS {
        let points = points(samples, way, given);
        let tangent = FORMULAS.name("tau_n");
        if way == WITH_START && points.iter().all(|point| point.values[tangent].is_zero()) {
            continue;
        }
        let probes = probes(&points, among, PROBES);
        let lost = samples.len() - points.len();
        if probes.is_empty() || LOST * lost > samples.len() {
            continue;
        }
        let explains = |change: &Change| {
            let mut of = probes.iter().copied().chain(&points);
            of.all(|point| point.is_explained(way, change, among))
        };
        found.par_extend(changes(way).into_par_iter().filter(explains));
    }
    let least = found.iter().map(|change| change.cost).min();
    found.retain(|change| Some(change.cost) == least);
    // The formula that is next to the answers is meant.
    found.sort_by_key(|change| Reverse(change.new.iter().map(|(name, _)| *name).max()));
    let mut told = BTreeSet::new();
    found.retain(|change| told.insert(change.words.clone()));
    // Of many, those of the last formula are as good as the others.
    if found.len() > TOLD {
        let last = |change: &Change| change.new.iter().map(|(name, _)| *name).max();
        let name = last(&found[0]);
        found.retain(|change| last(change) == name);
    }
    if found.len() > TOLD { Vec::new() } else { found }
}

/// The clearest samples at which one of these answers is wrong: one of each case in turn.
pub(super) fn probes<'a>(points: &'a [Point<'a>], among: &[Name], count: usize) -> Vec<&'a Point<'a>> {
    let mut wrong: Vec<&Point> = points.iter().filter(|point| point.is_wrong(among)).collect();
    wrong.sort_by(|one, other| other.clearness(among).total_cmp(&one.clearness(among)));
    let mut cases = BTreeSet::new();
    wrong.retain(|point| cases.insert(point.sample.case));
    wrong.truncate(count);
    wrong
}
