//! The parameters of a closest point as bounded numbers: how far they may be from the exact closest point.

use crate::closest_point::ClosestPoint;
use crate::linearization::closed_form::Projection;
use crate::number::Bounded;
use crate::specimen::AnyBeam;

/// xi and xi_bar with bounds, from the residual of the orthogonality conditions.
///
/// The residual and its rounding, multiplied by the inverse of the projection matrix, bound the step to the exact
/// closest point; the matrix over the whole uncertain region must stay regular. Nothing if it does not.
pub(super) fn parameters(beams: [&dyn AnyBeam; 2], point: &ClosestPoint) -> Option<(Bounded, Bounded)> {
    let active = point.active();
    let steps = |xi: Bounded, xi_bar: Bounded| {
        let (x, x_bar) = (beams[0].geometry_at(xi), beams[1].geometry_at(xi_bar));
        // The residual is that of the parameters as they are; the matrix that of the region they may be in.
        let (at, at_bar) = (beams[0].geometry_at(xi.value.into()), beams[1].geometry_at(xi_bar.value.into()));
        let d = at.x - at_bar.x;
        let residual = [d.dot(&at.t), d.dot(&at_bar.t)].map(|f| f.value.abs() + f.bound);
        Projection::new(&x, &x_bar, active).inverse().map(|row| {
            row.into_iter().zip(residual).map(|(entry, f)| (entry.value.abs() + entry.bound) * f).sum::<f64>()
        })
    };
    // The region is guessed from the matrix at its centre, doubled, and must then contain the step it yields.
    let [guess, guess_bar] = steps(point.xi.into(), point.xi_bar.into()).map(|step| 2.0 * step);
    let (xi, xi_bar) = (Bounded::new(point.xi, guess), Bounded::new(point.xi_bar, guess_bar));
    let [step, step_bar] = steps(xi, xi_bar);
    (step <= guess && step_bar <= guess_bar).then_some((xi, xi_bar))
}
