//! Formulas as trees, and their text.

use std::cmp::Ordering;
use std::collections::HashMap;
use std::fmt::Write;
use std::ops::Deref;
use std::sync::Arc;

/// The place of a name in [`Names`].
pub(super) type Name = usize;

/// The names of formulas and inputs.
#[derive(Clone, Debug, Default)]
pub(super) struct Names(pub(super) Vec<String>, HashMap<String, Name>);

impl Names {
    pub(super) fn find(&self, name: &str) -> Option<Name> {
        self.1.get(name).copied()
    }

    /// The place of a name, which is new if it is not known.
    pub(super) fn add(&mut self, name: &str) -> Name {
        self.find(name).unwrap_or_else(|| {
            self.0.push(name.to_owned());
            self.1.insert(name.to_owned(), self.0.len() - 1);
            self.0.len() - 1
        })
    }
}

/// What a node does with its branches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Op {
    Number(f64),
    Name(Name),
    /// A sum; whether each term is subtracted.
    Sum(Flags),
    /// A product; whether each factor is divided by.
    Product(Flags),
    Dot,
    Cross,
    Root,
    /// The number or vector in single precision.
    Single,
    /// The vector with other components: their place in [`AXES`](super::axes::AXES).
    Axes(usize),
    /// 1 if the first is less than the second, else 0.
    Less,
    /// The second if the first is not zero, else the third.
    If,
}

/// Up to 63 flags: their bits, and one more that is set after them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flags(u64);

impl Flags {
    #[inline]
    pub(super) fn len(self) -> usize {
        63 - self.0.leading_zeros() as usize
    }

    #[inline]
    pub(super) fn has(self, i: usize) -> bool {
        self.0 & (1 << i) != 0
    }

    pub(super) fn iter(self) -> impl Iterator<Item = bool> {
        (0..self.len()).map(move |i| self.has(i))
    }
}

impl FromIterator<bool> for Flags {
    fn from_iter<I: IntoIterator<Item = bool>>(all: I) -> Self {
        let (bits, end) = all
            .into_iter()
            .fold((0, 1), |(bits, next), flag| (if flag { bits | next } else { bits }, next << 1));
        Self(bits | end)
    }
}

/// The branches of a tree. They are shared by the many trees that differ in one place.
#[derive(Clone, Debug, Default)]
pub(super) struct Branches(Option<Arc<[Tree]>>);

impl Deref for Branches {
    type Target = [Tree];

    #[inline]
    fn deref(&self) -> &[Tree] {
        self.0.as_deref().unwrap_or_default()
    }
}

impl PartialEq for Branches {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other) || one == other,
            (None, None) => true,
            _ => false,
        }
    }
}

impl FromIterator<Tree> for Branches {
    fn from_iter<I: IntoIterator<Item = Tree>>(all: I) -> Self {
        let all: Arc<[Tree]> = all.into_iter().collect();
        Self(if all.is_empty() { None } else { Some(all) })
    }
}

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tree {
    pub(super) op: Op,
    pub(super) of: Branches,
}

impl Tree {
    pub(super) fn new(op: Op, of: impl IntoIterator<Item = Self>) -> Self {
        Self { op, of: of.into_iter().collect() }
    }

    pub(super) fn number(value: f64) -> Self {
        Self { op: Op::Number(value), of: Branches::default() }
    }

    pub(super) fn name(name: Name) -> Self {
        Self { op: Op::Name(name), of: Branches::default() }
    }

    pub(super) fn sum(terms: Vec<(bool, Self)>) -> Self {
        let signs = terms.iter().map(|(minus, _)| *minus).collect();
        Self::new(Op::Sum(signs), terms.into_iter().map(|(_, of)| of))
    }

    pub(super) fn product(factors: Vec<(bool, Self)>) -> Self {
        let divides = factors.iter().map(|(divides, _)| *divides).collect();
        Self::new(Op::Product(divides), factors.into_iter().map(|(_, of)| of))
    }

    /// Calls `f` with each name in it.
    pub(super) fn each_name(&self, f: &mut impl FnMut(Name)) {
        if let Op::Name(name) = self.op {
            f(name);
        }
        self.of.iter().for_each(|of| of.each_name(f));
    }

    /// The tree with other names.
    pub(super) fn renamed(&self, f: &impl Fn(Name) -> Name) -> Self {
        self.other(f).unwrap_or_else(|| self.clone())
    }

