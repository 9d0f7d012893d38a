//! One span of a non-uniform rational B-spline whose weights are degrees of freedom.

use super::nurbs::{BINOMIALS, leibniz, rational_bound};
use super::shapes::by_order;
use super::{BSpline, Curve, CurveError, DofDerivatives, Geometry, Jet, by_rows};
use crate::number::Real;
use nalgebra::{SMatrix, SVector, Vector3, Vector4};

/// One span of a rational B-spline of degree `P` - 1 with its weights among the dofs.
///
/// Dofs, node-major: (x, y, z, w) of every control point, the coordinates in the user's unit of length, the weight
/// without unit and positive; `N = 4 P`. The span, its knots and its control points are those of [`BSpline`]; the
/// formula is that of [`Nurbs`](super::Nurbs), x = A / W. It is not linear in the weights.
///
/// # Derivation
/// All derivatives follow from Leibniz' rule for A = W x, each solved for the highest derivative of x:
///
/// ```math
/// A^(k)   = sum_j binomial(k, j) W^(j) x^(k-j)
/// d A^(k) = sum_j binomial(k, j) (dW^(j) x^(k-j) + W^(j) dx^(k-j))
/// DdA^(k) = sum_j binomial(k, j) (dW^(j) Dx^(k-j) + DW^(j) dx^(k-j) + W^(j) Ddx^(k-j))
/// ```
///
/// where A is varied as dA = sum N_i (dw_i P_i + w_i dP_i), DdA = sum N_i (dw_i DP_i + Dw_i dP_i), and DdW = 0.
/// The origin is moved to the point x itself, which avoids cancellation far from the user's origin. With P_i - x for
/// P_i, x^(0) is zero in the first two rows.
///
/// The matrices contain the same derivatives in the unit directions. With n_i = N_i / W,
///
/// ```math
/// dx/dP_i = w_i n_i I                     d2x/dP_i dw_j = (delta_ij n_i - w_i n_i n_j) I
/// dx/dw_i = n_i (P_i - x)                 d2x/dw_i dw_j = -n_i n_j (P_i + P_j - 2 x)
/// ```
///
/// and their derivatives with respect to xi.
///
/// Source: L. Piegl, W. Tiller, *The NURBS Book*, 2nd ed., section 4.3, for the first row; the others by variation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NurbsWeighted<const P: usize> {
    span: BSpline<P>,
}

impl<const P: usize> NurbsWeighted<P> {
    /// The span in the middle of 2 (`P` - 1) knots.
    ///
    /// # Errors
    /// If the knots are invalid for a [`BSpline`].
    pub fn new(knots: &[f64]) -> Result<Self, CurveError> {
        BSpline::new(knots).map(|span| Self { span })
    }
}

/// The control points with their weights.
fn control_points<T: Real, const P: usize, const N: usize>(q: &SVector<T, N>) -> [Vector4<T>; P] {
    const { assert!(N == 4 * P, "P control points with weights have 4 P dofs") };
    std::array::from_fn(|i| q.fixed_rows::<4>(4 * i).into_owned())
}

impl<const P: usize, const N: usize> Curve<N> for NurbsWeighted<P> {
    type Dofs<T: Real> = NurbsDofs<T, P>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        let weighted = control_points::<T, P, N>(q).map(|p| (p.xyz() * p.w).push(p.w));
        let a = self.span.interpolate(weighted, xi);
        a.xyz() / a.w
    }

    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, NurbsDofs<T, P>> {
        let mut points = control_points::<T, P, N>(q);
        let n = by_order(&self.span.functions(xi));
        let w = n.map(|n| n.iter().zip(&points).fold(T::zero(), |sum, (&n, p)| sum + n * p.w));
        let weighted = |points: &[Vector4<T>; P], k: usize| sum(&n[k], |i| points[i].xyz() * points[i].w);
        let x = weighted(&points, 0) / w[0];
        for p in &mut points {
            p.x -= x.x;
            p.y -= x.y;
            p.z -= x.z;
        }
        let mut derivatives = [Vector3::zeros(); 4];
        for k in 1..4 {
            derivatives[k] = solve(&w, weighted(&points, k), &derivatives, k);
        }
        let [zero, t, t_xi, t_xixi] = derivatives;
        let [n0, n1, n2, _] = n;
        let [w0, w1, w2, _] = w;
        let dofs = NurbsDofs { n: [n0, n1, n2], w: [w0, w1, w2], points, x: [zero, t, t_xi] };
        Jet { geometry: Geometry { x, t, t_xi, t_xixi }, dofs }
    }

    /// By the quotient rule, as for [`Nurbs`](super::Nurbs); infinite unless all weights are positive.
    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64 {
        let points = control_points::<f64, P, N>(q);
        rational_bound(&self.span, points.map(|p| p.xyz()), points.map(|p| p.w))
    }
}

/// The sum of vectors, each times its number in `n`.
fn sum<T: Real, const P: usize>(n: &[T; P], vector: impl Fn(usize) -> Vector3<T>) -> Vector3<T> {
    n.iter().enumerate().fold(Vector3::zeros(), |sum, (i, &n)| sum + vector(i) * n)
}

/// x^(k) from a = W x^(k) + sum over j > 0 of binomial(k, j) W^(j) x^(k-j), the lower derivatives being known.
fn solve<T: Real>(w: &[T], a: Vector3<T>, lower: &[Vector3<T>], k: usize) -> Vector3<T> {
    (a - leibniz(k, 1, |j| lower[k - j] * w[j])) / w[0]
}

