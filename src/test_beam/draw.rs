//! Random dofs for every family that follow a given arc.

use super::{AnyBeam, Family, TestBeam, Unit};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// The arc that the dofs of a drawn curve roughly follow. The arc passes through `point` at `xi`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    /// The point that the beam passes through.
    pub(crate) point: Vector3<f64>,
    /// Tangent, normal and binormal there.
    pub(crate) frame: Matrix3<f64>,
    /// Length of the beam.
    pub(crate) length: f64,
    /// The angle by which it turns over its length.
    pub(crate) bend: f64,
    /// The sign of its torsion.
    pub(crate) hand: f64,
    /// The parameter at which it passes `point`.
    pub(crate) xi: f64,
}

impl Target {
    /// The point at xi and its derivative: an arc to second order, with some torsion.
    fn at(&self, xi: f64) -> [Vector3<f64>; 2] {
        let (s, half) = (xi - self.xi, 0.5 * self.length);
        let (k, c) = (0.25 * self.bend, 0.04 * self.bend * self.hand);
        let local = Vector3::new(s, k * s * s, c * s * s * s) * half;
        let slope = Vector3::new(1.0, 2.0 * k * s, 3.0 * c * s * s) * half;
        [self.point + self.frame * local, self.frame * slope]
    }

    /// A point near the one at xi, at a distance of a few percent of the deflection by the bend.
    fn near(&self, xi: f64, rng: &mut ChaCha8Rng) -> Vector3<f64> {
        let off = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        self.at(xi)[0] + off * (0.04 * self.bend.min(1.0) * self.length)
    }
}

impl Family {
    /// A beam of this family with random parameters (knots, weights, opening angle). Its dofs have no meaning.
    pub(crate) fn model(self, rng: &mut ChaCha8Rng) -> Box<dyn AnyBeam> {
        let target = Target {
            point: Vector3::zeros(),
            frame: Matrix3::identity(),
            length: 1.0,
            bend: 1.0,
            hand: 1.0,
            xi: 0.0,
        };
        self.draw(&target, rng).drawn()
    }

    /// Draws a curve that follows the target, and two directions of variation.
    pub(crate) fn draw(self, target: &Target, rng: &mut ChaCha8Rng) -> TestBeam {
        let (parameters, q) = match self {
            Self::Segment => (Vec::new(), points(&equidistant::<2>(), target, rng)),
            Self::Quadratic => (Vec::new(), points(&equidistant::<3>(), target, rng)),
            Self::Cubic => (Vec::new(), points(&equidistant::<4>(), target, rng)),
            Self::Bezier => (Vec::new(), points(&equidistant::<6>(), target, rng)),
            Self::Hermite => (Vec::new(), hermite(1.0, target, rng)),
            Self::HermiteScaled => (vec![target.length], hermite(0.5 * target.length, target, rng)),
            Self::BSpline => {
                let (knots, averages) = knots::<4>(rng);
                (knots, points(&averages, target, rng))
            }
            Self::Nurbs => {
                let weights: [f64; 3] = std::array::from_fn(|_| rng.random_range(0.5..2.0));
                let (knots, averages) = knots::<3>(rng);
                ([knots.as_slice(), &weights].concat(), points(&averages, target, rng))
            }
            Self::NurbsWeighted => {
                let (knots, averages) = knots::<4>(rng);
                let node = |xi| [&target.near(xi, rng).data.0[0][..], &[rng.random_range(0.5..2.0)]].concat();
                (knots, averages.into_iter().flat_map(node).collect())
            }
            Self::Arc => {
                let (half_angle, placed) = winding(target, 0.0, rng);
                (vec![half_angle], placed.to_vec())
            }
            Self::Helix => {
                let rise = target.hand * rng.random_range(0.2..1.5);
                let (half_angle, [x, y, z, radius, a, b, c, d, phase]) = winding(target, rise, rng);
                let pitch = rise * radius * std::f64::consts::TAU;
                (vec![half_angle], vec![x, y, z, a, b, c, d, radius, pitch, phase])
            }
        };
        let units = self.units();
        // Each entry has the unit of its dof. Tangents are half as long as the beam.
        let scale = |unit: Unit| match unit {
            Unit::Pure => 1.0,
            Unit::Length if self == Self::Hermite => 0.5 * target.length,
            Unit::Point | Unit::Length => target.length,
        };
        let mut direction = || units.iter().map(|&unit| scale(unit) * rng.random_range(-1.0..1.0)).collect();
        let (dq, linear_dq) = (direction(), direction());
        TestBeam { family: self, parameters, q, dq, linear_dq }
    }
}

