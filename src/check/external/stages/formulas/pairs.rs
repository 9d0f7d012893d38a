//! Two changes of the list that explain answers together.

use super::changes::{CHANGES, Change};
use super::list::FORMULAS;
use super::names::Set;
use super::point::{Point, points};
use super::search::probes;
use super::values::Values;
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use rayon::prelude::*;

/// The number of samples at which pairs are tried.
const PROBES: usize = 8;
/// The cost of a change that is one of two.
const SIMPLE: u32 = 3;
/// The ways of writing in which pairs are looked for.
const WAYS: [usize; 2] = [0, 2];

/// A pair whose effects on residual or tangent add up to the difference of the answers.
pub(super) fn found(samples: &[Sample], among: Set, given: Set) -> Vec<Change> {
    WAYS.into_iter().find_map(|way| of_way(samples, way, among, given)).into_iter().collect()
}

fn of_way(samples: &[Sample], way: usize, among: Set, given: Set) -> Option<Change> {
    let name = among.names().next()?;
    let is_valid = |point: &Point| point.among(among).all(|answer| answer.ways[way]);
    let points: Vec<Point> = points(samples, given).into_iter().filter(is_valid).collect();
    let probes = probes(&points, among, PROBES);
    if probes.len() < 2 {
        return None;
    }
    let needed = FORMULAS.needed(among);
    let effect = |point: &Point, change: &Change| -> RunningError {
        point.changed(way, change, needed).at(name).number() - point.values[way][name].number()
    };
    let wanted = |point: &Point| -> Option<RunningError> {
        let answer = point.among(among).next()?;
        Some(answer.number - point.values[way][name].number())
    };
    let wanted_at: Vec<RunningError> = probes.iter().filter_map(|point| wanted(point)).collect();
    let is_simple = |change: &&Change| change.cost <= SIMPLE && change.ways[way];
    let simple: Vec<&Change> = CHANGES.iter().filter(is_simple).collect();
    let effects: Vec<(&Change, Vec<RunningError>)> = simple
        .par_iter()
        .map(|&change| (change, probes.iter().map(|point| effect(point, change)).collect::<Vec<_>>()))
        .filter(|(_, effects)| effects.iter().all(|of| of.value.is_finite() && of.bound.is_finite()))
        .collect();
    let mut sorted: Vec<usize> = (0..effects.len()).collect();
    sorted.sort_by(|one, other| effects[*one].1[0].value.total_cmp(&effects[*other].1[0].value));
    let is_sum = |one: RunningError, other: RunningError, wanted: RunningError| {
        let left = one + other - wanted;
        left.value.abs() <= CAREFUL * left.bound
    };
    let of_first = |i: usize| {
        let (_, first) = &effects[i];
        let rest = wanted_at[0] - first[0];
        let near = 1e-9 * (wanted_at[0].value.abs() + first[0].value.abs());
        let start = sorted.partition_point(|k| effects[*k].1[0].value < rest.value - near);
        let candidates = sorted[start..].iter().take_while(|k| effects[**k].1[0].value <= rest.value + near);
        candidates.copied().filter(|&k| k > i).find(|&k| {
            let mut of = first.iter().zip(&effects[k].1).zip(&wanted_at);
            of.all(|((one, other), wanted)| is_sum(*one, *other, *wanted))
                && points.iter().all(|point| {
                    let of = |i: usize| effect(point, effects[i].0);
                    wanted(point).is_none_or(|wanted| is_sum(of(i), of(k), wanted))
                })
        })
    };
    let pair = (0..effects.len()).into_par_iter().find_map_first(|i| of_first(i).map(|k| [i, k]))?;
    let [one, other] = pair.map(|i| effects[i].0);
    let words = format!("{} and {}", one.words, other.words);
    Some(Change { words, cost: one.cost + other.cost, ..one.clone() })
}
