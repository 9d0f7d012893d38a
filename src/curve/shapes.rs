//! Curves that are linear in their dofs: x = sum of shape functions times control vectors.

use super::{DofDerivatives, Geometry, Jet};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// The values and first three derivatives of `P` shape functions at one parameter.
///
/// The dofs are node-major: control vector i (a point, or a nodal tangent) is `q[3i]`, `q[3i+1]`, `q[3i+2]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shapes<T, const P: usize> {
    /// `derivatives[k][i]`: the k-th derivative of shape function i.
    pub derivatives: [[T; P]; 4],
}

impl<T: Real, const P: usize> Shapes<T, P> {
    /// The jet of x = sum N_i q_i, from the shape functions (`n[0]`) and their first three derivatives.
    #[inline(always)]
    pub fn jet<const N: usize>(n: [[T; P]; 4], q: &SVector<T, N>) -> Jet<T, Self> {
        let geometry = Geometry {
            x: combine(&n[0], q),
            t: combine(&n[1], q),
            t_xi: combine(&n[2], q),
            t_xixi: combine(&n[3], q),
        };
        Jet { geometry, dofs: Self { derivatives: n } }
    }
}

/// The sum of the control vectors in `q`, each times its number in `n`.
#[inline(always)]
pub(super) fn combine<T: Real, const P: usize, const N: usize>(n: &[T; P], q: &SVector<T, N>) -> Vector3<T> {
    const { assert!(N == 3 * P, "a curve of P control vectors has 3 P dofs") };
    let mut sum = Vector3::from_fn(|c, _| q[c] * n[0]);
    for (i, &n) in n.iter().enumerate().skip(1) {
        for c in 0..3 {
            sum[c] += q[3 * i + c] * n;
        }
    }
    sum
}

/// The control vectors of a curve whose dofs are node-major.
pub(super) fn control_vectors<T: Real, const P: usize, const N: usize>(q: &SVector<T, N>) -> [Vector3<T>; P] {
    const { assert!(N == 3 * P, "a curve of P control vectors has 3 P dofs") };
    std::array::from_fn(|i| q.fixed_rows::<3>(3 * i).into_owned())
}

/// Repeated linear interpolation, the scheme of Neville, de Casteljau and de Boor. At every level m = 1, 2, .. point i
/// moves towards its right neighbour by `towards(m, i, point, neighbour)`, until one point is left.
///
/// Points are changed in place: a vector of dual numbers takes kilobytes, and copying it is slow.
pub(super) fn triangle<T: Real, const D: usize, const P: usize>(
    mut points: [SVector<T, D>; P],
    towards: impl Fn(usize, usize, &mut SVector<T, D>, &SVector<T, D>),
) -> SVector<T, D> {
    const { assert!(P > 0, "a curve has at least one control vector") };
    for level in 1..P {
        for i in 0..P - level {
            let (before, after) = points.split_at_mut(i + 1);
            towards(level, i, &mut before[i], &after[0]);
        }
    }
    points[0]
}

/// Moves a point towards another by the fraction `u` of the difference, with one product.
#[inline]
pub(super) fn go<T: Real, const D: usize>(point: &mut SVector<T, D>, to: &SVector<T, D>, u: T) {
    let from: &SVector<T, D> = point;
    let step = (to - from) * u;
    *point += step;
}

/// f times g, both by value and derivatives up to the third, by Leibniz' rule.
#[inline]
pub(super) fn times<T: Real>(f: &[T; 4], g: &[T; 4]) -> [T; 4] {
    let ([f0, f1, f2, f3], [g0, g1, g2, g3]) = (*f, *g);
    let three = T::from(3.0);
    let middle = f1 * g1;
    [
        f0 * g0,
        f1 * g0 + f0 * g1,
        f2 * g0 + (middle + middle) + f0 * g2,
        f3 * g0 + (f2 * g1 + f1 * g2) * three + f0 * g3,
    ]
}

/// f times a linear function, both by value and derivatives (f up to its third), by Leibniz' rule.
#[inline]
pub(super) fn times_linear<T: Real>(f: &[T; 4], value: T, slope: T) -> [T; 4] {
    let [f0, f1, f2, f3] = *f;
    [
        f0 * value,
        f1 * value + f0 * slope,
        f2 * value + (f1 + f1) * slope,
        f3 * value + T::from(3.0) * f2 * slope,
    ]
}

/// Transposes the derivatives of every function into the functions of every order of derivative.
pub(super) fn by_order<T: Real, const P: usize>(functions: &[[T; 4]; P]) -> [[T; P]; 4] {
    std::array::from_fn(|k| std::array::from_fn(|i| functions[i][k]))
}

/// A small count as an `f64`.
#[expect(clippy::cast_precision_loss, reason = "counts nodes of one element, far below 2^53")]
pub(super) const fn count(i: usize) -> f64 {
    i as f64
}

impl<T: Real, const P: usize, const N: usize> DofDerivatives<T, N> for Shapes<T, P> {
    const LINEAR: bool = true;

    #[inline]
    fn shapes(&self, k: usize) -> Option<&[T]> {
        Some(&self.derivatives[k])
    }

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
