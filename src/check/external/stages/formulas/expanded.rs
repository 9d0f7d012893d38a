//! Errors of one use of a formula: in one of the products that are multiplied out, or where one other formula uses it.

use super::change::{Change, put};
use super::edits::{Edit, edits};
use super::kinds::{Class, What};
use super::list::{Formula, Formulas};
use super::names::WAYS;
use super::tree::{Name, Op, Tree};
use super::words::OfEdit;
use std::sync::Arc;

/// The largest number of terms of a formula that is multiplied out.
const TERMS: usize = 40;

/// A term of a sum, and whether it is subtracted.
type Term = (bool, Tree);

impl Formulas {
    /// The changes of one use of what a formula is made of, in the ways of writing that are meant.
    pub(super) fn expanded_changes(
        &self,
        formula: &Formula,
        is_meant: impl Fn(&[bool; WAYS]) -> bool,
    ) -> Vec<Change> {
        let mut found = Vec::new();
        for way in 0..WAYS {
            let Some(ways) = self.first_ways(formula, way).filter(&is_meant) else { continue };
            let start = found.len();
            self.add_of_terms(formula, way, &mut found);
            self.add_of_uses(formula, way, &mut found);
            found[start..].iter_mut().for_each(|change: &mut Change| change.ways = ways);
        }
        found
    }

    /// The errors in a term of the formula after it is multiplied out, with the formula of one of its names in its place.
    fn add_of_terms(&self, formula: &Formula, way: usize, found: &mut Vec<Change>) {
        let tree = formula.written(way);
        let twin = self.twin_of(formula, way).filter(|twin| twin.name > formula.name);
        let expanded = self.multiplied_out(tree);
        let mut known = terms_of(tree);
        let is_sum = |name: &Name| {
            let of = self.all.iter().find(|of| of.name == *name);
            of.is_some_and(|of| terms_of(&self.multiplied_out(of.written(way))).len() > 1)
        };
        let names = self.used(tree).into_iter().filter(is_sum).map(Some);
        for name in (expanded != *tree).then_some(None).into_iter().chain(names) {
            let with = |tree: &Tree, name: Option<Name>| match name {
                Some(name) => self.multiplied_out(&self.with_formula(tree, name, way)),
                None => self.multiplied_out(tree),
            };
            let base = with(tree, name);
            if terms_of(&base).len() <= TERMS {
                let of_twin =
                    twin.map(|twin| (twin, with(twin.written(way), name.map(|name| self.twin(name)))));
                let of_twin = of_twin.filter(|(_, of_twin)| of_twin.is_congruent(&base));
                let is_new = |edit: &Edit| !known.contains(&term_at(&base, &edit.path));
                for edit in self.edits_of(&base).into_iter().filter(is_new).map(Arc::new) {
                    let same =
                        of_twin.as_ref().and_then(|(twin, tree)| Some((*twin, self.twin_edit(tree, &edit)?)));
                    let same = same
                        .as_ref()
                        .zip(of_twin.as_ref())
                        .map(|((twin, edit), (_, tree))| (*twin, tree, edit));
                    self.add_changes((formula, way, Class::Expanded), &base, &edit, same, found);
                }
            }
            if name.is_none() {
                known.extend(terms_of(&expanded));
            }
        }
    }

    /// The errors in the formula of a name where this formula, and its twin, use it.
    fn add_of_uses(&self, formula: &Formula, way: usize, found: &mut Vec<Change>) {
        let tree = formula.written(way);
        let twin = self.twin_of(formula, way);
        for name in self.used(tree) {
            let Some(used) = self.all.iter().find(|of| of.name == name) else { continue };
            let is_user = |of: &&Formula| {
                let mut uses = false;
                of.written(way).each_name(&mut |other| uses |= other == name);
                uses
            };
            let is_own =
                |of: &&Formula| of.name == formula.name || twin.is_some_and(|twin| twin.name == of.name);
            if self.all.iter().filter(is_user).all(|of| is_own(&of)) {
                continue;
            }
            let other = self.twin_of(used, way);
            for edit in self.edits_of(used.written(way)) {
                let of_used = used.written(way).with(&edit.path, &edit.new);
                let new = self.with_used(tree, name, &of_used);
                let edit = Arc::new(edit);
                add_use((formula, &new), None, (used.name, None), &edit, found);
                let Some(twin) = twin.filter(|twin| twin.name > formula.name) else { continue };
                let of_twin = match other {
                    Some(other) => {
                        let same = self.twin_edit(other.written(way), &edit);
                        same.map(|same| (other.name, other.written(way).with(&same.path, &same.new)))
                    }
                    None => Some((name, of_used)),
                };
                if let Some((of, tree)) = of_twin {
                    let tree = self.with_used(twin.written(way), of, &tree);
                    let other = other.map(|other| other.name);
                    add_use((formula, &new), Some((twin, &tree)), (used.name, other), &edit, found);
                }
            }
        }
    }

