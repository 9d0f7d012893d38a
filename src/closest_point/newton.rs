//! Newton's method for one stationary point.

use super::tree::evaluate;
use super::{Active, Centroid, ClosestPoint, HalfSquare, ProjectionError};
use crate::curve::Geometry;

/// The most steps. A simple zero takes five from nearby, a multiple one gains a bit a step.
const STEPS: usize = 60;
/// Steps below this, in the parameters, are the last ones.
const SMALL: f64 = 1e-7;

/// Follows Newton's method from `start` to the last digit, with the `active` parameters held at their ends.
///
/// The parameters that are free stay in [-1, 1]; those that are held are put to the end they are nearest to. Whether
/// the point is a minimum is for [`ClosestPoint::kind`] to say.
///
/// # Errors
/// [`ProjectionError::NonFinite`] if the start or a curve is not finite, [`ProjectionError::Singular`] if the Hessian is
/// exactly singular on the way, [`ProjectionError::NotConverged`] if the steps do not become small or end at an end.
pub fn refine(
    beam: &dyn Centroid,
    bar: &dyn Centroid,
    start: (f64, f64),
    active: Active,
) -> Result<ClosestPoint, ProjectionError> {
    if !(start.0.is_finite() && start.1.is_finite()) {
        return Err(ProjectionError::NonFinite);
    }
    let place = |held: bool, xi: f64| if held { 1.0_f64.copysign(xi) } else { xi.clamp(-1.0, 1.0) };
    let (mut xi, mut xi_bar) = (place(active.xi, start.0), place(active.xi_bar, start.1));
    let mut previous = f64::INFINITY;
    let mut best = Iterate::at(beam, bar, (xi, xi_bar), active)?;
    let mut current = best;
    for _ in 0..STEPS {
        let (step, step_bar) = current.half_square.step(active);
        if current.slope == 0.0 {
            break;
        }
        if !(step.is_finite() && step_bar.is_finite()) {
            return Err(ProjectionError::Singular { conditioning: current.half_square.conditioning(active) });
        }
        let next = ((xi + step).clamp(-1.0, 1.0), (xi_bar + step_bar).clamp(-1.0, 1.0));
        let size = (next.0 - xi).abs().max((next.1 - xi_bar).abs());
        if size == 0.0 || (size < SMALL && size >= 0.5 * previous) {
            break;
        }
        (xi, xi_bar) = next;
        current = Iterate::at(beam, bar, next, active)?;
        // Far away the gradient may grow for a while; at rounding level the least gradient is the best.
        if size >= SMALL || current.slope < best.slope {
            best = current;
        }
        previous = size;
    }
    let p = &best.half_square;
    let point = ClosestPoint::new(best.at, (&best.geometry[0], &best.geometry[1]), active);
    // Where positions carry much rounding the slope stays large; then the step that it still asks for is judged, unless
    // it leads out of the square.
    let (step, step_bar) = p.step(active);
    let settled = |held: bool, i: usize, at: f64, step: f64| {
        held || p.is_weak(i) || (step.abs() < SMALL && (at + step).abs() <= 1.0)
    };
    if settled(active.xi, 0, best.at.0, step) && settled(active.xi_bar, 1, best.at.1, step_bar) {
        Ok(point)
    } else {
        Err(ProjectionError::NotConverged { residual: point.residual })
    }
}

/// A pair of parameters with all that is known there.
#[derive(Clone, Copy)]
struct Iterate {
    at: (f64, f64),
    geometry: [Geometry<f64>; 2],
    half_square: HalfSquare,
    /// The larger component of the gradient for unit tangents.
    slope: f64,
}

impl Iterate {
    fn at(
        beam: &dyn Centroid,
        bar: &dyn Centroid,
        at: (f64, f64),
        active: Active,
    ) -> Result<Self, ProjectionError> {
        let geometry = [evaluate(beam, at.0)?, evaluate(bar, at.1)?];
        let half_square = HalfSquare::new(&geometry[0], &geometry[1]);
        Ok(Self { at, geometry, slope: half_square.slope(active), half_square })
    }
}
