//! The third oracle: central differences of the *value* in double-double, the closest point solved again for every dof
//! vector.
//!
//! It uses positions and nothing else. Tangents are differences of positions; the closest point is found by chord
//! iterations whose matrix is a difference of the orthogonality conditions; variations are differences of the
//! quantities at q ± h dq ± k Dq. No derivative is shared with the closed form or with automatic differentiation.
//!
//! # Steps
//! The distance over which the problem remains similar is measured. The rate at which the chord iterations
//! converge after a first step, and the relative changes of xi, d, t and t_bar, give a radius for each
//! direction. The first step is the part of the radius at which rounding and truncation are about equal. Twice and four
//! times this step are used too, and extrapolated to sixth order (L. F. Richardson).
//!
//! # Its error
//! Each number has an error estimate: the difference of the extrapolations of fourth and of sixth order, the rounding
//! of the positions (from their running error bound) carried through the solution and divided by the steps, and the
//! truncation of the tangents.

mod moved;
mod noise;
mod tangent;

use super::evaluation_point::EvaluationPoint;
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{DoubleDouble, Real};
use moved::Base;
use noise::Noise;

/// The largest step over the radius of the direction. Four times the step must be well within the radius.
const WIDEST: f64 = 1.0 / 64.0;

/// The safety factor on the difference of the two extrapolations. The steps suit the problem at the closest point, and
/// badly scaled beams change faster.
const CAUTION: f64 = 8.0;

/// A number with an estimate of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Estimated {
    pub(super) value: DoubleDouble,
    pub(super) error: f64,
}

/// All quantities with their variations; nothing if the closest point cannot be solved for again.
pub(super) fn differences(evaluation: &EvaluationPoint) -> Option<[Varied<Estimated>; COMPONENTS]> {
    let base = Base::new(evaluation)?;
    let radii = [base.radius([1.0, 0.0])?, base.radius([0.0, 1.0])?];
    // Rounding grows as ε/h², truncation as h⁴: the two are about equal at h⁶ = ε.
    let step = base.relative_noise().powf(1.0 / 6.0).min(WIDEST);
    let steps = radii.map(|radius| power_of_two(step * radius));
    let mut levels = [[[DoubleDouble::from(0.0); COMPONENTS]; 3]; 3];
    for (level, factor) in levels.iter_mut().zip([1.0, 2.0, 4.0]) {
        *level = corners(&base, steps.map(|step| factor * step))?;
    }
    let value = base.quantities();
    let Noise { rounding, truncation } = base.noise();
    let estimated = |i: usize, k: usize| {
        let [fine, middle, coarse] = levels.map(|level| level[k][i]);
        // The error of a second-order difference has terms h² and h⁴. From h, 2h, 4h first h² is removed, then h⁴.
        let fourth = extrapolated(fine, middle, 4.0);
        let sixth = extrapolated(fourth, extrapolated(middle, coarse, 4.0), 16.0);
        // 16/15 (4/3 + 1/3 · 1/2) + ... < 2 times the rounding of the finest difference.
        let over = |h: [f64; 2]| [h[0], h[1], h[0] * h[1]][k];
        let truncated = CAUTION * (sixth - fourth).abs().value();
        let error = truncated + 2.0 * rounding[i] / over(steps) + truncation[i] / over(radii);
        Estimated { value: sixth, error }
    };
    Some(std::array::from_fn(|i| Varied {
        value: Estimated { value: value[i], error: rounding[i] + truncation[i] },
        delta: estimated(i, 0),
        linear: estimated(i, 1),
        second: estimated(i, 2),
    }))
}

/// Both first differences and the mixed second one, of second order, from the four corners (± h, ± k).
fn corners(base: &Base, steps: [f64; 2]) -> Option<[[DoubleDouble; COMPONENTS]; 3]> {
    let at = |sign: f64, other: f64| Some(base.moved([sign * steps[0], other * steps[1]])?.quantities());
    let (pp, pm, mp, mm) = (at(1.0, 1.0)?, at(1.0, -1.0)?, at(-1.0, 1.0)?, at(-1.0, -1.0)?);
    let over = |by: f64| DoubleDouble::from(0.25 / by);
    Some([
        std::array::from_fn(|i| ((pp[i] - mm[i]) + (pm[i] - mp[i])) * over(steps[0])),
        std::array::from_fn(|i| ((pp[i] - mm[i]) - (pm[i] - mp[i])) * over(steps[1])),
        std::array::from_fn(|i| ((pp[i] - pm[i]) - (mp[i] - mm[i])) * over(steps[0]) * over(0.25 * steps[1])),
    ])
}

/// Removes the term that grows by `ratio` from `fine` to `coarse`.
fn extrapolated(fine: DoubleDouble, coarse: DoubleDouble, ratio: f64) -> DoubleDouble {
    fine + (fine - coarse) / DoubleDouble::from(ratio - 1.0)
}

/// The largest power of two below: products and quotients with it are exact.
fn power_of_two(x: f64) -> f64 {
    2.0_f64.powf(x.log2().floor())
}

/// The Euclidean norm as an `f64`.
fn norm(v: &nalgebra::Vector3<DoubleDouble>) -> f64 {
    v.dot(v).sqrt().value()
}

#[cfg(test)]
mod tests;
