//! The values of all formulas, right and with a change.

use super::change::Change;
use super::entries::Entries;
use super::list::{FORMULAS, Formulas};
use super::names::{Relations, Set, Step};
use super::operations::value;
use super::point::Point;
use super::tree::Name;
use super::values::{Number, Value, Values};
use std::num::NonZeroU16;

/// The values of some names.
type OfNames<'a> = &'a [(Name, Value)];

impl Formulas {
    /// The values of the names that are `needed`. They follow from the inputs. `known` are the values of conditions that are open
    /// within rounding.
    pub(super) fn values<S: Number>(
        &self,
        way: usize,
        inputs: &[Value<S>],
        known: OfNames,
        needed: Set,
    ) -> Vec<Value<S>> {
        let (operations, steps) = &self.operations[way];
        let mut values = Vec::new();
        operations.start(inputs, &mut values);
        let needed = self.ways[way].iter().zip(steps).filter(|(step, _)| needed.has(step.name));
        for (Step { name, .. }, steps) in needed {
            operations.run(steps, &mut values);
            values[*name] = or_known(*name, values[*name], known);
        }
        values.truncate(self.names.0.len());
        values
    }

    /// The same from the values in the first way. Only what may differ from them is evaluated.
    pub(super) fn values_in<S: Number>(
        &self,
        way: usize,
        first: &[Value<S>],
        known: OfNames,
        needed: Set,
    ) -> Vec<Value<S>> {
        self.values_from(way, first, (self.relations[way].differ[0], &[]), known, needed)
    }

    /// The same from the values with other inputs.
    pub(super) fn values_after<S: Number>(
        &self,
        way: usize,
        before: &[Value<S>],
        inputs: &[Value<S>],
        known: OfNames,
        needed: Set,
    ) -> Vec<Value<S>> {
        let differ = |(name, value): &(Name, Value<S>)| *value != before[*name];
        let others: Vec<_> = inputs.iter().copied().enumerate().filter(differ).collect();
        self.values_from(way, before, (Set::default(), &others), known, needed)
    }

    /// The same from the values where none is `given`.
    pub(super) fn values_with(
        &self,
        way: usize,
        before: &[Value],
        known: OfNames,
        given: OfNames,
        needed: Set,
    ) -> Vec<Value> {
        let names = given.iter().map(|(name, _)| *name).collect();
        self.values_from(way, before, (Set::default(), given), known, needed.without(names))
    }

    /// The values if some formulas and some values are others.
    fn values_from<S: Number>(
        &self,
        way: usize,
        before: &[Value<S>],
        (formulas, others): (Set, &[(Name, Value<S>)]),
        known: OfNames,
        needed: Set,
    ) -> Vec<Value<S>> {
        let uses = &self.relations[way].uses;
        let (operations, steps) = &self.operations[way];
        let mut values = Vec::new();
        operations.start(before, &mut values);
        let mut names = Set::default();
        for (name, value) in others {
            values[*name] = *value;
            names.add(*name);
        }
        let needed = self.ways[way].iter().zip(steps).filter(|(step, _)| needed.has(step.name));
        for (Step { name, .. }, steps) in needed {
            if formulas.has(*name) || !uses[*name].and(names).is_empty() {
                operations.run(steps, &mut values);
                values[*name] = or_known(*name, values[*name], known);
                if values[*name] != before[*name] {
                    names.add(*name);
                }
            }
        }
        values.truncate(self.names.0.len());
        values
    }

    /// Whether it is a derivative, or made of derivatives; the residual is not.
    pub(super) fn is_differentiated(&self, name: Name) -> bool {
        self.kinds[name].varies != [false; 2] && !self.residual.contains(&name)
    }
}

/// The values in a way of writing with a change.
#[derive(Clone, Debug)]
pub(super) struct Changed<'a> {
    way: usize,
    right: &'a [Value],
    /// The names whose values may be others by the formulas of this way.
    affected: Set,
    /// The names in the formulas of the change.
    used: Set,
    /// Those whose values are others, with their places in `others`.
    places: [Option<NonZeroU16>; Set::NAMES],
    others: Vec<Value>,
}

