//! A curve moved, turned or mirrored, and in another unit.

use crate::curve::{Curve, DofDerivatives, Geometry, Jet};
use crate::number::Real;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// s R x + c, with the dofs of x. R is a rotation or a reflection.
#[derive(Clone, Debug)]
pub(super) struct Placed<C> {
    pub(super) curve: C,
    /// s R.
    pub(super) turn: Matrix3<f64>,
    /// c.
    pub(super) shift: Vector3<f64>,
}

/// Its derivatives with respect to the dofs.
#[derive(Clone, Debug)]
pub(super) struct PlacedDofs<T, U> {
    dofs: U,
    turn: Matrix3<T>,
}

impl<C: Curve<N>, const N: usize> Curve<N> for Placed<C> {
    type Dofs<T: Real> = PlacedDofs<T, C::Dofs<T>>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        self.turn.map(T::from) * self.curve.position(q, xi) + self.shift.map(T::from)
    }

    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Self::Dofs<T>> {
        let turn = self.turn.map(T::from);
        let Jet { geometry: Geometry { x, t, t_xi, t_xixi }, dofs } = self.curve.jet(q, xi);
        let [x, t, t_xi, t_xixi] = [x, t, t_xi, t_xixi].map(|v| turn * v);
        let geometry = Geometry { x: x + self.shift.map(T::from), t, t_xi, t_xixi };
        Jet { geometry, dofs: PlacedDofs { dofs, turn } }
    }

    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64 {
        self.turn.norm() * self.curve.third_derivative_bound(q)
    }

    fn is_cubic(&self) -> bool {
        self.curve.is_cubic()
    }
}

impl<T: Real, U: DofDerivatives<T, N>, const N: usize> DofDerivatives<T, N> for PlacedDofs<T, U> {
    const LINEAR: bool = U::LINEAR;

    fn variation(&self, k: usize, dq: &SVector<T, N>) -> Vector3<T> {
        self.turn * self.dofs.variation(k, dq)
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, N>, linear_dq: &SVector<T, N>) -> Vector3<T> {
        self.turn * self.dofs.second_variation(k, dq, linear_dq)
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, N> {
        self.dofs.gradient(k, &self.turn.tr_mul(w))
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, N> {
        self.turn * self.dofs.jacobian(k)
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> SMatrix<T, N, N> {
        self.dofs.hessian(k, &self.turn.tr_mul(w))
    }
}
