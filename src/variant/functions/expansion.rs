//! Any beam at its closest point as a curve of two dofs.

use crate::curve::{Curve, DofDerivatives, Geometry, Jet};
use crate::linearization::closed_form::PartialVariations;
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// x + a delta_u u + b Delta_u u + a b Delta_u delta_u u, each a Taylor polynomial about the closest point.
///
/// Its dofs are a and b. At a = b = 0 it has the derivatives of the beam up to those that the second variations contain.
/// It is not linear in its dofs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Expansion {
    pub(super) at: f64,
    pub(super) of: PartialVariations<f64>,
}

/// Its derivatives with respect to the dofs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ExpansionDofs<T> {
    /// Those in a, and in b, by order.
    first: [[Vector3<T>; 3]; 2],
    /// Those in a and b.
    mixed: [Vector3<T>; 2],
}

/// The k-th derivative of the Taylor polynomial with these derivatives, at the distance h.
fn taylor<T: Real>(derivatives: &[Vector3<f64>], k: usize, h: T) -> Vector3<T> {
    let mut sum = Vector3::zeros();
    let mut power = T::one();
    for (i, derivative) in (0_i32..).zip(derivatives.iter().skip(k)) {
        if i > 0 {
            power = power * h / T::from(f64::from(i));
        }
        sum += derivative.map(|x| T::from(x)) * power;
    }
    sum
}

impl Expansion {
    /// The k-th derivatives in xi of x, of its derivatives in a and b, and of its mixed derivative.
    fn derivatives<T: Real>(&self, k: usize, xi: T) -> [Vector3<T>; 4] {
        let PartialVariations { geometry: Geometry { x, t, t_xi, t_xixi }, delta_u, linear_u, second_u } =
            &self.of;
        let h = xi - T::from(self.at);
        [&[*x, *t, *t_xi, *t_xixi][..], delta_u, linear_u, second_u].map(|of| taylor(of, k, h))
    }

    fn derivative<T: Real>(&self, q: &SVector<T, 2>, k: usize, xi: T) -> Vector3<T> {
        let [x, in_a, in_b, mixed] = self.derivatives(k, xi);
        x + in_a * q[0] + in_b * q[1] + mixed * (q[0] * q[1])
    }
}

impl Curve<2> for Expansion {
    type Dofs<T: Real> = ExpansionDofs<T>;

    fn position<T: Real>(&self, q: &SVector<T, 2>, xi: T) -> Vector3<T> {
        self.derivative(q, 0, xi)
    }

    fn jet<T: Real>(&self, q: &SVector<T, 2>, xi: T) -> Jet<T, Self::Dofs<T>> {
        let [x, t, t_xi, t_xixi] = [0, 1, 2, 3].map(|k| self.derivative(q, k, xi));
        let of = [0, 1, 2].map(|k| self.derivatives(k, xi));
        let first = [
            of.map(|[_, in_a, _, mixed]| in_a + mixed * q[1]),
            of.map(|[_, _, in_b, mixed]| in_b + mixed * q[0]),
        ];
        let dofs = ExpansionDofs { first, mixed: [of[0][3], of[1][3]] };
        Jet { geometry: Geometry { x, t, t_xi, t_xixi }, dofs }
    }

    fn third_derivative_bound(&self, _: &SVector<f64, 2>) -> f64 {
        f64::INFINITY
    }
}

impl<T: Real> DofDerivatives<T, 2> for ExpansionDofs<T> {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<T, 2>) -> Vector3<T> {
        self.first[0][k] * dq[0] + self.first[1][k] * dq[1]
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, 2>, linear_dq: &SVector<T, 2>) -> Vector3<T> {
        self.mixed[k] * (dq[0] * linear_dq[1] + dq[1] * linear_dq[0])
    }
}
