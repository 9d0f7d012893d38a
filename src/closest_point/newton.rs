//! Newton's method for one stationary point.

use super::unit::{is_usual_square, scaled};
use super::{Centroid, ClosestPoint, Held, ProjectionError, Side, SquaredDistance};
use crate::curve::Geometry;
use crate::number::Which;

/// The maximum number of steps. A simple zero takes two or three from nearby. A multiple one gains one bit a step.
const STEPS: usize = 60;
/// A step below this, in the parameters, is the last one.
const SMALL: f64 = 1e-7;
/// After a step below this, the error is the square of the step, which is rounding.
const LAST: f64 = 1e-8;
/// The widest step, in both parameters together, for which Taylor polynomials are used.
const REACH: f64 = 0.5;

/// Iterates Newton's method from `start` to the last digit, with the `held` parameters held at their ends.
///
/// The free parameters stay in [-1, 1]. The held parameters are set to the nearest end. [`ClosestPoint::kind`] says
/// whether the point is a minimum.
///
/// # Errors
/// [`ProjectionError::NonFinite`] if the start or a curve is not finite or the curves are of too unlike sizes,
/// [`ProjectionError::Singular`] if the Hessian becomes singular, or so nearly that the steps have no meaning,
/// [`ProjectionError::AtEnd`] if the steps lead out of a beam, [`ProjectionError::NotConverged`] if they do not become small.
pub fn refine(
    beam: &dyn Centroid,
    bar: &dyn Centroid,
    start: (f64, f64),
    held: Held,
) -> Result<ClosestPoint, ProjectionError> {
    if !(start.0.is_finite() && start.1.is_finite()) {
        return Err(ProjectionError::NonFinite);
    }
    let place = |held: bool, xi: f64| if held { 1.0_f64.copysign(xi) } else { xi.clamp(-1.0, 1.0) };
    let start = (place(held.xi, start.0), place(held.xi_bar, start.1));
    let found = match Iterate::at(beam, bar, start) {
        Ok(first) if is_usual_square(first.squared_distance.size2) => iterated([beam, bar], first, held),
        Ok(_) => Err(ProjectionError::NonFinite),
        Err(error) => Err(error),
    };
    if let Err(ProjectionError::NonFinite) = found {
        return refined_in_unit([beam, bar], start, held);
    }
    found
}

/// Newton's method in another unit of length.
#[cold]
#[inline(never)]
fn refined_in_unit(
    curves: [&dyn Centroid; 2],
    start: (f64, f64),
    held: Held,
) -> Result<ClosestPoint, ProjectionError> {
    let ([beam, bar], unit) = scaled(curves)?;
    let first = Iterate::at(&beam, &bar, start)?;
    Ok(iterated([&beam, &bar], first, held)?.in_unit(unit))
}

/// Newton's method from the first iterate.
#[inline]
fn iterated(
    [beam, bar]: [&dyn Centroid; 2],
    mut current: Iterate,
    held: Held,
) -> Result<ClosestPoint, ProjectionError> {
    let cubic = beam.is_cubic() && bar.is_cubic();
    // At rounding level the iterate with the smallest gradient is the best one. Later iterates may be worse.
    let mut best: Option<Iterate> = None;
    let mut previous = f64::INFINITY;
    for _ in 0..STEPS {
        if current.squared_distance.is_stationary(held) {
            return settled(current.at, &current.squared_distance, held);
        }
        let step = current.squared_distance.step(held);
        if !(step.0.is_finite() && step.1.is_finite()) {
            return Err(ProjectionError::Singular {
                conditioning: current.squared_distance.conditioning(held),
            });
        }
        let next = moved(current.at, step);
        let size = apart(current.at, next);
        if size == 0.0 || (size < SMALL && size >= 0.5 * previous) {
            break;
        }
        if size <= 2.0 * f64::EPSILON && best.is_none() {
            // The last digits of the parameters move the points by less than their rounding.
            return settled(next, &current.squared_distance, held);
        }
        let at = current.ahead(next, size, held);
        let new = if cubic && current.evaluated && apart(current.at, at) < REACH {
            current.extrapolated(at)
        } else {
            Iterate::at(beam, bar, at)?
        };
        // Far from the zero the gradient may grow for some steps.
        let least = &best.as_ref().unwrap_or(&current).squared_distance;
        if size >= SMALL || new.squared_distance.slope(held) < least.slope(held) {
            best = None;
        } else if best.is_none() {
            best = Some(current);
        }
        current = new;
        previous = size;
    }
    let end = best.as_ref().unwrap_or(&current);
    settled(end.at, &end.squared_distance, held)
}

