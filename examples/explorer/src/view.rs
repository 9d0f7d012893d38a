//! From space to the picture: an orthographic projection.

use crate::state::ViewState;
use beamgap::nalgebra::Vector3;

/// The size of the picture.
pub(crate) const WIDTH: f64 = 720.0;
/// The size of the picture.
pub(crate) const HEIGHT: f64 = 460.0;

/// A view of the beams.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// To the right in the picture.
    pub(crate) right: Vector3<f64>,
    /// Upwards in the picture.
    pub(crate) up: Vector3<f64>,
    /// Away from the eye.
    pub(crate) away: Vector3<f64>,
    /// Pixels a unit of length.
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

    /// Where a point is seen.
    pub(crate) fn at(&self, x: &Vector3<f64>) -> [f64; 2] {
        [WIDTH / 2.0 + self.scale * self.right.dot(x), HEIGHT / 2.0 - self.scale * self.up.dot(x)]
    }

    /// How far from the eye a point is; the zero is of no importance.
    pub(crate) fn depth(&self, x: &Vector3<f64>) -> f64 {
        self.away.dot(x)
    }
}
