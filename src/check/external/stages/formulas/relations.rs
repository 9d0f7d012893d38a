//! Formulas that belong to each other: those of both beams, and those of both directions.

use super::edits::Edit;
use super::list::{Formula, Formulas, Kind, STRAIGHT};
use super::names::Others;
use super::tree::{Name, Op, Tree};
use super::values::Value;

/// Entries and right-hand sides of the system for the parameters that are confused with a change of sign.
const SYSTEM: [&[&str]; 8] = [
    &["a", "b", "a_bar"],
    &["h11", "h12", "h21", "h22"],
    &["i11", "i12", "i22"],
    &["dp", "dp_bar"],
    &["Ddp", "Ddp_bar"],
    &["dh", "dh_bar"],
    &["Ddh", "Ddh_bar"],
    &["da", "db", "db_bar", "da_bar"],
];

/// Vectors with their unit vectors.
const UNIT_VECTORS: [[&str; 2]; 3] = [["d", "n"], ["t", "tau"], ["t_bar", "tau_bar"]];

/// The entries of the system that are the same for both beams.
const SYMMETRIC: [&str; 2] = ["h12", "h21"];

impl Formulas {
    /// The formula with delta and Delta exchanged; nothing if a name of it does not exist so.
    pub(super) fn transposed(&self, tree: &Tree) -> Option<Tree> {
        let other = |name: Name| self.linear.get(name).or(self.delta.get(name)).unwrap_or(name);
        let mut is_known = true;
        tree.each_name(&mut |name| is_known &= self.kinds[name].varies != [true; 2]);
        is_known.then(|| tree.renamed(&other))
    }

    /// The formula `new`, which has an edit of this tree, with the same edit where delta and Delta are exchanged: of the branch, or
    /// else of its term.
    pub(super) fn with_transpose(&self, tree: &Tree, new: &Tree, edit: &Edit) -> Option<Tree> {
        let other_than = |tree: &Tree| self.transposed(tree).filter(|old| old != tree);
        if let Some(old) = other_than(&edit.old)
            && let Some(path) = new.find(&|of| *of == old).filter(|path| *path > edit.path)
            && let Some(other) = self.transposed(&edit.new)
        {
            return Some(new.with(&path, &other));
        }
        let (mut of, mut term, mut from) = (tree, tree, 0);
        for (depth, &i) in edit.path.iter().enumerate() {
            let is_term = matches!(of.op, Op::Sum(_)) || (of.op == Op::If && i > 0);
            of = &of.of[i];
            if is_term {
                (term, from) = (of, depth + 1);
            }
        }
        let old = other_than(term)?;
        let path = new.find(&|of| *of == old)?;
        let other = self.transposed(&term.with(&edit.path[from..], &edit.new))?;
        Some(new.with(&path, &other))
    }

    /// The name of the same number of the other beam, or the name itself if it belongs to both.
    pub(super) fn twin(&self, name: Name) -> Name {
        self.twins.get(name).unwrap_or(name)
    }

    /// The same for the other beam.
    pub(super) fn twin_tree(&self, tree: &Tree) -> Tree {
        tree.renamed(&|name| self.twin(name))
    }

    /// The same with the numbers of the beam in the place of those of the bar beam.
    pub(super) fn of_beam(&self, tree: &Tree) -> Tree {
        let of = |name: Name| if self.names.0[name].contains("_bar") { self.twin(name) } else { name };
        tree.renamed(&of)
    }

    /// The inputs with the directions exchanged.
    pub(super) fn exchanged(&self, inputs: &[Value]) -> Vec<Value> {
        let mut exchanged = inputs.to_vec();
        for (delta, linear) in (0..self.inputs).filter_map(|name| Some((name, self.linear.get(name)?))) {
            exchanged.swap(delta, linear);
        }
        exchanged
    }

    /// The formula of the other beam, if it is written alike.
    pub(super) fn twin_of(&self, formula: &Formula, way: usize) -> Option<&Formula> {
        let twin = self.twin(formula.name);
        let twin = self.all.iter().find(|of| of.name == twin && of.name != formula.name)?;
        formula.written(way).is_congruent(twin.written(way)).then_some(twin)
    }

    /// The formula of the second order that is solved like this one of the first, and this tree in its place.
    pub(super) fn second_of(&self, formula: &Formula, tree: &Tree, way: usize) -> Option<(&Formula, Tree)> {
        let of_second = |tree: &Tree| {
            let is_first = |of: Name| self.kinds[of].varies == [true, false];
            tree.renamed(&|of| self.seconds.get(of).filter(|_| is_first(of)).unwrap_or(of))
        };
        let second = self.second_formula(formula)?;
        (*second.written(way) == of_second(formula.written(way))).then(|| (second, of_second(tree)))
    }

