//! The circular arc, in any position and orientation.

use super::screw::{Layout, Screw, ScrewDofs};
use super::{Curve, DofDerivatives, Jet, by_rows};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// A circular arc of fixed opening angle.
///
/// Half its opening angle, alpha (radian), is a fixed parameter. Dofs: centre c (3, the user's unit of length), radius r
/// (1, a length), orientation p = (w, x, y, z) (4, an unnormalised quaternion, scalar first, not zero), phase (1,
/// radian); `N = 9`.
///
/// ```math
/// x(xi) = c + R(p) (r cos phi, r sin phi, 0),   phi = phase + alpha xi
/// ```
///
/// The length of p has no effect, and a rotation about the axis of the circle equals a change of phase. These dofs are
/// redundant for a finite element, but useful as a test of a linearization. The derivation is that of the screw
/// line without pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    half_angle: f64,
}

impl Arc {
    /// The arc that spans the angle from -`half_angle` to `half_angle` (radian) about its phase.
    pub const fn new(half_angle: f64) -> Self {
        Self { half_angle }
    }
}

const LAYOUT: Layout = Layout { quaternion: 4, radius: 3, pitch: None, phase: 8 };

fn screw<T: Real>(q: &SVector<T, 9>) -> Screw<T> {
    Screw::read(LAYOUT, q)
}

impl Curve<9> for Arc {
    type Dofs<T: Real> = ScrewDofs<T>;

    fn position<T: Real>(&self, q: &SVector<T, 9>, xi: T) -> Vector3<T> {
        screw(q).position(self.half_angle, xi)
    }

    fn jet<T: Real>(&self, q: &SVector<T, 9>, xi: T) -> Jet<T, ScrewDofs<T>> {
        screw(q).jet(self.half_angle, xi)
    }

    /// Exact: ‖x,xixixi‖ = |r alpha^3| everywhere.
    fn third_derivative_bound(&self, q: &SVector<f64, 9>) -> f64 {
        (q[3] * self.half_angle.powi(3)).abs()
    }
}

impl<T: Real> DofDerivatives<T, 9> for ScrewDofs<T> {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<T, 9>) -> Vector3<T> {
        self.vary(k, &screw(dq))
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, 9>, linear_dq: &SVector<T, 9>) -> Vector3<T> {
        self.vary_twice(k, &screw(dq), &screw(linear_dq))
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, 9> {
        self.gradient_in(LAYOUT, k, w)
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, 9> {
        by_rows(|w| self.gradient_in(LAYOUT, k, w))
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> SMatrix<T, 9, 9> {
        self.hessian_in(LAYOUT, k, w)
    }
}
