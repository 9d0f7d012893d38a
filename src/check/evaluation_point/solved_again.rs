//! Bounds on the parameters for programs that solve for the closest point again, in `f64`.

use super::EvaluationPoint;
use crate::linearization::ad::Chord;
use crate::linearization::closed_form::{PartialVariations, Projection};
use crate::test_beam::RunningError2;
use nalgebra::Vector3;

impl EvaluationPoint<'_> {
    /// Widens the bounds for methods that solve for the closest point in `f64` again, from positions alone. Rounding of
    /// their conditions, whose tangents are derivatives of positions, moves the parameters too.
    pub(super) fn widen(&mut self) {
        let Self { beams: [beam, bar], held, at: (xi, xi_bar), .. } = *self;
        let exact = (RunningError2::from(xi.value), RunningError2::from(xi_bar.value));
        let chord = Chord::<RunningError2>::new(beam, bar, exact, held);
        let [step, step_bar] = chord.step(beam, bar, exact);
        for (at, step) in [(&mut self.at.0, step), (&mut self.at.1, step_bar)] {
            // Two steps, each of which rounds the parameter.
            let far = 2.0 * (step.value.abs() + step.bound[0] + f64::EPSILON * at.value.abs());
            at.bound[1] = at.bound[1].max(far);
        }
    }

    /// Both beams at the closest point, with these bounds on the parameters.
    pub(in crate::check) fn bounded_at(
        &self,
        (xi, xi_bar): (RunningError2, RunningError2),
    ) -> [PartialVariations<RunningError2>; 2] {
        let [beam, bar] = self.beams;
        [beam.partial_variations(xi), bar.partial_variations(xi_bar)]
    }

    /// The parameters, with bounds for methods that solve for the closest point in `f64` with positions and tangents that
    /// have these errors.
    pub(in crate::check) fn parameters_with(
        &self,
        errors: [Vector3<f64>; 2],
    ) -> (RunningError2, RunningError2) {
        let points = self.points();
        let size = |v: &Vector3<f64>, error: &Vector3<f64>| v.abs().dot(error);
        let of_both = errors[0] + errors[1];
        let residual = |t: &Vector3<f64>, own: &Vector3<f64>| size(t, &of_both) + size(&points.d, own);
        let residuals = [residual(&points.beam.t, &errors[0]), residual(&points.bar.t, &errors[1])];
        let inverse = Projection::new(&points.beam, &points.bar, self.held).inverse();
        let mut at = self.at;
        for (at, [p, q]) in [&mut at.0, &mut at.1].into_iter().zip(inverse) {
            at.bound[1] += p.abs() * residuals[0] + q.abs() * residuals[1];
        }
        at
    }
}
