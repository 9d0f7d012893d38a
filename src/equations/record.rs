//! The results for each equation.

use super::arc::Arc;
use super::source::Place;
use super::table::{Kind, Order, Reading};
use super::verdict::Verdict;
use serde::{Deserialize, Serialize};

/// All equations of the paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EquationTable {
    /// The seed of draws and cases.
    pub seed: u64,
    /// The draws for each ordered pair of families, over the prime field.
    pub draws: u64,
    /// Ordered pairs of families that are linear in their dofs, and those with one that is not.
    pub pairs: [u64; 2],
    /// The numbers of closest points in `f64`: of pairs that are linear in their dofs, and of those with one that is not.
    pub points: [u64; 2],
    /// Equation by equation.
    pub equations: Vec<EquationRow>,
    /// The claims of the paper about symmetry.
    pub claims: Vec<Claim>,
}

/// One equation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EquationRow {
    /// Its number.
    pub number: u8,
    /// Its statement.
    pub says: String,
    /// Its kind.
    pub kind: Kind,
    /// Its verdict.
    pub verdict: Verdict,
    /// LaTeX, as printed.
    pub printed: String,
    /// The corrected LaTeX, with the terms that the paper drops. For long equations, only the difference.
    pub corrected: Option<String>,
    /// Additional remarks.
    pub remark: String,
    /// The draws in which each part is equal in some reading of the print.
    pub as_printed: Score,
    /// The draws in which each part is equal as corrected.
    pub as_corrected: Score,
    /// The equalities with this number.
    pub parts: Vec<Part>,
    /// The terms that a list omits.
    pub omitted: Vec<String>,
    /// The difference between a slip along the tangent and the arc length.
    pub arcs: Vec<Arc>,
    /// The places in the source.
    pub places: Vec<Place>,
}

/// One of the equalities with one number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Its left-hand side, if there are several.
    pub name: String,
    /// Its order.
    pub order: Order,
    /// Every evaluated reading.
    pub runs: Vec<Run>,
}

/// One reading of an equality, evaluated.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// The kind of reading.
    pub reading: Reading,
    /// The reading in words.
    pub words: String,
    /// The counts of equal draws, and the errors.
    pub score: Score,
    /// The counts of draws that are unchanged with delta and Delta exchanged: at stationary pairs, and with random operands.
    pub symmetric: Option<[Counts; 2]>,
}

/// The results of a formula.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Score {
    /// Over the prime field, for pairs of curves that are linear in their dofs.
    pub linear: Counts,
    /// For pairs with a curve that is not.
    pub nonlinear: Counts,
    /// The largest difference of both sides in `f64`, over the larger sum of the absolute values of their terms, to two
    /// digits; for the two kinds of pairs.
    pub errors: [Option<f64>; 2],
}

/// Counts of draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// The number of draws in which both sides were equal.
    pub equal: u64,
    /// The number of draws in which they were not equal.
    pub refuted: u64,
}

/// A claim about formulas of second order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Claim {
    /// The claim.
    pub says: String,
    /// The place of the claim in the paper.
    pub made: String,
    /// The numbers of formulas that are symmetric for any operands, symmetric by relations between them, and not
    /// symmetric.
    pub found: [u64; 3],
    /// The equations with a formula that is not symmetric.
    pub broken_by: Vec<u8>,
}

impl Claim {
    /// Whether such formulas exist and all are symmetric.
    pub fn holds(&self) -> bool {
        self.found[2] == 0 && self.found.iter().sum::<u64>() > 0
    }
}

impl EquationTable {
    /// Whether all equations are present and none is refuted as corrected.
    pub fn holds(&self) -> bool {
        self.equations.iter().map(|entry| entry.number).eq(1..=59)
            && self.equations.iter().all(|entry| entry.verdict != Verdict::Refuted)
    }

    /// The equation with this number.
    pub fn equation(&self, number: u8) -> Option<&EquationRow> {
        self.equations.iter().find(|entry| entry.number == number)
    }
}

impl Counts {
    /// The number of all draws.
    pub fn total(self) -> u64 {
        self.equal + self.refuted
    }

    /// Counts one draw.
    pub(super) fn count(&mut self, equal: bool) {
        *if equal { &mut self.equal } else { &mut self.refuted } += 1;
    }

    /// Adds the counts of other draws.
    pub(super) fn add(&mut self, other: Self) {
        self.equal += other.equal;
        self.refuted += other.refuted;
    }
}

impl EquationRow {
    /// The largest error of the print: compared with the reference, and for a slip with the arc length.
    pub fn error(&self) -> Option<f64> {
        let [linear, nonlinear] = self.as_printed.errors;
        let worst = linear.zip(nonlinear).map(|(linear, nonlinear)| linear.max(nonlinear));
        self.arcs.iter().map(|arc| arc.error).fold(worst, |worst, error| worst.map(|worst| worst.max(error)))
    }
}
