//! The equations of the paper in numbers, at one closest point.

use super::paper;
use super::plain;
use super::point::Point;
use super::table::{Equation, Order, Reading};
use crate::check::CaseData;
use crate::closest_point::ClosestPoint;
use serde::{Deserialize, Serialize};

/// One equation in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Worked {
    /// Its number.
    pub number: u8,
    /// The equalities with this number.
    pub parts: Vec<WorkedPart>,
}

/// One equality in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkedPart {
    /// Its left-hand side, if there are several.
    pub name: String,
    /// Its order.
    pub order: Order,
    /// Every reading.
    pub readings: Vec<WorkedReading>,
}

/// Both sides of one reading.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorkedReading {
    /// The kind of reading.
    pub reading: Reading,
    /// The reading in words.
    pub words: String,
    /// The left-hand side, by hyper-dual numbers.
    pub left: Vec<f64>,
    /// The right-hand side, by the formula.
    pub right: Vec<f64>,
}

/// All equations in numbers, at a closest point of any case. The finite change moves the beam by a tenth of the distance.
///
/// None if the numbers define no beam, if the point is not inside both beams, or if it has no derivatives.
pub fn worked_at(case: &CaseData, point: &ClosestPoint) -> Option<Vec<Worked>> {
    plain::point(case, point).as_ref().map(worked)
}

/// All equations in numbers.
pub(super) fn worked(point: &Point<f64>) -> Vec<Worked> {
    let of = |equation: Equation<f64>| Worked {
        number: equation.number,
        parts: (equation.parts.into_iter())
            .map(|part| WorkedPart {
                name: part.name.to_owned(),
                order: part.order,
                readings: (part.lines.into_iter())
                    .map(|line| WorkedReading {
                        reading: line.reading,
                        words: line.words.to_owned(),
                        left: line.left,
                        right: line.right,
                    })
                    .collect(),
            })
            .collect(),
    };
    paper::read(point).equations.into_iter().map(of).collect()
}

impl WorkedReading {
    /// The number of decimal digits in which both sides agree, by norm; the digits of an `f64` if they are equal.
    ///
    /// If one side must be zero, the other is compared with `scale`.
    pub fn digits(&self, scale: f64) -> f64 {
        let norm = |of: &mut dyn Iterator<Item = f64>| of.map(|x| x * x).sum::<f64>().sqrt();
        let difference = norm(&mut self.left.iter().zip(&self.right).map(|(l, r)| l - r));
        let size = norm(&mut self.left.iter().copied()).max(norm(&mut self.right.iter().copied()));
        let size = if self.right.iter().all(|&x| x == 0.0) { scale } else { size };
        (-(difference / size).log10()).clamp(0.0, 15.9)
    }
}
