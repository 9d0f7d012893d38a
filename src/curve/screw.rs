//! The screw line, the common part of [`Arc`](super::Arc) and [`Helix`](super::Helix). The circle is a screw line
//! without pitch.

use super::{Geometry, Jet};
use crate::number::Real;
use nalgebra::{SVector, Vector3, Vector4};
use std::f64::consts::TAU;

mod matrices;

pub(super) use matrices::Layout;

/// The dofs of a screw line, or a direction in the space of these dofs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Screw<T> {
    pub(super) centre: Vector3<T>,
    /// (w, x, y, z), the scalar first.
    pub(super) quaternion: Vector4<T>,
    pub(super) radius: T,
    pub(super) pitch: T,
    pub(super) phase: T,
}

impl<T: Real> Screw<T> {
    /// Reads the dofs from a vector, at the places that `layout` gives.
    pub(super) fn read<const N: usize>(layout: Layout, q: &SVector<T, N>) -> Self {
        Self {
            centre: q.fixed_rows::<3>(0).into_owned(),
            quaternion: q.fixed_rows::<4>(layout.quaternion).into_owned(),
            radius: q[layout.radius],
            pitch: layout.pitch.map_or(T::zero(), |pitch| q[pitch]),
            phase: q[layout.phase],
        }
    }

    /// The point at xi, rotated by the matrix of the quaternion.
    pub(super) fn position(&self, half_angle: f64, xi: T) -> Vector3<T> {
        let angle = T::from(half_angle) * xi;
        let (sin, cos) = (self.phase + angle).sin_cos();
        let (x, y) = (self.radius * cos, self.radius * sin);
        let z = self.pitch * (angle / T::from(TAU));
        let [w, i, j, k] = self.quaternion.into();
        let twice = |a: T| a + a;
        let rotated = Vector3::new(
            (w * w + i * i - j * j - k * k) * x + twice(i * j - w * k) * y + twice(i * k + w * j) * z,
            twice(i * j + w * k) * x + (w * w - i * i + j * j - k * k) * y + twice(j * k - w * i) * z,
            twice(i * k - w * j) * x + twice(j * k + w * i) * y + (w * w - i * i - j * j + k * k) * z,
        );
        self.centre + rotated / (w * w + i * i + j * j + k * k)
    }

    pub(super) fn jet(self, half_angle: f64, xi: T) -> Jet<T, ScrewDofs<T>> {
        let alpha = T::from(half_angle);
        let (sin, cos) = (self.phase + alpha * xi).sin_cos();
        let square = self.quaternion.dot(&self.quaternion);
        let powers = [T::one(), alpha, alpha * alpha, alpha * alpha * alpha];
        let turn = alpha / T::from(TAU);
        let mut dofs = ScrewDofs {
            screw: self,
            sin,
            cos,
            square,
            powers,
            rise: [turn * xi, turn],
            y: [Vector3::zeros(); 4],
        };
        dofs.y =
            std::array::from_fn(|k| dofs.circle(k) * (powers[k] * self.radius) + dofs.axis(k, self.pitch));
        let [x, t, t_xi, t_xixi] = dofs.y.map(|y| dofs.rotated(&y));
        Jet { geometry: Geometry { x: self.centre + x, t, t_xi, t_xixi }, dofs }
    }
}

/// The values that the variations of an [`Arc`](super::Arc) or a [`Helix`](super::Helix) at one parameter need.
///
/// # Derivation
/// With phi = phase + alpha xi, y = (r cos phi, r sin phi, h alpha xi / (2 pi)) and a rotation R,
///
/// ```math
/// x = c + R y
/// ```
///
/// The orientation is an unnormalised quaternion p = (w, u). Every p other than zero represents the rotation
/// R(p) = M(p) / |p|^2, M(p) v = B(p, p) v with
///
/// ```math
/// B(p, p') v = (w w' - u . u') v + (u . v) u' + (u' . v) u + w u' x v + w' u x v
/// ```
///
/// symmetric and linear in both, so there is neither a constraint nor a singular chart. Leibniz' rule for
/// |p|^2 (R v) = M v, solved for the variations of R:
///
/// ```math
/// |p|^2 dR v  = 2 B(p, dp) v - 2 (p . dp) R v
/// |p|^2 DdR v = 2 B(Dp, dp) v - 2 (Dp . dp) R v - 2 (p . dp) DR v - 2 (p . Dp) dR v
/// ```
///
/// Source: K. Shoemake, "Animating rotation with quaternion curves", 1985, doi:10.1145/325165.325242, for R(p).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScrewDofs<T> {
    screw: Screw<T>,
    /// The sine of phi.
    sin: T,
    cos: T,
    /// |p|^2.
    square: T,
    /// The powers of alpha, starting with the zeroth.
    powers: [T; 4],
    /// The rise along the axis for a pitch of one, and its derivative.
    rise: [T; 2],
    /// y and its derivatives.
    y: [Vector3<T>; 4],
}

