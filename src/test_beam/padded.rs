//! Derivatives in the dofs, padded with zeros to a common number of dofs. A few instantiations of the matrices serve
//! all pairs of families.

use crate::curve::{DofDerivatives, Geometry, Jet};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// The number of dofs to which every family of the check can be padded.
pub(crate) const DOFS: usize = 18;
/// The number of dofs to which most families can be padded.
pub(crate) const FEW_DOFS: usize = 12;

/// A jet, the dofs and the two directions, padded.
pub(crate) type PaddedBeam<T, const D: usize = DOFS> = (Jet<T, Padded<T, D>>, [SVector<T, D>; 3]);

type Square<T, const D: usize> = SMatrix<T, D, D>;

/// Dof-derivatives of a curve with at most `D` dofs.
#[derive(Clone, Debug)]
pub(crate) enum Padded<T, const D: usize = DOFS> {
    /// The shape functions of a curve linear in its dofs, D / 3 of each order.
    Linear([SVector<T, D>; 4]),
    /// The Jacobians of any other curve, and the second derivatives of the three components of x and of x,xi.
    Nonlinear(Vec<SMatrix<T, 3, D>>, Vec<Square<T, D>>),
}

impl<T: Real, const D: usize> Padded<T, D> {
    /// Pads a jet.
    ///
    /// # Panics
    /// If the curve has more than `D` dofs.
    pub(crate) fn fill<U: DofDerivatives<T, N>, const N: usize>(jet: &Jet<T, U>) -> Jet<T, Self> {
        let dofs = &jet.dofs;
        let shapes = |k: usize| {
            let shapes = dofs.shapes(k)?;
            Some(SVector::from_fn(|i, _| shapes.get(i).copied().unwrap_or(T::zero())))
        };
        let padded = match [shapes(0), shapes(1), shapes(2), shapes(3)] {
            [Some(x), Some(t), Some(t_xi), Some(t_xixi)] => Self::Linear([x, t, t_xi, t_xixi]),
            _ => Self::nonlinear(dofs),
        };
        Jet { geometry: jet.geometry, dofs: padded }
    }

    /// A curve with more than `D` dofs, represented as a curve with two: its variations along the two directions.
    pub(crate) fn along<U: DofDerivatives<T, N>, const N: usize>(
        jet: &Jet<T, U>,
        dq: &SVector<T, N>,
        linear_dq: &SVector<T, N>,
    ) -> PaddedBeam<T, D> {
        let directions = [dq, linear_dq];
        let jacobian = |k| {
            let mut jacobian = SMatrix::<T, 3, D>::zeros();
            for (i, dq) in directions.iter().enumerate() {
                jacobian.set_column(i, &jet.dofs.variation(k, dq));
            }
            jacobian
        };
        let second = |k: usize| {
            let mut second = [Square::<T, D>::zeros(); 3];
            for (i, dq) in directions.iter().enumerate() {
                for (j, linear_dq) in directions.iter().enumerate() {
                    let of_x = jet.dofs.second_variation(k, dq, linear_dq);
                    for c in 0..3 {
                        second[c][(i, j)] = of_x[c];
                    }
                }
            }
            second
        };
        let dofs = Self::Nonlinear((0..3).map(jacobian).collect(), (0..2).flat_map(second).collect());
        let unit = |k: usize| SVector::from_fn(|i, _| if i == k { T::one() } else { T::zero() });
        let [first, other] = [0, 1].map(unit);
        (Jet { geometry: jet.geometry, dofs }, [SVector::zeros(), first, other])
    }

    /// The shape functions by order, if the curve has them.
    pub(crate) fn all_shapes(&self) -> Option<[&[T]; 4]> {
        match self {
            Self::Linear(shapes) => Some(shapes.each_ref().map(|shapes| &shapes.as_slice()[..D / 3])),
            Self::Nonlinear(..) => None,
        }
    }

