//! The values of all formulas, right and with a change.

use super::change::Change;
use super::entries::Entries;
use super::list::{FORMULAS, Formulas};
use super::names::{Relations, Set, Step};
use super::point::Point;
use super::tree::{Name, Tree};
use super::values::{Number, Value, Values, value};
use crate::number::RunningError;
use std::num::NonZeroU16;

impl Formulas {
    /// The values of the names that are `needed`. They follow from the inputs, and from values that are `given`. `known` are
    /// the values of conditions that are open within rounding.
    pub(super) fn values<S: Number>(
        &self,
        way: usize,
        inputs: &[Value<S>],
        known: &[(Name, Value)],
        given: &[(Name, Value)],
        needed: Set,
    ) -> Vec<Value<S>> {
        let mut values = Vec::with_capacity(self.names.0.len());
        values.extend_from_slice(inputs);
        values.resize(self.names.0.len(), Value::from(0.0));
        for Step { name, tree, .. } in self.ways[way].iter().filter(|step| needed.has(step.name)) {
            let fixed = given.iter().find(|(of, _)| of == name).map(|(_, value)| value.to());
            values[*name] = fixed.unwrap_or_else(|| evaluated(*name, tree, &values[..], known));
        }
        values
    }

    /// The same from the values in the first way. Only what may differ from them is evaluated.
    pub(super) fn values_in<S: Number>(
        &self,
        way: usize,
        first: &[Value<S>],
        known: &[(Name, Value)],
        given: &[(Name, Value)],
        needed: Set,
    ) -> Vec<Value<S>> {
        let Relations { uses, differ, .. } = &self.relations[way];
        let mut values = first.to_vec();
        let mut others = Set::default();
        for Step { name, tree, .. } in self.ways[way].iter().filter(|step| needed.has(step.name)) {
            let is_same = !differ[0].has(*name) && uses[*name].and(others).is_empty();
            if is_same || given.iter().any(|(of, _)| of == name) {
                continue;
            }
            let value = evaluated(*name, tree, &values[..], known);
            if value != values[*name] {
                values[*name] = value;
                others.add(*name);
            }
        }
        values
    }

    /// Whether it is a derivative, or made of derivatives; the residual is not.
    pub(super) fn is_differentiated(&self, name: Name) -> bool {
        self.kinds[name].varies != [false; 2] && !self.residual.contains(&name)
    }
}

/// The values in a way of writing with a change.
#[derive(Clone, Debug)]
pub(super) struct Changed<'a, S = RunningError> {
    way: usize,
    right: &'a [Value<S>],
    /// The names whose values may be others by the formulas of this way.
    affected: Set,
    /// The names in the formulas of the change.
    used: Set,
    /// Those whose values are others, with their places in `others`.
    places: [Option<NonZeroU16>; Set::NAMES],
    others: Vec<Value<S>>,
}

impl<S: Number> Changed<'_, S> {
    fn set(&mut self, name: Name, value: Value<S>) {
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

impl<S: Number> Values<S> for Changed<'_, S> {
    fn at(&self, name: Name) -> Value<S> {
        self.places[name].map_or_else(|| self.right[name], |place| self.others[usize::from(place.get()) - 1])
    }
}

impl Relations {
    /// The names that are needed and may have other values if this change is made. A name whose formula is another one is
    /// not among them.
    fn affected(&self, change: &Change, needed: Set) -> Set {
        let follow = change.names().names().fold(Set::default(), |all, name| all.or(self.follows[name]));
        follow.and(needed).without(change.new.iter().map(|(name, _)| *name).collect())
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
        self.with_change((way, right, used), (change, new), needed, &put)
    }

    /// The same without rounding. Entries of the change are left out. `names` are those of the change.
    pub(super) fn estimated(
        &self,
        way: usize,
        (change, names): (&Change, Set),
        needed: Set,
    ) -> Changed<'_, f64> {
        let of = (way, self.estimates(way), Set::default());
        self.with_change(of, (change, names), needed, &|_, value| value)
    }

    fn with_change<'a, S: Number>(
        &self,
        (way, right, used): (usize, &'a [Value<S>], Set),
        (change, new): (&Change, Set),
        needed: Set,
        put: &dyn Fn(Name, Value<S>) -> Value<S>,
    ) -> Changed<'a, S> {
        let list = &*FORMULAS;
        let (places, others) = ([None; Set::NAMES], Vec::new());
        let mut values = Changed { way, right, affected: Set::default(), used, places, others };
        if change.is_stored {
            for (name, tree) in &change.new {
                values.set(*name, value(tree, right));
            }
            for name in change.entries.iter().flat_map(Entries::names) {
                values.set(name, put(name, right[name]));
            }
            return values;
        }
        let relations = &list.relations[way];
        values.affected = relations.affected(change, needed);
        let mut others = Set::default();
        for (name, tree) in change.new.iter().filter(|(name, _)| *name < list.inputs) {
            values.set(*name, value(tree, right));
            others.add(*name);
        }
        let of_entries: Set = change.entries.iter().flat_map(Entries::names).collect();
        let affected = values.affected.or(new.and(needed));
        for name in affected.names().filter(|name| *name >= list.inputs) {
            let other = change.new.iter().find(|(of, _)| *of == name).map(|(_, tree)| tree);
            let is_given = self.given.iter().any(|(of, _)| *of == name);
            let is_other = other.is_some() || of_entries.has(name);
            let is_same = !is_other && relations.uses[name].and(others).is_empty();
            let is_kept = change.is_of_derivatives && other.is_none() && !list.is_differentiated(name);
            if is_given || is_same || is_kept {
                continue;
            }
            let tree = other.unwrap_or_else(|| &list.step(way, name).tree);
            let value = put(name, evaluated(name, tree, &values, &self.sample.inputs.known));
            if value != right[name] {
                values.set(name, value);
                others.add(name);
            }
        }
        if change.is_of_derivatives {
            for (name, _) in &change.new {
                values.places[*name] = None;
            }
        }
        values
    }
}

fn evaluated<S: Number>(
    name: Name,
    tree: &Tree,
    values: &(impl Values<S> + ?Sized),
    known: &[(Name, Value)],
) -> Value<S> {
    let found = value(tree, values);
    let open = || known.iter().find(|(of, _)| *of == name).map(|(_, value)| value.to());
    if found.is_nan() { open().unwrap_or(found) } else { found }
}
