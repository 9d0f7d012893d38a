//! All changes of the list of formulas that are tried.

use super::edits::{Edit, What, edits};
use super::list::{CURVES, FORMULAS, Formula, Formulas};
use super::tree::{Name, Op, Tree};

/// A change of the list.
#[derive(Clone, Debug)]
pub(super) struct Change {
    /// The other formulas, by the names of their results.
    pub(super) new: Vec<(Name, Tree)>,
    /// Whether the values use the right formulas, and only what is differentiated the others.
    pub(super) is_of_derivatives: bool,
    pub(super) words: String,
    /// The simplest has the smallest.
    pub(super) cost: u32,
}

/// What is wrong with something by a factor.
const FACTORS: [(f64, &str, u32); 4] = [
    (-1.0, "has the wrong sign", 2),
    (0.0, "is missing", 2),
    (2.0, "counts twice", 3),
    (0.5, "is halved", 3),
];
/// Names that only the answers have.
const ANSWERS: [&str; 3] = ["C", "C_bar", "state"];

fn scaled(name: Name, by: f64) -> Tree {
    Tree::product(vec![(false, Tree::number(by)), (false, Tree::name(name))])
}

/// The changes of the formulas that are written in this way.
pub(super) fn changes(way: usize) -> Vec<Change> {
    let list = &*FORMULAS;
    let mut found = list.of_curves();
    found.extend(list.of_inputs());
    found.extend(list.exchanges());
    for formula in &list.all {
        let tree = formula.written(way);
        let twin = list.twin_of(formula, way).filter(|twin| twin.name > formula.name);
        let of_twin = twin.map(|twin| edits(twin.written(way), &|name| list.others(name, twin)));
        for edit in edits(tree, &|name| list.others(name, formula)) {
            let new = tree.with(&edit.path, &edit.new);
            list.add_change(&[(formula, &new)], &edit, "", &mut found);
            // A name may be wrong in all its places.
            if let (Op::Name(old), Op::Name(other)) = (&edit.old.op, &edit.new.op) {
                let everywhere = tree.renamed(&|name| if name == *old { *other } else { name });
                if everywhere != new && tree.find(&|of| *of == edit.old).as_ref() == Some(&edit.path) {
                    list.add_change(&[(formula, &everywhere)], &edit, ", in all its places", &mut found);
                }
            }
            let [old, other] = [&edit.old, &edit.new].map(|tree| list.twin_tree(tree));
            // The same error in the formula of the other beam, or for the other beam in the same formula.
            let what = match edit.what {
                What::Other(name) => What::Other(list.twin(name)),
                what => what,
            };
            let is_same = |of: &&Edit| of.what == what && of.path == edit.path;
            let same = of_twin.iter().flatten().find(is_same);
            if let (Some(twin), Some(same)) = (twin, same) {
                let tree = twin.written(way).with(&same.path, &same.new);
                list.add_change(&[(formula, &new), (twin, &tree)], &edit, "", &mut found);
            }
            let later = |tree: &Tree| new.find(&|of| of == tree).filter(|path| *path > edit.path);
            if let Some(path) = later(&old).filter(|_| old != edit.old) {
                let tree = new.with(&path, &other);
                list.add_change(&[(formula, &tree)], &edit, ", as its twin", &mut found);
            }
            // Both of two terms that are each other's transpose.
            let transposed = |tree: &Tree| list.transposed(tree);
            if let Some((old, other)) = transposed(&edit.old).zip(transposed(&edit.new))
                && let Some(path) = later(&old).filter(|_| old != edit.old)
            {
                let tree = new.with(&path, &other);
                list.add_change(&[(formula, &tree)], &edit, ", as its transpose", &mut found);
            }
        }
    }
    found
}

impl Formulas {
    /// Factors on the vectors of a curve, or on their variations.
    fn of_curves(&self) -> Vec<Change> {
        let mut found = Vec::new();
        for (vector, variations) in CURVES {
            for bar in [false, true] {
                let named = |name: &str| {
                    let (letters, derivative) = name.split_once(',').unwrap_or((name, ""));
                    let comma = if derivative.is_empty() { "" } else { "," };
                    self.name(&format!("{letters}{}{comma}{derivative}", if bar { "_bar" } else { "" }))
                };
                let of: Vec<Name> = variations.iter().map(|name| named(name)).collect();
                let vector = named(vector);
                for (by, words, _) in FACTORS {
                    let scaled = |name: &Name| (*name, scaled(*name, by));
                    let all: Vec<Name> = [&[vector], &of[..]].concat();
                    let told = |names: &[Name]| {
                        names.iter().map(|name| self.names.0[*name].as_str()).collect::<Vec<_>>().join(", ")
                    };
                    for (names, cost) in [(&all, 3), (&of, 4)] {
                        if names.is_empty() {
                            continue;
                        }
                        let words = format!("the curves are wrong: each of {} {words}", told(names));
                        found.push(Change {
                            new: names.iter().map(scaled).collect(),
                            is_of_derivatives: false,
                            words,
                            cost,
                        });
                    }
                }
            }
        }
        found
    }

