//! The effect of the rounding of positions and the truncation of tangents on every quantity.

use super::moved::Base;
use super::norm;
use super::tangent::{REACH, STEP, WEIGHTS, tangent};
use crate::linearization::{COMPONENTS, Quantities};
use crate::number::{Differentiable, DoubleDouble, Dual};
use crate::test_beam::{AnyBeam, RunningError2};
use nalgebra::Vector3;

/// The rounding of double-double over that of `f64`: eight of its units 2^-106 in an operation.
const FINER: f64 = 8.0 * f64::EPSILON / 2.0;
/// The error of the stencil of twice the step is 2^8 times as large. The difference is 255 times the error, and half as
/// much again is allowed for the higher orders.
const TRUNCATED: f64 = 1.5 / 255.0;

/// The errors of all quantities at the closest point.
pub(super) struct Noise {
    /// From rounding: it is not smooth, so a difference divides it by its step.
    pub(super) rounding: [f64; COMPONENTS],
    /// From the truncation of the tangents: it is as smooth as the problem.
    pub(super) truncation: [f64; COMPONENTS],
}

/// The rounding of a position in double-double, from its running error bound in `f64`: the largest at the parameter
/// and at those of the tangent stencil, because shape functions may vanish at one of them.
pub(super) fn of_position(beam: &dyn AnyBeam, xi: f64) -> f64 {
    let at = |xi: f64| {
        let x: Vector3<Dual<Dual<RunningError2>>> =
            beam.position_at(RunningError2::from(xi).dual(0.0).dual(0.0));
        FINER * x.map(|x| x.re.re.bound[0]).norm()
    };
    [-REACH, 0.0, REACH].map(|off| at(xi + off)).into_iter().fold(0.0, f64::max)
}

impl Base<'_> {
    pub(super) fn noise(&self) -> Noise {
        let rounded = self.rounded;
        let beams = self.evaluation.beams.map(|beam| beam.moved([DoubleDouble::from(0.0); 2]));
        let truncated = [0, 1].map(|i| {
            let coarse = tangent(&*beams[i], self.place.at[i], 2.0 * STEP);
            TRUNCATED * norm(&(coarse - self.place.t[i]))
        });
        Noise {
            rounding: self.carried(rounded, rounded.map(|x| x * WEIGHTS / STEP)),
            truncation: self.carried([0.0; 2], truncated),
        }
    }

    /// The change of the parameters by rounding.
    pub(super) fn noise_of_parameters(&self) -> [f64; 2] {
        self.of_parameters(self.rounded, self.rounded.map(|x| x * WEIGHTS / STEP))
    }

    /// The largest relative rounding of the numbers that the problem depends on.
    pub(super) fn relative_noise(&self) -> f64 {
        let tangents = self.rounded.map(|x| x * WEIGHTS / STEP);
        let xi = self.of_parameters(self.rounded, tangents);
        let lengths = self.place.t.map(|t| norm(&t));
        let d = self.rounded[0] + self.rounded[1] + lengths[0] * xi[0] + lengths[1] * xi[1];
        let all =
            [xi[0], xi[1], d / norm(&self.place.d()), tangents[0] / lengths[0], tangents[1] / lengths[1]];
        all.into_iter().fold(0.0, f64::max)
    }

    fn of_parameters(&self, x: [f64; 2], t: [f64; 2]) -> [f64; 2] {
        let d = norm(&self.place.d());
        // δ(d·t) = d·δt + δd·t
        let f = [0, 1].map(|i| d * t[i] + norm(&self.place.t[i]) * (x[0] + x[1]));
        self.inverse.map(|[p, q]| p.abs() * f[0] + q.abs() * f[1])
    }

    /// The effect of errors of positions and tangents at fixed parameters on all quantities.
    fn carried(&self, x: [f64; 2], t: [f64; 2]) -> [f64; COMPONENTS] {
        let xi = self.of_parameters(x, t);
        let lengths = self.place.t.map(|t| norm(&t));
        let point = [0, 1].map(|i| x[i] + lengths[i] * xi[i]);
        // The last term is the rounding of squares and roots of the tangents, half an ulp of an `f64` made finer.
        let along = [0, 1].map(|i| t[i] + self.bends[i] * xi[i] + FINER * 0.5 * f64::EPSILON * lengths[i]);
        let slip =
            |i: usize, start: f64| (self.place.at[i].value() - start).abs() * along[i] + lengths[i] * xi[i];
        let d = point[0] + point[1];
        Quantities {
            x: Vector3::repeat(point[0]),
            x_bar: Vector3::repeat(point[1]),
            d_vector: Vector3::repeat(d),
            t_vector: Vector3::repeat(along[0]),
            t_bar_vector: Vector3::repeat(along[1]),
            d,
            t: along[0],
            t_bar: along[1],
            xi: xi[0],
            xi_bar: xi[1],
            g_n: d,
            g_t: slip(0, self.evaluation.contact.xi_0),
            g_t_bar: slip(1, self.evaluation.contact.xi_bar_0),
        }
        .components()
    }
}