impl Changed<'_> {
    fn set(&mut self, name: Name, value: Value) {
        if let Some(place) = self.places[name] {
            self.others[usize::from(place.get()) - 1] = value;
        } else {
            self.others.push(value);
            self.places[name] = u16::try_from(self.others.len()).ok().and_then(NonZeroU16::new);
        }
    }

    /// Whether the same values follow in another way of writing: its formulas are the same where the change has an effect,
    /// and so are the values that they use.
    pub(super) fn is_same(&self, point: &Point, way: usize, (change, needed): (&Change, Set)) -> bool {
        let Relations { uses, differ, .. } = &FORMULAS.relations[self.way];
        let is_affected =
            || change.is_stored || FORMULAS.relations[way].affected(change, needed) == self.affected;
        self.affected.and(differ[way]).is_empty() && is_affected() && {
            let used = self.affected.names().fold(self.used, |used, name| used.or(uses[name]));
            used.and(point.unlike(self.way, way)).is_empty()
        }
    }
}

impl Values for Changed<'_> {
    fn at(&self, name: Name) -> Value {
        self.places[name].map_or_else(|| self.right[name], |place| self.others[usize::from(place.get()) - 1])
    }
}

impl Relations {
    /// The names that are needed and may have other values if this change is made. A name whose formula is another one is
    /// not among them.
    fn affected(&self, change: &Change, needed: Set) -> Set {
        self.following(change.names()).and(needed).without(change.new.iter().map(|new| new.name).collect())
    }
}

impl Point<'_> {
    /// The values in a way of writing with other formulas in the place of some. Values that are given stay as they are, and
    /// those that are not `needed`.
    pub(super) fn changed(&self, way: usize, change: &Change, needed: Set) -> Changed<'_> {
        let right = &self.values[way][..];
        let new = change.names();
        let used = new.or(change.uses(new));
        let entries = change.entries.as_ref();
        let put = |name, value| match entries.filter(|of| of.names().any(|of| of == name)) {
            Some(of) => of.put(name, value, self.parts()),
            None => value,
        };
        let list = &*FORMULAS;
        let (places, others) = ([None; Set::NAMES], Vec::new());
        let mut values = Changed { way, right, affected: Set::default(), used, places, others };
        if change.is_stored {
            for new in &change.new {
                values.set(new.name, new.value(right));
            }
            for name in change.entries.iter().flat_map(Entries::names) {
                values.set(name, put(name, right[name]));
            }
            return values;
        }
        let relations = &list.relations[way];
        values.affected = relations.affected(change, needed);
        let mut others = Set::default();
        for new in change.new.iter().filter(|new| new.name < list.inputs) {
            values.set(new.name, new.value(right));
            others.add(new.name);
        }
        let of_entries: Set = change.entries.iter().flat_map(Entries::names).collect();
        let affected = values.affected.or(new.and(needed));
        for name in affected.names().filter(|name| *name >= list.inputs) {
            let other = change.new_of(name);
            let is_given = self.given.iter().any(|(of, _)| *of == name);
            let is_other = other.is_some() || of_entries.has(name);
            let is_same = !is_other && relations.uses[name].and(others).is_empty();
            let is_kept = change.is_of_derivatives && other.is_none() && !list.is_differentiated(name);
            if is_given || is_same || is_kept {
                continue;
            }
            let value = match other {
                Some(new) => new.value(&values),
                None => value(&list.step(way, name).tree, &values),
            };
            let value = put(name, or_known(name, value, &self.sample.inputs.known));
            if value != right[name] {
                values.set(name, value);
                others.add(name);
            }
        }
        if change.is_of_derivatives {
            for new in &change.new {
                values.places[new.name] = None;
            }
        }
        values
    }
}

/// The value of a name, or that which is known of an open condition.
pub(super) fn or_known<S: Number>(name: Name, value: Value<S>, known: &[(Name, Value)]) -> Value<S> {
    let open = || known.iter().find(|(of, _)| *of == name).map(|(_, value)| value.to());
    if value.is_nan() { open().unwrap_or(value) } else { value }
}
