//! The circular helix, in any position and orientation.

use super::screw::{Layout, Screw, ScrewDofs};
use super::{Curve, DofDerivatives, Jet, by_rows};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// A helix that winds through a fixed angle.
///
/// Half the angle it winds through, alpha (radian), is a fixed parameter. Dofs: centre c (3, the user's unit of
/// length), orientation p = (w, x, y, z) (4, an unnormalised quaternion, scalar first, not zero), radius r (1, a
/// length), pitch h (1, the rise in one turn, a length; its sign is the handedness), phase (1, radian); `N = 10`.
///
/// ```math
/// x(xi) = c + R(p) (r cos phi, r sin phi, h alpha xi / (2 pi)),   phi = phase + alpha xi
/// ```
///
/// The length of p has no effect. Unlike for the [`Arc`](super::Arc), all other dofs have one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Helix {
    half_angle: f64,
}

impl Helix {
    /// The helix that winds from -`half_angle` to `half_angle` (radian) about its phase.
    pub const fn new(half_angle: f64) -> Self {
        Self { half_angle }
    }
}

const LAYOUT: Layout = Layout { quaternion: 3, radius: 7, pitch: Some(8), phase: 9 };

fn screw<T: Real>(q: &SVector<T, 10>) -> Screw<T> {
    Screw::read(LAYOUT, q)
}

impl Curve<10> for Helix {
    type Dofs<T: Real> = ScrewDofs<T>;

    fn position<T: Real>(&self, q: &SVector<T, 10>, xi: T) -> Vector3<T> {
        screw(q).position(self.half_angle, xi)
    }

    fn jet<T: Real>(&self, q: &SVector<T, 10>, xi: T) -> Jet<T, ScrewDofs<T>> {
        screw(q).jet(self.half_angle, xi)
    }

    /// Exact: ‖x,xixixi‖ = |r alpha^3| everywhere; the rise is linear in xi.
    fn third_derivative_bound(&self, q: &SVector<f64, 10>) -> f64 {
        (q[7] * self.half_angle.powi(3)).abs()
    }
}

impl<T: Real> DofDerivatives<T, 10> for ScrewDofs<T> {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<T, 10>) -> Vector3<T> {
        self.vary(k, &screw(dq))
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, 10>, linear_dq: &SVector<T, 10>) -> Vector3<T> {
        self.vary_twice(k, &screw(dq), &screw(linear_dq))
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, 10> {
        self.gradient_in(LAYOUT, k, w)
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, 10> {
        by_rows(|w| self.gradient_in(LAYOUT, k, w))
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> SMatrix<T, 10, 10> {
        self.hessian_in(LAYOUT, k, w)
    }
}
