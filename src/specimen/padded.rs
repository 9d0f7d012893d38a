//! Derivatives in the dofs, filled up with zeros to a common number of dofs: a few instantiations of the matrices serve
//! all pairs of families.

use crate::curve::{DofDerivatives, Jet};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// The number of dofs that every family of the gate can be filled up to.
pub(crate) const DOFS: usize = 18;
/// The number of dofs that most families can be filled up to.
pub(crate) const FEW_DOFS: usize = 12;

/// A jet and the two directions, filled up.
pub(crate) type PaddedBeam<T, const D: usize = DOFS> = (Jet<T, Padded<T, D>>, [SVector<T, D>; 2]);

type Square<T, const D: usize> = SMatrix<T, D, D>;

/// Dof-derivatives of a curve with at most `D` dofs.
#[derive(Clone, Debug)]
pub(crate) struct Padded<T, const D: usize = DOFS> {
    jacobians: [SMatrix<T, 3, D>; 3],
    /// The shape functions of a curve linear in its dofs, or the second derivatives of the three components of x and
    /// x,xi.
    of: Kind<T, D>,
}

#[derive(Clone, Debug)]
enum Kind<T, const D: usize> {
    /// D / 3 functions each.
    Linear([SVector<T, D>; 3]),
    Nonlinear(Box<[[Square<T, D>; 3]; 2]>),
}

impl<T: Real, const D: usize> Padded<T, D> {
    /// Fills a jet up.
    ///
    /// # Panics
    /// If the curve has more dofs than there is room for.
    pub(crate) fn fill<U: DofDerivatives<T, N>, const N: usize>(jet: &Jet<T, U>) -> Jet<T, Self> {
        let dofs = &jet.dofs;
        let jacobians = std::array::from_fn(|k| {
            let mut padded = SMatrix::<T, 3, D>::zeros();
            padded.columns_mut(0, N).copy_from(&dofs.jacobian(k));
            padded
        });
        let shapes = |k: usize| {
            let shapes = dofs.shapes(k)?;
            Some(SVector::from_fn(|i, _| shapes.get(i).copied().unwrap_or(T::zero())))
        };
        let squares = |k: usize| {
            [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis: Vector3<T>| {
                let mut padded = Square::<T, D>::zeros();
                padded.view_mut((0, 0), (N, N)).copy_from(&dofs.hessian(k, &axis));
                padded
            })
        };
        let of = match [shapes(0), shapes(1), shapes(2)] {
            [Some(x), Some(t), Some(t_xi)] => Kind::Linear([x, t, t_xi]),
            _ => Kind::Nonlinear(Box::new([squares(0), squares(1)])),
        };
        Jet { geometry: jet.geometry, dofs: Self { jacobians, of } }
    }

    /// Fills a direction up.
    ///
    /// # Panics
    /// If there is no room for it.
    pub(crate) fn fill_vector<const N: usize>(v: &SVector<T, N>) -> SVector<T, D> {
        let mut padded = SVector::<T, D>::zeros();
        padded.rows_mut(0, N).copy_from(v);
        padded
    }
}

impl<T: Real, const D: usize> DofDerivatives<T, D> for Padded<T, D> {
    const LINEAR: bool = false;

    fn shapes(&self, k: usize) -> Option<&[T]> {
        match &self.of {
            Kind::Linear(shapes) => Some(&shapes[k].as_slice()[..D / 3]),
            Kind::Nonlinear(_) => None,
        }
    }

    fn variation(&self, k: usize, dq: &SVector<T, D>) -> Vector3<T> {
        self.jacobians[k] * dq
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, D>, linear_dq: &SVector<T, D>) -> Vector3<T> {
        match &self.of {
            Kind::Linear(_) => Vector3::zeros(),
            Kind::Nonlinear(second) => Vector3::from_fn(|c, _| dq.dot(&(second[k][c] * linear_dq))),
        }
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, D> {
        match &self.of {
            Kind::Linear(shapes) => SVector::from_fn(|i, _| shapes[k][i / 3] * w[i % 3]),
            Kind::Nonlinear(_) => self.jacobians[k].tr_mul(w),
        }
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, D> {
        self.jacobians[k]
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> Square<T, D> {
        match &self.of {
            Kind::Linear(_) => Square::zeros(),
            Kind::Nonlinear(second) => {
                let [x, y, z] = &second[k];
                x * w[0] + y * w[1] + z * w[2]
            }
        }
    }
}
