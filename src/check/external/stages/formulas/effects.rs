//! The effects of changes on answers, as estimates.
//!
//! To evaluate all formulas again is slow. The derivatives of an answer by all names are evaluated once, and the effect of a
//! change is the product of its own values with them. It is exact where the answer is of first degree in the names that are
//! changed, as it is in most, because derivatives are of first degree in each other. Elsewhere the formulas are evaluated
//! without their rounding.

use super::change::Change;
use super::degrees::{Through, affected, degrees, used};
use super::estimates::{Answered, Estimates};
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::outputs::Output;
use super::point::Point;
use super::ways::Ways;
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, OnceLock, RwLock};

/// What a change does to some answers.
pub(super) struct Effects<'a> {
    /// Those to wrong results, and to right ones.
    results: Vec<Answers<'a>>,
    /// By the names of changes, and what follows from them.
    of_names: RwLock<HashMap<(Set, Through), Arc<OfNames>>>,
}

/// The answers to a result where the same parameters are held.
pub(super) struct Answers<'a> {
    output: Output,
    /// The ways in which it may be written.
    ways: [bool; WAYS],
    pub(super) all: Vec<Answered<'a>>,
    /// The names that it follows from.
    pub(super) needed: Set,
}

/// What depends on the names of a change.
pub(super) struct OfNames {
    /// The order in which the results are looked at: those that are of first degree in all ways need no evaluation, and those
    /// that follow from few names need a short one.
    order: Vec<usize>,
    /// The ways of writing in which each result is of first degree in them.
    pub(super) of_first_degree: Vec<[bool; WAYS]>,
    /// They and all that follows from them in each way.
    pub(super) affected: [Set; WAYS],
    /// What is used in the formulas of these.
    pub(super) used: [Set; WAYS],
    /// For each result and way the ways, as bits, in which the same formulas of these lead to it.
    pub(super) alike: Vec<[u16; WAYS]>,
    pub(super) names: Set,
    through: Through,
    /// For each result, answer and way the first way in which the derivatives by the names are the same.
    same_derivatives: Vec<OnceLock<Vec<[usize; WAYS]>>>,
}

impl<'a> Effects<'a> {
    /// The effects on wrong answers at these samples, and on right ones that follow from nothing else.
    pub(super) fn new(probes: &[&'a Point<'a>], wrong: &Ways, right: &Ways) -> Self {
        let mut all: BTreeMap<_, Vec<Answered>> = BTreeMap::new();
        for of in probes.iter().flat_map(|point| Answered::all(point)) {
            all.entry((of.answer.output, of.point.sample.held)).or_default().push(of);
        }
        let of = |((output, held), all)| {
            let ways = wrong.of_answer((output, held)).or_else(|| right.of_answer((output, held)))?;
            Some(Answers::new(output, ways, all))
        };
        Self { results: all.into_iter().filter_map(of).collect(), of_names: RwLock::default() }
    }

    /// Whether a change may yield these answers.
    pub(super) fn may_yield(&self, change: &Change) -> bool {
        if change.entries.is_some() {
            return true;
        }
        let of_names = self.of_names(change.names(), Through::of(change));
        let mut estimates = Estimates::new(change, &of_names);
        of_names.order.iter().all(|&place| {
            let answers = &self.results[place];
            (0..WAYS).filter(|way| answers.ways[*way]).any(|way| {
                let mut all = answers.all.iter().enumerate().filter(|(_, of)| of.answer.ways[way]);
                all.all(|(i, of)| of.is_near(way, estimates.effect((answers, place), i, way)))
            })
        })
    }

    fn of_names(&self, names: Set, through: Through) -> Arc<OfNames> {
        let known = self.of_names.read().ok().and_then(|known| known.get(&(names, through)).cloned());
        known.unwrap_or_else(|| {
            let of = Arc::new(OfNames::new(names, through, &self.results));
            if let Ok(mut known) = self.of_names.write() {
                known.insert((names, through), Arc::clone(&of));
            }
            of
        })
    }
}

impl<'a> Answers<'a> {
    fn new(output: Output, ways: [bool; WAYS], all: Vec<Answered<'a>>) -> Self {
        Self { output, ways, all, needed: FORMULAS.needed(Set::from_iter([output.name])) }
    }
}

