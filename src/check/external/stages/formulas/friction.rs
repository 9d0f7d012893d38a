//! Errors of friction as a whole, as other formulas in the place of several.

use super::change::{Change, put};
use super::list::Formulas;
use super::parser::Parser;

/// Residual and tangent without friction, and with the wrong sign of it.
const PARTS: [(&str, &str, &str); 4] = [
    ("in the residual the part of friction is missing", "R", "-F_N dgap"),
    ("in the tangent the part of friction is missing", "K", "k dgap Dgap - F_N Ddgap"),
    ("in the residual the part of friction has the wrong sign", "R", "-F_N dgap - F A - F_bar A_bar"),
    (
        "in the tangent the part of friction has the wrong sign",
        "K",
        "k dgap Dgap - F_N Ddgap - A DF - A_bar DF_bar - F H_A - F_bar H_A_bar",
    ),
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
        let parts = PARTS.map(|(words, name, text)| (words.to_owned(), vec![(name, text.to_owned())]));
        let of_both = |i: usize, words: &str| {
            let new = PARTS[i..i + 2].iter().map(|(_, name, text)| (*name, (*text).to_owned())).collect();
            (format!("in residual and tangent the part of friction {words}"), new)
        };
        let both = [of_both(0, "is missing"), of_both(2, "has the wrong sign")];
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
        parts.into_iter().chain(both).chain(uncoupled).map(|(words, new)| self.instead(words, &new)).collect()
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
            put(formula, &tree, &mut new);
        }
        Change { new, cost: COSTS[usize::from(others.len() > 1)], ..Change::of(words) }
    }
}
