//! Counts: sums the results of the readings at single points over all points.

use super::record::{Counts, Score};
use super::table::{Order, Reading, Table};
use crate::number::{PrimeField, TermScale};

/// The counts of one reading.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Line {
    pub(super) score: Tallied,
    /// At stationary pairs, and with random operands.
    pub(super) symmetric: [Counts; 2],
}

/// Counts and errors. Those of pairs that are linear in their dofs come first.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tallied {
    counts: [Counts; 2],
    errors: [f64; 2],
}

/// All counts, in the order of the table.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Reading by reading.
    pub(super) lines: Vec<Line>,
    /// Equation by equation, as printed and as corrected.
    pub(super) equations: Vec<[Tallied; 2]>,
    /// Points in `f64`.
    pub(super) points: [u64; 2],
}

impl Tally {
    /// A draw over the prime field: a stationary point, random operands, and both with delta and Delta exchanged.
    pub(super) fn of_draw(
        nonlinear: bool,
        point: [&Table<PrimeField>; 2],
        random: [&Table<PrimeField>; 2],
    ) -> Self {
        let at = usize::from(nonlinear);
        let mut tally = Self::default();
        let exchanged = [point, random].map(|[table, exchanged]| unchanged(table, exchanged));
        for equation in &point[0].equations {
            let mut met = [true; 2];
            for part in &equation.parts {
                let equal: Vec<bool> = part.lines.iter().map(|line| line.left == line.right).collect();
                let mut printed = false;
                let mut corrected = None;
                for (line, &equal) in part.lines.iter().zip(&equal) {
                    let i = tally.lines.len();
                    let mut counted = Line::default();
                    counted.score.counts[at].count(equal);
                    if part.order == Order::Second {
                        for (symmetric, same) in counted.symmetric.iter_mut().zip(&exchanged) {
                            symmetric.count(same[i]);
                        }
                    }
                    tally.lines.push(counted);
                    printed |= line.reading == Reading::Printed && equal;
                    // The last of print, correction and completion is the correction.
                    if line.reading != Reading::Other
                        && (corrected.is_none() || line.reading != Reading::Printed)
                    {
                        corrected = Some(equal);
                    }
                }
                met[0] &= printed;
                met[1] &= corrected == Some(true);
            }
            let mut counted = [Tallied::default(); 2];
            if !equation.parts.is_empty() {
                counted[1].counts[at].count(met[1]);
                if !equation.printed.is_empty() {
                    counted[0].counts[at].count(met[0]);
                }
            }
            tally.equations.push(counted);
        }
        tally
    }

    /// A closest point in `f64`.
    pub(super) fn of_point(nonlinear: bool, table: &Table<TermScale>) -> Self {
        let at = usize::from(nonlinear);
        let mut tally = Self::default();
        tally.points[at] = 1;
        for equation in &table.equations {
            let mut worst = [0.0_f64; 2];
            for part in &equation.parts {
                let (mut printed, mut corrected) = (f64::INFINITY, None);
                for line in &part.lines {
                    let error = error(&line.left, &line.right);
                    let mut counted = Line::default();
                    counted.score.errors[at] = error;
                    tally.lines.push(counted);
                    if line.reading == Reading::Printed {
                        printed = printed.min(error);
                    }
                    if line.reading != Reading::Other
                        && (corrected.is_none() || line.reading != Reading::Printed)
                    {
                        corrected = Some(error);
                    }
                }
                worst = [worst[0].max(printed), worst[1].max(corrected.unwrap_or(f64::INFINITY))];
            }
            let mut counted = [Tallied::default(); 2];
            for (counted, worst) in counted.iter_mut().zip(worst) {
                counted.errors[at] = worst;
            }
            tally.equations.push(counted);
        }
        tally
    }

    /// The sum of both tallies.
    pub(super) fn merge(mut self, other: Self) -> Self {
        if self.lines.is_empty() {
            return other;
        }
        for (line, other) in self.lines.iter_mut().zip(&other.lines) {
            line.score.merge(&other.score);
            line.symmetric[0].add(other.symmetric[0]);
            line.symmetric[1].add(other.symmetric[1]);
        }
        for (pair, others) in self.equations.iter_mut().zip(&other.equations) {
            pair[0].merge(&others[0]);
            pair[1].merge(&others[1]);
        }
        self.points = [self.points[0] + other.points[0], self.points[1] + other.points[1]];
        self
    }
}

impl Tallied {
    fn merge(&mut self, other: &Self) {
        for i in 0..2 {
            self.counts[i].add(other.counts[i]);
            self.errors[i] = self.errors[i].max(other.errors[i]);
        }
    }

    /// The score for the record.
    pub(super) fn score(&self) -> Score {
        let [linear, nonlinear] = self.counts;
        // Two digits, because the others depend on the machine. JSON has no infinity.
        let rounded =
            |error: f64| format!("{error:.1e}").parse().ok().filter(|error: &f64| error.is_finite());
        Score { linear, nonlinear, errors: self.errors.map(rounded) }
    }
}

/// For each reading, whether both sides are unchanged when delta and Delta are exchanged.
fn unchanged(table: &Table<PrimeField>, exchanged: &Table<PrimeField>) -> Vec<bool> {
    let lines = |table: &Table<PrimeField>| -> Vec<[Vec<PrimeField>; 2]> {
        let parts = table.equations.iter().flat_map(|equation| &equation.parts);
        parts.flat_map(|part| &part.lines).map(|line| [line.left.clone(), line.right.clone()]).collect()
    };
    lines(table).iter().zip(&lines(exchanged)).map(|(one, other)| one == other).collect()
}

/// The length of the difference over the larger scale of the two sides; infinite if it is not a number.
fn error(left: &[TermScale], right: &[TermScale]) -> f64 {
    let length = |of: &mut dyn Iterator<Item = f64>| of.map(|x| x * x).sum::<f64>().sqrt();
    let difference = length(&mut left.iter().zip(right).map(|(l, r)| l.value - r.value));
    let scale = |side: &[TermScale]| length(&mut side.iter().map(|x| x.scale));
    let error = difference / scale(left).max(scale(right));
    match (difference == 0.0, error.is_nan()) {
        (true, _) => 0.0,
        (false, true) => f64::INFINITY,
        (false, false) => error,
    }
}
