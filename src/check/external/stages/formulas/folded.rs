//! The formulas that lead from changed names to a result, at one sample. All that does not change is a number in them.

use super::change::Change;
use super::degrees::Through;
use super::evaluation::or_known;
use super::list::FORMULAS;
use super::names::Set;
use super::operations::{At, Operations, Place};
use super::point::Point;
use super::tree::Name;
use super::values::{Value, Values};
use std::ops::Range;

/// A part of the evaluation.
#[derive(Debug)]
enum Part {
    /// The formula of the change.
    Changed(Name, Place),
    Steps(Range<usize>),
    /// A condition that may be open within rounding.
    Open(Name, Place),
}

/// The formulas after a change of some names.
#[derive(Debug)]
pub(super) struct Folded<'a> {
    right: &'a [Value<f64>],
    known: &'a [(Name, Value)],
    operations: Operations,
    parts: Vec<Part>,
    /// The places of names that may have other values, by name.
    places: Vec<(Name, Place)>,
    /// The values before the evaluation.
    start: Vec<Value<f64>>,
    /// The names that are right in the answers.
    answered_right: Set,
}

impl<'a> Folded<'a> {
    /// Of the names that are `affected`, those that are needed for the result and for the formulas of the change.
    pub(super) fn new(
        point: &'a Point<'a>,
        way: usize,
        (names, through): (Set, Through),
        affected: Set,
    ) -> Self {
        let list = &*FORMULAS;
        let (right, known) = (point.estimates(way), &point.sample.inputs.known[..]);
        let mut operations = Operations::folded();
        let (mut parts, mut places) = (Vec::new(), Vec::new());
        for name in affected.names().filter(|name| !point.given.iter().any(|(of, _)| of == name)) {
            if names.has(name) {
                let place = operations.new_place();
                parts.push(Part::Changed(name, place));
                places.push((name, place));
            } else if name >= list.inputs && through.has(name) {
                let first = operations.len();
                let at = |of: Name| at(of, &places).map_or(At::Known(right[of]), At::Place);
                // What is known is right.
                let At::Place(place) = operations.steps_of(&list.step(way, name).tree, &at) else { continue };
                match parts.last_mut() {
                    Some(Part::Steps(steps)) => steps.end = operations.len(),
                    _ => parts.push(Part::Steps(first..operations.len())),
                }
                if known.iter().any(|(of, _)| *of == name) {
                    parts.push(Part::Open(name, place));
                }
                places.push((name, place));
            }
        }
        let mut start = operations.take_start();
        // Until it is evaluated, a name has its right value: a formula may use its own name.
        for (name, place) in &places {
            start[usize::from(*place)] = right[*name];
        }
        let answered_right = if through == Through::Derivatives { names } else { Set::default() };
        Self { right, known, operations, parts, places, start, answered_right }
    }

    /// The value of the result after a change, if it may be another one. `values` are written over.
    pub(super) fn value(
        &self,
        change: &Change,
        result: Name,
        values: &mut Vec<Value<f64>>,
    ) -> Option<Value<f64>> {
        let place = at(result, &self.places).filter(|_| !self.answered_right.has(result))?;
        values.clear();
        values.extend_from_slice(&self.start);
        for part in &self.parts {
            match part {
                Part::Changed(name, place) => {
                    values[usize::from(*place)] = self.changed(*name, change, values);
                }
                Part::Steps(steps) => self.operations.run(steps, values),
                Part::Open(name, place) => {
                    let place = usize::from(*place);
                    values[place] = or_known(*name, values[place], self.known);
                }
            }
        }
        Some(values[usize::from(place)])
    }

    fn changed(&self, name: Name, change: &Change, values: &[Value<f64>]) -> Value<f64> {
        let Some(new) = change.new_of(name) else { return self.right[name] };
        if name < FORMULAS.inputs {
            return new.value(self.right);
        }
        or_known(name, new.value(&Here { of: self, values }), self.known)
    }
}

/// Where a name has its value, if it may be another one.
#[inline]
fn at(name: Name, places: &[(Name, Place)]) -> Option<Place> {
    places.binary_search_by_key(&name, |(of, _)| *of).ok().map(|i| places[i].1)
}

/// The values during the evaluation.
struct Here<'a> {
    of: &'a Folded<'a>,
    values: &'a [Value<f64>],
}

impl Values<f64> for Here<'_> {
    #[inline]
    fn at(&self, name: Name) -> Value<f64> {
        at(name, &self.of.places).map_or(self.of.right[name], |place| self.values[usize::from(place)])
    }
}
