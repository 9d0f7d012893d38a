//! A change of the list of formulas.

use super::entries::Entries;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::tree::{Name, Tree};
use super::words::Words;

/// A change of the list.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// The other formulas, by the names of their results.
    pub(super) new: Vec<(Name, Tree)>,
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

    /// The names in the other formulas of some results.
    pub(super) fn uses(&self, of: Set) -> Set {
        let mut used = Set::default();
        let new = self.new.iter().filter(|(name, _)| of.has(*name));
        new.for_each(|(_, tree)| tree.each_name(&mut |name| used.add(name)));
        used
    }

    /// What is used in its formulas, and what that follows from.
    pub(super) fn needed(&self) -> Set {
        FORMULAS.needed(self.uses(self.names()))
    }

    /// The names whose formulas or entries are others.
    pub(super) fn names(&self) -> Set {
        let of_entries = self.entries.iter().flat_map(Entries::names);
        self.new.iter().map(|(name, _)| *name).chain(of_entries).collect()
    }
}
