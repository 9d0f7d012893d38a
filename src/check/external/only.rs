//! What a program answers, if it does not answer everything: stated in the head of its answers.

use super::conventions::STATE_AND_FORCES;
use crate::check::verdict::Order;
use crate::linearization::Quantity;
use std::collections::BTreeSet;

/// A part of a quantity: order, quantity, and the name of the order; or a part of a contact element with its own name.
pub type PartKey = (Order, Quantity, &'static str);

pub(super) const RESIDUAL: PartKey = (Order::First, Quantity::GN, "residual");
pub(super) const TANGENT: PartKey = (Order::Second, Quantity::GN, "tangent");
/// State and forces of a contact element.
pub(super) const FORCES: [PartKey; 4] = {
    let [state, f_n, f, f_bar] = STATE_AND_FORCES;
    let of = Quantity::GN;
    [(Order::Value, of, state), (Order::Value, of, f_n), (Order::Value, of, f), (Order::Value, of, f_bar)]
};

/// Whether the name is that of a part of a contact element: residual, tangent, state, `F_N`, F, `F_bar`.
pub fn is_of_element(name: &str) -> bool {
    matches!(name, "residual" | "tangent") || is_force(name)
}

/// Whether the name is that of a state or force.
pub(super) fn is_force(name: &str) -> bool {
    STATE_AND_FORCES.contains(&name)
}

/// The parts and the cases that a program answers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Only {
    /// The parts that it answers, if not all.
    pub parts: Option<BTreeSet<PartKey>>,
    /// The names of the cases that it answers, if not all.
    pub cases: Option<BTreeSet<String>>,
    /// The parameters that may be held at the cases that it answers, if not all: none, xi, `xi_bar`, both.
    pub held: Option<BTreeSet<String>>,
}

/// The keys of the head.
pub(super) const ONLY: [&str; 3] = ["only", "only_cases", "only_held"];

impl Only {
    /// Sets an entry of the head: a list of words.
    ///
    /// # Errors
    /// What was expected, if a word is unknown, or there is none.
    pub(super) fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        let words: Vec<&str> = value
            .trim_matches(['[', ']'])
            .split(',')
            .map(|word| word.trim().trim_matches(['"', '\'']))
            .filter(|word| !word.is_empty())
            .collect();
        let set = |words: &[&str]| Some(words.iter().map(ToString::to_string).collect());
        if words.is_empty() {
            return Err(format!("{key}: a list of words expected, found none"));
        }
        match key {
            "only" => {
                let parts = words.iter().map(|word| parts(word)).collect::<Result<Vec<_>, _>>()?;
                self.parts = Some(parts.into_iter().flatten().collect());
            }
            "only_cases" => self.cases = set(&words),
            _ => {
                let known = ["none", "xi", "xi_bar", "both"];
                if let Some(found) = words.iter().find(|word| !known.contains(word)) {
                    return Err(format!("{key}: none, xi, xi_bar or both expected, found {found:?}"));
                }
                self.held = set(&words);
            }
        }
        Ok(())
    }

    /// Whether the program answers this case.
    pub(super) fn has_case(&self, id: &str, held: &str) -> bool {
        self.cases.as_ref().is_none_or(|cases| cases.contains(id))
            && self.held.as_ref().is_none_or(|of| of.contains(held))
    }

    /// The parts that the program answers; `is_element` if it states the penalty stiffness of a contact element.
    pub(super) fn required(&self, is_element: bool) -> BTreeSet<PartKey> {
        let all = || {
            let of_quantities = Quantity::ALL.into_iter().flat_map(of_quantity);
            of_quantities.chain(if is_element { vec![RESIDUAL, TANGENT] } else { Vec::new() }).collect()
        };
        self.parts.clone().unwrap_or_else(all)
    }
}

/// The parts of a contact element.
pub(super) fn of_element() -> BTreeSet<PartKey> {
    [RESIDUAL, TANGENT].into()
}

pub(super) fn of_quantity(quantity: Quantity) -> [PartKey; 3] {
    [Order::Value, Order::First, Order::Second].map(|order| (order, quantity, order.name()))
}

/// The parts with a name such as `d`, `d:first` or `residual`.
fn parts(word: &str) -> Result<Vec<PartKey>, String> {
    let (name, part) = word.split_once(':').map_or((word, None), |(name, part)| (name, Some(part)));
    let unknown = || {
        let names = Quantity::ALL.map(Quantity::name).join(", ");
        format!(
            "only: residual, tangent, state, F_N, F, F_bar or one of {names} expected, alone or with :value, :first or :second, found {word:?}"
        )
    };
    let mut of_element = [RESIDUAL, TANGENT].into_iter().chain(FORCES);
    if let (Some(found), None) = (of_element.find(|(_, _, known)| *known == name), part) {
        return Ok(vec![found]);
    }
    let quantity = Quantity::ALL.into_iter().find(|known| known.name() == name).ok_or_else(unknown)?;
    let all = of_quantity(quantity);
    let at = match part {
        None => return Ok(all.to_vec()),
        Some("value") => 0,
        Some("first" | "gradient" | "delta" | "Delta") => 1,
        Some("second" | "hessian" | "Delta-delta") => 2,
        Some(_) => return Err(unknown()),
    };
    Ok(vec![all[at]])
}

/// The words of `only` for these parts: a quantity with all its parts is one word.
pub(super) fn words(parts: &BTreeSet<PartKey>) -> Vec<String> {
    let mut words = Vec::new();
    for quantity in Quantity::ALL {
        let of: Vec<_> = of_quantity(quantity).into_iter().filter(|part| parts.contains(part)).collect();
        match of.len() {
            3 => words.push(quantity.name().to_owned()),
            _ => words.extend(of.iter().map(|(_, _, order)| format!("{}:{order}", quantity.name()))),
        }
    }
    let of_element = [RESIDUAL, TANGENT].into_iter().chain(FORCES).filter(|part| parts.contains(part));
    words.into_iter().chain(of_element.map(|(_, _, name)| name.to_owned())).collect()
}

#[cfg(test)]
mod tests {
    use super::{Only, words};

    #[test]
    fn parts_are_named_as_they_are_read() {
        let mut only = Only::default();
        for (key, value) in
            [("only", "[\"d\", xi:gradient,residual,F_bar]"), ("only_cases", "[1, 2]"), ("only_held", "none")]
        {
            only.set(key, value).unwrap();
        }
        assert_eq!(words(&only.required(false)), ["d", "xi:first", "residual", "F_bar"]);
        assert!(only.has_case("1", "none") && !only.has_case("3", "none") && !only.has_case("1", "xi"));
        assert_eq!((Only::default().required(false).len(), Only::default().required(true).len()), (39, 41));
    }

    #[test]
    fn unknown_words_say_what_was_expected() {
        for (key, value, expected) in [
            ("only", "e", "only: residual, tangent, state, F_N, F, F_bar or one of x, x_bar,"),
            ("only", "d:third", "found \"d:third\""),
            ("only", "[]", "only: a list of words expected, found none"),
            ("only_held", "left", "only_held: none, xi, xi_bar or both expected, found \"left\""),
        ] {
            let told = Only::default().set(key, value).unwrap_err();
            assert!(told.contains(expected), "{told}");
        }
    }
}
