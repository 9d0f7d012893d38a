//! Gradients and Hessians in the dofs of a screw line, without a variation for every pair of dofs.
//!
//! # Derivation
//! For fixed v and w the product w . B(p, p') v is a bilinear form of the quaternions, p^T S p' with the symmetric
//!
//! ```math
//! S(v, w) = [ v . w      (v x w)^T                  ]
//!           [ v x w      v w^T + w v^T - (v . w) I  ]
//! ```
//!
//! so that w . R v = p^T S p / |p|^2 is a Rayleigh quotient, with the gradient and the Hessian
//!
//! ```math
//! g = (2 S p - 2 (w . R v) p) / |p|^2      H = (2 S - 2 (w . R v) I - 2 p g^T - 2 g p^T) / |p|^2
//! ```
//!
//! The other dofs enter through y, all but the phase linearly. For them, w . R v = (R^T w) . v.

use super::{ScrewDofs, bilinear};
use crate::number::Real;
use nalgebra::{Matrix4, SMatrix, SVector, Vector3, Vector4};

/// The places of the dofs of a screw line in its dof vector. The centre comes first.
#[derive(Clone, Copy, Debug)]
pub(in crate::curve) struct Layout {
    pub(in crate::curve) quaternion: usize,
    pub(in crate::curve) radius: usize,
    pub(in crate::curve) pitch: Option<usize>,
    pub(in crate::curve) phase: usize,
}

/// S(v, w).
fn form<T: Real>(v: &Vector3<T>, w: &Vector3<T>) -> Matrix4<T> {
    let (dot, cross) = (v.dot(w), v.cross(w));
    let mut form = Matrix4::zeros();
    form[(0, 0)] = dot;
    for i in 0..3 {
        (form[(0, i + 1)], form[(i + 1, 0)]) = (cross[i], cross[i]);
        form[(i + 1, i + 1)] = v[i] * w[i] + v[i] * w[i] - dot;
        for j in 0..i {
            let product = v[i] * w[j] + w[i] * v[j];
            (form[(i + 1, j + 1)], form[(j + 1, i + 1)]) = (product, product);
        }
    }
    form
}

impl<T: Real> ScrewDofs<T> {
    /// R^T w.
    fn turned_back(&self, w: &Vector3<T>) -> Vector3<T> {
        let p = &self.screw.quaternion;
        let conjugate = Vector4::new(p[0], -p[1], -p[2], -p[3]);
        bilinear(&conjugate, &conjugate, w) / self.square
    }

    /// The gradient of w . R v in p, with `value` = w . R v and `form` = S(v, w).
    fn turning(&self, value: T, form: &Matrix4<T>) -> Vector4<T> {
        let p = &self.screw.quaternion;
        let half = form * p - p * value;
        (half + half) / self.square
    }

    /// The derivatives of y^(k) in the radius, the phase and the pitch.
    fn directions(&self, k: usize) -> [Vector3<T>; 3] {
        let (power, one) = (self.powers[k], T::one());
        [self.circle(k) * power, self.circle(k + 1) * (self.screw.radius * power), self.axis(k, one)]
    }

    /// The gradient of w . x^(k).
    pub(in crate::curve) fn gradient_in<const N: usize>(
        &self,
        layout: Layout,
        k: usize,
        w: &Vector3<T>,
    ) -> SVector<T, N> {
        let Layout { quaternion, radius, pitch, phase } = layout;
        let (u, y) = (self.turned_back(w), &self.y[k]);
        let [direction, turn, rise] = self.directions(k);
        let mut gradient = SVector::<T, N>::zeros();
        if k == 0 {
            gradient.fixed_rows_mut::<3>(0).copy_from(w);
        }
        gradient.fixed_rows_mut::<4>(quaternion).copy_from(&self.turning(u.dot(y), &form(y, w)));
        (gradient[radius], gradient[phase]) = (u.dot(&direction), u.dot(&turn));
        if let Some(pitch) = pitch {
            gradient[pitch] = u.dot(&rise);
        }
        gradient
    }

    /// The Hessian of w . x^(k).
    pub(in crate::curve) fn hessian_in<const N: usize>(
        &self,
        layout: Layout,
        k: usize,
        w: &Vector3<T>,
    ) -> SMatrix<T, N, N> {
        let Layout { quaternion, radius, pitch, phase } = layout;
        let (p, u, y) = (&self.screw.quaternion, self.turned_back(w), &self.y[k]);
        let [direction, turn, rise] = self.directions(k);
        let mut hessian = SMatrix::<T, N, N>::zeros();

        let (value, form_y) = (u.dot(y), form(y, w));
        let g = self.turning(value, &form_y);
        let half = form_y - Matrix4::from_diagonal_element(value) - p * g.transpose() - g * p.transpose();
        hessian.fixed_view_mut::<4, 4>(quaternion, quaternion).copy_from(&((half + half) / self.square));
        for (i, direction) in [(Some(radius), &direction), (Some(phase), &turn), (pitch, &rise)] {
            let Some(i) = i else { continue };
            let mixed = self.turning(u.dot(direction), &form(direction, w));
            hessian.fixed_view_mut::<4, 1>(quaternion, i).copy_from(&mixed);
            hessian.fixed_view_mut::<1, 4>(i, quaternion).copy_from(&mixed.transpose());
        }
        let tangential = u.dot(&self.circle(k + 1)) * self.powers[k];
        (hessian[(radius, phase)], hessian[(phase, radius)]) = (tangential, tangential);
        hessian[(phase, phase)] = u.dot(&self.circle(k + 2)) * (self.screw.radius * self.powers[k]);
        hessian
    }
}
