//! All that was found out about each equation.

use super::arc::Arc;
use super::claim::Claim;
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
    /// Closest points of the gate in `f64`: of pairs that are linear in their dofs, and of those with one that is not.
    pub points: [u64; 2],
    /// Equation by equation.
    pub equations: Vec<EquationRow>,
    /// What the paper says of symmetry.
    pub claims: Vec<Claim>,
}

/// One equation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EquationRow {
    /// Its number.
    pub number: u8,
    /// What it says.
    pub says: String,
    /// What it is.
    pub kind: Kind,
    /// What became of it.
    pub verdict: Verdict,
    /// LaTeX, as printed.
    pub printed: String,
    /// LaTeX, as it should be; of long equations, what differs.
    pub corrected: Option<String>,
    /// What else is to be said.
    pub remark: String,
    /// Draws in which each part is equal in some reading of the print.
    pub as_printed: Score,
    /// Draws in which each part is equal as corrected.
    pub as_corrected: Score,
    /// The equalities under this number.
    pub parts: Vec<Part>,
    /// What a list leaves out.
    pub omitted: Vec<String>,
    /// How far a slip along the tangent is from the arc length.
    pub arcs: Vec<Arc>,
    /// Where it is in the source.
    pub places: Vec<Place>,
}

/// One of the equalities under a number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Its left-hand side, if there are several.
    pub name: String,
    /// Its order.
    pub order: Order,
    /// Every reading that was run.
    pub runs: Vec<Run>,
}

/// One reading of an equality, run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// What kind of reading it is.
    pub reading: Reading,
    /// How it reads.
    pub words: String,
    /// How often it was equal, and how far off.
    pub score: Score,
    /// How often it stayed the same with delta and Delta exchanged: at stationary pairs, and with random operands.
    pub symmetric: Option<[Counts; 2]>,
}

/// How a formula did.
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

/// Draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// In which both sides were equal.
    pub equal: u64,
    /// In which they were not.
    pub refuted: u64,
}

impl EquationTable {
    /// Whether every equation is there and none is refuted as corrected.
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
    /// All draws.
    pub fn total(self) -> u64 {
        self.equal + self.refuted
    }

    /// Counts one draw.
    pub(super) fn count(&mut self, equal: bool) {
        *if equal { &mut self.equal } else { &mut self.refuted } += 1;
    }

    /// Adds other draws.
    pub(super) fn add(&mut self, other: Self) {
        self.equal += other.equal;
        self.refuted += other.refuted;
    }
}

impl EquationRow {
    /// The largest error of the print: against the truth, and for a slip against the arc length.
    pub fn error(&self) -> Option<f64> {
        let [linear, nonlinear] = self.as_printed.errors;
        let worst = linear.zip(nonlinear).map(|(linear, nonlinear)| linear.max(nonlinear));
        self.arcs.iter().map(|arc| arc.error).fold(worst, |worst, error| worst.map(|worst| worst.max(error)))
    }
}