    /// The tree with other names, if it has some.
    fn other(&self, f: &impl Fn(Name) -> Name) -> Option<Self> {
        if let Op::Name(name) = self.op {
            let other = f(name);
            return (other != name).then(|| Self::name(other));
        }
        let mut of = self.of.iter().enumerate();
        let (first, new) = of.find_map(|(i, of)| Some((i, of.other(f)?)))?;
        let branch = |(i, of): (usize, &Self)| match i.cmp(&first) {
            Ordering::Less => of.clone(),
            Ordering::Equal => new.clone(),
            Ordering::Greater => of.renamed(f),
        };
        Some(Self::new(self.op, self.of.iter().enumerate().map(branch)))
    }

    /// The tree with other trees in the place of names.
    pub(super) fn substituted(&self, f: &impl Fn(Name) -> Option<Self>) -> Self {
        if let Op::Name(name) = self.op {
            return f(name).unwrap_or_else(|| self.clone());
        }
        if self.of.is_empty() {
            return self.clone();
        }
        Self::new(self.op, self.of.iter().map(|of| of.substituted(f)))
    }

    /// The tree with another branch at the end of a path.
    pub(super) fn with(&self, path: &[usize], new: &Self) -> Self {
        let Some((&first, rest)) = path.split_first() else { return new.clone() };
        let branch = |(i, of): (usize, &Self)| if i == first { of.with(rest, new) } else { of.clone() };
        Self::new(self.op, self.of.iter().enumerate().map(branch))
    }

    /// The path to the first branch that is meant.
    pub(super) fn find(&self, is_meant: &dyn Fn(&Self) -> bool) -> Option<Vec<usize>> {
        if is_meant(self) {
            return Some(vec![]);
        }
        let found = |(i, of): (usize, &Self)| of.find(is_meant).map(|path| [vec![i], path].concat());
        self.of.iter().enumerate().find_map(found)
    }

    /// Whether both are alike but for names, numbers and signs.
    pub(super) fn is_congruent(&self, other: &Self) -> bool {
        let is_alike = match (&self.op, &other.op) {
            (Op::Sum(one), Op::Sum(other)) => one.len() == other.len(),
            (one, other) => std::mem::discriminant(one) == std::mem::discriminant(other),
        };
        let mut branches = self.of.iter().zip(other.of.iter());
        is_alike && self.of.len() == other.of.len() && branches.all(|(one, other)| one.is_congruent(other))
    }

    /// The text of the formula.
    pub(super) fn text(&self, names: &Names) -> String {
        let mut text = String::new();
        self.write(names, 0, &mut text);
        text
    }

    /// How strongly the node binds: a choice 0, a sum 1, a product 2, a scalar product 3, all else 4.
    fn strength(&self) -> u8 {
        match self.op {
            Op::If | Op::Less => 0,
            Op::Sum(_) => 1,
            Op::Product(_) => 2,
            Op::Dot => 3,
            _ => 4,
        }
    }

    fn write(&self, names: &Names, least: u8, to: &mut String) {
        let needs = self.strength() < least;
        to.push_str(if needs { "(" } else { "" });
        let call = |name: &str, to: &mut String| {
            to.push_str(name);
            for (i, of) in self.of.iter().enumerate() {
                to.push_str(if i == 0 { "(" } else { ", " });
                of.write(names, 0, to);
            }
            to.push(')');
        };
        let infix = |signs: &[&str], least: u8, to: &mut String| {
            for (i, of) in self.of.iter().enumerate() {
                to.push_str(if i == 0 { "" } else { signs[i - 1] });
                of.write(names, least, to);
            }
        };
        match &self.op {
            Op::Number(value) => {
                let _ = write!(to, "{value}");
            }
            Op::Name(name) => to.push_str(&names.0[*name]),
            Op::Sum(minus) => {
                to.push_str(if minus.has(0) { "-" } else { "" });
                let signs: Vec<_> =
                    minus.iter().skip(1).map(|minus| if minus { " - " } else { " + " }).collect();
                infix(&signs, 2, to);
            }
            Op::Product(divides) => {
                to.push_str(if divides.has(0) { "1/" } else { "" });
                let signs: Vec<_> = divides.iter().skip(1).map(|by| if by { "/" } else { " " }).collect();
                infix(&signs, 3, to);
            }
            Op::Dot => infix(&["."], 4, to),
            Op::Cross => call("cross", to),
            Op::Root => call("sqrt", to),
            Op::Single => call("single", to),
            Op::Axes(_) => call("axes", to),
            Op::Less => infix(&[" < "], 1, to),
            Op::If => infix(&[" ? ", " : "], 1, to),
        }
        to.push_str(if needs { ")" } else { "" });
    }
}
