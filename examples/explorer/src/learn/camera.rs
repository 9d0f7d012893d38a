//! An orthographic view of space in a picture.

use beamgap::nalgebra::Vector3;

/// The direction of view, the scale, and where the origin is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    right: Vector3<f64>,
    up: Vector3<f64>,
    /// Pixels per unit of length.
    pub(super) scale: f64,
    origin: [f64; 2],
}

impl Camera {
    /// The view along a direction, with the z axis upwards in the picture.
    pub(super) fn new(away: [f64; 3], scale: f64, origin: [f64; 2]) -> Self {
        let away = Vector3::from(away);
        let right = away.cross(&Vector3::z()).normalize();
        Self { right, up: right.cross(&away).normalize(), scale, origin }
    }

    /// The view that most scenes use: from the front, somewhat from above and from the right.
    pub(super) fn usual(scale: f64, origin: [f64; 2]) -> Self {
        Self::new([-0.2, 1.0, -1.3], scale, origin)
    }

    /// Where a point is drawn.
    pub(super) fn at(&self, x: &Vector3<f64>) -> [f64; 2] {
        [self.origin[0] + self.scale * self.right.dot(x), self.origin[1] - self.scale * self.up.dot(x)]
    }

    /// The point of the vertical plane y = 0 that is drawn here.
    pub(super) fn upright(&self, [x, y]: [f64; 2]) -> Vector3<f64> {
        let (u, v) = ((x - self.origin[0]) / self.scale, (self.origin[1] - y) / self.scale);
        // right has no z component.
        let x = u / self.right.x;
        Vector3::new(x, 0.0, (v - self.up.x * x) / self.up.z)
    }

    /// The point of the horizontal plane at this height that is drawn here.
    pub(super) fn on_level(&self, [x, y]: [f64; 2], height: f64) -> Vector3<f64> {
        let (u, v) = ((x - self.origin[0]) / self.scale, (self.origin[1] - y) / self.scale);
        // right has no z component.
        let (r, s) = (self.right, self.up);
        let v = v - s.z * height;
        let det = r.x * s.y - r.y * s.x;
        Vector3::new((u * s.y - v * r.y) / det, (v * r.x - u * s.x) / det, height)
    }
}
