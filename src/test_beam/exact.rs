//! A beam of any family with dofs in an exact scalar: random residues, or degrees.

use super::padded::{DOFS, Padded, PaddedBeam};
use crate::curve::{Curve, Geometry};
use crate::linearization::ad::{Perturbed, PositionAt};
use crate::linearization::closed_form::PartialVariations;
use crate::number::{Dual, Extends, HyperDual, Real};
use nalgebra::{SVector, Vector3};

/// The methods that the proof needs of a beam. All compared numbers come from here.
pub(crate) trait ExactBeam<T: Real>:
    PositionAt<Dual<HyperDual<T>>> + PositionAt<Dual<Dual<T>>> + Send + Sync
{
    /// The number of dofs.
    fn dofs(&self) -> usize;

    /// Point and tangents.
    fn geometry(&self, xi: T) -> Geometry<T>;

    /// Moves the whole beam.
    fn translate(&mut self, by: &Vector3<T>);

    /// The variations at a fixed parameter.
    fn partial_variations(&self, xi: T) -> PartialVariations<T>;

    /// The jet and the two directions, padded to a common number of dofs.
    fn padded(&self, xi: T) -> PaddedBeam<T>;
}

/// A curve with its dofs and the two directions of variation.
#[derive(Clone, Debug)]
pub(crate) struct Exact<C, T, const N: usize> {
    pub(crate) curve: C,
    pub(crate) q: SVector<T, N>,
    pub(crate) dq: SVector<T, N>,
    pub(crate) linear_dq: SVector<T, N>,
    /// The indices in `q` where the points start.
    pub(crate) points: Vec<usize>,
}

impl<C: Curve<N>, T: Real, const N: usize> PositionAt<Dual<HyperDual<T>>> for Exact<C, T, N> {
    fn position_at(&self, xi: Dual<HyperDual<T>>) -> Vector3<Dual<HyperDual<T>>> {
        let seed = |i: usize| HyperDual::new(self.q[i], self.dq[i], self.linear_dq[i], T::zero());
        let q = SVector::<HyperDual<T>, N>::from_fn(|i, _| seed(i));
        Perturbed { curve: &self.curve, q }.position_at(xi)
    }
}

impl<C: Curve<N>, T: Real, const N: usize> PositionAt<Dual<Dual<T>>> for Exact<C, T, N> {
    fn position_at(&self, xi: Dual<Dual<T>>) -> Vector3<Dual<Dual<T>>> {
        let q = self.q.map(|q| <Dual<Dual<T>> as Extends<T>>::constant(q));
        self.curve.position(&q, xi)
    }
}

impl<C: Curve<N> + Send + Sync, T: Real + Send + Sync, const N: usize> ExactBeam<T> for Exact<C, T, N> {
    fn geometry(&self, xi: T) -> Geometry<T> {
        self.curve.jet(&self.q, xi).geometry
    }

    fn translate(&mut self, by: &Vector3<T>) {
        for &start in &self.points {
            for c in 0..3 {
                self.q[start + c] += by[c];
            }
        }
    }

    fn partial_variations(&self, xi: T) -> PartialVariations<T> {
        PartialVariations::new(&self.curve.jet(&self.q, xi), &self.dq, &self.linear_dq)
    }

    fn dofs(&self) -> usize {
        N
    }

    fn padded(&self, xi: T) -> PaddedBeam<T> {
        let vectors = [&self.q, &self.dq, &self.linear_dq].map(Padded::<T, DOFS>::fill_vector);
        (Padded::fill(&self.curve.jet(&self.q, xi)), vectors)
    }
}
