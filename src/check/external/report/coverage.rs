//! What a program answered, of what it was asked.

use crate::check::external::answered::answered;
use crate::check::external::answers::Answers;
use crate::check::external::only::{self, Only, PartKey};
use crate::check::external::vectors::Vector;
use crate::linearization::Quantity;
use std::collections::{BTreeMap, BTreeSet};

/// The parts that a program answered, of those that it was asked for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// The parts that it was asked for.
    required: BTreeSet<PartKey>,
    /// Whether the program states what it answers.
    is_stated: bool,
    /// The cases at which each part was answered.
    parts: BTreeMap<PartKey, u64>,
    /// The answered cases.
    cases: u64,
    /// The last answered case in the file, and its line.
    last: Option<(usize, String)>,
    /// The line of the first case that was not answered.
    first_missing: Option<usize>,
}

impl Coverage {
    pub(super) fn new(only: &Only, is_element: bool) -> Self {
        let is_stated = *only != Only::default();
        Self { required: only.required(is_element), is_stated, ..Self::default() }
    }

    pub(super) fn add(&mut self, vector: &Vector, line: usize, answers: &Answers) {
        if vector.element.is_some() && !self.is_stated {
            // The geometry is asked for only beside the element.
            self.required = only::of_element();
        }
        self.cases += 1;
        for part in answered(answers) {
            *self.parts.entry(part).or_default() += 1;
        }
        if self.last.as_ref().is_none_or(|(last, _)| *last < line) {
            self.last = Some((line, vector.id.clone()));
        }
    }

    pub(super) fn add_missing(&mut self, line: usize) {
        self.first_missing = Some(self.first_missing.map_or(line, |first| first.min(line)));
    }

    /// Whether the program states what it answers.
    pub fn is_stated(&self) -> bool {
        self.is_stated
    }

    /// The last answered case, if no case before it is missing.
    pub fn ends_after(&self) -> Option<&str> {
        let (last, id) = self.last.as_ref()?;
        (self.first_missing? > *last && *last > 0).then_some(id)
    }

    /// The parts that were asked for and are not answered at every answered case, each with the count of cases at which
    /// it is answered.
    pub fn open_parts(&self) -> BTreeMap<PartKey, u64> {
        let counts = self.required.iter().map(|part| (*part, self.parts.get(part).copied().unwrap_or(0)));
        counts.filter(|(_, count)| *count < self.cases).collect()
    }

    /// The parts that are answered at some cases and not at others, with the count of cases at which they are.
    pub fn partly(&self) -> Vec<(String, u64)> {
        let partly = self.parts.iter().filter(|(_, count)| **count < self.cases);
        partly.map(|(part, count)| (only::words(&[*part].into()).join(", "), *count)).collect()
    }

    /// Whether residual and tangent of a contact element are asked for, and not the geometry.
    pub fn is_of_element(&self) -> bool {
        self.required.iter().all(|(_, _, name)| only::is_of_element(name))
    }

    /// The answered cases.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// The words of the entry `only` for what is answered at some case.
    pub fn words(&self) -> Vec<String> {
        only::words(&self.parts.keys().copied().collect())
    }

    /// The number of quantities of which all, some and no parts are answered.
    pub fn quantities(&self) -> [usize; 3] {
        let mut counts = [0; 3];
        for quantity in Quantity::ALL {
            let of =
                self.parts.keys().filter(|(_, known, name)| *known == quantity && !only::is_of_element(name));
            counts[match of.count() {
                3 => 0,
                0 => 2,
                _ => 1,
            }] += 1;
        }
        counts
    }
}
