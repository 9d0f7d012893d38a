//! An elastic beam: one cubic Hermite element with linear axial and bending stiffness, clamped at its first node.

use crate::curve::{Curve, DofDerivatives, Hermite};
use nalgebra::{SMatrix, SVector, Vector3};

/// The dofs of a beam: point and tangent at both ends.
pub const DOFS: usize = 12;
/// The dofs of its free end: the last six.
pub const FREE: usize = 6;

/// Points and weights of Gauss's rule with three points, exact for the products of two derivatives of cubics.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// The material and section of a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// EA, a force.
    pub axial: f64,
    /// EI, a force times a length squared, the same about both axes.
    pub bending: f64,
    /// The radius of the section, a length.
    pub radius: f64,
}

/// A straight beam before deformation.
#[derive(Clone, Debug, PartialEq)]
pub struct Beam {
    /// Its undeformed dofs.
    pub reference: SVector<f64, DOFS>,
    /// Its material and section.
    pub material: Material,
    stiffness: SMatrix<f64, DOFS, DOFS>,
}

impl Beam {
    /// The straight beam between two points, of which the first is clamped.
    pub fn between(start: [f64; 3], end: [f64; 3], material: Material) -> Self {
        let [x1, x2] = [start, end].map(Vector3::from);
        let half = (x2 - x1) * 0.5;
        let mut reference: SVector<f64, DOFS> = SVector::zeros();
        for (i, v) in [x1, half, x2, half].iter().enumerate() {
            reference.fixed_rows_mut::<3>(3 * i).copy_from(v);
        }
        Self { reference, material, stiffness: stiffness(&reference, &half, &material) }
    }

    /// The elastic forces K (q - Q) of the deformed beam.
    pub fn forces(&self, q: &SVector<f64, DOFS>) -> SVector<f64, DOFS> {
        self.stiffness * (q - self.reference)
    }

    /// The stiffness K, which is constant: the energy is quadratic in the displacements.
    pub fn stiffness(&self) -> &SMatrix<f64, DOFS, DOFS> {
        &self.stiffness
    }
}

/// K = ∫ EA u'·e e·v' + EI u''·(I - e eᵀ) v'' ds with e along the beam, ds = |half| dxi.
fn stiffness(
    reference: &SVector<f64, DOFS>,
    half: &Vector3<f64>,
    material: &Material,
) -> SMatrix<f64, DOFS, DOFS> {
    let length = half.norm();
    let along = half * half.transpose() / half.norm_squared();
    let across = SMatrix::<f64, 3, 3>::identity() - along;
    let mut sum = SMatrix::zeros();
    for (xi, weight) in GAUSS {
        let dofs = Hermite::new().jet(reference, xi).dofs;
        // Derivatives in s are those in xi over |half|.
        let [first, second]: [SMatrix<f64, 3, DOFS>; 2] =
            [dofs.jacobian(1) / length, dofs.jacobian(2) / length.powi(2)];
        let axial = first.transpose() * along * first * material.axial;
        let bending = second.transpose() * across * second * material.bending;
        sum += (axial + bending) * (weight * length);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::{Beam, FREE, Material};
    use nalgebra::{SMatrix, SVector};

    /// A force at the free end moves it by F L³/(3 EI), and rotates it by F L²/(2 EI). Along the beam it moves it by 8/9 of
    /// F L/(EA): the clamped tangent does not stretch, and the best of the strains a s + b s² is too small by a ninth.
    #[test]
    fn a_cantilever_bends_and_stretches_as_beam_theory_says() {
        let material = Material { axial: 7.0, bending: 0.5, radius: 0.1 };
        let beam = Beam::between([1.0, 0.0, 2.0], [1.0, 3.0, 2.0], material);
        let free: SMatrix<f64, FREE, FREE> = beam.stiffness().fixed_view::<FREE, FREE>(6, 6).into_owned();
        let moved = |force: [f64; 3]| {
            let [x, y, z] = force;
            free.lu().solve(&SVector::from([x, y, z, 0.0, 0.0, 0.0])).unwrap()
        };
        let (length, force) = (3.0_f64, 0.2);
        let across = moved([0.0, 0.0, force]);
        assert!((across[2] - force * length.powi(3) / (3.0 * 0.5)).abs() < 1e-12);
        // The tangent is a derivative in xi: half the length times the slope.
        assert!((across[5] - 1.5 * force * length.powi(2) / (2.0 * 0.5)).abs() < 1e-12);
        let along = moved([0.0, force, 0.0]);
        assert!((along[1] - 8.0 / 9.0 * force * length / 7.0).abs() < 1e-12);
    }

    #[test]
    fn a_beam_that_is_moved_is_not_strained() {
        let material = Material { axial: 2.0, bending: 3.0, radius: 0.1 };
        let beam = Beam::between([0.0; 3], [1.0, 2.0, -1.0], material);
        let mut moved = beam.reference;
        for i in [0, 1, 2, 6, 7, 8] {
            moved[i] += 0.5;
        }
        assert!(beam.forces(&moved).norm() < 1e-13);
        assert!(beam.forces(&(beam.reference * 1.1)).norm() > 0.1);
    }
}
