//! The errors that a formula can have: one change of its tree.

use super::axes::AXES;
use super::kinds::{Class, What};
use super::list::FORMULAS;
use super::tree::{Flags, Name, Op, Tree};

/// A branch of a formula and what stands in its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edit {
    /// The branches from the root to the place.
    pub(super) path: Vec<usize>,
    pub(super) what: What,
    pub(super) old: Tree,
    pub(super) new: Tree,
    pub(super) term: Term,
    /// The simplest errors have the smallest cost.
    pub(super) cost: u32,
}

/// The term that a change is in.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Term {
    /// The whole formula.
    Whole,
    /// The branch itself.
    Itself,
    In(Tree),
}

/// Numbers that are confused.
const NUMBERS: [u8; 4] = [2, 3, 4, 6];

/// All changes of a formula of this class. `others` are the names that can be taken for another one by mistake.
pub(super) fn edits(of: &Tree, class: Class, others: &dyn Fn(Name) -> Vec<Name>) -> Vec<Edit> {
    let mut names = Vec::new();
    of.each_name(&mut |name| names.push(name));
    let kind = FORMULAS.kind(of);
    names.sort_unstable();
    names.dedup();
    let all = names.clone();
    names.retain(|name| FORMULAS.kinds[*name] == kind);
    let mut edits = Edits { class, others, names, all, found: Vec::new() };
    let is_expanded = class == Class::Expanded;
    let whole = Place { path: vec![], is_term: true, term: of, is_whole: true, is_expanded };
    edits.add_of(of, &whole);
    edits.found
}

/// A branch of a formula.
struct Place<'a> {
    path: Vec<usize>,
    /// Whether it is added to something, or is a formula or a choice by itself.
    is_term: bool,
    /// The term that it is in.
    term: &'a Tree,
    /// Whether this term is the whole formula.
    is_whole: bool,
    is_expanded: bool,
}

impl Place<'_> {
    fn term(&self, of: &Tree) -> Term {
        // What is multiplied out does not stand so in the list.
        let is_told = self.is_expanded || of != self.term;
        match (self.is_whole, is_told) {
            (true, _) => Term::Whole,
            (false, true) => Term::In(self.term.clone()),
            (false, false) => Term::Itself,
        }
    }
}

struct Edits<'a> {
    class: Class,
    others: &'a dyn Fn(Name) -> Vec<Name>,
    /// The names of the formula that are of its kind.
    names: Vec<Name>,
    /// All names of the formula.
    all: Vec<Name>,
    found: Vec<Edit>,
}

