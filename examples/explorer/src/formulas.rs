//! The formulas of the closed form, with a name for each term that can be made faulty.

use beamgap::linearization::{Quantity, Varied};
use beamgap::number::Label;
use std::sync::OnceLock;

const TEXT: &str = include_str!("formulas.txt");

/// A formula.
#[derive(Clone, Debug)]
pub struct Formula {
    /// The groups in which it is shown, such as `gap1`, each with a condition.
    pub groups: Vec<(&'static str, char)>,
    /// When it is evaluated.
    pub when: char,
    /// Groups and condition as written: formulas that share it are visible together.
    pub visible: &'static str,
    /// The number of its equation in the paper.
    pub equation: &'static str,
    /// The quantity and the index of the part that it computes, if it is one of them.
    pub result: Option<(Quantity, usize)>,
    /// Its parts from left to right.
    pub pieces: Vec<Piece>,
}

/// A part of a formula.
#[derive(Clone, Debug)]
pub enum Piece {
    /// LaTeX between terms.
    Latex(&'static str),
    /// A term.
    Term(Term),
}

/// A term of a formula.
#[derive(Clone, Debug)]
pub struct Term {
    /// Its number among all terms of all formulas.
    pub number: usize,
    /// Its name in the closed form.
    pub name: &'static str,
    /// The same as a label.
    pub label: Label,
    /// Whether its value is a vector, and which of the values of this name it is; nothing if it is a matrix.
    pub value: Option<(bool, usize)>,
    /// What is written for it.
    pub latex: &'static str,
}

impl Formula {
    /// Its terms.
    pub fn terms(&self) -> impl Iterator<Item = &Term> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Term(term) => Some(term),
            Piece::Latex(_) => None,
        })
    }

    /// Whether it is shown in a group, if `holds` tells which conditions hold.
    pub(crate) fn is_shown(&self, group: &str, holds: impl Fn(char) -> bool) -> bool {
        holds(self.when) && self.groups.iter().any(|&(name, when)| name == group && holds(when))
    }
}

/// All formulas.
///
/// # Panics
/// If the file of the formulas has a mistake; a test reads it.
pub fn formulas() -> &'static [Formula] {
    static ALL: OnceLock<Vec<Formula>> = OnceLock::new();
    ALL.get_or_init(|| {
        let mut count = 0;
        TEXT.lines().filter(|line| !line.starts_with('#')).map(|line| read(line, &mut count)).collect()
    })
}

fn read(line: &'static str, count: &mut usize) -> Formula {
    let fields: Vec<&'static str> = line.splitn(5, " @ ").collect();
    let [groups, when, equation, result, mut rest] = fields[..] else {
        panic!("{line:?} has no five fields")
    };
    let letter = |text: &str| text.chars().next().unwrap_or('.');
    let group =
        |text: &'static str| text.split_once('?').map_or((text, '.'), |(name, when)| (name, letter(when)));
    let mut pieces = Vec::new();
    while let Some((before, from)) = rest.split_once("[[") {
        let (term, after) =
            from.split_once("]]").unwrap_or_else(|| panic!("a term of {line:?} does not end"));
        pieces.push(Piece::Latex(before.trim()));
        pieces.push(Piece::Term(of_term(term, *count)));
        *count += 1;
        rest = after;
    }
    pieces.push(Piece::Latex(rest.trim()));
    pieces.retain(|piece| !matches!(piece, Piece::Latex("")));
    Formula {
        groups: groups.split(' ').map(group).collect(),
        when: letter(when),
        visible: line[..groups.len() + " @ ".len() + when.len()].into(),
        equation,
        result: of_result(result),
        pieces,
    }
}

fn of_term(text: &'static str, number: usize) -> Term {
    let fields: Vec<&str> = text.splitn(3, ';').collect();
    let [name, value, latex] = fields[..] else { panic!("{text:?} has no name, value and LaTeX") };
    let of = |number: &str| number.parse().unwrap_or_else(|_| panic!("{text:?} has no number of a value"));
    let value = match value {
        "m" => None,
        _ => Some(value.strip_prefix('v').map_or_else(|| (false, of(value)), |number| (true, of(number)))),
    };
    let label = Label::read(name).unwrap_or_else(|| panic!("{text:?} has no formula"));
    Term { number, name, label, value, latex }
}

fn of_result(text: &str) -> Option<(Quantity, usize)> {
    let (quantity, part) = text.split_once(' ')?;
    let part = if part == "second" { "Delta-delta" } else { part };
    let quantity = Quantity::ALL.into_iter().find(|known| known.name() == quantity);
    let part = Varied::<f64>::PARTS.iter().position(|known| *known == part);
    quantity.zip(part).or_else(|| panic!("{text:?} is no part of a quantity"))
}
