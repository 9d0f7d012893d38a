//! All changes of the list of formulas that are tried.

use super::change::{Change, New, put};
use super::edits::{Edit, edits};
use super::kinds::{Class, What};
use super::list::{FORMULAS, Formula, Formulas};
use super::names::{Set, WAYS};
use super::outputs::RESULTS;
use super::tree::{Name, Op, Tree};
use super::words::{IN_DERIVATIVES, OfEdit};
use crate::parallel;
use std::collections::HashMap;
use std::sync::{Arc, LazyLock, OnceLock};

/// All changes. Those of a formula are made when they are asked for.
pub(super) static CHANGES: LazyLock<Changes> = LazyLock::new(Changes::new);

pub(super) struct Changes {
    /// The changes that are not of one formula.
    others: Vec<Change>,
    of_formulas: Vec<OfFormula>,
}

struct OfFormula {
    /// The names that its changes may give another formula.
    names: Set,
    /// The ways in which the formula is written as in each one, unless this is as an earlier one.
    ways: [Option<[bool; WAYS]>; WAYS],
    of_classes: [OfClass; Class::KEPT.len()],
}

/// The changes in each way of writing.
type OfClass = [OnceLock<Box<[Change]>>; WAYS];

/// What is wrong with something by a factor.
pub(super) const FACTORS: [(f64, &str, u32); 4] = [
    (-1.0, "has the wrong sign", 2),
    (0.0, "is missing", 2),
    (2.0, "counts twice", 3),
    (0.5, "is halved", 3),
];
/// Names that only the answers have.
static ANSWERS: LazyLock<Set> =
    LazyLock::new(|| set("C C_bar state |d| g_N d|d| dg_N g_T g_T_bar dg_T dg_T_bar"));

/// The system with unit rows for held parameters. Most programs have a formula for each end in the place of it.
static UNIT_ROWS: LazyLock<Set> = LazyLock::new(|| set("h11 h12 h21 h22 hdet dh dh_bar Ddh Ddh_bar"));

fn set(names: &str) -> Set {
    names.split(' ').map(|name| FORMULAS.name(name)).collect()
}

pub(super) fn scaled(name: Name, by: f64) -> Tree {
    Tree::product(vec![(false, Tree::number(by)), (false, Tree::name(name))])
}

impl Changes {
    fn new() -> Self {
        let list = &*FORMULAS;
        let mut others = list.of_inputs();
        others.extend(list.of_entries());
        others.extend(list.of_results());
        others.extend(list.of_lengths());
        others.extend(list.of_friction());
        others.extend(list.of_straight_beams());
        others.push(list.of_side());
        let exchange = |formula: &Formula| {
            let twin = list.twin_of(formula, 0).filter(|twin| twin.name > formula.name)?;
            Some(list.exchange_of(formula, twin))
        };
        others.extend(list.all.iter().filter_map(exchange));
        let of_formula = |formula| {
            let of_classes = [const { [const { OnceLock::new() }; WAYS] }; Class::KEPT.len()];
            let ways = std::array::from_fn(|way| list.first_ways(formula, way));
            OfFormula { names: list.names_of_changes(formula), ways, of_classes }
        };
        Self { others, of_formulas: list.all.iter().map(of_formula).collect() }
    }

    /// The changes of each formula that are made, with the names that they may give another formula.
    #[cfg(test)]
    pub(super) fn of_each_formula(&self) -> impl Iterator<Item = (Set, &[Change])> {
        self.of_formulas.iter().flat_map(|of| {
            let all = of.of_classes.as_flattened().iter();
            all.filter_map(|all| Some((of.names, &all.get()?[..])))
        })
    }

    /// The changes of this class of formulas that these names follow from, and that are written in the ways that are meant. Those
    /// that are not of one formula are with the simple ones.
    pub(super) fn of(
        &self,
        needed: Set,
        class: Class,
        is_meant: impl Fn(&[bool; WAYS]) -> bool,
    ) -> Vec<&Change> {
        let is_needed = |i: &usize| !self.of_formulas[*i].names.and(needed).is_empty();
        let is_written =
            |(i, way): &(usize, usize)| self.of_formulas[*i].ways[*way].as_ref().is_some_and(&is_meant);
        let which = (0..self.of_formulas.len()).filter(is_needed);
        let which: Vec<(usize, usize)> =
            which.flat_map(|i| (0..WAYS).map(move |way| (i, way))).filter(is_written).collect();
        let of = |(i, way): (usize, usize)| &self.of_formulas[i].of_classes[class as usize][way];
        let missing: Vec<_> = which.iter().copied().filter(|which| of(*which).get().is_none()).collect();
        // No lock is held while other threads are waited for.
        let made = parallel::map(&missing, |&(i, way)| FORMULAS.changes_in(&FORMULAS.all[i], way, class));
        for (which, changes) in missing.into_iter().zip(made) {
            of(which).get_or_init(|| changes.into_boxed_slice());
        }
        let of_formulas = which.into_iter().filter_map(|which| Some(&of(which).get()?[..]));
        let others = if class == Class::Simple { &self.others[..] } else { &[] };
        others.iter().chain(of_formulas.flatten()).collect()
    }
}

