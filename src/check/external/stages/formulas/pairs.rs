//! Two changes of the list that explain answers together, and a term with a factor of its own.

use super::change::Change;
use super::changes::{CHANGES, FACTORS};
use super::kinds::Class;
use super::list::FORMULAS;
use super::names::Set;
use super::point::{Point, probes};
use super::values::Values;
use crate::check::candidate::CAREFUL;
use crate::number::RunningError;
use crate::parallel;
use std::cmp::Reverse;

/// The number of samples at which pairs are tried.
const PROBES: usize = 8;
/// The ways of writing in which pairs are looked for.
const WAYS: [usize; 2] = [0, 2];

/// The rounding of a factor.
const FACTOR: f64 = 1e-6;
/// The words of a term that is left out.
const MISSING: &str = "is missing";

/// A term with a factor, or a pair whose effects on residual or tangent add up to the difference of the answers.
pub(super) fn found(points: &[Point], among: Set) -> Vec<Change> {
    WAYS.into_iter().find_map(|way| of_way(points, way, among)).into_iter().collect()
}

/// The factor of what is left out in these effects, if it is the same at all samples: the wanted effects are a multiple.
fn factor(effects: &[RunningError], wanted: &[RunningError]) -> Option<f64> {
    let mut clear = effects.iter().zip(wanted).filter(|(of, wanted)| {
        let is_clear = |of: &RunningError| of.value.abs() * FACTOR > of.bound;
        is_clear(of) && is_clear(wanted)
    });
    let (first, first_wanted) = clear.next()?;
    // Two samples agree by chance on no factor.
    clear.next()?;
    let share = first_wanted.value / first.value;
    let is_multiple = |(of, wanted): (&RunningError, &RunningError)| {
        let allowed = CAREFUL * (wanted.bound + share.abs() * of.bound) + FACTOR * wanted.value.abs();
        (wanted.value - share * of.value).abs() <= allowed
    };
    effects.iter().zip(wanted).all(is_multiple).then_some(1.0 - share)
}

fn of_way(points: &[Point], way: usize, among: Set) -> Option<Change> {
    let name = among.names().next()?;
    let is_valid = |point: &&Point| point.among(among).all(|answer| answer.ways[way]);
    let points: Vec<&Point> = points.iter().filter(is_valid).collect();
    let probes = probes(points.iter().copied(), among, PROBES);
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
    let is_simple = |change: &&Change| change.cost <= Class::SIMPLE && change.ways[way];
    let mut simple = CHANGES.of(needed, Class::Simple, |ways| ways[way]);
    simple.retain(is_simple);
    let with_effects = |change: &&'static Change| {
        let effects: Vec<RunningError> = probes.iter().map(|point| effect(point, change)).collect();
        let is_finite = effects.iter().all(|of| of.value.is_finite() && of.bound.is_finite());
        (is_finite && effects.iter().any(|of| of.value.abs() > of.bound)).then_some((*change, effects))
    };
    let effects = parallel::filter_map(&simple, with_effects);
    let of_factor = |(change, at_probes): &(&Change, Vec<RunningError>)| {
        factor(at_probes, &wanted_at)?;
        let words = change.words();
        let (subject, scope) = words.split_once(MISSING)?;
        let at: Vec<_> =
            points.iter().filter_map(|point| Some((effect(point, change), wanted(point)?))).collect();
        let (of, wanted): (Vec<_>, Vec<_>) = at.into_iter().unzip();
        let words = format!("{subject}is multiplied by {}{scope}", short(factor(&of, &wanted)?)).into();
        Some(Change { words, cost: change.cost + 1, ..(*change).clone() })
    };
    // The formula that is next to the answers is meant.
    let last = |change: &Change| (change.last(), Reverse(change.cost));
    if let Some(found) = parallel::filter_map(&effects, of_factor).into_iter().max_by_key(last) {
        return Some(found);
    }
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
        let differ = |k: &usize| *k > i && term(effects[*k].0) != term(effects[i].0);
        candidates.copied().filter(differ).find(|&k| {
            let mut of = first.iter().zip(&effects[k].1).zip(&wanted_at);
            of.all(|((one, other), wanted)| is_sum(*one, *other, *wanted))
                && points.iter().all(|point| {
                    let of = |i: usize| effect(point, effects[i].0);
                    wanted(point).is_none_or(|wanted| is_sum(of(i), of(k), wanted))
                })
        })
    };
    let pair = parallel::first(effects.len(), |i| of_first(i).map(|k| [i, k]))?;
    let [one, other] = pair.map(|i| effects[i].0);
    let words = format!("{} and {}", one.words(), other.words()).into();
    Some(Change { words, cost: one.cost + other.cost, ..one.clone() })
}

/// What a change is about, without what is wrong with it.
fn term(change: &Change) -> String {
    let words = change.words();
    let subject = FACTORS.iter().find_map(|(_, wrong, _)| Some(words.split_once(wrong)?.0.to_owned()));
    subject.unwrap_or(words)
}

/// A factor with six digits at most.
fn short(factor: f64) -> String {
    let text = format!("{factor:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
