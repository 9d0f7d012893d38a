//! The centroid of a beam: a space curve x(xi; q) over xi in [-1, 1], with its degrees of freedom as an argument.
//!
//! Every curve has two descriptions. Automatic differentiation uses [`Curve::position`] only. The closed form uses
//! [`Curve::jet`] only. Both are written by hand and independently of each other, so each checks the other.

mod arc;
mod bezier;
mod bspline;
mod error;
mod helix;
mod hermite;
mod lagrange;
mod nurbs;
mod nurbs_weighted;
mod screw;
mod shapes;

pub use arc::Arc;
pub use bezier::Bezier;
pub use bspline::BSpline;
pub use error::CurveError;
pub use helix::Helix;
pub use hermite::Hermite;
pub use lagrange::{Cubic, Lagrange, Quadratic, Segment};
pub use nurbs::Nurbs;
pub use nurbs_weighted::{NurbsDofs, NurbsWeighted};
pub use screw::ScrewDofs;
pub use shapes::Shapes;

use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// A curve family with `N` degrees of freedom.
///
/// # User-defined curves
/// Curves that are linear in their dofs use [`Shapes`] as [`Curve::Dofs`]. [`Shapes`] needs the shape functions and
/// their first three derivatives. Other curves implement [`DofDerivatives`] for a type of their own.
pub trait Curve<const N: usize> {
    /// The derivatives with respect to the dofs at one point of the curve.
    type Dofs<T: Real>: DofDerivatives<T, N>;

    /// The point x(xi), in the user's unit of length.
    #[doc(alias = "Eq. (1)")]
    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T>;

    /// The point with its derivatives in xi (up to the third) and in the dofs.
    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Self::Dofs<T>>;

    /// An upper bound of ‖x,xixixi‖ over [-1, 1]. The search for closest points needs it, so that it misses no point.
    ///
    /// It may be wrong by rounding. A bound that is too small voids the guarantee; one that is too large costs time.
    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64;

    /// Whether x is a polynomial in xi of third degree at most. Such a curve equals its own Taylor polynomial.
    ///
    /// It only saves the search for closest points some evaluations.
    fn is_cubic(&self) -> bool {
        false
    }
}

/// The point of a curve and its derivatives with respect to xi.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "Eq. (6)")]
#[doc(alias = "Eq. (10)")]
pub struct Geometry<T> {
    /// x, the point.
    pub x: Vector3<T>,
    /// t = x,xi, the tangent (parametric, not of unit length).
    pub t: Vector3<T>,
    /// t,xi = x,xixi.
    pub t_xi: Vector3<T>,
    /// t,xixi = x,xixixi.
    pub t_xixi: Vector3<T>,
}

/// What the closed form uses of a curve at one parameter.
#[derive(Clone, Copy, Debug)]
pub struct Jet<T, U> {
    /// The point and its xi-derivatives.
    pub geometry: Geometry<T>,
    /// The derivatives with respect to the dofs.
    pub dofs: U,
}

/// Derivatives of a curve with respect to its dofs, at a fixed parameter.
///
/// The order `k` counts derivatives with respect to xi: 0 is x, 1 is x,xi, 2 is x,xixi.
pub trait DofDerivatives<T: Real, const N: usize> {
    /// Whether x is linear in q, so that every second derivative vanishes.
    const LINEAR: bool;

    /// The k-th xi-derivatives of the shape functions, if x is a sum of control vectors times shape functions and the
    /// dofs are the coordinates of one control vector after the other.
    ///
    /// Then A_k consists of multiples of the unit matrix, and a product of two such matrices takes a ninth of the work.
    #[inline]
    fn shapes(&self, _k: usize) -> Option<&[T]> {
        None
    }

    /// delta_u u, delta_u u,xi or delta_u u,xixi (`k` = 0, 1, 2) in the direction `dq`.
    fn variation(&self, k: usize, dq: &SVector<T, N>) -> Vector3<T>;

    /// Delta_u delta_u u or Delta_u delta_u u,xi (`k` = 0, 1) in two directions.
    fn second_variation(&self, k: usize, dq: &SVector<T, N>, linear_dq: &SVector<T, N>) -> Vector3<T>;

    /// A_k^T w: the gradient of w . x,xi..xi (`k` times) for a fixed vector w.
    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, N> {
        SVector::from_fn(|i, _| w.dot(&self.variation(k, &unit(i))))
    }

    /// A_k, the Jacobian of x,xi..xi (`k` times).
    fn jacobian(&self, k: usize) -> SMatrix<T, 3, N> {
        let mut jacobian = SMatrix::<T, 3, N>::zeros();
        for i in 0..N {
            jacobian.set_column(i, &self.variation(k, &unit(i)));
        }
        jacobian
    }

    /// The matrix of second derivatives of w . x,xi..xi (`k` = 0, 1) for a fixed vector w.
    fn hessian(&self, k: usize, w: &Vector3<T>) -> SMatrix<T, N, N> {
        SMatrix::from_fn(|i, j| w.dot(&self.second_variation(k, &unit(i), &unit(j))))
    }
}

/// A_k from its rows, the gradients of the three components.
fn by_rows<T: Real, const N: usize>(gradient: impl Fn(&Vector3<T>) -> SVector<T, N>) -> SMatrix<T, 3, N> {
    SMatrix::from_rows(&[0, 1, 2].map(|c| gradient(&unit(c)).transpose()))
}

/// The `i`-th unit vector.
fn unit<T: Real, const N: usize>(i: usize) -> SVector<T, N> {
    let mut e = SVector::zeros();
    e[i] = T::one();
    e
}
