//! The derivative of a formula, as a formula.

use super::list::{Formula, Formulas};
use super::tree::{Name, Op, Tree};

/// Names whose derivatives have a name of their own.
const NAMED: [(&str, &str); 9] = [
    ("v", "H_v"),
    ("A", "H_A"),
    ("A_bar", "H_A_bar"),
    ("R", "K"),
    ("slip", "dxi"),
    ("slip_bar", "dxi_bar"),
    ("moved", "dxi"),
    ("moved_bar", "dxi_bar"),
    ("d_s", "dgap"),
];
/// The normal force as a function of the gap.
const FORCE: &str = "force";
/// Names that are constant in a step.
const CONSTANT: [&str; 6] = ["e_0", "e_bar_0", "side", "n_n", "tau_n", "tau_bar_n"];
/// Their formulas are differentiated at fixed parameters.
const PARTIAL: [&str; 3] = ["a", "b", "a_bar"];

impl Formulas {
    /// The formula of the derivative of a formula; nothing if the list has none.
    pub(super) fn derivative_of(&self, formula: &Formula) -> Option<&Formula> {
        let name = &*self.names.0[formula.name];
        let of = |name: &str| self.all.iter().find(|formula| self.names.0[formula.name] == name);
        match name {
            name if PARTIAL.contains(&name) => None,
            // The stiffness is -dF_N/dg_N.
            FORCE => of("stiffness"),
            name => {
                let named = NAMED.iter().find(|(of, _)| *of == name && self.is_row(formula));
                match named {
                    Some((_, named)) => of(named),
                    None => of(&format!("{}{name}", self.letter(formula))),
                }
            }
        }
    }

    /// Whether it is a row, as the residual is. Rows are differentiated along Delta.
    fn is_row(&self, formula: &Formula) -> bool {
        self.kinds[formula.name].varies == [true, false]
    }

    /// The letter of the direction along which it is differentiated.
    fn letter(&self, formula: &Formula) -> &'static str {
        if self.is_row(formula) { "D" } else { "d" }
    }

    /// The formula of the derivative, if this one stood in the place of a formula; nothing if the list has none.
    pub(super) fn derivative(&self, formula: &Formula, tree: &Tree) -> Option<(&Formula, Tree)> {
        let result = self.derivative_of(formula)?;
        if self.names.0[formula.name] == FORCE {
            let by_gap = |name: Name| match &*self.names.0[name] {
                "gap" => Of::Tree(Tree::number(-1.0)),
                "line" => Of::Tree(Tree::name(self.name("eps_N"))),
                _ if name < self.inputs || self.kinds[name].is_condition => Of::Zero,
                _ => Of::Unknown,
            };
            return Some((result, derivative(tree, &by_gap)?));
        }
        let letter = self.letter(formula);
        let by_dofs = |name: Name| {
            let text = &*self.names.0[name];
            let is_constant = name < self.inputs && !self.kinds[name].is_vector && !text.starts_with("xi");
            if is_constant || self.kinds[name].is_condition || CONSTANT.contains(&text) {
                return Of::Zero;
            }
            let named =
                NAMED.iter().find(|(of, _)| *of == text).map(|(_, named)| match named.strip_prefix('d') {
                    Some(rest) => format!("{letter}{rest}"),
                    None => (*named).to_owned(),
                });
            let text = named.unwrap_or_else(|| format!("{letter}{text}"));
            self.names.find(&text).map_or(Of::Unknown, |name| Of::Tree(Tree::name(name)))
        };
        Some((result, derivative(tree, &by_dofs)?))
    }
}

/// The derivative of a name.
enum Of {
    Zero,
    Tree(Tree),
    /// There is no formula for it.
    Unknown,
}

/// The derivative of a formula; nothing if that of a name is not known.
fn derivative(tree: &Tree, of: &impl Fn(Name) -> Of) -> Option<Tree> {
    Some(derived(tree, of)?.unwrap_or_else(|| Tree::number(0.0)))
}

/// The same, with nothing inside for zero.
#[expect(clippy::option_option, reason = "unknown, zero, or a formula")]
fn derived(tree: &Tree, of: &impl Fn(Name) -> Of) -> Option<Option<Tree>> {
    let branches = || tree.of.iter().map(|branch| derived(branch, of)).collect::<Option<Vec<_>>>();
    let with = |i: usize, branch: Tree| tree.with(&[i], &branch);
    let summed = |terms: Vec<(bool, Tree)>| if terms.is_empty() { None } else { Some(Tree::sum(terms)) };
    Some(match &tree.op {
        Op::Number(_) | Op::Less => None,
        Op::Name(name) => match of(*name) {
            Of::Zero => None,
            Of::Tree(tree) => Some(tree),
            Of::Unknown => return None,
        },
        Op::Sum(signs) => {
            let terms = branches()?.into_iter().zip(signs.iter());
            summed(terms.filter_map(|(branch, sign)| Some((sign, branch?))).collect())
        }
        Op::Product(divides) => {
            let mut terms = Vec::new();
            for (i, branch) in branches()?.into_iter().enumerate() {
                let Some(branch) = branch else { continue };
                terms.push(if divides.has(i) {
                    let factors = vec![(false, tree.clone()), (false, branch), (true, tree.of[i].clone())];
                    (true, Tree::product(factors))
                } else {
                    (false, with(i, branch))
                });
            }
            summed(terms)
        }
        Op::Dot | Op::Cross | Op::Axes(_) | Op::Single => {
            let branches = branches()?.into_iter().enumerate();
            summed(branches.filter_map(|(i, branch)| Some((false, with(i, branch?)))).collect())
        }
        Op::Root => branches()?.remove(0).map(|branch| {
            Tree::product(vec![(false, branch), (true, Tree::number(2.0)), (true, tree.clone())])
        }),
        Op::If => {
            let [yes, no] = [derived(&tree.of[1], of)?, derived(&tree.of[2], of)?];
            if yes.is_none() && no.is_none() {
                return Some(None);
            }
            let [yes, no] = [yes, no].map(|of| of.unwrap_or_else(|| Tree::number(0.0)));
            Some(Tree::new(Op::If, vec![tree.of[0].clone(), yes, no]))
        }
    })
}