impl Edits<'_> {
    fn add(&mut self, (tree, place): (&Tree, &Place), what: What, new: Tree) {
        if self.class.has(what.cost()) {
            let (path, old, term) = (place.path.clone(), tree.clone(), place.term(tree));
            self.found.push(Edit { path, what, old, new, term, cost: what.cost() });
        }
    }

    fn add_of(&mut self, tree: &Tree, place: &Place) {
        let at = (tree, place);
        // A choice between something and zero is its one term.
        let is_zero = |of: &Tree| of.op == Op::Number(0.0);
        let is_of_one = tree.op == Op::If && tree.of[1..].iter().any(is_zero);
        if place.is_term && !is_of_one && !matches!(tree.op, Op::Less | Op::Number(_)) {
            self.add_of_term(tree, place);
        }
        match &tree.op {
            Op::Product(divides) => {
                for (what, new) in of_factors(tree, *divides) {
                    self.add(at, what, new);
                }
            }
            Op::If => {
                for i in [1, 2] {
                    self.add(at, What::Always(i), tree.of[i].clone());
                }
                let reversed = vec![tree.of[0].clone(), tree.of[2].clone(), tree.of[1].clone()];
                self.add(at, What::Reversed, Tree::new(Op::If, reversed));
            }
            Op::Less => {
                let [one, other] = [tree.of[0].clone(), tree.of[1].clone()];
                self.add(at, What::Reversed, Tree::new(Op::Less, vec![other, one]));
                for (holds, value) in [(false, 0.0), (true, 1.0)] {
                    self.add(at, What::Holds(holds), Tree::number(value));
                }
            }
            Op::Root => self.add(at, What::NoRoot, tree.of[0].clone()),
            Op::Number(number) if *number > 1.0 => {
                for other in NUMBERS.into_iter().filter(|other| (f64::from(*other) - *number).abs() > 0.5) {
                    self.add(at, What::Number(other), Tree::number(f64::from(other)));
                }
            }
            Op::Number(0.0) if place.is_term => {
                for name in self.names.clone() {
                    self.add(at, What::Other(name), Tree::name(name));
                }
            }
            Op::Name(name) if self.class != Class::Simple => self.add_of_name(*name, at),
            Op::Sum(_) => {
                if let Some(first) = FORMULAS.first_of_difference(tree) {
                    for other in (self.others)(first) {
                        self.add(at, What::Difference(other), Tree::name(other));
                    }
                }
            }
            _ => {}
        }
        if place.is_term && self.class != Class::Simple {
            self.add_along_both(tree, place);
        }
        self.add_of_branches(tree, place);
    }

    /// The changes of a term as a whole.
    fn add_of_term(&mut self, tree: &Tree, place: &Place) {
        let at = (tree, place);
        if tree.op != Op::Root {
            self.add(at, What::Sign, Tree::sum(vec![(true, tree.clone())]));
        }
        self.add(at, What::Missing, Tree::number(0.0));
        self.add(at, What::Doubled, scaled(tree, 2.0));
        self.add(at, What::Halved, scaled(tree, 0.5));
        let is_one_name = matches!(tree.op, Op::Name(_));
        let of_beams =
            [(What::Exchanged, FORMULAS.twin_tree(tree)), (What::Forgotten, FORMULAS.of_beam(tree))];
        for (what, new) in of_beams.into_iter().filter(|(_, new)| new != tree && !is_one_name) {
            self.add(at, what, new);
        }
        if FORMULAS.kind(tree).varies == [true; 2]
            && let Some(transposed) = FORMULAS.transposed(tree)
        {
            self.add(at, What::Transposed, transposed);
        }
    }

    /// A variation in the place of another one of the formula, along delta and along Delta.
    fn add_along_both(&mut self, term: &Tree, place: &Place) {
        let linear = |name: Name| FORMULAS.linear.get(name);
        let has = |name: Name| term.find(&|of| of.op == Op::Name(name)).is_some();
        let both: Vec<[Name; 2]> = self.all.iter().filter_map(|name| Some([*name, linear(*name)?])).collect();
        for &[name, along] in both.iter().filter(|both| both.iter().all(|name| has(*name))) {
            let twin = FORMULAS.twin(name);
            let mut others = (self.others)(name);
            others.retain(|other| *other == twin || self.all.contains(other));
            for (other, other_along) in others.into_iter().filter_map(|other| Some((other, linear(other)?))) {
                let renamed = |of: Name| match of {
                    of if of == name => other,
                    of if of == along => other_along,
                    of => of,
                };
                self.add((term, place), What::AlongBoth(name, other), term.renamed(&renamed));
            }
        }
    }

    /// What may stand in the place of a name. These are no simple errors.
    fn add_of_name(&mut self, name: Name, at: (&Tree, &Place)) {
        let count = if FORMULAS.kinds[name].is_vector { AXES.len() } else { 0 };
        for k in 0..count {
            self.add(at, What::Axes(k), Tree::new(Op::Axes(k), [at.0.clone()]));
        }
        let of_others = [
            (What::Length, FORMULAS.length_of_variation(name)),
            (What::Product, FORMULAS.product_of_variations(name)),
            (What::Straight, FORMULAS.straight_form(name)),
        ];
        for (what, new) in of_others.into_iter().filter_map(|(what, new)| Some((what, new?))) {
            self.add(at, what, new);
        }
        for other in FORMULAS.of_opposite_sign(name) {
            self.add(at, What::Negative(other), Tree::sum(vec![(true, Tree::name(other))]));
        }
        if let Some(new) = FORMULAS.difference_of(name) {
            self.add(at, What::Difference(name), new);
        }
        for other in (self.others)(name) {
            self.add(at, What::Other(other), Tree::name(other));
        }
    }

    fn add_of_branches(&mut self, tree: &Tree, place: &Place) {
        let is_sum = matches!(&tree.op, Op::Sum(signs) if signs.len() > 1);
        for (i, branch) in tree.of.iter().enumerate() {
            let is_choice = tree.op == Op::If && i > 0;
            let is_term = matches!(tree.op, Op::Sum(_)) || is_choice;
            let of = Place {
                path: [&place.path[..], &[i]].concat(),
                is_term,
                term: if is_sum || is_choice { branch } else { place.term },
                is_whole: place.is_whole && !is_sum && !is_choice,
                is_expanded: place.is_expanded,
            };
            self.add_of(branch, &of);
        }
    }
}

/// The changes of a product: a factor left out, there twice, or on the other side of the division, which may be of one term alone.
fn of_factors(tree: &Tree, divides: Flags) -> Vec<(What, Tree)> {
    let mut found = Vec::new();
    let factors: Vec<_> = divides.iter().zip(tree.of.iter().cloned()).collect();
    for (i, factor) in tree.of.iter().enumerate() {
        let mut without = factors.clone();
        without.remove(i);
        found.push((What::Without(i), Tree::product(without)));
        let squared = [&factors[..], &factors[i..=i]].concat();
        found.push((What::Squared(i), Tree::product(squared)));
        if tree.of.len() > 1 && !FORMULAS.kind(factor).is_vector {
            let mut inverted = factors.clone();
            inverted[i].0 = !divides.has(i);
            found.push((What::Inverted(i), Tree::product(inverted)));
        }
    }
    let is_quotient = divides.len() == 2 && !divides.has(0) && divides.has(1);
    if let (true, Op::Sum(minus)) = (is_quotient, &tree.of[0].op) {
        let terms: Vec<_> = minus.iter().zip(tree.of[0].of.iter().cloned()).collect();
        for i in 0..if terms.len() > 2 { terms.len() } else { 0 } {
            let mut terms = terms.clone();
            terms[i].1 = Tree::product(vec![(false, terms[i].1.clone()), (true, tree.of[1].clone())]);
            found.push((What::Alone(i), Tree::sum(terms)));
        }
    }
    found
}

fn scaled(tree: &Tree, by: f64) -> Tree {
    Tree::product(vec![(false, Tree::number(by)), (false, tree.clone())])
}