impl Formulas {
    /// The names that a change of this formula may give another formula.
    pub(super) fn names_of_changes(&self, formula: &Formula) -> Set {
        let twins = (0..WAYS).filter_map(|way| self.twin_of(formula, way));
        let all: Vec<&Formula> = twins.chain([formula]).collect();
        let derived = all.iter().flat_map(|of| [self.derivative_of(of), self.second_formula(of)]).flatten();
        all.iter().copied().chain(derived).flat_map(|of| [Some(of.name), of.linear]).flatten().collect()
    }

    /// The ways in which a formula and its twin are written like this, unless an earlier way is one of them.
    pub(super) fn first_ways(&self, formula: &Formula, way: usize) -> Option<[bool; WAYS]> {
        let twin = |way| self.twin_of(formula, way);
        let both = |way| (formula.written(way), twin(way).map(|twin| twin.written(way)));
        let ways: [bool; WAYS] = std::array::from_fn(|other| both(other) == both(way));
        (!ways[..way].contains(&true)).then_some(ways)
    }

    /// The changes of a formula that is written in this way, unless an earlier way is the same.
    fn changes_in(&self, formula: &Formula, way: usize, class: Class) -> Vec<Change> {
        let Some(ways) = self.first_ways(formula, way) else { return Vec::new() };
        let twin = self.twin_of(formula, way).filter(|twin| twin.name > formula.name);
        let unit_rows = *UNIT_ROWS;
        let mut is_rare = unit_rows.has(formula.name);
        formula.written(way).each_name(&mut |name| is_rare |= unit_rows.has(name));
        let others = |name: Name, before: &Formula| {
            let mut others = self.others(name, before);
            others.retain(|other| is_rare || !unit_rows.has(*other));
            others
        };
        let of_twin = twin.map(|twin| edits(twin.written(way), class, &|name| others(name, twin)));
        let same: HashMap<_, _> =
            of_twin.iter().flatten().rev().map(|edit| ((edit.what, &*edit.path), edit)).collect();
        let of_edit = |edit: &Arc<Edit>| {
            let mut found = Vec::new();
            let what = match edit.what {
                What::Other(name) => What::Other(self.twin(name)),
                What::Negative(name) => What::Negative(self.twin(name)),
                What::Difference(name) => What::Difference(self.twin(name)),
                What::AlongBoth(name, other) => What::AlongBoth(self.twin(name), self.twin(other)),
                what => what,
            };
            let same = twin.zip(same.get(&(what, &*edit.path)).copied());
            let same = same.map(|(twin, edit)| (twin, twin.written(way), edit));
            self.add_changes((formula, way, class), formula.written(way), edit, same, &mut found);
            for change in &mut found {
                change.ways = ways;
                change.cost += u32::from(is_rare);
            }
            found
        };
        let edits = edits(formula.written(way), class, &|name| others(name, formula));
        let edits: Vec<Arc<Edit>> = edits.into_iter().map(Arc::new).collect();
        parallel::flat_map(&edits, of_edit)
    }

