//! Lagrange interpolation: the curve through `P` nodes at equal distances of xi.

use super::shapes::{by_order, control_vectors, count, go, times, times_linear, triangle};
use super::{Curve, Jet, Shapes};
use crate::number::Real;
use crate::source_fault::source_fault;
use nalgebra::{SVector, Vector3};

/// The polynomial of degree `P` - 1 through `P` equidistant nodes.
///
/// The nodes are at xi_i = -1 + 2 i / (P - 1), in the order from -1 to 1. Dofs, node-major: the coordinates of node 0,
/// node 1, .., all in the user's unit of length; `N = 3 P`. In s = (P - 1) (xi + 1) / 2 the nodes are the integers:
///
/// ```math
/// x(xi) = sum_i N_i x_i,   N_i = product over j != i of (s - j) / (i - j)
/// ```
///
/// Source: O. Zienkiewicz, R. Taylor, *The Finite Element Method*, one-dimensional Lagrange shape functions; the
/// position by Neville's scheme (E. Neville, 1934).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lagrange<const P: usize>;

/// The straight segment between two nodes; N = 6.
pub type Segment = Lagrange<2>;

/// The parabola through three nodes, the second in the middle; N = 9.
pub type Quadratic = Lagrange<3>;

/// The cubic through four nodes at xi = -1, -1/3, 1/3, 1; N = 12.
pub type Cubic = Lagrange<4>;

impl<const P: usize> Lagrange<P> {
    /// The curve family; it has no parameters.
    pub const fn new() -> Self {
        const { assert!(P >= 2, "a curve has at least two nodes") };
        Self
    }

    /// ∏ (i - j), j ≠ i, for each node: exact, as products of integers.
    const DENOMINATORS: [f64; P] = {
        let mut denominators = [1.0; P];
        let mut i = 0;
        while i < P {
            let mut j = 0;
            while j < P {
                if j != i {
                    denominators[i] *= count(i) - count(j);
                }
                j += 1;
            }
            i += 1;
        }
        denominators
    };

    /// s(xi), in which the nodes are 0, 1, .., P - 1, and its slope.
    fn stretched<T: Real>(xi: T) -> (T, T) {
        let slope = T::from(0.5 * (count(P) - 1.0));
        ((xi + T::one()) * slope, slope)
    }
}

impl<const P: usize, const N: usize> Curve<N> for Lagrange<P> {
    type Dofs<T: Real> = Shapes<T, P>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        let (s, _) = Self::stretched(xi);
        triangle(control_vectors::<T, P, N>(q), |level, i, point, to| {
            let (away, width) = (s - T::from(count(i)), count(level));
            // A division by a power of two equals a multiplication by its inverse.
            let u = if level.is_power_of_two() { away * T::from(1.0 / width) } else { away / T::from(width) };
            go(point, to, u);
        })
    }

    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Shapes<T, P>> {
        let (s, slope) = Self::stretched(xi);
        let away = |j: usize| s - T::from(count(j));
        // N_i = ∏ (s - j) / ∏ (i - j), j ≠ i. The products over the nodes before and after i are built recursively.
        let [mut before, mut after] = [0, P - 1].map(|j| [[away(j), slope, T::zero(), T::zero()]; P]);
        for i in 2..P {
            before[i] = times_linear(&before[i - 1], away(i - 1), slope);
            after[P - 1 - i] = times_linear(&after[P - i], away(P - i), slope);
        }
        let mut functions = [[T::zero(); 4]; P];
        for i in 0..P {
            let product = match (i, P - 1 - i) {
                (0, _) => after[i],
                (_, 0) => before[i],
                (1, _) => times_linear(&after[i], away(0), slope),
                (_, 1) => times_linear(&before[i], away(P - 1), slope),
                _ => times(&before[i], &after[i]),
            };
            let factor = T::one() / T::from(Self::DENOMINATORS[i]);
            functions[i] = product.map(|derivative| derivative * factor);
        }
        let shapes = by_order(&functions);
        let shapes = source_fault!("jet-of-lagrange": [shapes[0], shapes[1], shapes[2], shapes[2]], shapes);
        Shapes::jet(shapes, q)
    }

    /// The sum of the absolute coefficients of x,xixixi as a polynomial in xi; exact up to the cubic.
    fn third_derivative_bound(&self, q: &SVector<f64, N>) -> f64 {
        // x = Σ powers[m] ξ^m, summed from the shape functions expanded in powers of ξ.
        let nodes = control_vectors::<f64, P, N>(q);
        let mut powers = [Vector3::zeros(); P];
        for (i, node) in nodes.iter().enumerate() {
            let mut function = [0.0; P];
            function[0] = 1.0;
            for j in (0..P).filter(|&j| j != i) {
                // Multiply by (s - j) / (i - j) = slope ξ + offset.
                let (half, distance) = (0.5 * (count(P) - 1.0), count(i) - count(j));
                let (slope, offset) = (half / distance, (half - count(j)) / distance);
                for m in (0..P).rev() {
                    function[m] = function[m] * offset + if m > 0 { function[m - 1] * slope } else { 0.0 };
                }
            }
            for (power, coefficient) in powers.iter_mut().zip(function) {
                *power += node * coefficient;
            }
        }
        let third =
            |(m, c): (usize, &Vector3<f64>)| count(m) * (count(m) - 1.0) * (count(m) - 2.0) * c.norm();
        powers.iter().enumerate().skip(3).map(third).sum()
    }

    fn is_cubic(&self) -> bool {
        P <= 4
    }
}