    fn nonlinear<U: DofDerivatives<T, N>, const N: usize>(dofs: &U) -> Self {
        let mut jacobians = vec![SMatrix::<T, 3, D>::zeros(); 3];
        for (k, padded) in jacobians.iter_mut().enumerate() {
            padded.columns_mut(0, N).copy_from(&dofs.jacobian(k));
        }
        let mut second = vec![Square::<T, D>::zeros(); 6];
        for (i, padded) in second.iter_mut().enumerate() {
            let axis = Vector3::ith(i % 3, T::one());
            padded.view_mut((0, 0), (N, N)).copy_from(&dofs.hessian(i / 3, &axis));
        }
        Self::Nonlinear(jacobians, second)
    }

    /// Pads dofs or a direction.
    ///
    /// # Panics
    /// If it has more than `D` entries.
    pub(crate) fn fill_vector<const N: usize>(v: &SVector<T, N>) -> SVector<T, D> {
        let mut padded = SVector::<T, D>::zeros();
        padded.rows_mut(0, N).copy_from(v);
        padded
    }
}

/// The same over another scalar.
pub(crate) fn map_padded<T: Real, U: Real, const D: usize>(
    (jet, vectors): &PaddedBeam<T, D>,
    number: impl Fn(T) -> U + Copy,
) -> PaddedBeam<U, D> {
    let dofs = match &jet.dofs {
        Padded::Linear(shapes) => Padded::Linear(shapes.map(|shapes| shapes.map(number))),
        Padded::Nonlinear(jacobians, second) => Padded::Nonlinear(
            jacobians.iter().map(|jacobian| jacobian.map(number)).collect(),
            second.iter().map(|second| second.map(number)).collect(),
        ),
    };
    let Geometry { x, t, t_xi, t_xixi } = jet.geometry;
    let [x, t, t_xi, t_xixi] = [x, t, t_xi, t_xixi].map(|v| v.map(number));
    (Jet { geometry: Geometry { x, t, t_xi, t_xixi }, dofs }, vectors.map(|v| v.map(number)))
}

impl<T: Real, const D: usize> DofDerivatives<T, D> for Padded<T, D> {
    const LINEAR: bool = false;

    fn shapes(&self, k: usize) -> Option<&[T]> {
        match self {
            Self::Linear(shapes) => Some(&shapes[k].as_slice()[..D / 3]),
            Self::Nonlinear(..) => None,
        }
    }

    fn variation(&self, k: usize, dq: &SVector<T, D>) -> Vector3<T> {
        self.jacobian(k) * dq
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, D>, linear_dq: &SVector<T, D>) -> Vector3<T> {
        match self {
            Self::Linear(_) => Vector3::zeros(),
            Self::Nonlinear(_, second) => Vector3::from_fn(|c, _| dq.dot(&(second[3 * k + c] * linear_dq))),
        }
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, D> {
        match self {
            Self::Linear(shapes) => {
                let mut gradient = SVector::zeros();
                for (i, &shape) in shapes[k].as_slice()[..D / 3].iter().enumerate() {
                    for c in 0..3 {
                        gradient[3 * i + c] = shape * w[c];
                    }
                }
                gradient
            }
            Self::Nonlinear(jacobians, _) => jacobians[k].tr_mul(w),
        }
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, D> {
        match self {
            Self::Linear(shapes) => {
                let entry = |c, i| if c == i % 3 { shapes[k][i / 3] } else { T::zero() };
                SMatrix::from_fn(entry)
            }
            Self::Nonlinear(jacobians, _) => jacobians[k],
        }
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> Square<T, D> {
        match self {
            Self::Linear(_) => Square::zeros(),
            Self::Nonlinear(_, second) => {
                let [x, y, z] = [0, 1, 2].map(|c| &second[3 * k + c]);
                x.zip_zip_map(y, z, |x, y, z| x * w[0] + y * w[1] + z * w[2])
            }
        }
    }
}
