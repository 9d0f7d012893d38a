//! The families the gate draws from, and dofs for each that follow a given arc.

use super::beam::{AnyBeam, Drawn};
use crate::curve::{
    Arc, BSpline, Bezier, Cubic, Curve, CurveError, Helix, Hermite, Nurbs, NurbsWeighted, Quadratic, Segment,
};
use nalgebra::{Matrix3, Rotation3, SVector, UnitQuaternion, Vector3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// A family of curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Straight segment, 6 dofs.
    Segment,
    /// Quadratic Lagrange, 9 dofs.
    Quadratic,
    /// Cubic Lagrange, 12 dofs.
    Cubic,
    /// Cubic Hermite with tangents d x/d xi, 12 dofs.
    Hermite,
    /// Cubic Hermite with tangents scaled by a reference length, 12 dofs.
    HermiteScaled,
    /// Bezier of degree 5, 18 dofs.
    Bezier,
    /// Span of a cubic B-spline, 12 dofs.
    BSpline,
    /// Span of a quadratic NURBS with fixed weights, 9 dofs.
    Nurbs,
    /// Span of a cubic NURBS with its weights as dofs, 16 dofs.
    NurbsWeighted,
    /// Circular arc, 9 dofs.
    Arc,
    /// Helix, 10 dofs.
    Helix,
}

/// The arc that the dofs of a drawn curve follow, roughly; it passes through `point` at `xi` exactly in kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    /// Where the beam is to pass.
    pub(super) point: Vector3<f64>,
    /// Tangent, normal and binormal there.
    pub(super) frame: Matrix3<f64>,
    /// Length of the beam.
    pub(super) length: f64,
    /// The angle by which it turns over its length.
    pub(super) bend: f64,
    /// The parameter at which it passes `point`.
    pub(super) xi: f64,
}

impl Target {
    /// The point at xi and its derivative: an arc to second order, with some torsion.
    fn at(&self, xi: f64) -> [Vector3<f64>; 2] {
        let (s, half) = (xi - self.xi, 0.5 * self.length);
        let (k, c) = (0.25 * self.bend, 0.04 * self.bend);
        let local = Vector3::new(s, k * s * s, c * s * s * s) * half;
        let slope = Vector3::new(1.0, 2.0 * k * s, 3.0 * c * s * s) * half;
        [self.point + self.frame * local, self.frame * slope]
    }

    /// A point near the one at xi: off it by a few percent of what the bend bends.
    fn near(&self, xi: f64, rng: &mut ChaCha8Rng) -> Vector3<f64> {
        let off = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        self.at(xi)[0] + off * (0.04 * self.bend.min(1.0) * self.length)
    }
}

impl Family {
    /// All families.
    pub const ALL: [Self; 11] = [
        Self::Segment,
        Self::Quadratic,
        Self::Cubic,
        Self::Hermite,
        Self::HermiteScaled,
        Self::Bezier,
        Self::BSpline,
        Self::Nurbs,
        Self::NurbsWeighted,
        Self::Arc,
        Self::Helix,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Segment => "segment",
            Self::Quadratic => "quadratic",
            Self::Cubic => "cubic",
            Self::Hermite => "hermite",
            Self::HermiteScaled => "hermite-scaled",
            Self::Bezier => "bezier",
            Self::BSpline => "bspline",
            Self::Nurbs => "nurbs",
            Self::NurbsWeighted => "nurbs-weighted",
            Self::Arc => "arc",
            Self::Helix => "helix",
        }
    }

    /// Draws a curve that follows the target, and two directions of variation.
    pub(super) fn draw(self, target: &Target, rng: &mut ChaCha8Rng) -> Box<dyn AnyBeam> {
        let length = target.length;
        match self {
            Self::Segment => nodes::<_, 2, 6>(Segment::new(), equidistant(), target, rng),
            Self::Quadratic => nodes::<_, 3, 9>(Quadratic::new(), equidistant(), target, rng),
            Self::Cubic => nodes::<_, 4, 12>(Cubic::new(), equidistant(), target, rng),
            Self::Bezier => nodes::<_, 6, 18>(Bezier::<6>::new(), equidistant(), target, rng),
            Self::Hermite => hermite(Hermite::new(), 1.0, target, rng),
            Self::HermiteScaled => hermite(Hermite::scaled_by(length), 0.5 * length, target, rng),
            Self::BSpline => {
                let (spline, averages) = spline::<4, _>(rng, BSpline::<4>::new);
                nodes::<_, 4, 12>(spline, averages, target, rng)
            }
            Self::Nurbs => {
                let weights: [f64; 3] = std::array::from_fn(|_| rng.random_range(0.5..2.0));
                let (spline, averages) = spline::<3, _>(rng, |knots| Nurbs::new(knots, weights));
                nodes::<_, 3, 9>(spline, averages, target, rng)
            }
            Self::NurbsWeighted => {
                let (curve, averages) = spline::<4, _>(rng, NurbsWeighted::<4>::new);
                let mut q = SVector::<f64, 16>::zeros();
                for (i, xi) in averages.into_iter().enumerate() {
                    q.fixed_rows_mut::<3>(4 * i).copy_from(&target.near(xi, rng));
                    q[4 * i + 3] = rng.random_range(0.5..2.0);
                }
                let units = SVector::from_fn(|i, _| if i % 4 == 3 { 1.0 } else { length });
                drawn(curve, q, &units, vec![0, 4, 8, 12], rng)
            }
            Self::Arc => {
                let (half_angle, placed) = winding(target, 0.0, rng);
                let q = SVector::from_iterator(placed.into_iter());
                let units = SVector::from_fn(|i, _| if i < 4 { length } else { 1.0 });
                drawn(Arc::new(half_angle), q, &units, vec![0], rng)
            }
            Self::Helix => {
                let rise = rng.random_range(0.2..1.5);
                let (half_angle, [x, y, z, radius, a, b, c, d, phase]) = winding(target, rise, rng);
                let pitch = rise * radius * std::f64::consts::TAU;
                let q = SVector::from([x, y, z, a, b, c, d, radius, pitch, phase]);
                let units = SVector::from_fn(|i, _| if i < 3 || i == 7 || i == 8 { length } else { 1.0 });
                drawn(Helix::new(half_angle), q, &units, vec![0], rng)
            }
        }
    }
}