impl OfNames {
    fn new(names: Set, through: Through, results: &[Answers]) -> Self {
        let mut of_first_degree = vec![[false; WAYS]; results.len()];
        for way in 0..WAYS {
            let degrees = degrees(way, names, through);
            for (of, Answers { output, .. }) in of_first_degree.iter_mut().zip(results) {
                of[way] = degrees.is_some_and(|degrees| degrees[output.name] <= 1);
            }
        }
        // Another force seldom leads to another state.
        let state = FORMULAS.name("state");
        let mut order: Vec<usize> = (0..results.len()).collect();
        order.sort_by_key(|i| {
            let Answers { output, ways, .. } = &results[*i];
            let is_sum = (0..WAYS).all(|way| !ways[way] || of_first_degree[*i][way]);
            (!is_sum).then_some((output.name == state, output.name))
        });
        let affected: [Set; WAYS] = std::array::from_fn(|way| affected(way, names, through));
        let used = std::array::from_fn(|way| used(way, affected[way]));
        let alike = |Answers { needed, .. }: &Answers| {
            let here = affected.map(|of| of.and(*needed));
            let is_alike = |way: usize, other: usize| {
                here[way] == here[other] && here[way].and(FORMULAS.relations[way].differ[other]).is_empty()
            };
            let bits = |way: usize| (0..WAYS).map(|other| u16::from(is_alike(way, other)) << other).sum();
            std::array::from_fn(bits)
        };
        let alike = results.iter().map(alike).collect();
        let same_derivatives = vec![OnceLock::new(); results.len()];
        Self { order, of_first_degree, affected, used, alike, names, through, same_derivatives }
    }

    /// The first way in which the derivatives of an answer by the names are the same as in this one.
    pub(super) fn first_like(&self, (result, place): (&Answers, usize), answer: usize, way: usize) -> usize {
        let first_ways = |of: &Answered| {
            let is_used = |way: usize| result.ways[way] && of.answer.ways[way];
            let is_same = |way: usize, other: usize| {
                let [one, other] = [way, other].map(|way| of.derivatives(way, self.through));
                self.names.names().all(|name| one[name].is_about(other[name]))
            };
            std::array::from_fn(|way| {
                let mut before = (0..way).filter(|other| is_used(way) && is_used(*other));
                before.find(|other| is_same(way, *other)).unwrap_or(way)
            })
        };
        self.same_derivatives[place].get_or_init(|| result.all.iter().map(first_ways).collect())[answer][way]
    }
}

#[cfg(test)]
mod tests {
    use super::super::point::points;
    use super::super::tests::{all_changes, right_answers};
    use super::{Answered, Answers, Change, Estimates, FORMULAS, OfNames, Through, WAYS};
    use crate::check::candidate::CAREFUL;
    use crate::test_beam::Family;
    use std::collections::HashSet;

    /// The estimates are the effects of the changed formulas.
    #[test]
    fn effects_are_those_of_the_changed_formulas() {
        let samples = right_answers(&[Family::Hermite]);
        let points: Vec<_> = points(&samples).into_iter().step_by(40).collect();
        let needed = (0..FORMULAS.names.0.len()).collect();
        let answered = points.iter().flat_map(Answered::all);
        let results: Vec<Answers> =
            answered.map(|of| Answers::new(of.answer.output, [true; WAYS], vec![of])).collect();
        // Both kinds of estimates, and those that are not zero.
        let (mut equal, mut affected) = ([0; 2], [0; 2]);
        // One change of each set of names.
        let mut sets = HashSet::new();
        let is_tried = |change: &&&Change| {
            change.entries.is_none() && sets.insert((change.names(), Through::of(change)))
        };
        for change in all_changes().iter().filter(is_tried) {
            let of_names = OfNames::new(change.names(), Through::of(change), &results);
            // What is the same in several ways of writing is estimated once, to the rounding of all of them.
            let mut estimates = Estimates::new(change, &of_names);
            for point in &points {
                let changed: [_; WAYS] = std::array::from_fn(|way| point.changed(way, change, needed));
                let is_here = |(_, of): &(usize, &Answers)| std::ptr::eq(of.all[0].point, point);
                for (place, of) in results.iter().enumerate().filter(is_here) {
                    let effects: [_; WAYS] = std::array::from_fn(|way| {
                        let [before, after] =
                            [of.output.of(&point.values[way][..]), of.output.of(&changed[way])];
                        (after.value - before.value, CAREFUL * (before.bound + after.bound))
                    });
                    let allowed =
                        effects.iter().map(|of| of.1).filter(|of| of.is_finite()).fold(0.0, f64::max);
                    for (way, (found, _)) in effects.into_iter().enumerate() {
                        let effect = estimates.effect((of, place), 0, way);
                        let is_equal =
                            (effect - found).abs() <= allowed || !found.is_finite() || effect.is_nan();
                        assert!(is_equal, "{}, way {way}: {effect:e}, {found:e}", change.words());
                        let kind = usize::from(estimates.is_sum(way, place));
                        equal[kind] += 1;
                        affected[kind] += u32::from(found.abs() > 1e3 * allowed && !effect.is_nan());
                    }
                }
            }
        }
        assert!(equal.iter().all(|count| *count > 10_000), "{equal:?}");
        assert!(affected.iter().all(|count| *count > 500), "{affected:?}");
    }
}