    /// Factors on numbers of the input.
    fn of_inputs(&self) -> Vec<Change> {
        let is_number = |name: &Name| {
            let kind = self.kinds[*name];
            !kind.is_vector && !kind.is_condition
        };
        let of = |name: Name| {
            FACTORS.map(|(by, words, cost)| Change {
                new: vec![(name, scaled(name, by))],
                is_of_derivatives: false,
                words: format!("{} {words}", self.names.0[name]),
                cost,
            })
        };
        (0..self.inputs).filter(is_number).flat_map(of).collect()
    }

    /// A number of the beam and that of the bar beam in each other's place.
    fn exchanges(&self) -> Vec<Change> {
        let exchanged = |(name, text): (Name, &String)| {
            let twin = Some(self.twin(name)).filter(|twin| *twin > name)?;
            let words = format!("{text} and {} are exchanged", self.names.0[twin]);
            let new = vec![(name, Tree::name(twin)), (twin, Tree::name(name))];
            Some(Change { new, is_of_derivatives: false, words, cost: 4 })
        };
        self.names.0.iter().enumerate().take(self.inputs).filter_map(exchanged).collect()
    }

    /// The names of the same kind that are known before a formula. A product of variations can have exchanged directions.
    fn others(&self, name: Name, before: &Formula) -> Vec<Name> {
        let kind = self.kinds[name];
        let is_mixed = self.kinds[before.name].varies == [true; 2];
        let is_one = |varies: [bool; 2]| varies[0] != varies[1];
        let is_like = |other: &Name| {
            let of = self.kinds[*other];
            let varies = of.varies == kind.varies || (is_mixed && is_one(kind.varies) && is_one(of.varies));
            of.is_vector == kind.is_vector && of.is_condition == kind.is_condition && varies
        };
        let is_meant = |other: &Name| !ANSWERS.contains(&&*self.names.0[*other]);
        (0..before.name).filter(|other| *other != name && is_like(other) && is_meant(other)).collect()
    }

    /// Adds the change of these formulas, and the same with their derivatives, and in what is differentiated alone.
    fn add_change(&self, changed: &[(&Formula, &Tree)], edit: &Edit, scope: &str, found: &mut Vec<Change>) {
        let mut new = Vec::new();
        for (formula, tree) in changed {
            self.put(formula, tree, &mut new);
        }
        let names: Vec<_> = changed.iter().map(|(of, _)| self.words_of(of)).collect();
        let cost = edit.cost + u32::from(changed.len() > 1 || !scope.is_empty());
        // What is wrong with the whole formula is told of its result.
        let (subject, verb) = match edit.words.strip_prefix("it ") {
            Some(verb) if names.len() > 1 => (format!("each of {}", names.join(" and ")), verb),
            Some(verb) => (names.concat(), verb),
            None => (format!("in {}", names.join(" and ")), &*edit.words),
        };
        let words = format!("{subject} {verb}{scope}");
        let derivatives: Option<Vec<_>> =
            changed.iter().map(|(formula, tree)| self.derivative(formula, tree)).collect();
        if let Some(derivatives) = derivatives {
            let mut new = new.clone();
            for (formula, tree) in &derivatives {
                self.put(formula, tree, &mut new);
            }
            let words = format!("{words}, and in its derivative");
            found.push(Change { new, words, cost: cost + 1, is_of_derivatives: false });
        }
        let kind = self.kinds[changed[0].0.name];
        if kind.varies == [false; 2] && !kind.is_condition {
            let words = format!(
                "in the derivatives, {}",
                words.strip_prefix("in ").map_or_else(|| words.clone(), |of| format!("for {of}"))
            );
            found.push(Change { new: new.clone(), words, cost: cost + 2, is_of_derivatives: true });
        }
        found.push(Change { new, words, cost, is_of_derivatives: false });
    }

    /// Puts a formula in the place of another, also along Delta.
    fn put(&self, formula: &Formula, tree: &Tree, new: &mut Vec<(Name, Tree)>) {
        new.push((formula.name, tree.clone()));
        new.extend(formula.linear.map(|linear| (linear, self.along_linear(tree))));
    }

    fn words_of(&self, formula: &Formula) -> String {
        match &*self.names.0[formula.name] {
            "R" => "the residual".into(),
            "K" => "the tangent".into(),
            name => name.to_owned(),
        }
    }
}
