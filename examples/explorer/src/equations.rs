//! The equations of the paper, evaluated.

use crate::html::{digits, number};
use beamgap::check::CaseData;
use beamgap::closest_point::ClosestPoint;
use beamgap::equations::{Reading, Worked, WorkedPart, WorkedReading, worked_at};
use serde::Serialize;

/// The cells of an equation, for its part that agrees in the fewest digits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EquationCells {
    /// Its number.
    pub number: u8,
    /// The value of the formula, corrected where the printed one is wrong.
    pub formula: String,
    /// The value by hyper-dual numbers.
    pub hyper_dual: String,
    /// The digits in which both values agree.
    pub digits: String,
    /// The digits in which the value of the printed formula agrees.
    pub printed: String,
}

/// All equations; nothing if they are not valid at this point.
pub fn cells(case: &CaseData, point: &ClosestPoint) -> Vec<EquationCells> {
    worked_at(case, point).unwrap_or_default().iter().map(cell).collect()
}

/// The relative error of a variant; if both sides are zero, the error relative to a length of the beams.
fn error(reading: &WorkedReading) -> f64 {
    10.0_f64.powf(-reading.digits(1.0))
}

/// The correct variant: the last of the printed, the corrected and the completed one.
fn right(part: &WorkedPart) -> Option<&WorkedReading> {
    let of = |reading| part.readings.iter().find(|run| run.reading == reading);
    of(Reading::Complete).or_else(|| of(Reading::Corrected)).or_else(|| of(Reading::Printed))
}

fn cell(worked: &Worked) -> EquationCells {
    let by_error = |x: &&WorkedReading, y: &&WorkedReading| error(x).total_cmp(&error(y));
    let worst = worked.parts.iter().filter_map(right).max_by(by_error);
    // Of several readings of a printed formula the best is used; of several parts the worst.
    let printed = |part: &WorkedPart| {
        let of_print = part.readings.iter().filter(|reading| reading.reading == Reading::Printed);
        of_print.map(error).reduce(f64::min)
    };
    let printed = worked.parts.iter().filter_map(printed).reduce(f64::max);
    EquationCells {
        number: worked.number,
        formula: worst.map(|reading| values(&reading.right)).unwrap_or_default(),
        hyper_dual: worst.map(|reading| values(&reading.left)).unwrap_or_default(),
        digits: worst.map(|reading| digits(error(reading))).unwrap_or_default(),
        printed: printed.map(digits).unwrap_or_default(),
    }
}

/// At most three numbers.
fn values(numbers: &[f64]) -> String {
    // Rounding errors of zero are shown as zero.
    let rounded = |&x: &f64| if x.abs() < 1e-12 { "0".to_owned() } else { number(x) };
    let shown = numbers.iter().take(3).map(rounded).collect::<Vec<_>>().join(", ");
    if numbers.len() > 3 { shown + ", .." } else { shown }
}
