//! The list of formulas, and the order of its evaluation.

use super::names::{Others, Relations, Set, Step, WAYS};
use super::operations::Operations;
use super::parser::Parser;
use super::tree::{Name, Names, Op, Tree};
use std::ops::Range;
use std::sync::LazyLock;

/// The formulas of the geometry and of a contact element in which errors are looked for, one a line.
pub const LIST_OF_FORMULAS: &str = include_str!("list.txt");

/// The way that is right for straight beams alone.
pub(super) const STRAIGHT: usize = 3;
/// The way in which the elastic slip of the last step is a vector. It is tried if the tangents of that step are known.
pub(super) const WITH_START: usize = 5;

/// The vectors of the curves, with their variations.
pub(super) const CURVES: [(&str, &[&str]); 4] = [
    ("x", &["du", "Du", "Ddu"]),
    ("t", &["du,xi", "Du,xi", "Ddu,xi"]),
    ("t,xi", &["du,xixi", "Du,xixi"]),
    ("t,xixi", &[]),
];
/// Inputs that are vectors, with their variations.
const VECTORS: &str = "x x_bar t t_bar t,xi t_bar,xi t,xixi t_bar,xixi n_n tau_n tau_bar_n";
const VARIATIONS: &str = "du du_bar du,xi du_bar,xi du,xixi du_bar,xixi";
const MIXED: &str = "Ddu Ddu_bar Ddu,xi Ddu_bar,xi";
/// Inputs that are numbers.
const NUMBERS: &str = "xi xi_bar xi_0 xi_bar_0 r r_bar xi_n xi_bar_n e_n e_bar_n c_n eps_N g_0 lambda eps_T mu \
     penalty";
/// Inputs that are conditions.
const CONDITIONS: &str =
    "both_free free_xi free_xi_bar has_n has_slips was_free_xi was_free_xi_bar lpqp augmented paper always";

pub(super) static FORMULAS: LazyLock<Formulas> = LazyLock::new(Formulas::new);

/// What a name stands for: names of the same kind can be taken for each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Kind {
    pub(super) is_vector: bool,
    pub(super) is_condition: bool,
    /// Whether it varies with delta and with Delta.
    pub(super) varies: [bool; 2],
}

/// A formula, in each way of writing.
pub(super) struct Formula {
    pub(super) name: Name,
    pub(super) ways: [Tree; WAYS],
    /// The name of the same formula along Delta.
    pub(super) linear: Option<Name>,
    /// The number of its equation in the paper; empty if it has none.
    pub(super) equation: &'static str,
}

impl Formula {
    pub(super) fn written(&self, way: usize) -> &Tree {
        &self.ways[way]
    }

    /// Writes it so in the ways of these digits.
    fn write(&mut self, digits: &str, tree: &Tree) {
        for way in digits.chars().filter_map(|digit| digit.to_digit(10)?.try_into().ok()) {
            let way: usize = way;
            self.ways[way] = tree.clone();
        }
    }
}

pub(super) struct Formulas {
    pub(super) names: Names,
    pub(super) all: Vec<Formula>,
    /// The steps in each way of writing.
    pub(super) ways: [Vec<Step>; WAYS],
    /// Their operations.
    pub(super) operations: [(Operations, Vec<Range<usize>>); WAYS],
    pub(super) kinds: Vec<Kind>,
    /// The names of inputs.
    pub(super) inputs: usize,
    /// The same name along Delta.
    pub(super) linear: Others,
    /// The same name along delta.
    pub(super) delta: Others,
    /// The same name for the other beam.
    pub(super) twins: Others,
    /// The second order of a name of the first.
    pub(super) seconds: Others,
    /// The formulas of the residual that vary.
    pub(super) residual: Vec<Name>,
    /// The names that each name follows from, in some way of writing, and it itself.
    before: Vec<Set>,
    /// How the names depend on each other in each way of writing.
    pub(super) relations: [Relations; WAYS],
}

