//! The table of the equations: the statement of each, and both its sides at one point, in every reading.

use crate::number::Real;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// The kind of an equation. Equations that are not statements are computed only to confirm that they are satisfied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// It states that two things are equal.
    Statement,
    /// It defines a name.
    Definition,
    /// It lists the terms that are needed.
    List,
    /// It makes an assumption.
    Assumption,
    /// It is missing in the scan of the paper.
    Lost,
}

/// The order of a part of an equation in the variations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Order {
    /// No variation.
    Value,
    /// delta or Delta.
    First,
    /// Delta-delta: symmetry applies.
    Second,
    /// delta and Delta are finite increments.
    Finite,
}

/// The reading of an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reading {
    /// As printed. One of several readings, if the print has no meaning or more than one.
    Printed,
    /// A reading that is not printed.
    Other,
    /// With the misprint corrected.
    Corrected,
    /// With the terms Delta_u delta_u u that the paper drops.
    Complete,
}

/// Both sides of one reading.
#[derive(Clone, Debug)]
pub(super) struct Line<T> {
    pub(super) reading: Reading,
    pub(super) words: &'static str,
    pub(super) left: Vec<T>,
    pub(super) right: Vec<T>,
}

/// One of the equalities with one number.
#[derive(Clone, Debug)]
pub(super) struct Part<T> {
    pub(super) name: &'static str,
    pub(super) order: Order,
    pub(super) lines: Vec<Line<T>>,
}

/// An equation of the paper at one point.
#[derive(Clone, Debug)]
pub(super) struct Equation<T> {
    pub(super) number: u8,
    pub(super) kind: Kind,
    pub(super) says: &'static str,
    pub(super) printed: &'static str,
    pub(super) corrected: Option<&'static str>,
    pub(super) remark: &'static str,
    pub(super) parts: Vec<Part<T>>,
}

/// All equations at one point.
#[derive(Clone, Debug, Default)]
pub(super) struct Table<T> {
    pub(super) equations: Vec<Equation<T>>,
}

impl<T: Real> Table<T> {
    /// Adds an equation with the printed LaTeX.
    pub(super) fn enter(
        &mut self,
        number: u8,
        kind: Kind,
        says: &'static str,
        printed: &'static str,
    ) -> &mut Equation<T> {
        self.equations.push(Equation {
            number,
            kind,
            says,
            printed,
            corrected: None,
            remark: "",
            parts: Vec::new(),
        });
        let last = self.equations.len() - 1;
        &mut self.equations[last]
    }

    /// Adds a statement.
    pub(super) fn state(
        &mut self,
        number: u8,
        says: &'static str,
        printed: &'static str,
    ) -> &mut Equation<T> {
        self.enter(number, Kind::Statement, says, printed)
    }

    /// Adds a definition.
    pub(super) fn define(
        &mut self,
        number: u8,
        says: &'static str,
        printed: &'static str,
    ) -> &mut Equation<T> {
        self.enter(number, Kind::Definition, says, printed)
    }
}

impl<T: Real> Equation<T> {
    /// Sets the corrected LaTeX.
    pub(super) fn corrected_to(&mut self, latex: &'static str) -> &mut Self {
        self.corrected = Some(latex);
        self
    }

    /// Adds a remark.
    pub(super) fn remark(&mut self, words: &'static str) -> &mut Self {
        self.remark = words;
        self
    }

    /// Begins a part.
    pub(super) fn part(&mut self, order: Order, name: &'static str) -> &mut Self {
        self.parts.push(Part { name, order, lines: Vec::new() });
        self
    }

    fn line(
        &mut self,
        reading: Reading,
        words: &'static str,
        left: impl Sides<T>,
        right: impl Sides<T>,
    ) -> &mut Self {
        if let Some(part) = self.parts.last_mut() {
            part.lines.push(Line { reading, words, left: left.entries(), right: right.entries() });
        }
        self
    }

    /// Both sides as printed.
    pub(super) fn printed(&mut self, left: impl Sides<T>, right: impl Sides<T>) -> &mut Self {
        self.line(Reading::Printed, "", left, right)
    }

    /// Both sides as printed, in this reading.
    pub(super) fn read(
        &mut self,
        words: &'static str,
        left: impl Sides<T>,
        right: impl Sides<T>,
    ) -> &mut Self {
        self.line(Reading::Printed, words, left, right)
    }

    /// Both sides in a reading that is not printed.
    pub(super) fn other(
        &mut self,
        words: &'static str,
        left: impl Sides<T>,
        right: impl Sides<T>,
    ) -> &mut Self {
        self.line(Reading::Other, words, left, right)
    }

    /// Both sides with the misprint corrected.
    pub(super) fn corrected(
        &mut self,
        words: &'static str,
        left: impl Sides<T>,
        right: impl Sides<T>,
    ) -> &mut Self {
        self.line(Reading::Corrected, words, left, right)
    }

    /// Both sides with the terms that the paper drops.
    pub(super) fn complete(
        &mut self,
        words: &'static str,
        left: impl Sides<T>,
        right: impl Sides<T>,
    ) -> &mut Self {
        self.line(Reading::Complete, words, left, right)
    }
}

/// The contents of one side: numbers in brackets, a vector, or vectors in brackets.
pub(super) trait Sides<T> {
    fn entries(self) -> Vec<T>;
}

impl<T: Real, const N: usize> Sides<T> for [T; N] {
    fn entries(self) -> Vec<T> {
        self.to_vec()
    }
}

impl<T: Real> Sides<T> for Vector3<T> {
    fn entries(self) -> Vec<T> {
        self.iter().copied().collect()
    }
}

impl<T: Real, const N: usize> Sides<T> for [Vector3<T>; N] {
    fn entries(self) -> Vec<T> {
        self.iter().flat_map(|v| v.iter().copied()).collect()
    }
}