/// B(p, p') v.
fn bilinear<T: Real>(p: &Vector4<T>, other: &Vector4<T>, v: &Vector3<T>) -> Vector3<T> {
    let (a, b) = (Vector3::new(p[1], p[2], p[3]), Vector3::new(other[1], other[2], other[3]));
    let (w, z) = (p[0], other[0]);
    v * (w * z - a.dot(&b)) + b * a.dot(v) + a * b.dot(v) + b.cross(v) * w + a.cross(v) * z
}

impl<T: Real> ScrewDofs<T> {
    /// The k-th derivative of (cos phi, sin phi, 0) with respect to phi. Each derivative rotates it by a right angle.
    fn circle(&self, k: usize) -> Vector3<T> {
        match k % 4 {
            0 => Vector3::new(self.cos, self.sin, T::zero()),
            1 => Vector3::new(-self.sin, self.cos, T::zero()),
            2 => Vector3::new(-self.cos, -self.sin, T::zero()),
            _ => Vector3::new(self.sin, -self.cos, T::zero()),
        }
    }

    /// The k-th derivative of the translation along the axis.
    fn axis(&self, k: usize, pitch: T) -> Vector3<T> {
        let rise = if k < 2 { self.rise[k] * pitch } else { T::zero() };
        Vector3::new(T::zero(), T::zero(), rise)
    }

    /// R v.
    fn rotated(&self, v: &Vector3<T>) -> Vector3<T> {
        bilinear(&self.screw.quaternion, &self.screw.quaternion, v) / self.square
    }

    /// δR v.
    fn rotation_varied(&self, dp: &Vector4<T>, v: &Vector3<T>) -> Vector3<T> {
        let p = &self.screw.quaternion;
        let half = bilinear(p, dp, v) - self.rotated(v) * p.dot(dp);
        (half + half) / self.square
    }

    /// ΔδR v.
    fn rotation_varied_twice(&self, dp: &Vector4<T>, linear_dp: &Vector4<T>, v: &Vector3<T>) -> Vector3<T> {
        let p = &self.screw.quaternion;
        let half = bilinear(linear_dp, dp, v)
            - self.rotated(v) * linear_dp.dot(dp)
            - self.rotation_varied(linear_dp, v) * p.dot(dp)
            - self.rotation_varied(dp, v) * p.dot(linear_dp);
        (half + half) / self.square
    }

    /// δy^(k).
    fn local_varied(&self, k: usize, d: &Screw<T>) -> Vector3<T> {
        let along = self.circle(k) * d.radius + self.circle(k + 1) * (self.screw.radius * d.phase);
        along * self.powers[k] + self.axis(k, d.pitch)
    }

    /// δx^(k) in one direction.
    pub(super) fn vary(&self, k: usize, d: &Screw<T>) -> Vector3<T> {
        let turned = self.rotation_varied(&d.quaternion, &self.y[k]) + self.rotated(&self.local_varied(k, d));
        if k == 0 { d.centre + turned } else { turned }
    }

    /// Δδx^(k) in two directions.
    pub(super) fn vary_twice(&self, k: usize, d: &Screw<T>, linear: &Screw<T>) -> Vector3<T> {
        // Δδy^(k) = α^k [(δr Δφ + Δr δφ) e_(k+1) + r δφ Δφ e_(k+2)]
        let tangential = d.radius * linear.phase + linear.radius * d.phase;
        let radial = self.screw.radius * d.phase * linear.phase;
        let local = (self.circle(k + 1) * tangential + self.circle(k + 2) * radial) * self.powers[k];
        self.rotation_varied_twice(&d.quaternion, &linear.quaternion, &self.y[k])
            + self.rotation_varied(&d.quaternion, &self.local_varied(k, linear))
            + self.rotation_varied(&linear.quaternion, &self.local_varied(k, d))
            + self.rotated(&local)
    }
}
