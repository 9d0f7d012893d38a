//! Two beams that may touch: their curves, their sections, and vectors over the dofs of both.

use crate::number::Real;
use nalgebra::SVector;

/// A beam and a bar beam; the two may be of different families and sizes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair<A, B> {
    /// The curve of the beam.
    pub curve: A,
    /// The curve of the bar beam.
    pub curve_bar: B,
    /// Radii and reference parameters.
    pub contact: Contact,
}

/// What a pair of beams has besides its centroids.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(alias = "gap")]
pub struct Contact {
    /// r, the radius of the beam's cross-section; constant under variation.
    pub radius: f64,
    /// r_bar, the radius of the other beam.
    pub radius_bar: f64,
    /// xi_C0, where the contact began: the parameter that slips are measured from; constant under variation.
    pub xi_0: f64,
    /// xi_bar_C0, the same on the other beam.
    pub xi_bar_0: f64,
}

/// A vector over the dofs of both beams, beam before bar beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DofVector<T, const N: usize, const M: usize> {
    /// The part of the beam.
    pub beam: SVector<T, N>,
    /// The part of the bar beam.
    pub bar: SVector<T, M>,
}

impl<T: Real, const N: usize, const M: usize> DofVector<T, N, M> {
    /// The zero vector.
    #[inline]
    pub fn zeros() -> Self {
        Self { beam: SVector::zeros(), bar: SVector::zeros() }
    }

    /// The vector with nothing on the bar beam.
    #[inline]
    pub fn of_beam(beam: SVector<T, N>) -> Self {
        Self { beam, bar: SVector::zeros() }
    }

    /// The vector with nothing on the beam.
    #[inline]
    pub fn of_bar(bar: SVector<T, M>) -> Self {
        Self { beam: SVector::zeros(), bar }
    }

    /// self + factor * other.
    #[inline]
    #[must_use]
    pub fn plus(&self, factor: T, other: &Self) -> Self {
        Self { beam: self.beam + other.beam * factor, bar: self.bar + other.bar * factor }
    }

    /// factor * self.
    #[inline]
    #[must_use]
    pub fn times(&self, factor: T) -> Self {
        Self { beam: self.beam * factor, bar: self.bar * factor }
    }

    /// The scalar product with a direction.
    pub fn along(&self, dq: &Self) -> T {
        self.beam.dot(&dq.beam) + self.bar.dot(&dq.bar)
    }

    /// The entry of dof `i`, counted through both beams.
    pub fn entry(&self, i: usize) -> T {
        if i < N { self.beam[i] } else { self.bar[i - N] }
    }

    /// Sets the entry of dof `i`, counted through both beams.
    pub fn set(&mut self, i: usize, value: T) {
        if i < N {
            self.beam[i] = value;
        } else {
            self.bar[i - N] = value;
        }
    }

    /// The unit vector of dof `i`, counted through both beams.
    pub fn unit(i: usize) -> Self {
        let mut e = Self::zeros();
        e.set(i, T::one());
        e
    }
}
