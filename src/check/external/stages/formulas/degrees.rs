//! What follows from changed formulas, and the degree of it in them.

use super::change::Change;
use super::list::FORMULAS;
use super::names::Set;
use super::tree::{Name, Op, Tree};

/// What has other values with a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Through {
    /// All that follows.
    All,
    /// The derivatives that follow.
    Derivatives,
    /// What is changed.
    Nothing,
}

impl Through {
    pub(super) const COUNT: usize = 3;

    pub(super) fn of(change: &Change) -> Self {
        match (change.is_stored, change.is_of_derivatives) {
            (true, _) => Self::Nothing,
            (_, true) => Self::Derivatives,
            _ => Self::All,
        }
    }

    /// Whether a name that follows has another value.
    pub(super) fn has(self, name: Name) -> bool {
        match self {
            Self::All => true,
            Self::Derivatives => FORMULAS.is_differentiated(name),
            Self::Nothing => false,
        }
    }
}

/// These names and all that follows from them, if something does.
pub(super) fn affected(way: usize, names: Set, through: Through) -> Set {
    if through == Through::Nothing {
        return Set::default();
    }
    FORMULAS.relations[way].following(names)
}

/// What is used in the formulas of these names.
pub(super) fn used(way: usize, names: Set) -> Set {
    names.names().fold(Set::default(), |all, name| all.or(FORMULAS.relations[way].uses[name]))
}

/// The degree of each result in these names, unless one of them follows from another.
pub(super) fn degrees(way: usize, names: Set, through: Through) -> Option<[u8; Set::NAMES]> {
    let mut degrees = [0; Set::NAMES];
    names.names().for_each(|name| degrees[name] = 1);
    let is_other = |name: &Name| names.has(*name) || through.has(*name);
    let follow = affected(way, names, through).names().filter(|name| *name >= FORMULAS.inputs);
    for name in follow.filter(is_other) {
        let degree = degree(&FORMULAS.step(way, name).tree, &degrees);
        if !names.has(name) {
            degrees[name] = degree;
        } else if degree > 0 {
            return None;
        }
    }
    Some(degrees)
}

/// The degree of a formula in some names, of which these are the degrees: 0, 1, or 2 for all others.
fn degree(tree: &Tree, degrees: &[u8; Set::NAMES]) -> u8 {
    let of = |i: usize| degree(&tree.of[i], degrees);
    let all = 0..tree.of.len();
    let only_constant = |degree: u8| if degree > 0 { 2 } else { 0 };
    let found = match &tree.op {
        Op::Number(_) => 0,
        Op::Name(name) => degrees[*name],
        Op::Product(divides) => all.map(|i| if divides.has(i) { only_constant(of(i)) } else { of(i) }).sum(),
        Op::Dot | Op::Cross => all.map(of).sum(),
        Op::Sum(_) | Op::Axes(_) => all.map(of).max().unwrap_or(0),
        Op::Root | Op::Single => only_constant(of(0)),
        Op::Less => only_constant(of(0).max(of(1))),
        Op::If => only_constant(of(0)).max(of(1)).max(of(2)),
    };
    found.min(2)
}
