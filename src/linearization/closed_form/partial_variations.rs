//! A curve at a fixed parameter, varied in two directions: the data of one beam that the variations need.

use crate::curve::{DofDerivatives, Geometry, Jet};
use crate::number::Real;
use nalgebra::{SVector, Vector3};

/// Geometry of a curve at its contact point, with the variations that keep the parameter fixed.
///
/// A beam of any family and any number of dofs enters the variations only through these fifteen vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartialVariations<T> {
    /// x, t, t,xi and t,xixi.
    pub geometry: Geometry<T>,
    /// delta_u u, delta_u u,xi and delta_u u,xixi.
    pub delta_u: [Vector3<T>; 3],
    /// Delta_u u, Delta_u u,xi and Delta_u u,xixi.
    pub linear_u: [Vector3<T>; 3],
    /// Delta_u delta_u u and Delta_u delta_u u,xi: zero for curves that are linear in their dofs.
    pub second_u: [Vector3<T>; 2],
}

impl<T: Real> PartialVariations<T> {
    /// Varies a curve along `dq` (delta) and `linear_dq` (Delta).
    pub fn new<U: DofDerivatives<T, N>, const N: usize>(
        jet: &Jet<T, U>,
        dq: &SVector<T, N>,
        linear_dq: &SVector<T, N>,
    ) -> Self {
        Self {
            geometry: jet.geometry,
            delta_u: std::array::from_fn(|k| jet.dofs.variation(k, dq)),
            linear_u: std::array::from_fn(|k| jet.dofs.variation(k, linear_dq)),
            second_u: if U::LINEAR {
                [Vector3::zeros(); 2]
            } else {
                std::array::from_fn(|k| jet.dofs.second_variation(k, dq, linear_dq))
            },
        }
    }

    /// The same with delta and Delta exchanged.
    #[must_use]
    pub fn exchanged(self) -> Self {
        Self { delta_u: self.linear_u, linear_u: self.delta_u, ..self }
    }

    /// The same in another scalar, vector by vector.
    #[must_use]
    pub fn map<S: Real>(self, f: impl Fn(Vector3<T>) -> Vector3<S> + Copy) -> PartialVariations<S> {
        let Geometry { x, t, t_xi, t_xixi } = self.geometry;
        let [x, t, t_xi, t_xixi] = [x, t, t_xi, t_xixi].map(f);
        PartialVariations {
            geometry: Geometry { x, t, t_xi, t_xixi },
            delta_u: self.delta_u.map(f),
            linear_u: self.linear_u.map(f),
            second_u: self.second_u.map(f),
        }
    }
}
