//! Tangents as differences of positions.

use crate::linearization::ad::PositionAt;
use crate::number::DoubleDouble;
use nalgebra::Vector3;

/// The step in the parameter, a power of two.
pub(super) const STEP: f64 = 1.0 / 2048.0;
/// The distance of the farthest position.
pub(super) const REACH: f64 = 4.0 * STEP;
/// The sum of the absolute weights of the stencil: the factor on the rounding of positions, over the step.
pub(super) const WEIGHTS: f64 = 2.0 * (672.0 + 168.0 + 32.0 + 3.0) / 840.0;

/// x,xi by the central difference of eighth order.
pub(super) fn tangent(
    beam: &dyn PositionAt<DoubleDouble>,
    xi: DoubleDouble,
    step: f64,
) -> Vector3<DoubleDouble> {
    let mut sum = Vector3::zeros();
    // (672 (x₁ − x₋₁) − 168 (x₂ − x₋₂) + 32 (x₃ − x₋₃) − 3 (x₄ − x₋₄)) / 840 h
    for (k, weight) in [(1.0, 672.0), (2.0, -168.0), (3.0, 32.0), (4.0, -3.0)] {
        let away = DoubleDouble::from(k * step);
        let difference = beam.position_at(xi + away) - beam.position_at(xi - away);
        sum += difference * DoubleDouble::from(weight);
    }
    sum / DoubleDouble::from(840.0 * step)
}
