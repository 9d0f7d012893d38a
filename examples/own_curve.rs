//! The check of a user-defined curve: a quartic with five control points.
//!
//! `cargo run --release --example own_curve`

use beamgap::check;
use beamgap::curve::{Curve, Jet, Shapes};
use beamgap::faults;
use beamgap::nalgebra::{SVector, Vector3};
use beamgap::number::Real;

/// A Bernstein polynomial of fourth degree in u = (1 + xi)/2.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Quartic;

/// The binomial coefficients.
const BINOMIAL: [f64; 5] = [1.0, 4.0, 6.0, 4.0, 1.0];

/// x^n with its first three derivatives.
fn power<T: Real>(x: T, n: u32) -> [T; 4] {
    let mut all = [T::zero(); 4];
    for (k, derivative) in (0..=n).zip(&mut all) {
        let factor: u32 = (n - k + 1..=n).product();
        *derivative = (0..n - k).fold(T::from(f64::from(factor)), |product, _| product * x);
    }
    all
}

impl Curve<15> for Quartic {
    type Dofs<T: Real> = Shapes<T, 5>;

    /// Computed by repeated interpolation, without the shape functions, so that each method verifies the other.
    fn position<T: Real>(&self, q: &SVector<T, 15>, xi: T) -> Vector3<T> {
        let u = (T::one() + xi) * T::from(0.5);
        let mut points: [Vector3<T>; 5] = std::array::from_fn(|i| q.fixed_rows::<3>(3 * i).into_owned());
        for level in (1..5).rev() {
            for i in 0..level {
                points[i] = points[i] + (points[i + 1] - points[i]) * u;
            }
        }
        points[0]
    }

    fn jet<T: Real>(&self, q: &SVector<T, 15>, xi: T) -> Jet<T, Shapes<T, 5>> {
        let half = T::from(0.5);
        let (u, v) = ((T::one() + xi) * half, (T::one() - xi) * half);
        // The derivatives of u^i v^(4 - i) in xi: du = dxi/2, dv = -dxi/2.
        let shapes: [[T; 4]; 5] = [0, 1, 2, 3, 4].map(|i| {
            let (f, g) = (power(u, i), power(v, 4 - i));
            let three = T::from(3.0);
            [
                f[0] * g[0],
                (f[1] * g[0] - f[0] * g[1]) * half,
                (f[2] * g[0] - (f[1] * g[1]) * T::from(2.0) + f[0] * g[2]) * T::from(0.25),
                (f[3] * g[0] - f[2] * g[1] * three + f[1] * g[2] * three - f[0] * g[3]) * T::from(0.125),
            ]
        });
        Shapes::jet(std::array::from_fn(|k| std::array::from_fn(|i| shapes[i][k] * T::from(BINOMIAL[i]))), q)
    }

    /// The third derivative is linear in xi, so its maximum is at an end.
    fn third_derivative_bound(&self, q: &SVector<f64, 15>) -> f64 {
        [-1.0, 1.0].map(|xi| self.jet(q, xi).geometry.t_xixi.norm()).into_iter().fold(0.0, f64::max)
    }
}

fn main() {
    let beam = [0.0, 0.0, 0.0, 0.5, 0.1, 0.0, 1.0, 0.3, 0.1, 1.5, 0.3, 0.3, 2.0, 0.2, 0.4];
    let found = check::curve(&Quartic, &[beam], 24);
    println!("{found}");
    assert!(found.agrees());
    println!("{}", faults::operations_of_curve(&Quartic));
}