/// `P` points that follow the target at the given parameters, as node-major dofs.
fn nodes<C: Curve<N> + Send + Sync + 'static, const P: usize, const N: usize>(
    curve: C,
    at: [f64; P],
    target: &Target,
    rng: &mut ChaCha8Rng,
) -> Box<dyn AnyBeam> {
    let mut q = SVector::<f64, N>::zeros();
    for (i, xi) in at.into_iter().enumerate() {
        q.fixed_rows_mut::<3>(3 * i).copy_from(&target.near(xi, rng));
    }
    drawn(curve, q, &SVector::repeat(target.length), (0..N).step_by(3).collect(), rng)
}

/// Parameters at equal distances from -1 to 1.
#[expect(clippy::cast_precision_loss, reason = "a handful of nodes")]
fn equidistant<const P: usize>() -> [f64; P] {
    std::array::from_fn(|i| 2.0 * i as f64 / (P - 1) as f64 - 1.0)
}

fn hermite(curve: Hermite, tangent: f64, target: &Target, rng: &mut ChaCha8Rng) -> Box<dyn AnyBeam> {
    let mut q = SVector::<f64, 12>::zeros();
    for (i, xi) in [-1.0, 1.0].into_iter().enumerate() {
        let [_, slope] = target.at(xi);
        q.fixed_rows_mut::<3>(6 * i).copy_from(&target.near(xi, rng));
        q.fixed_rows_mut::<3>(6 * i + 3).copy_from(&(slope / tangent));
    }
    let units =
        SVector::from_fn(|i, _| if i % 6 < 3 { target.length } else { 0.5 * target.length / tangent });
    drawn(curve, q, &units, vec![0, 6], rng)
}

/// A spline with uneven knots, and the parameters that its `P` control points belong to (Greville's averages).
#[expect(clippy::cast_precision_loss, reason = "a handful of knots")]
fn spline<const P: usize, C>(
    rng: &mut ChaCha8Rng,
    make: impl FnOnce(&[f64]) -> Result<C, CurveError>,
) -> (C, [f64; P]) {
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
    (make(&knots).expect("knots that rise are valid"), averages)
}

/// Half the opening angle, and (centre, radius, quaternion, phase), of a winding curve that follows the target with
/// `rise` over radius and radian.
fn winding(target: &Target, rise: f64, rng: &mut ChaCha8Rng) -> (f64, [f64; 9]) {
    let half_angle = 0.5 * target.bend;
    let slant = rise.hypot(1.0);
    let radius = target.length / (target.bend * slant);
    let phase: f64 = rng.random_range(-3.0..3.0);
    let angle = phase + half_angle * target.xi;
    // Where the curve passes the point, its radial, circumferential and axial directions are ..
    let (sin, cos) = angle.sin_cos();
    let local = Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
    // .. to be turned so that the tangent (0, 1, rise) falls on the target's, and the radial direction on its normal.
    let (tangent, normal, binormal) =
        (target.frame.column(0), target.frame.column(1), target.frame.column(2));
    let circumferential = (tangent - binormal * rise) / slant;
    let axial = (tangent * rise + binormal) / slant;
    let global = Matrix3::from_columns(&[-normal, circumferential, axial]);
    let rotation = Rotation3::from_matrix_unchecked(global * local.transpose());
    let axial_offset = rise * radius * half_angle * target.xi;
    let centre = target.point + normal * radius - axial * axial_offset;
    let quaternion =
        UnitQuaternion::from_rotation_matrix(&rotation).into_inner() * rng.random_range(0.5..2.0);
    let [x, y, z, w] = [quaternion.i, quaternion.j, quaternion.k, quaternion.w];
    (half_angle, [centre.x, centre.y, centre.z, radius, w, x, y, z, phase])
}

/// Adds directions of variation, each entry in the unit of its dof.
fn drawn<C: Curve<N> + Send + Sync + 'static, const N: usize>(
    curve: C,
    q: SVector<f64, N>,
    units: &SVector<f64, N>,
    points: Vec<usize>,
    rng: &mut ChaCha8Rng,
) -> Box<dyn AnyBeam> {
    let mut direction = || SVector::from_fn(|i, _| units[i] * rng.random_range(-1.0..1.0));
    Box::new(Drawn { curve, q, dq: direction(), linear_dq: direction(), points })
}
