//! A beam of equal elements in a row.

use super::rod::{Gauss, element};
use crate::curve::{Curve, Geometry, Hermite};
use crate::number::Real;
use crate::teaching::{DOFS, Material};
use nalgebra::{DMatrix, DVector, SVector, Vector3};

/// The dofs of a node: its point and its tangent dx/ds.
pub(super) const NODE: usize = 6;

/// A beam that is straight in the reference, of equal cubic Hermite elements without torsion.
///
/// Dofs, node-major: the point (a length), and the tangent dx/ds (no unit), a unit vector in the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain {
    /// The first point of the reference.
    pub start: Vector3<f64>,
    /// The last point of the reference.
    pub end: Vector3<f64>,
    /// The number of elements.
    pub elements: usize,
    /// The material and the section.
    pub material: Material,
    /// The integration.
    pub rule: Gauss,
    /// Its first dof in the model.
    pub first: usize,
}

impl Chain {
    /// The length of an element in the reference.
    pub fn element_length(&self) -> f64 {
        (self.end - self.start).norm() / count(self.elements)
    }

    /// The number of dofs.
    pub fn dofs(&self) -> usize {
        NODE * (self.elements + 1)
    }

    /// The first dof of a node in the model: three of the point, three of the tangent.
    pub fn node(&self, node: usize) -> usize {
        self.first + NODE * node
    }

    /// The curve of each element.
    pub fn curve(&self) -> Hermite {
        Hermite::scaled_by(self.element_length())
    }

    /// The dofs of an element.
    pub fn element<T: Real>(&self, u: &DVector<T>, element: usize) -> SVector<T, DOFS> {
        u.fixed_rows::<DOFS>(self.node(element)).into_owned()
    }

    /// A point of an element with its derivatives in xi.
    pub fn geometry(&self, u: &DVector<f64>, element: usize, xi: f64) -> Geometry<f64> {
        self.curve().jet(&self.element(u, element), xi).geometry
    }

    /// Writes the dofs of the reference.
    pub(super) fn write_reference(&self, u: &mut DVector<f64>) {
        let chord = self.end - self.start;
        for node in 0..=self.elements {
            let point = self.start + chord * (count(node) / count(self.elements));
            u.fixed_rows_mut::<3>(self.node(node)).copy_from(&point);
            u.fixed_rows_mut::<3>(self.node(node) + 3).copy_from(&chord.normalize());
        }
    }

    /// Adds the elastic forces and their tangent.
    pub(super) fn add<T: Real>(&self, u: &DVector<T>, residual: &mut DVector<T>, tangent: &mut DMatrix<T>) {
        let length = self.element_length();
        for i in 0..self.elements {
            let (r, k) = element(&self.element(u, i), length, &self.material, self.rule);
            let at = self.node(i);
            let mut rows = residual.fixed_rows_mut::<DOFS>(at);
            rows += r;
            let mut block = tangent.fixed_view_mut::<DOFS, DOFS>(at, at);
            block += k;
        }
    }
}

/// A small count as a number.
#[expect(clippy::cast_precision_loss, reason = "a number of elements, far below 2^53")]
fn count(n: usize) -> f64 {
    n as f64
}
