//! The orthographic projection from space to the picture.

use crate::state::ViewState;
use beamgap::nalgebra::Vector3;

/// The width of the picture.
pub(crate) const WIDTH: f64 = 720.0;
/// The height of the picture.
pub(crate) const HEIGHT: f64 = 430.0;

/// A view of the beams.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// The vector to the right in the picture.
    pub(crate) right: Vector3<f64>,
    /// The vector upwards in the picture.
    pub(crate) up: Vector3<f64>,
    /// The vector away from the eye.
    pub(crate) away: Vector3<f64>,
    /// Pixels per unit of length.
    pub(crate) scale: f64,
}

impl View {
    pub(crate) fn new(state: &ViewState) -> Self {
        let (sin, cos) = state.azimuth.to_radians().sin_cos();
        let (rise, level) = state.elevation.to_radians().sin_cos();
        Self {
            right: Vector3::new(cos, sin, 0.0),
            up: Vector3::new(-sin * rise, cos * rise, level),
            away: Vector3::new(-sin * level, cos * level, -rise),
            scale: state.scale,
        }
    }

    /// The position of a point in the picture.
    pub(crate) fn at(&self, x: &Vector3<f64>) -> [f64; 2] {
        [WIDTH / 2.0 + self.scale * self.right.dot(x), HEIGHT / 2.0 - self.scale * self.up.dot(x)]
    }

    /// The depth of a point, up to a constant.
    pub(crate) fn depth(&self, x: &Vector3<f64>) -> f64 {
        self.away.dot(x)
    }
}
