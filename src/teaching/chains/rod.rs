//! The energy of a beam without shear and torsion, its gradient and its Hessian.
//!
//! # Derivation
//! Let a = dx/ds and b = d²x/ds², s the arc length of the straight reference. The beam stores, for each unit of s,
//!
//! ```math
//! w(a, b) = EA/2 (|a| - 1)^2 + EI/2 |a × b|^2/|a|^4
//! ```
//!
//! The second fraction is the square of the curvature a × b/|a|² that is conjugate to the bending moment. Points are linear
//! in the dofs, a = B₁ q and b = B₂ q. So the residual is ∫ B₁ᵀw,a + B₂ᵀw,b ds, and the tangent is Σ Bᵢᵀw,ᵢⱼ Bⱼ.
//!
//! Source: C. Meier, A. Popp, W. Wall, "A locking-free finite element formulation and reduced models for geometrically
//! exact Kirchhoff rods", 2015, doi:10.1016/j.cma.2015.02.029 (the model without torsion).

use crate::curve::{Curve, DofDerivatives, Hermite};
use crate::number::Real;
use crate::teaching::{DOFS, Material};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// A rule of Gauss on [-1, 1].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gauss {
    /// Three points.
    Three,
    /// Six points.
    Six,
}

/// Half of a symmetric rule.
const THREE: [(f64, f64); 2] = [(0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];
const SIX: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691_04),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_36),
];

impl Gauss {
    /// Points and weights.
    pub fn points(self) -> impl Iterator<Item = (f64, f64)> {
        let half: &[(f64, f64)] = if self == Self::Three { &THREE } else { &SIX };
        half.iter().flat_map(|&(xi, weight)| {
            let mirrored = (xi != 0.0).then_some((-xi, weight));
            std::iter::once((xi, weight)).chain(mirrored)
        })
    }
}

/// The energy of a unit of length: w, and its derivatives over (a, b).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Density<T> {
    /// w, a force.
    pub value: T,
    /// w,a (a force) and w,b (a moment).
    pub gradient: [Vector3<T>; 2],
    /// The second derivatives, in blocks.
    pub hessian: [[Matrix3<T>; 2]; 2],
}

/// The energy of a unit of length at a = dx/ds and b = d²x/ds².
pub fn density<T: Real>(a: &Vector3<T>, b: &Vector3<T>, material: &Material) -> Density<T> {
    let number = T::from;
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let (length, one) = (aa.sqrt(), Matrix3::identity());
    let (strain, tau) = (length - T::one(), a / length);
    // c = |a × b|²
    let across = a.cross(b);
    let c = across.dot(&across);
    let (c_a, c_b) = ((a * bb - b * ab) * number(2.0), (b * aa - a * ab) * number(2.0));
    let c_aa = (one * bb - b * b.transpose()) * number(2.0);
    let c_ab = a * b.transpose() * number(4.0) - b * a.transpose() * number(2.0) - one * (number(2.0) * ab);
    let c_bb = (one * aa - a * a.transpose()) * number(2.0);
    // p = |a|⁻⁴
    let p = T::one() / (aa * aa);
    let p_a = a * (number(-4.0) * p / aa);
    let p_aa = one * (number(-4.0) * p / aa) + a * a.transpose() * (number(24.0) * p / (aa * aa));

    let (axial, bending) = (number(material.axial), number(0.5 * material.bending));
    let value = number(0.5) * axial * strain * strain + bending * c * p;
    let gradient = [tau * (axial * strain) + (c_a * p + p_a * c) * bending, c_b * (bending * p)];
    let across = one - tau * tau.transpose();
    let stretch = (tau * tau.transpose() + across * (strain / length)) * axial;
    let w_aa = stretch + (c_aa * p + c_a * p_a.transpose() + p_a * c_a.transpose() + p_aa * c) * bending;
    let w_ab = (c_ab * p + p_a * c_b.transpose()) * bending;
    let w_bb = c_bb * (bending * p);
    Density { value, gradient, hessian: [[w_aa, w_ab], [w_ab.transpose(), w_bb]] }
}

/// Residual and tangent of an element with this length in the reference, over points and tangents dx/ds of both nodes.
pub(super) fn element<T: Real>(
    q: &SVector<T, DOFS>,
    length: f64,
    material: &Material,
    rule: Gauss,
) -> (SVector<T, DOFS>, SMatrix<T, DOFS, DOFS>) {
    let (mut residual, mut tangent) = (SVector::zeros(), SMatrix::zeros());
    let half = T::from(0.5 * length);
    for (xi, weight) in rule.points() {
        let jet = Hermite::scaled_by(length).jet(q, T::from(xi));
        let (a, b) = (jet.geometry.t / half, jet.geometry.t_xi / (half * half));
        let of: [SMatrix<T, 3, DOFS>; 2] =
            [jet.dofs.jacobian(1) / half, jet.dofs.jacobian(2) / (half * half)];
        let Density { gradient, hessian, .. } = density(&a, &b, material);
        for ((row, gradient), hessian) in of.iter().zip(&gradient).zip(&hessian) {
            let rows = row.transpose() * (T::from(weight) * half);
            residual += rows * gradient;
            for (column, hessian) in of.iter().zip(hessian) {
                tangent += rows * hessian * column;
            }
        }
    }
    (residual, tangent)
}
