//! Newton's steps for half the squared distance.

use super::SquaredDistance;
use crate::closest_point::Held;
use nalgebra::{Matrix2, Vector2};

impl SquaredDistance {
    /// Whether a step of this size explains the gradient in parameter `i`: g = -H step.
    ///
    /// It does not where the numerators of the step cancel, between nearly parallel tangents.
    pub(in crate::closest_point) fn explains_gradient(&self, i: usize, step: f64) -> bool {
        let own = [self.a, self.a_bar][i];
        self.gradient[i].abs() <= 2.0 * step * (own.abs() + self.b.abs())
    }

    /// The Newton step in the parameters that are not held; not finite if the Hessian is singular.
    pub(in crate::closest_point) fn step(&self, held: Held) -> (f64, f64) {
        let [g, g_bar] = self.gradient;
        match (held.xi, held.xi_bar) {
            (true, true) => (0.0, 0.0),
            (true, false) => (0.0, g_bar / self.a_bar),
            (false, true) => (-g / self.a, 0.0),
            (false, false) => {
                // H⁻¹ = [[-a_bar, b], [b, a]] / det H
                ((self.a_bar * g - self.b * g_bar) / self.det, -(self.b * g + self.a * g_bar) / self.det)
            }
        }
    }

    /// A Newton step only in the directions in which the Hessian, for unit tangents, is clearly not singular.
    ///
    /// It leads to a continuum of stationary points by the shortest step, where [`Self::step`] has no meaning.
    pub(in crate::closest_point) fn valley_step(&self, held: Held) -> (f64, f64) {
        const CLEAR: f64 = 1e-9;
        let lengths = self.squares.map(f64::sqrt);
        if held != Held::default() || lengths.contains(&0.0) {
            let step = self.step(held);
            return if self.smallest_magnitude(held) > CLEAR { step } else { (0.0, 0.0) };
        }
        let scaled = Vector2::new(self.gradient[0] / lengths[0], self.gradient[1] / lengths[1]);
        let off = -self.b / lengths[0] / lengths[1];
        let hessian = Matrix2::new(self.a / self.squares[0], off, off, -self.a_bar / self.squares[1]);
        let eigen = hessian.symmetric_eigen();
        let clear = CLEAR * eigen.eigenvalues.amax();
        let mut step = Vector2::zeros();
        for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            if value.abs() > clear {
                step -= vector * (vector.dot(&scaled) / value);
            }
        }
        (step[0] / lengths[0], step[1] / lengths[1])
    }
}
