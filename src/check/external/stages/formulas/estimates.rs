//! The effect of one change on answers, without rounding.

use super::change::Change;
use super::degrees::Through;
use super::derivatives::derivatives;
use super::effects::{Answers, OfNames};
use super::evaluation::Changed;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::point::{Answer, Point};
use super::tree::{Name, Tree};
use super::values::{Value, value};
use std::sync::OnceLock;

/// The answer of a sample, with its derivatives by all names in each way of writing.
pub(super) struct Answered<'a> {
    pub(super) point: &'a Point<'a>,
    pub(super) answer: &'a Answer,
    derivatives: [[OnceLock<Vec<Value<f64>>>; WAYS]; Through::COUNT],
}

impl<'a> Answered<'a> {
    pub(super) fn all(point: &'a Point<'a>) -> Vec<Self> {
        let of = |answer| Self { point, answer, derivatives: Default::default() };
        point.answers.iter().map(of).collect()
    }

    /// The derivatives of the answer by all names.
    fn derivatives(&self, way: usize, through: Through) -> &[Value<f64>] {
        let Point { given, .. } = self.point;
        self.derivatives[through as usize][way]
            .get_or_init(|| derivatives(through, self.point.estimates(way), given, (self.answer.output, way)))
    }
}

/// Something at a sample, in a way of writing.
type At<'a, T> = (&'a Point<'a>, usize, T);

/// What a change does at some samples. Most is the same in all ways of writing.
pub(super) struct Estimates<'a> {
    change: &'a Change,
    /// The names that are changed.
    names: Set,
    /// The names in the formulas of these.
    uses: Set,
    /// What these follow from.
    needed: Set,
    of_names: &'a OfNames,
    /// How the values of what is changed differ.
    differences: Vec<At<'a, Vec<Value<f64>>>>,
    /// The values that a result follows from.
    values: Vec<At<'a, (Name, Changed<'a, f64>)>>,
}

impl<'a> Estimates<'a> {
    pub(super) fn new(change: &'a Change, of_names: &'a OfNames) -> Self {
        let names = change.names();
        let uses = change.uses(names);
        let (needed, differences, values) = (FORMULAS.needed(uses), Vec::new(), Vec::new());
        Self { change, names, uses, needed, of_names, differences, values }
    }

    /// What the change adds to an answer, which is one to the result in this place; not a number if this is not known.
    pub(super) fn effect(
        &mut self,
        of: &Answered<'a>,
        way: usize,
        (result, place): (&Answers, usize),
    ) -> f64 {
        if self.is_sum(way, place) { self.sum(of, way) } else { self.difference(of, way, (result, place)) }
    }

    /// Whether a result is of first degree in what is changed. What stands in the place of a formula must have its right value.
    pub(super) fn is_sum(&self, way: usize, place: usize) -> bool {
        self.of_names.of_first_degree[place][way] && self.uses.and(self.of_names.affected[way]).is_empty()
    }

    fn sum(&mut self, of: &Answered<'a>, way: usize) -> f64 {
        let derivatives = of.derivatives(way, Through::of(self.change));
        let new = &self.change.new;
        if !new.iter().any(|(name, _)| !derivatives[*name].is_zero()) {
            return 0.0;
        }
        let (point, used) = (of.point, self.uses.or(self.names));
        let is_same = |(other, before, _): &At<_>| {
            std::ptr::eq(*other, point) && used.and(point.unlike(way, *before)).is_empty()
        };
        let at = self.differences.iter().position(is_same).unwrap_or_else(|| {
            let right = point.estimates(way);
            let of = |(name, tree): &(Name, Tree)| value(tree, right).plus(right[*name].negative());
            self.differences.push((point, way, new.iter().map(of).collect()));
            self.differences.len() - 1
        });
        let of = new.iter().zip(&self.differences[at].2);
        let of = of.filter(|((name, _), _)| !derivatives[*name].is_zero());
        of.map(|((name, _), difference)| derivatives[*name].along(*difference).number()).sum()
    }

    fn difference(&mut self, of: &Answered<'a>, way: usize, (result, place): (&Answers, usize)) -> f64 {
        let (point, output) = (of.point, of.answer.output);
        let OfNames { affected, used, alike, .. } = self.of_names;
        let is_given = point.given.iter().any(|(name, _)| *name == output.name);
        if is_given || !affected[way].has(output.name) {
            return 0.0;
        }
        let used = self.uses.or(self.names).or(used[way]);
        // What the formulas of the change use may be changed, too.
        let here = affected[way].and(self.needed);
        let is_same = |(other, before, (name, _)): &At<(Name, _)>| {
            *name == output.name
                && std::ptr::eq(*other, point)
                && alike[place][way] & (1 << before) != 0
                && here == affected[*before].and(self.needed)
                && here.and(FORMULAS.relations[way].differ[*before]).is_empty()
                && used.and(point.unlike(way, *before)).is_empty()
        };
        let at = self.values.iter().position(is_same).unwrap_or_else(|| {
            let changed = point.estimated(way, (self.change, self.names), result.needed.or(self.needed));
            self.values.push((point, way, (output.name, changed)));
            self.values.len() - 1
        });
        let (_, _, (_, changed)) = &self.values[at];
        output.of(changed) - output.of(point.estimates(way))
    }
}