    /// The names of a formula that have formulas.
    fn used(&self, tree: &Tree) -> Vec<Name> {
        let mut names = Vec::new();
        tree.each_name(&mut |name| names.push(name));
        names.retain(|name| *name >= self.inputs && !self.kinds[*name].is_condition);
        names.retain(|name| self.all.iter().any(|of| of.name == *name));
        names.sort_unstable();
        names.dedup();
        names
    }

    /// The edits of a formula. A name may be that of the other beam, another one of the same formula, or a vector that is not
    /// normalised, or is.
    fn edits_of(&self, tree: &Tree) -> Vec<Edit> {
        let mut names = Vec::new();
        tree.each_name(&mut |name| names.push(name));
        names.sort_unstable();
        names.dedup();
        let others = |name: Name| {
            let is_like = |other: &Name| *other != name && self.kinds[*other] == self.kinds[name];
            let mut others: Vec<Name> = names
                .iter()
                .copied()
                .chain([self.twin(name)])
                .chain(self.of_other_length(name))
                .filter(is_like)
                .collect();
            others.sort_unstable();
            others.dedup();
            others
        };
        let mut edits = edits(tree, Class::Expanded, &others);
        // Of one use, these are too rare for their number.
        let is_rare = |what: What| {
            matches!(
                what,
                What::Axes(_) | What::Length | What::Product | What::Negative(_) | What::Difference(_)
            )
        };
        edits.retain(|edit| !is_rare(edit.what));
        edits
    }

    /// The same edit of the formula of the other beam.
    fn twin_edit(&self, tree: &Tree, edit: &Edit) -> Option<Edit> {
        let [old, new] = [&edit.old, &edit.new].map(|of| self.twin_tree(of));
        let there = edit.path.iter().try_fold(tree, |tree, &i| tree.of.get(i))?;
        (*there == old).then(|| Edit { old, new, ..edit.clone() })
    }

    /// The tree with the formula of a name, and of that along Delta, in their place.
    fn with_formula(&self, tree: &Tree, name: Name, way: usize) -> Tree {
        match self.all.iter().find(|of| of.name == name) {
            Some(of) => self.with_used(tree, name, of.written(way)),
            None => tree.clone(),
        }
    }

    fn with_used(&self, tree: &Tree, name: Name, new: &Tree) -> Tree {
        let linear = self.linear.get(name);
        tree.substituted(&|of| match of {
            of if of == name => Some(new.clone()),
            of if Some(of) == linear => Some(self.along_linear(new)),
            _ => None,
        })
    }

    /// The tree as a sum of products.
    fn multiplied_out(&self, tree: &Tree) -> Tree {
        if tree.op == Op::If {
            let [condition, one, other] = [0, 1, 2].map(|i| &tree.of[i]);
            let of = vec![condition.clone(), self.multiplied_out(one), self.multiplied_out(other)];
            return Tree::new(Op::If, of);
        }
        let mut terms = self.terms(tree);
        match terms.len() {
            1 if !terms[0].0 => terms.remove(0).1,
            _ => Tree::sum(terms),
        }
    }

