//! The cubic Hermite curve: two end points and the tangents there.

use super::shapes::control_vectors;
use super::{Curve, Jet, Shapes};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// The cubic through two points with given tangents.
///
/// Dofs, node-major: x_1, t_1, x_2, t_2; `N = 12`. The points are in the user's unit of length. The two constructors,
/// [`Hermite::new`] and [`Hermite::scaled_by`], define the tangents.
///
/// ```math
/// x(xi) = H_1 x_1 + H_2 x_2 + c (Ht_1 t_1 + Ht_2 t_2)
/// H_1  = (2 - 3 xi + xi^3) / 4          H_2  = (2 + 3 xi - xi^3) / 4
/// Ht_1 = (1 - xi - xi^2 + xi^3) / 4     Ht_2 = (-1 - xi + xi^2 + xi^3) / 4
/// ```
///
/// Source: C. Meier, A. Popp, W. Wall, "An objective 3D large deformation finite element formulation for
/// geometrically exact curved Kirchhoff rods", 2014, doi:10.1016/j.cma.2014.05.017.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hermite {
    /// dx/dxi = c t_k at the nodes.
    c: f64,
}

impl Hermite {
    /// The nodal tangents are derivatives with respect to xi: dx/dxi = t_k (c = 1), a length each.
    pub const fn new() -> Self {
        Self { c: 1.0 }
    }

    /// The nodal tangents are derivatives with respect to the arc length of the reference configuration, in which the
    /// element is `length` long: dx/dxi = (`length` / 2) t_k, so that c = `length` / 2 and t_k has no unit.
    ///
    /// If the parametrisation of the reference configuration is uniform, its tangents are unit vectors. The solver 4C
    /// uses this form for its beam elements. The length is a fixed parameter and not a dof. It is not checked.
    pub const fn scaled_by(length: f64) -> Self {
        Self { c: 0.5 * length }
    }
}

impl Default for Hermite {
    fn default() -> Self {
        Self::new()
    }
}

impl Curve<12> for Hermite {
    type Dofs<T: Real> = Shapes<T, 4>;

    /// The chord, plus a cubic term that vanishes at both ends.
    fn position<T: Real>(&self, q: &SVector<T, 12>, xi: T) -> Vector3<T> {
        let [x1, t1, x2, t2] = control_vectors(q);
        let (c, half) = (T::from(self.c), T::from(0.5));
        let (v, u) = ((T::one() - xi) * half, (T::one() + xi) * half);
        let chord = (x2 - x1) * half;
        // x = v x₁ + u x₂ + 2 u v [v (c t₁ - chord) - u (c t₂ - chord)]
        x1 * v + x2 * u + ((t1 * c - chord) * v - (t2 * c - chord) * u) * ((u + u) * v)
    }

    #[inline(always)]
    fn jet<T: Real>(&self, q: &SVector<T, 12>, xi: T) -> Jet<T, Shapes<T, 4>> {
        let c = T::from(self.c);
        let [one, two, three] = [1.0, 2.0, 3.0].map(T::from);
        let (quarter, square) = (T::from(0.25), xi * xi);
        let tangents = c * quarter;
        let shapes =
            |h1: T, ht1: T, h2: T, ht2: T| [h1 * quarter, ht1 * tangents, h2 * quarter, ht2 * tangents];
        let (up, down) = (one + xi, one - xi);
        let (slope, curvature, cubic) = (three * (square - one), T::from(6.0) * xi, T::from(6.0));
        let n = [
            shapes(down * down * (two + xi), up * down * down, up * up * (two - xi), -down * up * up),
            shapes(slope, -down * (one + three * xi), -slope, -up * (one - three * xi)),
            shapes(curvature, curvature - two, -curvature, curvature + two),
            shapes(cubic, cubic, -cubic, cubic),
        ];
        Shapes::jet(n, q)
    }

    /// Exact: x,xixixi = 3/2 (x_1 - x_2 + c t_1 + c t_2) is constant.
    fn third_derivative_bound(&self, q: &SVector<f64, 12>) -> f64 {
        let [x1, t1, x2, t2] = control_vectors(q);
        1.5 * (x1 - x2 + (t1 + t2) * self.c).norm()
    }

    fn is_cubic(&self) -> bool {
        true
    }
}