    /// The changes with an edit of a formula that is this tree. `same` is the same edit of its twin.
    pub(super) fn add_changes(
        &self,
        (formula, way, class): (&Formula, usize, Class),
        tree: &Tree,
        edit: &Arc<Edit>,
        same: Option<(&Formula, &Tree, &Edit)>,
        found: &mut Vec<Change>,
    ) {
        let new = tree.with(&edit.path, &edit.new);
        self.add_change((way, class), &[(formula, &new)], edit, "", found);
        // A name may be wrong in all its places.
        if let (Op::Name(old), Op::Name(other)) = (&edit.old.op, &edit.new.op) {
            let everywhere = tree.renamed(&|name| if name == *old { *other } else { name });
            if everywhere != new && tree.find(&|of| *of == edit.old).as_ref() == Some(&edit.path) {
                self.add_change((way, class), &[(formula, &everywhere)], edit, ", in all its places", found);
            }
        }
        // The same error in the formula of the other beam, or for the other beam in the same formula.
        let of_twin = same.map(|(twin, tree, edit)| (twin, tree.with(&edit.path, &edit.new), (tree, edit)));
        if let Some((twin, tree, _)) = &of_twin {
            self.add_change((way, class), &[(formula, &new), (twin, tree)], edit, "", found);
        }
        let old = Some(self.twin_tree(&edit.old)).filter(|old| *old != edit.old);
        let later = old.and_then(|old| new.find(&|of| *of == old)).filter(|path| *path > edit.path);
        if let Some(path) = later {
            let tree = new.with(&path, &self.twin_tree(&edit.new));
            self.add_change((way, class), &[(formula, &tree)], edit, ", as its twin", found);
        }
        // Both of two terms that are each other's transpose.
        let is_mixed = self.kinds[formula.name].varies == [true; 2];
        if is_mixed && let Some(tree) = self.with_transpose(tree, &new, edit) {
            let words = ", as its transpose";
            self.add_change((way, class), &[(formula, &tree)], edit, words, found);
            let other = of_twin
                .filter(|_| class != Class::Expanded)
                .and_then(|(twin, new, (tree, edit))| Some((twin, self.with_transpose(tree, &new, edit)?)));
            if let Some((twin, of_twin)) = other {
                self.add_change((way, class), &[(formula, &tree), (twin, &of_twin)], edit, words, found);
            }
        }
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
        let is_meant = |other: &Name| !ANSWERS.has(*other);
        (0..before.name).filter(|other| *other != name && is_like(other) && is_meant(other)).collect()
    }

    /// Adds the change of these formulas, and the same with their derivatives, and in what is differentiated alone.
    fn add_change(
        &self,
        (way, class): (usize, Class),
        changed: &[(&Formula, &Tree)],
        edit: &Arc<Edit>,
        scope: &'static str,
        found: &mut Vec<Change>,
    ) {
        let cost = edit.cost + u32::from(changed.len() > 1 || !scope.is_empty());
        let formulas = [Some(changed[0].0.name), changed.get(1).map(|(twin, _)| twin.name)];
        let words = OfEdit { edit: Arc::clone(edit), formulas, users: [None; 2], scope, form: "" };
        if class == Class::Tangent {
            let along = |(formula, tree): &(&Formula, &Tree)| {
                Some(New::along_linear(formula.linear?, Tree::clone(tree)))
            };
            if let Some(new) = changed.iter().map(along).collect() {
                let words = words.in_form(", in the tangent alone");
                found.push(Change { new, cost: cost + 1, ..Change::of(words) });
            }
            return;
        }
        let mut new = Vec::new();
        for (formula, tree) in changed {
            put(formula, tree, &mut new);
        }
        if class == Class::Expanded {
            found.push(Change { new, cost: cost + 1, ..Change::of(words) });
            return;
        }
        let mut add_with = |others: Option<Vec<(&Formula, Tree)>>, form: &'static str| {
            let Some(others) = others else { return };
            let mut new = new.clone();
            for (formula, tree) in &others {
                put(formula, tree, &mut new);
            }
            found.push(Change { new, cost: cost + 1, ..Change::of(words.in_form(form)) });
        };
        let derivatives = changed.iter().map(|(formula, tree)| self.derivative(formula, tree)).collect();
        add_with(derivatives, ", and in its derivative");
        // One function of a program may solve for both orders.
        let seconds = changed.iter().map(|(formula, tree)| self.second_of(formula, tree, way)).collect();
        add_with(seconds, ", in both orders");
        let kind = self.kinds[changed[0].0.name];
        if kind.varies == [false; 2] && !kind.is_condition {
            let (new, words) = (new.clone(), words.in_form(IN_DERIVATIVES));
            found.push(Change { new, cost: cost + 2, is_of_derivatives: true, ..Change::of(words) });
        }
        if changed.iter().all(|(formula, _)| RESULTS.contains(&formula.name)) {
            let (new, words) = (new.clone(), words.in_form(", where it is answered alone"));
            found.push(Change { new, is_stored: true, cost: cost + 2, ..Change::of(words) });
        }
        found.push(Change { new, cost, ..Change::of(words) });
    }
}