/// The point where the iteration ended, if the steps have become small.
#[inline]
fn settled(at: (f64, f64), p: &SquaredDistance, held: Held) -> Result<ClosestPoint, ProjectionError> {
    let mut point = ClosestPoint::new(at, p, held);
    // If the positions have large rounding errors, the slope stays large. Then the next step has to be small, and must
    // not leave the square.
    let (step, step_bar) = p.step(held);
    let free = [(0, held.xi, at.0, step), (1, held.xi_bar, at.1, step_bar)];
    let free = || free.into_iter().filter(|&(i, held, ..)| !held && !p.is_weak(i));
    let leaves = |at: f64, step: f64| (at + step).abs() > 1.0;
    if let Some((i, _, at, _)) = free().find(|&(_, _, at, step)| at.abs() >= 1.0 && leaves(at, step)) {
        return Err(ProjectionError::AtEnd { which: [Which::Beam, Which::Bar][i], side: Side::nearest(at) });
    }
    let is_still =
        (!held.xi && p.is_near_standstill(0, step)) || (!held.xi_bar && p.is_near_standstill(1, step_bar));
    if is_still || free().any(|(_, _, at, step)| step.is_nan() || step.abs() >= SMALL || leaves(at, step)) {
        return Err(ProjectionError::NotConverged { residual: point.residual });
    }
    if !free().all(|(i, ..)| p.explains_gradient(i, SMALL)) {
        return Err(ProjectionError::Singular { conditioning: point.conditioning });
    }
    // Where the last digit of one parameter changes its gradient much, the other parameter is off by its next step.
    for (uncertainty, step) in point.uncertainty.iter_mut().zip([step, step_bar]) {
        *uncertainty = uncertainty.max((2.0 * step.abs()).min(SMALL));
    }
    Ok(point)
}

/// A pair of parameters with the quantities computed there.
struct Iterate {
    at: (f64, f64),
    geometry: [Geometry<f64>; 2],
    squared_distance: SquaredDistance,
    /// Whether the curves were evaluated here, and not extrapolated.
    evaluated: bool,
}

impl Iterate {
    #[inline(always)]
    fn at(beam: &dyn Centroid, bar: &dyn Centroid, at: (f64, f64)) -> Result<Self, ProjectionError> {
        let geometry = [beam.geometry(at.0), bar.geometry(at.1)];
        let squared_distance = SquaredDistance::new(&geometry[0], &geometry[1]);
        if !squared_distance.is_finite() {
            return Err(ProjectionError::NonFinite);
        }
        Ok(Self { at, geometry, squared_distance, evaluated: true })
    }

    /// The iterate at other parameters, with the curves from their Taylor polynomials of third degree.
    #[inline(always)]
    fn extrapolated(&self, at: (f64, f64)) -> Self {
        let geometry = self.geometry_at(at);
        Self {
            at,
            squared_distance: SquaredDistance::new(&geometry[0], &geometry[1]),
            geometry,
            evaluated: false,
        }
    }

    /// The curves from these polynomials.
    #[inline(always)]
    fn geometry_at(&self, at: (f64, f64)) -> [Geometry<f64>; 2] {
        [about(&self.geometry[0], at.0 - self.at.0), about(&self.geometry[1], at.1 - self.at.1)]
    }

    /// The result of Newton's method from here through `next`, with Taylor polynomials in place of the curves.
    ///
    /// The polynomials are exact if the curves are cubic. For other curves, this result replaces two or three Newton
    /// steps. The loop stops if a step is not much smaller than the one before.
    #[inline]
    fn ahead(&self, mut next: (f64, f64), mut size: f64, held: Held) -> (f64, f64) {
        while size > LAST && size < REACH {
            let [x, x_bar] = self.geometry_at(next);
            let further = moved(next, SquaredDistance::new(&x, &x_bar).step(held));
            let step = apart(next, further);
            // If the step is not a number, the polynomials are singular there.
            if step.is_nan() || step > 0.25 * size {
                break;
            }
            (next, size) = (further, step);
        }
        next
    }
}

/// The Taylor polynomial of third degree, at the distance `h` from the point of the known geometry.
#[inline]
fn about(at: &Geometry<f64>, h: f64) -> Geometry<f64> {
    let Geometry { x, t, t_xi, t_xixi } = at;
    let square = h * h;
    Geometry {
        x: (x + t * h) + (t_xi * 0.5 + t_xixi * (1.0 / 6.0) * h) * square,
        t: (t + t_xi * h) + t_xixi * 0.5 * square,
        t_xi: t_xi + t_xixi * h,
        t_xixi: *t_xixi,
    }
}

/// The parameters after a step, limited to the square.
#[inline]
fn moved(at: (f64, f64), step: (f64, f64)) -> (f64, f64) {
    ((at.0 + step.0).clamp(-1.0, 1.0), (at.1 + step.1).clamp(-1.0, 1.0))
}

/// The distance of two pairs of parameters; not a number if one of the four is not.
#[inline]
fn apart(one: (f64, f64), other: (f64, f64)) -> f64 {
    (one.0 - other.0).abs() + (one.1 - other.1).abs()
}
