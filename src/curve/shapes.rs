//! Curves that are linear in their dofs: x = sum of shape functions times control vectors.

use super::{DofDerivatives, Geometry, Jet};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// The values and first two derivatives of `P` shape functions at one parameter.
///
/// The dofs are node-major: control vector i (a point, or a nodal tangent) is q[3i], q[3i+1], q[3i+2].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shapes<T, const P: usize> {
    /// `derivatives[k][i]`: the k-th derivative of shape function i.
    pub derivatives: [[T; P]; 3],
}

impl<T: Real, const P: usize> Shapes<T, P> {
    /// The jet of x = sum N_i q_i, from the shape functions (`n[0]`) and their first three derivatives.
    pub fn jet<const N: usize>(n: [[T; P]; 4], q: &SVector<T, N>) -> Jet<T, Self> {
        let [n0, n1, n2, n3] = n;
        let geometry = Geometry {
            x: combine(&n0, q),
            t: combine(&n1, q),
            t_xi: combine(&n2, q),
            t_xixi: combine(&n3, q),
        };
        Jet { geometry, dofs: Self { derivatives: [n0, n1, n2] } }
    }
}

/// The sum of the control vectors in `q`, each times its number in `n`.
#[inline]
pub(super) fn combine<T: Real, const P: usize, const N: usize>(n: &[T; P], q: &SVector<T, N>) -> Vector3<T> {
    const { assert!(N == 3 * P, "a curve of P control vectors has 3 P dofs") };
    let mut sum = Vector3::zeros();
    for (i, &n) in n.iter().enumerate() {
        sum += q.fixed_rows::<3>(3 * i) * n;
    }
    sum
}

impl<T: Real, const P: usize, const N: usize> DofDerivatives<T, N> for Shapes<T, P> {
    const LINEAR: bool = true;

    #[inline]
    fn variation(&self, k: usize, dq: &SVector<T, N>) -> Vector3<T> {
        combine(&self.derivatives[k], dq)
    }

    #[inline]
    fn second_variation(&self, _: usize, _: &SVector<T, N>, _: &SVector<T, N>) -> Vector3<T> {
        Vector3::zeros()
    }

    #[inline]
    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, N> {
        SVector::from_fn(|i, _| self.derivatives[k][i / 3] * w[i % 3])
    }

    #[inline]
    fn jacobian(&self, k: usize) -> SMatrix<T, 3, N> {
        SMatrix::from_fn(|c, i| if i % 3 == c { self.derivatives[k][i / 3] } else { T::zero() })
    }

    #[inline]
    fn hessian(&self, _: usize, _: &Vector3<T>) -> SMatrix<T, N, N> {
        SMatrix::zeros()
    }
}
