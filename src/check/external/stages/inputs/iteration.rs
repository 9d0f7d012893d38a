//! By how much something is wrong in the curves of a case, found by Gauss-Newton iterations.

use crate::check::external::stages::terms::Beam;
use crate::number::RunningError;
use nalgebra::{DMatrix, DVector};

/// The number of iterations.
const STEPS: usize = 25;
/// The number of iterations after which only a part of the residuals may be left, and this part.
const SLOW: usize = 10;
const REDUCED: f64 = 0.1;
/// The step of differences.
const STEP: f64 = 1e-5;
/// The part of the residuals that an iteration may leave.
const LEFT: f64 = 1e-7;

/// By how much something is wrong for each of these beams, if that leaves only rounding of the residuals. Nothing for a beam where
/// it has no effect. The estimates are the residuals without their rounding.
pub(in crate::check::external::stages) fn error_by_beam(
    beams: &[Beam],
    residuals: &dyn Fn([f64; 2]) -> Vec<RunningError>,
    estimates: &dyn Fn([f64; 2]) -> Vec<f64>,
) -> Option<[Option<f64>; 2]> {
    let mut by = [0.0; 2];
    let mut effects = [0.0; 2];
    let first = residuals(by);
    let weights: Vec<f64> = first.iter().map(|r| 1.0 / (r.value.abs() + 1e3 * r.bound)).collect();
    let weighted = |by: [f64; 2]| {
        let estimates = estimates(by);
        DVector::from_iterator(weights.len(), estimates.iter().zip(&weights).map(|(r, w)| r * w))
    };
    for k in 0..STEPS {
        let here = weighted(by);
        // The first residuals are 1 at most.
        if k >= SLOW && here.amax() > REDUCED {
            return None;
        }
        let mut slopes = DMatrix::zeros(here.len(), 2);
        for &beam in beams {
            let mut next = by;
            next[beam] += STEP;
            slopes.set_column(beam, &((weighted(next) - &here) / STEP));
        }
        if here.is_empty() || !here.iter().chain(&slopes).all(|number| number.is_finite()) {
            return None;
        }
        effects = [0, 1].map(|beam| slopes.column(beam).amax());
        let step = slopes.svd(true, true).solve(&here, 1e-9).ok()?;
        if !step.iter().all(|s| s.is_finite() && s.abs() < 1e3) {
            return None;
        }
        (by[0], by[1]) = (by[0] - step[0], by[1] - step[1]);
        if (0..2).all(|i| step[i].abs() <= 1e-10 * by[i].abs().max(1e-3)) {
            break;
        }
    }
    let is_small = |(left, first): (&RunningError, &RunningError)| {
        left.value.abs() <= 4.0 * left.bound + LEFT * first.value.abs()
    };
    let has_effect = |beam: Beam| effects[beam] > LEFT * effects[0].max(effects[1]);
    let found = [0, 1].map(|beam| Some(by[beam]).filter(|_| has_effect(beam)));
    residuals(by).iter().zip(&first).all(is_small).then_some(found)
}
