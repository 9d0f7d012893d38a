//! Pairs of parabolic beams, which most scenes use, and drawn lines of beams.

use super::camera::Camera;
use beamgap::closest_point::{ClosestPoint, Held};
use beamgap::curve::{Curve, Geometry, Quadratic};
use beamgap::linearization::closed_form::paper::FirstOrder;
use beamgap::linearization::closed_form::{PartialVariations, Projection, variations};
use beamgap::linearization::{Quantities, Varied};
use beamgap::nalgebra::{SVector, Vector3};
use beamgap::pair::{DofVector, Pair};

/// The dofs of a parabolic beam: three points.
pub(super) type Dofs = SVector<f64, 9>;
/// The dofs of both beams.
pub(super) type Both = DofVector<f64, 9, 9>;
/// Two parabolic beams.
pub(super) type Parabolas = Pair<Quadratic, Quadratic, 9, 9>;

/// The pieces of a drawn beam.
const PIECES: u32 = 24;

pub(super) fn parabolas() -> Parabolas {
    Pair::new(Quadratic::new(), Quadratic::new())
}

/// The beam above: it sags.
pub(super) fn above() -> Dofs {
    Dofs::from([-1.15, -0.1, 0.55, 0.0, 0.1, 0.2, 1.15, -0.1, 0.5])
}

/// The bar beam below: it arches.
pub(super) fn below() -> Dofs {
    Dofs::from([-0.5, -1.0, -0.6, 0.0, 0.05, -0.3, 0.45, 1.05, -0.55])
}

/// The point and the tangent of a parabolic beam.
pub(super) fn geometry(q: &Dofs, xi: f64) -> Geometry<f64> {
    Quadratic::new().jet(q, xi).geometry
}

/// The closest point that Newton's method finds from here, if there is one inside both beams.
pub(super) fn nearest(q: &Both, from: (f64, f64)) -> Option<ClosestPoint> {
    parabolas().refine(q, from, Held::default()).ok().filter(ClosestPoint::is_interior)
}

/// The closest point after a motion in small steps, so that a large one does not lead to another minimum.
pub(super) fn followed(q: &Both, dq: &Both, step: f64, point: &ClosestPoint) -> Option<ClosestPoint> {
    let mut found = *point;
    for part in 1..=4 {
        found = nearest(&q.plus(0.25 * f64::from(part) * step, dq), (found.xi, found.xi_bar))?;
    }
    Some(found)
}

/// Everything of first order along a direction: the system, its right-hand sides, and the variations.
#[derive(Clone, Copy, Debug)]
pub(super) struct First {
    pub(super) beam: PartialVariations<f64>,
    pub(super) bar: PartialVariations<f64>,
    pub(super) d: Vector3<f64>,
    pub(super) projection: Projection<f64>,
    pub(super) delta: FirstOrder<f64>,
}

impl First {
    /// The variations along `dq` at a pair of parameters, with parameters held or not.
    pub(super) fn new(q: &Both, dq: &Both, at: (f64, f64), held: Held) -> Self {
        let curve = Quadratic::new();
        let beam = PartialVariations::new(&curve.jet(&q.beam, at.0), &dq.beam, &dq.beam);
        let bar = PartialVariations::new(&curve.jet(&q.bar, at.1), &dq.bar, &dq.bar);
        let d = beam.geometry.x - bar.geometry.x;
        let projection = Projection::new(&beam.geometry, &bar.geometry, held);
        let delta = FirstOrder::new([&beam, &bar], [&beam.delta_u, &bar.delta_u], &d, &projection);
        Self { beam, bar, d, projection, delta }
    }

    /// The right-hand sides R and R_bar of (50).
    pub(super) fn right_hand_sides(&self) -> [f64; 2] {
        let u_hat = &self.delta.u_hat;
        let row = |t: &Vector3<f64>, u_xi: &Vector3<f64>| -u_hat.dot(t) - u_xi.dot(&self.d);
        [row(&self.beam.geometry.t, &self.delta.beam.u[1]), row(&self.bar.geometry.t, &self.delta.bar.u[1])]
    }

    /// All quantities with both directions alike, with parameters held or not.
    pub(super) fn seconds(&self, at: (f64, f64), held: Held) -> Quantities<Varied<f64>> {
        variations(&self.beam, &self.bar, at, held, &parabolas().contact)
    }
}

/// The drawn line of a beam.
pub(super) fn drawn(camera: &Camera, geometry: impl Fn(f64) -> Geometry<f64>) -> Vec<[f64; 2]> {
    let at = |i: u32| camera.at(&geometry(2.0 * f64::from(i) / f64::from(PIECES) - 1.0).x);
    (0..=PIECES).map(at).collect()
}

/// The parameter at which a beam is drawn nearest to a place.
pub(super) fn nearest_drawn(camera: &Camera, q: &Dofs, [x, y]: [f64; 2]) -> f64 {
    let away = |xi: f64| {
        let [u, v] = camera.at(&geometry(q, xi).x);
        (u - x) * (u - x) + (v - y) * (v - y)
    };
    let mut best = 0.0;
    let mut width = 1.0;
    // Each round looks at eleven places around the best, and then more closely.
    for _ in 0..5 {
        let tried = (-5..=5).map(|i| (best + width * f64::from(i) / 5.0).clamp(-1.0, 1.0));
        best = tried.min_by(|one, other| away(*one).total_cmp(&away(*other))).unwrap_or(best);
        width /= 4.0;
    }
    best
}
