//! The parameters of the closest point, refined in double-double.

use super::EvaluationPoint;
use crate::linearization::closed_form::Projection;
use crate::number::DoubleDouble;
use crate::test_beam::RunningError2;

impl EvaluationPoint<'_> {
    /// The parameters in double-double, by Newton's method; nothing if it does not converge.
    pub(super) fn refined(&self) -> Option<[Refined; 2]> {
        let Self { beams: [beam, bar], held, at, .. } = *self;
        let (mut xi, mut xi_bar) = (DoubleDouble::from(at.0.value), DoubleDouble::from(at.1.value));
        let mut previous = f64::INFINITY;
        for _ in 0..STEPS {
            let (x, x_bar) = (beam.geometry_precise(xi), bar.geometry_precise(xi_bar));
            let d = x.x - x_bar.x;
            // Eq. (48): d·t = d·t̄ = 0, by the matrix of (50).
            let (step, step_bar) = Projection::new(&x, &x_bar, held).solve(-d.dot(&x.t), -d.dot(&x_bar.t));
            let [size, size_bar] = [step, step_bar].map(|step| step.value().abs());
            let larger = size.max(size_bar);
            let is_last = size <= FINER * at.0.bound[0] && size_bar <= FINER * at.1.bound[0];
            if is_last || larger >= 0.5 * previous {
                let end = |value, size: f64, was: RunningError2| Refined {
                    value,
                    bound: 2.0 * size + FINER * was.bound[0],
                    within: was,
                };
                let both = [end(xi + step, size, at.0), end(xi_bar + step_bar, size_bar, at.1)];
                return both.iter().all(Refined::is_within).then_some(both);
            }
            (xi, xi_bar, previous) = (xi + step, xi_bar + step_bar, larger);
        }
        None
    }
}

/// A parameter of the closest point in double-double.
#[derive(Clone, Copy)]
pub(super) struct Refined {
    pub(super) value: DoubleDouble,
    /// The remaining step, and the rounding of double-double: that part of the rounding of `f64`.
    bound: f64,
    /// The known enclosure of the parameter.
    within: RunningError2,
}

impl Refined {
    fn is_within(&self) -> bool {
        let moved = (self.value - DoubleDouble::from(self.within.value)).abs().value();
        let [bound, _] = self.within.bound;
        moved <= bound && self.bound <= bound
    }

    /// The nearest `f64`, with a bound of about half an ulp, and with the bound that was known before.
    pub(super) fn rounded(self) -> RunningError2 {
        let value = self.value.value();
        let rounding = (self.value - DoubleDouble::from(value)).abs().value();
        let [_, within] = self.within.bound;
        RunningError2::new(value, [rounding + self.bound, within + (value - self.within.value).abs()])
    }
}

/// The rounding of double-double over that of `f64`: eight of its units 2^-106 in an operation.
const FINER: f64 = 8.0 * f64::EPSILON / 2.0;
/// The maximum number of steps of Newton's method, which doubles the digits each time.
const STEPS: usize = 12;
