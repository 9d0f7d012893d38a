//! What is wrong, in words. Most changes explain nothing, so their sentences are made when they are told.

use super::edits::Edit;
use super::list::{FORMULAS, Formula, Formulas};
use super::tree::Name;
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
        let (subject, verb) = match edit.words.strip_prefix("it ") {
            Some(verb) if names.len() > 1 => (format!("each of {}", names.join(" and ")), verb),
            Some(verb) => (names.concat(), verb),
            None => (format!("in {}", names.join(" and ")), &*edit.words),
        };
        let words = format!("{subject}{of_equation} {verb}{scope}{of_users}");
        if *form != IN_DERIVATIVES {
            return words + form;
        }
        format!("{form}{}", words.strip_prefix("in ").map_or_else(|| words.clone(), |of| format!("for {of}")))
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
