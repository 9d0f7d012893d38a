//! Sets of names, and what follows from a name.

use super::tree::{Name, Tree};

/// The number of ways in which all formulas are written.
pub(super) const WAYS: usize = 10;

/// A set of names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Set([u64; 8]);

impl Set {
    /// The number of names that there may be.
    pub(super) const NAMES: usize = 512;

    #[inline]
    pub(super) fn add(&mut self, name: Name) {
        self.0[name / 64] |= 1 << (name % 64);
    }

    #[inline]
    pub(super) fn has(&self, name: Name) -> bool {
        self.0[name / 64] & (1 << (name % 64)) != 0
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        // Faster than a comparison of both.
        self.0.iter().fold(0, |all, bits| all | bits) == 0
    }

    #[inline]
    pub(super) fn or(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] | other.0[i]))
    }

    #[inline]
    pub(super) fn and(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] & other.0[i]))
    }

    #[inline]
    pub(super) fn without(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] & !other.0[i]))
    }

    /// The names, in their order.
    pub(super) fn names(self) -> impl Iterator<Item = Name> {
        self.0.into_iter().enumerate().flat_map(|(i, mut bits)| {
            std::iter::from_fn(move || {
                let bit = (bits != 0).then(|| bits.trailing_zeros() as usize)?;
                bits &= bits - 1;
                Some(64 * i + bit)
            })
        })
    }
}

impl FromIterator<Name> for Set {
    fn from_iter<I: IntoIterator<Item = Name>>(names: I) -> Self {
        let mut set = Self::default();
        names.into_iter().for_each(|name| set.add(name));
        set
    }
}

/// For some names another one, such as that of the other beam.
#[derive(Debug, Default)]
pub(super) struct Others(Vec<Option<Name>>);

impl Others {
    pub(super) fn insert(&mut self, name: Name, other: Name) {
        self.0.resize(self.0.len().max(name + 1), None);
        self.0[name] = Some(other);
    }

    pub(super) fn get(&self, name: Name) -> Option<Name> {
        self.0.get(name).copied().flatten()
    }
}

/// A step of the evaluation.
pub(super) struct Step {
    pub(super) name: Name,
    pub(super) tree: Tree,
    pub(super) uses: Vec<Name>,
}

/// How names depend on each other in one way of writing.
#[derive(Clone, Debug, Default)]
pub(super) struct Relations {
    /// The names in the formula of each name.
    pub(super) uses: Vec<Set>,
    /// The names that follow from each name, and itself.
    pub(super) follows: Vec<Set>,
    /// The names whose formula is not that of each way.
    pub(super) differ: [Set; WAYS],
}

impl Relations {
    /// `all` are the steps of all ways.
    pub(super) fn new(all: &[Vec<Step>; WAYS], names: usize, way: usize) -> Self {
        let steps = &all[way];
        let mut uses = vec![Set::default(); names];
        let mut follows: Vec<Set> = (0..uses.len()).map(|name| Set::from_iter([name])).collect();
        for step in steps {
            uses[step.name] = step.uses.iter().copied().collect();
        }
        for step in steps.iter().rev() {
            let of_step = follows[step.name];
            step.uses.iter().for_each(|name| follows[*name] = follows[*name].or(of_step));
        }
        let differ = |other: usize| {
            let pairs = steps.iter().zip(&all[other]);
            pairs.filter(|(one, other)| one.tree != other.tree).map(|(one, _)| one.name).collect()
        };
        Self { uses, follows, differ: std::array::from_fn(differ) }
    }

    /// These names, and all that follows from them.
    pub(super) fn following(&self, names: Set) -> Set {
        names.names().fold(names, |all, name| all.or(self.follows[name]))
    }
}