impl Formulas {
    fn new() -> Self {
        let mut list = Self {
            names: Names::default(),
            all: Vec::new(),
            ways: [const { Vec::new() }; WAYS],
            operations: Default::default(),
            kinds: Vec::new(),
            inputs: 0,
            linear: Others::default(),
            delta: Others::default(),
            twins: Others::default(),
            seconds: Others::default(),
            residual: Vec::new(),
            before: Vec::new(),
            relations: Default::default(),
        };
        list.add_inputs();
        for line in LIST_OF_FORMULAS.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
            let (line, equation) = line.trim_end_matches(']').rsplit_once("  [").unwrap_or((line, ""));
            let (name, text) = line.split_once('=').unwrap_or((line, ""));
            let (way, text) = text.split_once(' ').unwrap_or((text, ""));
            let tree = Parser::tree(text, &mut list.names);
            let tree = tree.unwrap_or_else(|at| unreachable!("the list of formulas is wrong at {at}"));
            if name.trim().is_empty() {
                if let Some(formula) = list.all.last_mut() {
                    formula.write(way, &tree);
                }
            } else {
                list.add(name.trim(), &tree, equation);
            }
        }
        list.twins = list.find_twins();
        list.seconds = list.find_seconds();
        list.residual = ["A", "A_bar", "R", "R_p", "A^T", "A_bar^T", "R^T", "R_p^T"]
            .iter()
            .map(|name| list.name(name))
            .collect();
        list.ways = std::array::from_fn(|way| list.steps(way));
        assert!(list.names.0.len() <= Set::NAMES, "{} names", list.names.0.len());
        let (ways, names) = (&list.ways, list.names.0.len());
        list.operations = list
            .ways
            .each_ref()
            .map(|steps| Operations::of_formulas(names, steps.iter().map(|step| (step.name, &step.tree))));
        list.relations = std::array::from_fn(|way| Relations::new(ways, names, way));
        list.before = (0..names).map(|name| Set::from_iter([name])).collect();
        for name in list.inputs..names {
            let used = list.relations.iter().fold(Set::default(), |used, of| used.or(of.uses[name]));
            list.before[name] = list.before[name].or(list.needed(used));
        }
        list
    }

    fn add_inputs(&mut self) {
        let plain = Kind { is_vector: false, is_condition: false, varies: [false; 2] };
        for (names, kind) in [
            (VECTORS, Kind { is_vector: true, ..plain }),
            (NUMBERS, plain),
            (CONDITIONS, Kind { is_condition: true, ..plain }),
            (MIXED, Kind { is_vector: true, varies: [true; 2], ..plain }),
        ] {
            for name in names.split(' ') {
                self.names.add(name);
                self.kinds.push(kind);
            }
        }
        for name in VARIATIONS.split(' ') {
            let along = self.names.add(name);
            self.kinds.push(Kind { is_vector: true, varies: [true, false], ..plain });
            let linear = self.names.add(&linear_name(name));
            self.kinds.push(Kind { is_vector: true, varies: [false, true], ..plain });
            self.add_linear(along, linear);
        }
        self.inputs = self.kinds.len();
    }

    fn add(&mut self, name: &str, tree: &Tree, equation: &'static str) {
        let kind = self.kind(tree);
        let place = self.names.add(name);
        self.kinds.push(kind);
        let linear = (kind.varies == [true, false]).then(|| self.names.add(&linear_name(name)));
        if let Some(linear) = linear {
            self.kinds.push(Kind { varies: [false, true], ..kind });
            self.add_linear(place, linear);
        }
        assert_eq!(self.kinds.len(), self.names.0.len(), "a formula before {name} has an unknown name");
        let ways = std::array::from_fn(|_| tree.clone());
        self.all.push(Formula { name: place, ways, linear, equation });
    }

    fn add_linear(&mut self, delta: Name, linear: Name) {
        self.linear.insert(delta, linear);
        self.delta.insert(linear, delta);
    }

    /// The kind of the result of a formula.
    pub(super) fn kind(&self, tree: &Tree) -> Kind {
        let mut varies = [false; 2];
        tree.each_name(&mut |name| {
            let of = self.kinds[name].varies;
            varies = [varies[0] | of[0], varies[1] | of[1]];
        });
        Kind { is_vector: self.is_vector(tree), is_condition: self.is_condition(tree), varies }
    }

    fn is_condition(&self, tree: &Tree) -> bool {
        match &tree.op {
            Op::Less => true,
            Op::Name(name) => self.kinds[*name].is_condition,
            Op::If => tree.of[1..].iter().any(|of| self.is_condition(of)),
            _ => false,
        }
    }

    fn is_vector(&self, tree: &Tree) -> bool {
        match &tree.op {
            Op::Name(name) => self.kinds[*name].is_vector,
            Op::Sum(_) | Op::Product(_) => tree.of.iter().any(|of| self.is_vector(of)),
            Op::Cross | Op::Axes(_) => true,
            Op::If => self.is_vector(&tree.of[1]),
            Op::Single => self.is_vector(&tree.of[0]),
            Op::Number(_) | Op::Dot | Op::Root | Op::Less => false,
        }
    }

    fn steps(&self, way: usize) -> Vec<Step> {
        let step = |name, tree: Tree| {
            let mut uses = Vec::new();
            tree.each_name(&mut |name| uses.push(name));
            Step { name, tree, uses }
        };
        let mut steps = Vec::new();
        for formula in &self.all {
            let tree = formula.written(way);
            steps.push(step(formula.name, tree.clone()));
            steps.extend(formula.linear.map(|linear| step(linear, self.along_linear(tree))));
        }
        steps
    }

    /// The names that these follow from, in some way of writing, and they themselves.
    pub(super) fn needed(&self, among: Set) -> Set {
        among.names().fold(Set::default(), |needed, name| needed.or(self.before[name]))
    }

    /// The step of a name that is no input.
    pub(super) fn step(&self, way: usize, name: Name) -> &Step {
        &self.ways[way][name - self.inputs]
    }

    /// For each way the first one in which the formulas that are needed are written in the same way.
    pub(super) fn same_ways(&self, needed: Set) -> [usize; WAYS] {
        std::array::from_fn(|way| {
            let is_same = |other: &usize| self.relations[way].differ[*other].and(needed).is_empty();
            (0..way).find(is_same).unwrap_or(way)
        })
    }

    /// The ways in which the formulas that are needed are not written as in an earlier way.
    pub(super) fn distinct_ways(&self, needed: Set) -> Vec<usize> {
        self.same_ways(needed)
            .into_iter()
            .enumerate()
            .filter(|(way, same)| way == same)
            .map(|of| of.0)
            .collect()
    }

    /// The formula along Delta.
    pub(super) fn along_linear(&self, tree: &Tree) -> Tree {
        tree.renamed(&|name| self.name_along_linear(name))
    }

    /// The name along Delta; the same if it does not vary.
    pub(super) fn name_along_linear(&self, name: Name) -> Name {
        self.linear.get(name).unwrap_or(name)
    }

    /// The place of a name that is in the list.
    pub(super) fn name(&self, name: &str) -> Name {
        self.names.find(name).unwrap_or_else(|| unreachable!("the list of formulas has no {name}"))
    }
}

/// The name of a variation along Delta.
fn linear_name(name: &str) -> String {
    name.strip_prefix('d').map_or_else(|| format!("{name}^T"), |rest| format!("D{rest}"))
}
