//! Formulas as trees, and their text.

use std::collections::HashMap;
use std::fmt::Write;
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
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Op {
    Number(f64),
    Name(Name),
    /// A sum; whether each term is subtracted.
    Sum(Arc<[bool]>),
    /// A product; whether each factor is divided by.
    Product(Arc<[bool]>),
    Dot,
    Cross,
    Root,
    /// The vector with other components: the place of each, and a factor.
    Axes([(usize, f64); 3]),
    /// 1 if the first is less than the second, else 0.
    Less,
    /// The second if the first is not zero, else the third.
    If,
}

/// A formula. Its branches are shared by the many trees that differ in one place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tree {
    pub(super) op: Op,
    pub(super) of: Arc<[Tree]>,
}

impl Tree {
    pub(super) fn new(op: Op, of: impl Into<Arc<[Self]>>) -> Self {
        Self { op, of: of.into() }
    }

    pub(super) fn number(value: f64) -> Self {
        Self::new(Op::Number(value), [])
    }

    pub(super) fn name(name: Name) -> Self {
        Self::new(Op::Name(name), [])
    }

    pub(super) fn sum(terms: Vec<(bool, Self)>) -> Self {
        let (signs, of): (Vec<bool>, Vec<Self>) = terms.into_iter().unzip();
        Self::new(Op::Sum(signs.into()), of)
    }

    pub(super) fn product(factors: Vec<(bool, Self)>) -> Self {
        let (divides, of): (Vec<bool>, Vec<Self>) = factors.into_iter().unzip();
        Self::new(Op::Product(divides.into()), of)
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
        let mut is_other = false;
        self.each_name(&mut |name| is_other |= f(name) != name);
        if !is_other {
            return self.clone();
        }
        let op = if let Op::Name(name) = self.op { Op::Name(f(name)) } else { self.op.clone() };
        Self::new(op, self.of.iter().map(|of| of.renamed(f)).collect::<Vec<_>>())
    }

    /// The tree with other trees in the place of names.
    pub(super) fn substituted(&self, f: &impl Fn(Name) -> Option<Self>) -> Self {
        if let Op::Name(name) = self.op {
            return f(name).unwrap_or_else(|| self.clone());
        }
        Self::new(self.op.clone(), self.of.iter().map(|of| of.substituted(f)).collect::<Vec<_>>())
    }

    /// The tree with another branch at the end of a path.
    pub(super) fn with(&self, path: &[usize], new: &Self) -> Self {
        let Some((&first, rest)) = path.split_first() else { return new.clone() };
        let branch = |(i, of): (usize, &Self)| if i == first { of.with(rest, new) } else { of.clone() };
        Self::new(self.op.clone(), self.of.iter().enumerate().map(branch).collect::<Vec<_>>())
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
                to.push_str(if minus[0] { "-" } else { "" });
                let signs: Vec<_> =
                    minus[1..].iter().map(|&minus| if minus { " - " } else { " + " }).collect();
                infix(&signs, 2, to);
            }
            Op::Product(divides) => {
                to.push_str(if divides[0] { "1/" } else { "" });
                let signs: Vec<_> = divides[1..].iter().map(|&by| if by { "/" } else { " " }).collect();
                infix(&signs, 3, to);
            }
            Op::Dot => infix(&["."], 4, to),
            Op::Cross => call("cross", to),
            Op::Root => call("sqrt", to),
            Op::Axes(_) => call("axes", to),
            Op::Less => infix(&[" < "], 1, to),
            Op::If => infix(&[" ? ", " : "], 1, to),
        }
        to.push_str(if needs { ")" } else { "" });
    }
}