/// The values that the variations of a [`NurbsWeighted`] curve at one parameter need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NurbsDofs<T, const P: usize> {
    /// The basis functions N_i and their first two derivatives.
    n: [[T; P]; 3],
    /// W and its first two derivatives.
    w: [T; 3],
    /// The control points relative to x, with their weights.
    points: [Vector4<T>; P],
    /// x relative to itself, which is zero, and its first two derivatives.
    x: [Vector3<T>; 3],
}

/// The variations of W and of x, up to a certain derivative.
struct Variation<T> {
    w: [T; 3],
    x: [Vector3<T>; 3],
}

impl<T: Real, const P: usize> NurbsDofs<T, P> {
    /// n_i = N_i / W and its first `k` derivatives, by Leibniz' rule for N_i = W n_i.
    fn quotients(&self, k: usize) -> [[T; P]; 3] {
        let mut n = [[T::zero(); P]; 3];
        for (k, functions) in self.n.iter().enumerate().take(k + 1) {
            for i in 0..P {
                let lower = (1..=k)
                    .fold(functions[i], |sum, j| sum - T::from(BINOMIALS[k][j]) * self.w[j] * n[k - j][i]);
                n[k][i] = lower / self.w[0];
            }
        }
        n
    }

    /// The variations of the first `k` derivatives.
    fn vary(&self, k: usize, dq: &[Vector4<T>; P]) -> Variation<T> {
        let mut d = Variation { w: [T::zero(); 3], x: [Vector3::zeros(); 3] };
        for (k, n) in self.n.iter().enumerate().take(k + 1) {
            d.w[k] = n.iter().zip(dq).fold(T::zero(), |sum, (&n, dp)| sum + n * dp.w);
            // δA^(k) = Σ N_i^(k) (δw_i P_i + w_i δP_i)
            let p = &self.points;
            let da = sum(n, |i| p[i].xyz() * dq[i].w + dq[i].xyz() * p[i].w);
            d.x[k] = solve(&self.w, da - leibniz(k, 0, |j| self.x[k - j] * d.w[j]), &d.x, k);
        }
        d
    }
}

impl<T: Real, const P: usize, const N: usize> DofDerivatives<T, N> for NurbsDofs<T, P> {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<T, N>) -> Vector3<T> {
        self.vary(k, &control_points(dq)).x[k]
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, N>, linear_dq: &SVector<T, N>) -> Vector3<T> {
        let (dq, linear_dq) = (control_points::<T, P, N>(dq), control_points::<T, P, N>(linear_dq));
        let (d, linear) = (self.vary(k, &dq), self.vary(k, &linear_dq));
        let mut both = [Vector3::zeros(); 3];
        for (k, n) in self.n.iter().enumerate().take(k + 1) {
            // ΔδA^(k) = Σ N_i^(k) (δw_i ΔP_i + Δw_i δP_i)
            let da = sum(n, |i| linear_dq[i].xyz() * dq[i].w + dq[i].xyz() * linear_dq[i].w);
            let products = leibniz(k, 0, |j| linear.x[k - j] * d.w[j] + d.x[k - j] * linear.w[j]);
            both[k] = solve(&self.w, da - products, &both, k);
        }
        both[k]
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, N> {
        const { assert!(N == 4 * P, "P control points with weights have 4 P dofs") };
        let n = self.quotients(k);
        let mut gradient = SVector::<T, N>::zeros();
        for (i, p) in self.points.iter().enumerate() {
            gradient.fixed_rows_mut::<3>(4 * i).copy_from(&(w * (p.w * n[k][i])));
            // The k-th derivative of n_i (P_i - x)
            gradient[4 * i + 3] = (1..=k).fold(n[k][i] * w.dot(&p.xyz()), |sum, j| {
                sum - T::from(BINOMIALS[k][j]) * n[k - j][i] * w.dot(&self.x[j])
            });
        }
        gradient
    }

    fn jacobian(&self, k: usize) -> SMatrix<T, 3, N> {
        by_rows(|w| self.gradient(k, w))
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> SMatrix<T, N, N> {
        let n = self.quotients(k);
        let along = self.points.map(|p| w.dot(&p.xyz()));
        let mut hessian = SMatrix::<T, N, N>::zeros();
        for (i, p) in self.points.iter().enumerate() {
            for j in 0..P {
                // The k-th derivatives of n_i n_j, of δ_ij n_i - w_i n_i n_j, and of -n_i n_j (P_i + P_j - 2 x)
                let product = match k {
                    0 => n[0][i] * n[0][j],
                    _ => n[1][i] * n[0][j] + n[0][i] * n[1][j],
                };
                let own = if i == j { n[k][i] } else { T::zero() };
                let mixed = w * (own - p.w * product);
                hessian.fixed_view_mut::<3, 1>(4 * i, 4 * j + 3).copy_from(&mixed);
                hessian.fixed_view_mut::<1, 3>(4 * j + 3, 4 * i).copy_from(&mixed.transpose());
                let mut weights = -product * (along[i] + along[j]);
                if k == 1 {
                    let square = n[0][i] * n[0][j];
                    weights += (square + square) * w.dot(&self.x[1]);
                }
                hessian[(4 * i + 3, 4 * j + 3)] = weights;
            }
        }
        hessian
    }
}
