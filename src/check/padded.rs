//! Derivatives in the dofs, filled up with zeros to a common number of dofs: one instantiation of the matrices serves
//! all pairs of families.

use crate::curve::{DofDerivatives, Jet};
use crate::number::{Bounded, Real};
use nalgebra::{SMatrix, SVector, Vector3};

/// The largest number of dofs that a family of the gate has.
const DOFS: usize = 18;

type Square = SMatrix<Bounded, DOFS, DOFS>;

/// Dense dof-derivatives of a curve with at most [`Padded::DOFS`] dofs.
#[derive(Clone, Debug)]
pub(crate) struct Padded {
    jacobians: [SMatrix<Bounded, 3, DOFS>; 3],
    /// Second derivatives of the three components, for x and x,xi; none for a curve linear in its dofs.
    second: Option<Box<[[Square; 3]; 2]>>,
}

impl Padded {
    pub(crate) const DOFS: usize = DOFS;

    /// Fills a jet up.
    pub(crate) fn fill<U: DofDerivatives<Bounded, N>, const N: usize>(
        jet: &Jet<Bounded, U>,
    ) -> Jet<Bounded, Self> {
        const { assert!(N <= DOFS, "the family has more dofs than the gate provides for") };
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let jacobians = std::array::from_fn(|k| {
            let mut padded = SMatrix::<Bounded, 3, DOFS>::zeros();
            padded.fixed_columns_mut::<N>(0).copy_from(&jet.dofs.jacobian(k));
            padded
        });
        let square = |k: usize, axis: &Vector3<Bounded>| {
            let mut padded = Square::zeros();
            padded.fixed_view_mut::<N, N>(0, 0).copy_from(&jet.dofs.hessian(k, axis));
            padded
        };
        let second =
            (!U::LINEAR).then(|| Box::new([0, 1].map(|k| axes.each_ref().map(|axis| square(k, axis)))));
        Jet { geometry: jet.geometry, dofs: Self { jacobians, second } }
    }

    /// Fills a direction up.
    pub(crate) fn fill_vector<T: Real, const N: usize>(v: &SVector<T, N>) -> SVector<T, DOFS> {
        let mut padded = SVector::<T, DOFS>::zeros();
        padded.fixed_rows_mut::<N>(0).copy_from(v);
        padded
    }
}

impl DofDerivatives<Bounded, DOFS> for Padded {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<Bounded, DOFS>) -> Vector3<Bounded> {
        self.jacobians[k] * dq
    }

    fn second_variation(
        &self,
        k: usize,
        dq: &SVector<Bounded, DOFS>,
        linear_dq: &SVector<Bounded, DOFS>,
    ) -> Vector3<Bounded> {
        let Some(second) = &self.second else { return Vector3::zeros() };
        Vector3::from_fn(|c, _| dq.dot(&(second[k][c] * linear_dq)))
    }

    fn gradient(&self, k: usize, w: &Vector3<Bounded>) -> SVector<Bounded, DOFS> {
        self.jacobians[k].tr_mul(w)
    }

    fn jacobian(&self, k: usize) -> SMatrix<Bounded, 3, DOFS> {
        self.jacobians[k]
    }

    fn hessian(&self, k: usize, w: &Vector3<Bounded>) -> Square {
        match &self.second {
            None => Square::zeros(),
            Some(second) => second[k][0] * w[0] + second[k][1] * w[1] + second[k][2] * w[2],
        }
    }
}