impl TestBeam {
    /// The beam of numbers that were drawn here.
    pub(crate) fn drawn(&self) -> Box<dyn AnyBeam> {
        self.beam().expect("what is drawn is finite, with knots that rise and positive weights")
    }
}

/// Points that follow the target at the given parameters, as node-major dofs.
fn points(at: &[f64], target: &Target, rng: &mut ChaCha8Rng) -> Vec<f64> {
    at.iter().flat_map(|&xi| target.near(xi, rng).data.0[0]).collect()
}

/// Parameters at equal distances from -1 to 1.
#[expect(clippy::cast_precision_loss, reason = "a handful of nodes")]
fn equidistant<const P: usize>() -> [f64; P] {
    std::array::from_fn(|i| 2.0 * i as f64 / (P - 1) as f64 - 1.0)
}

/// A point and a tangent at both ends; `tangent` is the length of dx/dxi for a tangent dof of length one.
fn hermite(tangent: f64, target: &Target, rng: &mut ChaCha8Rng) -> Vec<f64> {
    let mut node = |xi| {
        let [_, slope] = target.at(xi);
        [target.near(xi, rng), slope / tangent].map(|v| v.data.0[0]).concat()
    };
    [node(-1.0), node(1.0)].concat()
}

/// Uneven knots, and the parameters of the `P` control points of the span (Greville's averages).
#[expect(clippy::cast_precision_loss, reason = "a handful of knots")]
fn knots<const P: usize>(rng: &mut ChaCha8Rng) -> (Vec<f64>, [f64; P]) {
    let degree = P - 1;
    let mut knots = Vec::with_capacity(2 * degree);
    let mut knot = 0.0;
    for _ in 0..2 * degree {
        knots.push(knot);
        knot += rng.random_range(0.3..1.0);
    }
    let (start, end) = (knots[degree - 1], knots[degree]);
    let averages = std::array::from_fn(|i| {
        let average = knots[i..i + degree].iter().sum::<f64>() / degree as f64;
        (2.0 * average - start - end) / (end - start)
    });
    (knots, averages)
}

/// Half the opening angle, and (centre, radius, quaternion, phase), of a winding curve that follows the target with
/// `rise` over radius and radian.
fn winding(target: &Target, rise: f64, rng: &mut ChaCha8Rng) -> (f64, [f64; 9]) {
    let half_angle = 0.5 * target.bend;
    let slant = rise.hypot(1.0);
    let radius = target.length / (target.bend * slant);
    let phase: f64 = rng.random_range(-3.0..3.0);
    let angle = phase + half_angle * target.xi;
    // At the point where the curve passes, its radial, circumferential and axial directions are ..
    let (sin, cos) = angle.sin_cos();
    let local = Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
    // .. to be rotated so that the tangent (0, 1, rise) falls on the target's, and the radial direction on its normal.
    let (tangent, normal, binormal) =
        (target.frame.column(0), target.frame.column(1), target.frame.column(2));
    let circumferential = (tangent - binormal * rise) / slant;
    let axial = (tangent * rise + binormal) / slant;
    let global = Matrix3::from_columns(&[-normal, circumferential, axial]);
    let rotation = Rotation3::from_matrix_unchecked(global * local.transpose());
    let axial_offset = rise * radius * half_angle * target.xi;
    let centre = target.point + normal * radius - axial * axial_offset;
    // A quaternion and its negative are the same rotation.
    let sign = if rng.random() { 1.0 } else { -1.0 };
    let quaternion =
        UnitQuaternion::from_rotation_matrix(&rotation).into_inner() * (rng.random_range(0.5..2.0) * sign);
    let [x, y, z, w] = [quaternion.i, quaternion.j, quaternion.k, quaternion.w];
    (half_angle, [centre.x, centre.y, centre.z, radius, w, x, y, z, phase])
}