    /// The formula of the second order that belongs to one of the first.
    pub(super) fn second_formula(&self, formula: &Formula) -> Option<&Formula> {
        let name = self.seconds.get(formula.name)?;
        self.all.iter().find(|of| of.name == name)
    }

    /// The names with a D before them.
    pub(super) fn find_seconds(&self) -> Others {
        let mut seconds = Others::default();
        let pair = |(name, text): (Name, &String)| Some((name, self.names.find(&format!("D{text}"))?));
        let pairs = self.names.0.iter().enumerate().filter_map(pair);
        pairs.for_each(|(name, second)| seconds.insert(name, second));
        seconds
    }

    /// Names of the system that differ from this one in sign in the symmetric form: a is -a_bar of the other beam.
    pub(super) fn of_opposite_sign(&self, name: Name) -> Vec<Name> {
        let back = self.delta.get(name);
        let text = &*self.names.0[back.unwrap_or(name)];
        let group = SYSTEM.iter().find(|group| group.contains(&text));
        let others = group.into_iter().flat_map(|group| *group).filter(|other| **other != text);
        let named = others.filter_map(|other| self.names.find(other));
        named.filter_map(|other| if back.is_some() { self.linear.get(other) } else { Some(other) }).collect()
    }

    /// The unit vector of a vector, or the vector of a unit vector.
    pub(super) fn of_other_length(&self, name: Name) -> Option<Name> {
        let text = &*self.names.0[name];
        let pair = UNIT_VECTORS.iter().find(|pair| pair.contains(&text))?;
        Some(self.name(pair[usize::from(pair[0] == text)]))
    }

    /// An entry of the matrix of eq. (52) as it is for straight beams.
    pub(super) fn straight_form(&self, name: Name) -> Option<Tree> {
        let is_entry = ["a", "a_bar"].contains(&&*self.names.0[name]);
        let formula = self.all.iter().find(|of| is_entry && of.name == name)?;
        Some(formula.written(STRAIGHT).clone())
    }

    /// The difference of both displacements for a variation of one beam, along the same direction.
    pub(super) fn difference_of(&self, name: Name) -> Option<Tree> {
        let [delta, delta_bar] = ["du", "du_bar"].map(|name| self.name(name));
        let is_of = |varies: [bool; 2]| self.kinds[name] == Kind { varies, ..self.kinds[delta] };
        let along = |of: Name| if is_of([true, false]) { of } else { self.name_along_linear(of) };
        let is_one = is_of([true, false]) || is_of([false, true]);
        let is_vector_of_curve = self.names.0[name].contains('u');
        (is_one && is_vector_of_curve)
            .then(|| Tree::sum(vec![(false, Tree::name(along(delta))), (true, Tree::name(along(delta_bar)))]))
    }

    /// The first name of the difference of two variations of a vector.
    pub(super) fn first_of_difference(&self, tree: &Tree) -> Option<Name> {
        let is_difference = matches!(&tree.op, Op::Sum(minus) if minus.iter().eq([false, true]));
        match tree.of.iter().map(|of| &of.op).collect::<Vec<_>>()[..] {
            [Op::Name(first), Op::Name(second)] if is_difference && self.twin(*first) == *second => {
                Some(*first)
            }
            _ => None,
        }
    }

    /// The length of the variation of a vector, for the variation of its length.
    pub(super) fn length_of_variation(&self, name: Name) -> Option<Tree> {
        let vector = self.names.0[name].strip_prefix("d|")?.strip_suffix('|')?;
        let vector = self.names.find(&format!("d{vector}"))?;
        let square = Tree::new(Op::Dot, [Tree::name(vector), Tree::name(vector)]);
        Some(Tree::new(Op::Root, [square]))
    }

    /// The product of first variations, for the second variation of the same number.
    pub(super) fn product_of_variations(&self, name: Name) -> Option<Tree> {
        let number = self.names.0[name].strip_prefix("Dd").filter(|_| !self.kinds[name].is_vector)?;
        let [along, linear] = ["d", "D"].map(|of| self.names.find(&format!("{of}{number}")));
        Some(Tree::product(vec![(false, Tree::name(along?)), (false, Tree::name(linear?))]))
    }

    /// Pairs of names that differ in `_bar`.
    pub(super) fn find_twins(&self) -> Others {
        let pair = |(name, text): (Name, &String)| {
            let twin = self.names.find(&text.replacen("_bar", "", 1)).filter(|twin| *twin != name)?;
            Some([(name, twin), (twin, name)])
        };
        let of_rows = SYMMETRIC.map(|name| self.name(name));
        let of_rows = [(of_rows[0], of_rows[1]), (of_rows[1], of_rows[0])];
        let mut twins = Others::default();
        let pairs = self.names.0.iter().enumerate().filter_map(pair).flatten();
        pairs.chain(of_rows).for_each(|(name, twin)| twins.insert(name, twin));
        twins
    }
}
