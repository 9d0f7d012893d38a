//! What is wrong, in words. Most changes explain nothing, so their sentences are made when they are told.

use super::axes::AXES;
use super::edits::{Edit, Term};
use super::kinds::What;
use super::list::{FORMULAS, Formula, Formulas};
use super::tree::{Name, Op, Tree};
use std::sync::Arc;

/// The words of a change.
#[derive(Clone, Debug)]
pub(super) enum Words {
    Text(String),
    OfEdit(OfEdit),
}

/// An edit of one formula or of both twins.
#[derive(Clone, Debug)]
pub(super) struct OfEdit {
    pub(super) edit: Arc<Edit>,
    /// The results of the formulas that it is in.
    pub(super) formulas: [Option<Name>; 2],
    /// The results of the formulas that alone use them with it; nothing if all do.
    pub(super) users: [Option<Name>; 2],
    /// Where else it is.
    pub(super) scope: &'static str,
    /// In which form it is used, or [`IN_DERIVATIVES`].
    pub(super) form: &'static str,
}

/// Said of a number that is compared with another one.
const AS_GOOD: &str = ", or is another number with the same effect on this condition";

/// The form of a change of what is differentiated alone.
pub(super) const IN_DERIVATIVES: &str = "in the derivatives, ";

impl From<String> for Words {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<OfEdit> for Words {
    fn from(of: OfEdit) -> Self {
        Self::OfEdit(of)
    }
}

impl Words {
    /// A sentence without its full stop.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::OfEdit(of) => of.text(),
        }
    }
}

impl OfEdit {
    pub(super) fn in_form(&self, form: &'static str) -> Self {
        Self { form, ..self.clone() }
    }

    fn text(&self) -> String {
        let Self { edit, formulas, users, scope, form } = self;
        let of = |names: &[Option<Name>; 2]| -> Vec<&Formula> {
            FORMULAS.all.iter().filter(|formula| names.contains(&Some(formula.name))).collect()
        };
        let words = |of: &[&Formula]| of.iter().map(|formula| FORMULAS.words_of(formula)).collect::<Vec<_>>();
        let (changed, users) = (of(formulas), of(users));
        let names = words(&changed);
        let of_users = if users.is_empty() {
            String::new()
        } else {
            format!(", in {} alone", words(&users).join(" and "))
        };
        // What is wrong with the whole formula is told of its result.
        let of_equation = match changed[0].equation {
            "" => String::new(),
            number => format!(", eq. ({number}),"),
        };
        let edit = edit.words();
        let (subject, verb) = match edit.strip_prefix("it ") {
            Some(verb) if names.len() > 1 => (format!("each of {}", names.join(" and ")), verb),
            Some(verb) => (names.concat(), verb),
            None => (format!("in {}", names.join(" and ")), &*edit),
        };
        let is_in_condition = FORMULAS.kinds[changed[0].name].is_condition && self.edit.is_of_number();
        let of_condition = if is_in_condition { AS_GOOD } else { "" };
        let words = format!("{subject}{of_equation} {verb}{scope}{of_users}{of_condition}");
        if *form != IN_DERIVATIVES {
            return words + form;
        }
        format!("{form}{}", words.strip_prefix("in ").map_or_else(|| words.clone(), |of| format!("for {of}")))
    }
}

fn text(tree: &Tree) -> String {
    tree.text(&FORMULAS.names)
}

impl Edit {
    /// Whether it is in the place of a number.
    fn is_of_number(&self) -> bool {
        !matches!(self.old.op, Op::Less | Op::If) && !FORMULAS.kind(&self.old).is_condition
    }

    /// What is wrong, as a clause.
    fn words(&self) -> String {
        let Self { what, old, new, term, .. } = self;
        let in_term = match term {
            Term::In(term) => format!(" in {}", text(term)),
            Term::Whole | Term::Itself => String::new(),
        };
        let of = || if *term == Term::Whole { "it".into() } else { format!("the term {}", text(old)) };
        let branch = |i: usize| text(&old.of[i]);
        let is_divisor = |i: usize| matches!(&old.op, Op::Product(all) if all.has(i));
        let factor = |i: usize| {
            let what = if is_divisor(i) { "the division by" } else { "the factor" };
            format!("{what} {}{in_term}", branch(i))
        };
        let instead = || format!("{} stands in the place of {}{in_term}", text(new), text(old));
        match what {
            What::Sign => format!("{} has the wrong sign", of()),
            What::Missing => format!("{} is missing", of()),
            What::Doubled => format!("{} counts twice", of()),
            What::Halved => format!("{} is halved", of()),
            What::Transposed => format!("{} is transposed", of()),
            What::Exchanged => format!("{} has the beams exchanged", of()),
            What::Forgotten => format!("{} takes the beam where the bar beam belongs", of()),
            What::Without(i) => format!("{} is left out", factor(*i)),
            What::Squared(i) => format!("{} is there twice", factor(*i)),
            What::Inverted(i) => {
                let verb = if is_divisor(*i) { "multiplied" } else { "divided" };
                format!("the term {} is {verb} by {}", text(old), branch(*i))
            }
            What::Alone(i) => {
                let term = text(&old.of[0].of[*i]);
                format!("the division by {} is left out of all terms but {term}", branch(1))
            }
            What::Always(i) => format!("{} is taken whatever {} is", branch(*i), branch(0)),
            What::Reversed if old.op == Op::Less => format!("the condition {} is reversed", text(old)),
            What::Reversed => format!("the condition {} is reversed", branch(0)),
            What::Holds(false) => format!("{} is never taken to hold", text(old)),
            What::Holds(true) => format!("{} is always taken to hold", text(old)),
            What::NoRoot => format!("the root of {} is left out", branch(0)),
            What::AlongBoth(name, other) => {
                let [new, old] = [other, name].map(|of| &FORMULAS.names.0[*of]);
                format!("{new} stands in the place of {old} along both directions{in_term}")
            }
            What::Axes(k) => format!("{} of {}{in_term}", AXES[*k].1, text(old)),
            What::Other(_) if old.op == Op::Number(0.0) => {
                format!("{} stands in the place of 0", text(new))
            }
            What::Other(_)
            | What::Number(_)
            | What::Straight
            | What::Negative(_)
            | What::Difference(_)
            | What::Length
            | What::Product => instead(),
        }
    }
}

impl Formulas {
    /// A formula in words.
    pub(super) fn words_of(&self, formula: &Formula) -> String {
        match &*self.names.0[formula.name] {
            "R" | "R_p" => "the residual".into(),
            "K" | "K_p" => "the tangent".into(),
            name => name.to_owned(),
        }
    }
}