    fn terms(&self, tree: &Tree) -> Vec<Term> {
        let terms: Vec<Term> = match &tree.op {
            Op::Sum(signs) => {
                let of = |(sign, of): (bool, &Tree)| {
                    self.terms(of).into_iter().map(move |(minus, of)| (minus != sign, of))
                };
                signs.iter().zip(tree.of.iter()).flat_map(of).collect()
            }
            Op::Product(divides) => {
                let mut all = vec![(false, Vec::new())];
                for (divides, factor) in divides.iter().zip(tree.of.iter()) {
                    let terms = if divides { vec![(false, factor.clone())] } else { self.terms(factor) };
                    all = combined(&all, &terms, |before, term| {
                        [&before[..], &factors(term, divides)[..]].concat()
                    });
                }
                all.into_iter().map(|(minus, factors)| (minus, product(factors))).collect()
            }
            Op::Dot => {
                let [one, other] = [0, 1].map(|i| self.terms(&tree.of[i]));
                combined(&one, &other, |one, other| {
                    let ([one, of_one], [other, of_other]) = (self.split(one), self.split(other));
                    let dot = Tree::new(Op::Dot, vec![product(one), product(other)]);
                    product([vec![(false, dot)], of_one, of_other].concat())
                })
            }
            Op::If => vec![(false, self.multiplied_out(tree))],
            _ => vec![(false, tree.clone())],
        };
        if terms.len() > TERMS { vec![(false, tree.clone())] } else { terms }
    }

    /// The vector of a term, and its other factors.
    fn split(&self, term: &Tree) -> [Vec<(bool, Tree)>; 2] {
        let is_vector = |(_, of): &(bool, Tree)| self.kind(of).is_vector;
        let (vector, others): (Vec<_>, Vec<_>) = factors(term, false).into_iter().partition(is_vector);
        [vector, others]
    }
}

/// Adds the error of a formula that these formulas alone use with it.
fn add_use(
    (formula, tree): (&Formula, &Tree),
    twin: Option<(&Formula, &Tree)>,
    (used, other): (Name, Option<Name>),
    edit: &Arc<Edit>,
    found: &mut Vec<Change>,
) {
    let mut new = Vec::new();
    put(formula, tree, &mut new);
    if let Some((twin, tree)) = twin {
        put(twin, tree, &mut new);
    }
    let users = [Some(formula.name), twin.map(|(twin, _)| twin.name)];
    let formulas = [Some(used), other];
    let words = OfEdit { edit: Arc::clone(edit), formulas, users, scope: "", form: "" };
    let cost = edit.cost + 2 + u32::from(twin.is_some());
    found.push(Change { new, cost, ..Change::of(words) });
}

/// The products of all terms of both.
fn combined<A, B>(all: &[(bool, A)], terms: &[Term], of: impl Fn(&A, &Tree) -> B) -> Vec<(bool, B)> {
    let with = |(minus, one): &(bool, A)| -> Vec<(bool, B)> {
        terms.iter().map(|(other, term)| (minus != other, of(one, term))).collect()
    };
    all.iter().flat_map(with).collect()
}

/// The factors of a term, and whether it is divided by them.
fn factors(term: &Tree, divides: bool) -> Vec<(bool, Tree)> {
    match &term.op {
        Op::Product(of) => {
            of.iter().zip(term.of.iter()).map(|(by, of)| (by != divides, of.clone())).collect()
        }
        _ => vec![(divides, term.clone())],
    }
}

fn product(mut factors: Vec<(bool, Tree)>) -> Tree {
    match factors.len() {
        1 if !factors[0].0 => factors.remove(0).1,
        _ => Tree::product(factors),
    }
}

/// The terms of a sum, also in a choice.
fn terms_of(tree: &Tree) -> Vec<Tree> {
    match tree.op {
        Op::Sum(_) => tree.of.to_vec(),
        Op::If => tree.of[1..].iter().flat_map(terms_of).collect(),
        _ => vec![tree.clone()],
    }
}

/// The term that the end of a path is in.
fn term_at(tree: &Tree, path: &[usize]) -> Tree {
    match (&tree.op, path.split_first()) {
        (Op::Sum(_), Some((&i, _))) => tree.of[i].clone(),
        (Op::If, Some((&i, rest))) if i > 0 => term_at(&tree.of[i], rest),
        _ => tree.clone(),
    }
}
