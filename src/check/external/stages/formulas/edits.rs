//! The errors that a formula can have: one change of its tree.

use super::axes::axes;
use super::kinds::{Class, What};
use super::list::FORMULAS;
use super::tree::{Name, Op, Tree};

/// A branch of a formula and what stands in its place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edit {
    /// The branches from the root to the place.
    pub(super) path: Vec<usize>,
    pub(super) what: What,
    pub(super) old: Tree,
    pub(super) new: Tree,
    /// What is wrong, as a clause.
    pub(super) words: String,
    /// The simplest errors have the smallest cost.
    pub(super) cost: u32,
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
    /// The term that a change is in, unless it is all that there is.
    fn words(&self, of: &Tree) -> String {
        // What is multiplied out does not stand so in the list.
        let is_told = self.is_expanded || of != self.term;
        if self.is_whole || !is_told { String::new() } else { format!(" in {}", text(self.term)) }
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

fn text(tree: &Tree) -> String {
    tree.text(&FORMULAS.names)
}

impl Edits<'_> {
    fn add_of(&mut self, tree: &Tree, place: &Place) {
        let mut add = |what: What, new: Tree, words: String| {
            if self.class.has(what.cost()) {
                let (path, old) = (place.path.clone(), tree.clone());
                self.found.push(Edit { path, what, old, new, words, cost: what.cost() });
            }
        };
        // A choice between something and zero is its one term.
        let is_zero = |of: &Tree| of.op == Op::Number(0.0);
        let is_of_one = tree.op == Op::If && tree.of[1..].iter().any(is_zero);
        if place.is_term && !is_of_one && !matches!(tree.op, Op::Less | Op::Number(_)) {
            let of = if place.is_whole { "it".into() } else { format!("the term {}", text(tree)) };
            if tree.op != Op::Root {
                add(What::Sign, Tree::sum(vec![(true, tree.clone())]), format!("{of} has the wrong sign"));
            }
            add(What::Missing, Tree::number(0.0), format!("{of} is missing"));
            add(What::Doubled, scaled(tree, 2.0), format!("{of} counts twice"));
            add(What::Halved, scaled(tree, 0.5), format!("{of} is halved"));
            for (what, new, words) in [
                (What::Exchanged, FORMULAS.twin_tree(tree), "has the beams exchanged"),
                (What::Forgotten, FORMULAS.of_beam(tree), "takes the beam where the bar beam belongs"),
            ] {
                let is_one_name = matches!(tree.op, Op::Name(_));
                if new != *tree && !is_one_name {
                    add(what, new, format!("{of} {words}"));
                }
            }
            if FORMULAS.kind(tree).varies == [true; 2]
                && let Some(transposed) = FORMULAS.transposed(tree)
            {
                add(What::Transposed, transposed, format!("{of} is transposed"));
            }
        }
        match &tree.op {
            Op::Product(divides) => {
                for (what, new, words) in of_factors(tree, divides, &place.words(tree)) {
                    add(what, new, words);
                }
            }
            Op::If => {
                for i in [1, 2] {
                    let [condition, branch] = [text(&tree.of[0]), text(&tree.of[i])];
                    let words = format!("{branch} is taken whatever {condition} is");
                    add(What::Always(i), tree.of[i].clone(), words);
                }
                let reversed = vec![tree.of[0].clone(), tree.of[2].clone(), tree.of[1].clone()];
                let words = format!("the condition {} is reversed", text(&tree.of[0]));
                add(What::Reversed, Tree::new(Op::If, reversed), words);
            }
            Op::Less => {
                let [one, other] = [tree.of[0].clone(), tree.of[1].clone()];
                let reversed = Tree::new(Op::Less, vec![other, one]);
                add(What::Reversed, reversed, format!("the condition {} is reversed", text(tree)));
                for (holds, word) in [(false, "never"), (true, "always")] {
                    let value = Tree::number(if holds { 1.0 } else { 0.0 });
                    add(What::Holds(holds), value, format!("{} is {word} taken to hold", text(tree)));
                }
            }
            Op::Root => {
                add(
                    What::NoRoot,
                    tree.of[0].clone(),
                    format!("the root of {} is left out", text(&tree.of[0])),
                );
            }
            Op::Number(number) if *number > 1.0 => {
                for other in NUMBERS.into_iter().filter(|other| (f64::from(*other) - *number).abs() > 0.5) {
                    let words = format!("{other} stands in the place of {number}{}", place.words(tree));
                    add(What::Number(other), Tree::number(f64::from(other)), words);
                }
            }
            Op::Number(0.0) if place.is_term => {
                for &name in &self.names {
                    let words = format!("{} stands in the place of 0", FORMULAS.names.0[name]);
                    add(What::Other(name), Tree::name(name), words);
                }
            }
            Op::Name(name) if self.class != Class::Simple => self.add_of_name(*name, tree, place),
            Op::Sum(_) => {
                if let Some(first) = FORMULAS.first_of_difference(tree) {
                    for other in (self.others)(first) {
                        let [new, old] = [&Tree::name(other), tree].map(text);
                        let words = format!("{new} stands in the place of {old}{}", place.words(tree));
                        add(What::Difference(other), Tree::name(other), words);
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

    /// A variation in the place of another one of the formula, along delta and along Delta.
    fn add_along_both(&mut self, term: &Tree, place: &Place) {
        let linear = |name: Name| FORMULAS.linear.get(name);
        let has = |name: Name| term.find(&|of| of.op == Op::Name(name)).is_some();
        let both: Vec<[Name; 2]> = self.all.iter().filter_map(|name| Some([*name, linear(*name)?])).collect();
        for &[name, along] in both.iter().filter(|both| both.iter().all(|name| has(*name))) {
            let twin = FORMULAS.twin(name);
            let others =
                (self.others)(name).into_iter().filter(|other| *other == twin || self.all.contains(other));
            for (other, other_along) in others.filter_map(|other| Some((other, linear(other)?))) {
                let renamed = |of: Name| match of {
                    of if of == name => other,
                    of if of == along => other_along,
                    of => of,
                };
                let [new, old] = [other, name].map(|of| &FORMULAS.names.0[of]);
                let words =
                    format!("{new} stands in the place of {old} along both directions{}", place.words(term));
                let what = What::AlongBoth(name, other);
                let (path, new) = (place.path.clone(), term.renamed(&renamed));
                self.found.push(Edit { path, what, old: term.clone(), new, words, cost: what.cost() });
            }
        }
    }

    /// What may stand in the place of a name. These are no simple errors.
    fn add_of_name(&mut self, name: Name, tree: &Tree, place: &Place) {
        let others = (self.others)(name);
        let mut add = |what: What, new: Tree, words: String| {
            let (path, old) = (place.path.clone(), tree.clone());
            self.found.push(Edit { path, what, old, new, words, cost: what.cost() });
        };
        let axes = if FORMULAS.kinds[name].is_vector { axes() } else { Vec::new() };
        for (k, (axes, words)) in axes.into_iter().enumerate() {
            let words = format!("{words} of {}{}", FORMULAS.names.0[name], place.words(tree));
            add(What::Axes(k), Tree::new(Op::Axes(axes), vec![tree.clone()]), words);
        }
        let old = &FORMULAS.names.0[name];
        let of_others = [
            (What::Length, FORMULAS.length_of_variation(name)),
            (What::Product, FORMULAS.product_of_variations(name)),
        ];
        for (what, new) in of_others.into_iter().filter_map(|(what, new)| Some((what, new?))) {
            let words = format!("{} stands in the place of {old}{}", text(&new), place.words(tree));
            add(what, new, words);
        }
        if let Some(new) = FORMULAS.straight_form(name) {
            let words = format!("{} stands in the place of {old}{}", text(&new), place.words(tree));
            add(What::Straight, new, words);
        }
        for other in FORMULAS.of_opposite_sign(name) {
            let new = Tree::sum(vec![(true, Tree::name(other))]);
            let words = format!("{} stands in the place of {old}{}", text(&new), place.words(tree));
            add(What::Negative(other), new, words);
        }
        if let Some(new) = FORMULAS.difference_of(name) {
            let words = format!("{} stands in the place of {old}{}", text(&new), place.words(tree));
            add(What::Difference(name), new, words);
        }
        for other in others {
            let [new, old] = [other, name].map(|of| &FORMULAS.names.0[of]);
            add(
                What::Other(other),
                Tree::name(other),
                format!("{new} stands in the place of {old}{}", place.words(tree)),
            );
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

/// The changes of a product: a factor left out, there twice, or on the other side of the division.
fn of_factors(tree: &Tree, divides: &[bool], in_term: &str) -> Vec<(What, Tree, String)> {
    let mut found = Vec::new();
    let factors: Vec<_> = divides.iter().copied().zip(tree.of.iter().cloned()).collect();
    for (i, factor) in tree.of.iter().enumerate() {
        let what = if divides[i] { "the division by" } else { "the factor" };
        let of = format!("{what} {}{in_term}", text(factor));
        let mut without = factors.clone();
        without.remove(i);
        found.push((What::Without(i), Tree::product(without), format!("{of} is left out")));
        let squared = [&factors[..], &factors[i..=i]].concat();
        found.push((What::Squared(i), Tree::product(squared), format!("{of} is there twice")));
        if tree.of.len() > 1 && !FORMULAS.kind(factor).is_vector {
            let mut inverted = factors.clone();
            inverted[i].0 = !divides[i];
            let verb = if divides[i] { "multiplied" } else { "divided" };
            let words = format!("the term {} is {verb} by {}", text(tree), text(factor));
            found.push((What::Inverted(i), Tree::product(inverted), words));
        }
    }
    found
}

fn scaled(tree: &Tree, by: f64) -> Tree {
    Tree::product(vec![(false, Tree::number(by)), (false, tree.clone())])
}
