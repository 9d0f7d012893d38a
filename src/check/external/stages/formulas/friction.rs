//! Errors of friction as a whole, as other formulas in the place of several.

use super::changes::Change;
use super::list::Formulas;
use super::parser::Parser;

/// Residual and tangent without friction.
const WITHOUT: [(&str, &str, &str); 2] = [
    ("in the residual the part of friction is missing", "R", "-F_N dgap"),
    ("in the tangent the part of friction is missing", "K", "k dgap Dgap - F_N Ddgap"),
];
/// Each beam with a cone of its own. @ is the slip or its component.
const FORCE: &str = "friction ? (mu F_N < eps_T @ ? mu F_N : (eps_T @ < -mu F_N ? -mu F_N : eps_T @)) : 0";
const VARIED: &str =
    "friction ? (mu F_N < eps_T @ ? mu dF_N : (eps_T @ < -mu F_N ? -mu dF_N : eps_T d@)) : 0";
const SLIPS: &str = "friction ? (mu F_N < eps_T @ ? friction : (eps_T @ < -mu F_N ? friction : \
                     (mu F_N < eps_T @_bar ? friction : eps_T @_bar < -mu F_N))) : 0";

/// The costs of one formula and of several.
const COSTS: [u32; 2] = [2, 4];

impl Formulas {
    /// All errors of friction as a whole.
    pub(super) fn of_friction(&self) -> Vec<Change> {
        let without = WITHOUT.map(|(words, name, text)| (words.to_owned(), vec![(name, text.to_owned())]));
        let uncoupled = ["e", "l"].map(|slip| {
            let of = |text: &str, bar: &str| text.replace('@', &format!("{slip}{bar}"));
            let new = vec![
                ("slips", of(SLIPS, "")),
                ("F", of(FORCE, "")),
                ("dF", of(VARIED, "")),
                ("F_bar", of(FORCE, "_bar")),
                ("dF_bar", of(VARIED, "_bar")),
            ];
            let words = format!("friction is uncoupled: eps_T {slip} and eps_T {slip}_bar have a cone each");
            (words, new)
        });
        without.into_iter().chain(uncoupled).map(|(words, new)| self.instead(words, &new)).collect()
    }

    /// The change with these formulas in the place of others.
    pub(super) fn instead(&self, words: String, others: &[(&str, String)]) -> Change {
        let mut names = self.names.clone();
        let mut new = Vec::new();
        for (name, text) in others {
            let formula = self.all.iter().find(|formula| formula.name == self.name(name));
            let (Some(formula), Ok(tree)) = (formula, Parser::tree(text, &mut names)) else {
                unreachable!("an error of friction has a wrong formula of {name}")
            };
            self.put(formula, &tree, &mut new);
        }
        Change { new, cost: COSTS[usize::from(others.len() > 1)], ..Change::of(words) }
    }
}
