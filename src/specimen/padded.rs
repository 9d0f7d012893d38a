//! Derivatives in the dofs, filled up with zeros to a common number of dofs: one instantiation of the matrices serves
//! all pairs of families.

use crate::curve::{DofDerivatives, Jet};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// The largest number of dofs that a family of the gate has.
const DOFS: usize = 18;

/// A jet and the two directions, filled up.
pub(crate) type PaddedBeam<T> = (Jet<T, Padded<T>>, [SVector<T, DOFS>; 2]);

type Square<T> = SMatrix<T, DOFS, DOFS>;

/// Dense dof-derivatives of a curve with at most [`Padded::DOFS`] dofs.
#[derive(Clone, Debug)]
pub(crate) struct Padded<T> {
    jacobians: [SMatrix<T, 3, DOFS>; 3],
    /// Second derivatives of the three components, for x and x,xi; none for a curve linear in its dofs.
    second: Option<Box<[[Square<T>; 3]; 2]>>,
}

impl<T: Real> Padded<T> {
    /// Fills a jet up.
    pub(crate) fn fill<U: DofDerivatives<T, N>, const N: usize>(jet: &Jet<T, U>) -> Jet<T, Self> {
        const { assert!(N <= DOFS, "the family has more dofs than the gate provides for") };
        let jacobians = std::array::from_fn(|k| {
            let mut padded = SMatrix::<T, 3, DOFS>::zeros();
            padded.fixed_columns_mut::<N>(0).copy_from(&jet.dofs.jacobian(k));
            padded
        });
        let unit = |i: usize| SVector::<T, N>::from_fn(|j, _| if i == j { T::one() } else { T::zero() });
        let squares = |k: usize| {
            let mut padded = [Square::<T>::zeros(); 3];
            for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
                let entry = jet.dofs.second_variation(k, &unit(i), &unit(j));
                for c in 0..3 {
                    padded[c][(i, j)] = entry[c];
                }
            }
            padded
        };
        let second = (!U::LINEAR).then(|| Box::new([squares(0), squares(1)]));
        Jet { geometry: jet.geometry, dofs: Self { jacobians, second } }
    }

    /// Fills a direction up.
    pub(crate) fn fill_vector<const N: usize>(v: &SVector<T, N>) -> SVector<T, DOFS> {
        let mut padded = SVector::<T, DOFS>::zeros();
        padded.fixed_rows_mut::<N>(0).copy_from(v);
        padded
    }
}

impl<T: Real> DofDerivatives<T, DOFS> for Padded<T> {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<T, DOFS>) -> Vector3<T> {
        self.jacobians[k] * dq
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, DOFS>, linear_dq: &SVector<T, DOFS>) -> Vector3<T> {
        let Some(second) = &self.second else { return Vector3::zeros() };
        Vector3::from_fn(|c, _| dq.dot(&(second[k][c] * linear_dq)))
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, DOFS> {
        self.jacobians[k].tr_mul(w)
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, DOFS> {
        self.jacobians[k]
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> Square<T> {
        match &self.second {
            None => Square::<T>::zeros(),
            Some(second) => second[k][0] * w[0] + second[k][1] * w[1] + second[k][2] * w[2],
        }
    }
}
