//! A change of the list of formulas.

use super::entries::Entries;
use super::list::{FORMULAS, Formula};
use super::names::{Set, WAYS};
use super::operations::value;
use super::tree::{Name, Tree};
use super::values::{Number, Value, Values};
use super::words::Words;

/// Another formula of a name.
#[derive(Clone, Debug)]
pub(super) struct New {
    pub(super) name: Name,
    pub(super) tree: Tree,
    /// Whether the formula is this one along Delta. Most are, and so they are made once.
    is_along_linear: bool,
}

impl New {
    pub(super) fn of(name: Name, tree: Tree) -> Self {
        Self { name, tree, is_along_linear: false }
    }

    /// The formula along Delta.
    pub(super) fn along_linear(name: Name, tree: Tree) -> Self {
        Self { name, tree, is_along_linear: true }
    }

    /// Its value.
    pub(super) fn value<S: Number>(&self, values: &(impl Values<S> + ?Sized)) -> Value<S> {
        if self.is_along_linear { value(&self.tree, &AlongLinear(values)) } else { value(&self.tree, values) }
    }

    fn each_name(&self, f: &mut impl FnMut(Name)) {
        self.tree.each_name(&mut |name| {
            f(if self.is_along_linear { FORMULAS.name_along_linear(name) } else { name });
        });
    }
}

/// Puts a formula in the place of another, also along Delta.
pub(super) fn put(formula: &Formula, tree: &Tree, new: &mut Vec<New>) {
    new.push(New::of(formula.name, tree.clone()));
    new.extend(formula.linear.map(|linear| New::along_linear(linear, tree.clone())));
}

/// The values of names along Delta.
struct AlongLinear<'a, V: ?Sized>(&'a V);

impl<S, V: Values<S> + ?Sized> Values<S> for AlongLinear<'_, V> {
    fn at(&self, name: Name) -> Value<S> {
        self.0.at(FORMULAS.name_along_linear(name))
    }
}

/// A change of the list.
#[derive(Clone, Debug)]
pub(super) struct Change {
    pub(super) new: Vec<New>,
    /// Whether the values use the right formulas, and only what is differentiated the others.
    pub(super) is_of_derivatives: bool,
    /// Whether later formulas use the right values.
    pub(super) is_stored: bool,
    pub(super) words: Words,
    /// The simplest has the smallest.
    pub(super) cost: u32,
    /// The ways in which the formulas are written so, but for the change.
    pub(super) ways: [bool; WAYS],
    /// Some entries of a gradient or Hessian that are wrong.
    pub(super) entries: Option<Entries>,
}

impl Change {
    pub(super) fn of(words: impl Into<Words>) -> Self {
        let (ways, words) = ([true; WAYS], words.into());
        let new = Vec::new();
        Self { new, is_of_derivatives: false, is_stored: false, words, cost: 0, ways, entries: None }
    }

    /// What is wrong, as a sentence without its full stop.
    pub(super) fn words(&self) -> String {
        self.words.text()
    }

    /// The last name that has another formula.
    pub(super) fn last(&self) -> Option<Name> {
        self.new.iter().map(|new| new.name).max()
    }

    /// The other formula of a name.
    pub(super) fn new_of(&self, name: Name) -> Option<&New> {
        self.new.iter().find(|new| new.name == name)
    }

    /// The names in the other formulas of some results.
    pub(super) fn uses(&self, of: Set) -> Set {
        let mut used = Set::default();
        let new = self.new.iter().filter(|new| of.has(new.name));
        new.for_each(|new| new.each_name(&mut |name| used.add(name)));
        used
    }

    /// What is used in its formulas, and what that follows from.
    pub(super) fn needed(&self) -> Set {
        FORMULAS.needed(self.uses(self.names()))
    }

    /// The names whose formulas or entries are others.
    pub(super) fn names(&self) -> Set {
        let of_entries = self.entries.iter().flat_map(Entries::names);
        self.new.iter().map(|new| new.name).chain(of_entries).collect()
    }
}
