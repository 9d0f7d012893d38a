//! Two beams that may touch: their curves, their sections, and vectors over the dofs of both.

use crate::curve::Curve;
use crate::number::Real;
use nalgebra::SVector;
use thiserror::Error;

/// A beam of `N` dofs and a bar beam of `M` dofs; the two may be of different families.
///
/// | function | result |
/// |---|---|
/// | [`Pair::closest_points`], [`Pair::refine`] | where the two are closest |
/// | [`Pair::linearize`], [`Pair::linearize_into`] | there, all scalar quantities with gradients and Hessians |
/// | [`Pair::write`] | the wanted ones of these, or gradients alone, in the caller's layout |
/// | [`write_d_batch`](crate::linearization::closed_form::kernel::write_d_batch) | d of many pairs, four at a time |
/// | [`closed_form::vary`](crate::linearization::closed_form::vary) | the variations of all quantities along two directions |
/// | [`ad`](crate::linearization::ad) | all of these by automatic differentiation |
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair<A, B, const N: usize, const M: usize> {
    /// The curve of the beam.
    pub curve: A,
    /// The curve of the bar beam.
    pub curve_bar: B,
    /// Radii and reference parameters.
    pub contact: Contact,
}

impl<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize> Pair<A, B, N, M> {
    /// Two curves with zero radii. Slips are measured from the middle of each curve.
    pub fn new(curve: A, curve_bar: B) -> Self {
        Self { curve, curve_bar, contact: Contact::default() }
    }

    /// The same pair with radii and reference parameters.
    #[must_use]
    pub fn with_contact(self, contact: Contact) -> Self {
        Self { contact, ..self }
    }

    /// The dofs of both beams, from the numbers of each.
    ///
    /// # Errors
    /// [`LengthError`] if there are not `N` and `M` numbers.
    pub fn dofs(&self, beam: &[f64], bar: &[f64]) -> Result<DofVector<f64, N, M>, LengthError> {
        DofVector::from_slices(beam, bar)
    }
}

/// Memory or input of the wrong length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{found} numbers where {expected} were expected")]
pub struct LengthError {
    /// The required length.
    pub expected: usize,
    /// The actual length.
    pub found: usize,
}

impl LengthError {
    /// Checks the length of a slice.
    ///
    /// # Errors
    /// If the length is another one.
    pub(crate) fn check<T>(slice: &[T], expected: usize) -> Result<(), Self> {
        let found = slice.len();
        if found == expected { Ok(()) } else { Err(Self { expected, found }) }
    }
}

/// The properties of a pair of beams other than its centroids.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(alias = "gap")]
pub struct Contact {
    /// r, the radius of the beam's cross-section; constant under variation.
    pub radius: f64,
    /// r_bar, the radius of the other beam.
    pub radius_bar: f64,
    /// xi_C0, the parameter where the contact began. Slips are measured from it; constant under variation.
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

impl<T: Real, const N: usize, const M: usize> From<([T; N], [T; M])> for DofVector<T, N, M> {
    fn from((beam, bar): ([T; N], [T; M])) -> Self {
        Self { beam: beam.into(), bar: bar.into() }
    }
}

impl<T: Real, const N: usize, const M: usize> DofVector<T, N, M> {
    /// The zero vector.
    #[inline]
    pub fn zeros() -> Self {
        Self { beam: SVector::zeros(), bar: SVector::zeros() }
    }

    /// The vector that is zero on the bar beam.
    #[inline]
    pub fn of_beam(beam: SVector<T, N>) -> Self {
        Self { beam, bar: SVector::zeros() }
    }

    /// The vector that is zero on the beam.
    #[inline]
    pub fn of_bar(bar: SVector<T, M>) -> Self {
        Self { beam: SVector::zeros(), bar }
    }

    /// The vector from the numbers of each beam.
    ///
    /// # Errors
    /// [`LengthError`] if there are not `N` and `M` numbers.
    pub fn from_slices(beam: &[T], bar: &[T]) -> Result<Self, LengthError> {
        LengthError::check(beam, N)?;
        LengthError::check(bar, M)?;
        Ok(Self { beam: SVector::from_column_slice(beam), bar: SVector::from_column_slice(bar) })
    }

    /// The vector from all numbers, beam before bar beam.
    ///
    /// # Errors
    /// [`LengthError`] if there are not `N` + `M` numbers.
    pub fn from_slice(all: &[T]) -> Result<Self, LengthError> {
        LengthError::check(all, N + M)?;
        let (beam, bar) = all.split_at(N);
        Self::from_slices(beam, bar)
    }

    /// Writes all numbers, beam before bar beam.
    ///
    /// # Errors
    /// [`LengthError`] if `to` does not have exactly `N` + `M` numbers.
    pub fn write_to(&self, to: &mut [T]) -> Result<(), LengthError> {
        LengthError::check(to, N + M)?;
        let (beam, bar) = to.split_at_mut(N);
        beam.copy_from_slice(self.beam.as_slice());
        bar.copy_from_slice(self.bar.as_slice());
        Ok(())
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

#[cfg(test)]
mod tests;
