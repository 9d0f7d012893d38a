//! The effect of one change on answers, without rounding.

use super::change::Change;
use super::degrees::Through;
use super::derivatives::derivatives;
use super::effects::{Answers, OfNames};
use super::folded::Folded;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::point::{Answer, Point};
use super::tree::Name;
use super::values::Value;
use std::cell::OnceCell;
use std::collections::HashMap;
use std::sync::{Arc, OnceLock, RwLock};

/// The answer of a sample, with its derivatives by all names in each way of writing.
pub(super) struct Answered<'a> {
    pub(super) point: &'a Point<'a>,
    pub(super) answer: &'a Answer,
    /// In each way of writing.
    wanted: [[f64; 2]; WAYS],
    derivatives: [[OnceLock<Vec<Value<f64>>>; WAYS]; Through::COUNT],
    /// The formulas after changes of some names, by what is affected.
    folded: [RwLock<HashMap<Affected, Arc<Folded<'a>>>>; WAYS],
}

/// The names of a change, what has other values with it, and what of this is evaluated.
type Affected = (Set, Through, Set);

impl<'a> Answered<'a> {
    pub(super) fn all(point: &'a Point<'a>) -> Vec<Self> {
        let of = |answer| {
            let wanted = std::array::from_fn(|way| point.wanted(answer, way));
            Self { point, answer, wanted, derivatives: Default::default(), folded: Default::default() }
        };
        point.answers.iter().map(of).collect()
    }

    /// Whether it may be explained by what adds so much to the right one, or whether this is not known.
    pub(super) fn is_near(&self, way: usize, effect: f64) -> bool {
        let [wanted, most] = self.wanted[way];
        let left = wanted - effect;
        left.is_nan() || left.abs() <= most
    }

    /// The derivatives of the answer by all names.
    pub(super) fn derivatives(&self, way: usize, through: Through) -> &[Value<f64>] {
        let Point { given, .. } = self.point;
        self.derivatives[through as usize][way]
            .get_or_init(|| derivatives(through, self.point.estimates(way), given, (self.answer.output, way)))
    }

    /// The formulas of a way of writing after a change.
    fn folded(&self, way: usize, (names, through, evaluated): Affected) -> Arc<Folded<'a>> {
        let of = (names, through, evaluated);
        let known = self.folded[way].read().ok().and_then(|known| known.get(&of).cloned());
        known.unwrap_or_else(|| {
            let folded = Arc::new(Folded::new(self.point, way, (names, through), evaluated));
            if let Ok(mut known) = self.folded[way].write() {
                known.insert(of, Arc::clone(&folded));
            }
            folded
        })
    }
}

/// Something at a sample, of which this is the address, in a way of writing.
type At<T> = (usize, usize, T);

fn address(point: &Point) -> usize {
    std::ptr::from_ref(point).addr()
}

/// What a change does at some samples. Most is the same in all ways of writing.
pub(super) struct Estimates<'a> {
    change: &'a Change,
    /// The names in its formulas.
    uses: Set,
    /// The names that are changed, and those in their formulas.
    used: Set,
    /// What these follow from.
    needed: OnceCell<Set>,
    of_names: &'a OfNames,
    /// The points and ways for which it is known how the values of what is changed differ.
    differences: Vec<(usize, usize)>,
    /// By how much, one after the other.
    by: Vec<Value<f64>>,
    /// The effects on answers by these differences.
    sums: Vec<At<f64>>,
    /// The other values of results.
    others: Vec<At<(Name, Option<Value<f64>>)>>,
    /// Memory of the evaluation.
    values: Vec<Value<f64>>,
}

impl<'a> Estimates<'a> {
    pub(super) fn new(change: &'a Change, of_names: &'a OfNames) -> Self {
        let names = change.names();
        let uses = change.uses(names);
        let used = uses.or(names);
        let (needed, differences, by, sums, others, values) = Default::default();
        Self { change, uses, used, needed, of_names, differences, by, sums, others, values }
    }

    /// What the change adds to an answer, which is one to the result in this place; not a number if this is not known.
    pub(super) fn effect(
        &mut self,
        (result, place): (&Answers<'_>, usize),
        answer: usize,
        way: usize,
    ) -> f64 {
        let of = &result.all[answer];
        if !self.is_sum(way, place) {
            return self.difference(of, way, (result, place));
        }
        let first = self.of_names.first_like((result, place), answer, way);
        let is_same = first == way || self.used.and(of.point.unlike(way, first)).is_empty();
        let way = if is_same { first } else { way };
        let at = std::ptr::from_ref(of).addr();
        if let Some((.., sum)) = self.sums.iter().find(|(of, other, _)| (*of, *other) == (at, way)) {
            return *sum;
        }
        let sum = self.sum(of, way);
        self.sums.push((at, way, sum));
        sum
    }

    /// Whether a result is of first degree in what is changed. What stands in the place of a formula must have its right value.
    pub(super) fn is_sum(&self, way: usize, place: usize) -> bool {
        self.of_names.of_first_degree[place][way] && self.uses.and(self.of_names.affected[way]).is_empty()
    }

    fn sum(&mut self, of: &Answered<'_>, way: usize) -> f64 {
        let derivatives = of.derivatives(way, Through::of(self.change));
        let new = &self.change.new;
        if !new.iter().any(|new| !derivatives[new.name].is_zero()) {
            return 0.0;
        }
        let (point, used) = (of.point, self.used);
        let is_same = |(other, before): &(usize, usize)| {
            *other == address(point) && used.and(point.unlike(way, *before)).is_empty()
        };
        let known = self.differences.iter().position(is_same);
        let at = known.unwrap_or_else(|| {
            let right = point.estimates(way);
            self.by.extend(new.iter().map(|new| new.value(right).plus(right[new.name].negative())));
            self.differences.push((address(point), way));
            self.differences.len() - 1
        });
        let of = new.iter().zip(&self.by[at * new.len()..]);
        let of = of.filter(|(new, _)| !derivatives[new.name].is_zero());
        of.map(|(new, difference)| derivatives[new.name].along(*difference).number()).sum()
    }

    fn difference(&mut self, of: &Answered<'_>, way: usize, (result, place): (&Answers<'_>, usize)) -> f64 {
        let (point, output) = (of.point, of.answer.output);
        let OfNames { affected, used, alike, .. } = self.of_names;
        let is_given = point.given.iter().any(|(name, _)| *name == output.name);
        if is_given || !affected[way].has(output.name) {
            return 0.0;
        }
        let needed = *self.needed.get_or_init(|| FORMULAS.needed(self.uses));
        let used = self.used.or(used[way]);
        // What the formulas of the change use may be changed, too.
        let here = affected[way].and(needed);
        let is_same = |(other, before, (name, _)): &&At<(Name, _)>| {
            *name == output.name
                && *other == address(point)
                && alike[place][way] & (1 << before) != 0
                && here == affected[*before].and(needed)
                && here.and(FORMULAS.relations[way].differ[*before]).is_empty()
                && used.and(point.unlike(way, *before)).is_empty()
        };
        let known = self.others.iter().find(is_same).map(|(_, _, (_, other))| *other);
        let other = known.unwrap_or_else(|| {
            let evaluated = affected[way].and(result.needed.or(needed));
            let folded = of.folded(way, (self.of_names.names, Through::of(self.change), evaluated));
            let other = folded.value(self.change, output.name, &mut self.values);
            self.others.push((address(point), way, (output.name, other)));
            other
        });
        other.map_or(0.0, |other| other.component(output.axis) - output.of(point.estimates(way)))
    }
}
