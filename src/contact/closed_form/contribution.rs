//! Residual and tangent of a contact, with the geometry that they are made of.

use crate::contact::BlockMatrix;
use crate::linearization::Derivatives;
use crate::number::Real;
use crate::pair::DofVector;

/// Residual and tangent of a contact, and memory for the geometry.
#[derive(Clone, Copy, Debug)]
pub struct Contribution<T, const N: usize, const M: usize> {
    /// K, the derivative of R.
    pub tangent: BlockMatrix<T, N, M>,
    /// R, the contribution to the internal forces.
    pub residual: DofVector<T, N, M>,
    pub(in crate::contact) kinematics: Kinematics<T, N, M>,
}

impl<T: Real, const N: usize, const M: usize> Contribution<T, N, M> {
    /// Zeros, to be overwritten.
    pub fn zeros() -> Self {
        let zero = Derivatives::zero;
        let kinematics = Kinematics { d: zero(), t: zero(), t_bar: zero(), xi: zero(), xi_bar: zero() };
        Self { tangent: BlockMatrix::zeros(), residual: DofVector::zeros(), kinematics }
    }

    /// Sets residual and tangent to zero.
    pub(in crate::contact) fn set_zero(&mut self) {
        self.residual = DofVector::zeros();
        self.tangent.set_zero();
    }
}

impl<const N: usize, const M: usize> Contribution<f64, N, M> {
    /// The first entry of R, or of the diagonal of K, that is infinite or not a number, with the name of its array.
    /// To look at all of K would cost a tenth of its computation.
    pub(in crate::contact) fn not_finite(&self) -> Option<(&'static str, f64)> {
        let Self { tangent: k, residual: r, .. } = self;
        // One running sum: an instruction an entry. It may overflow by itself.
        let of_r = r.beam.data.0[0].iter().chain(&r.bar.data.0[0]).fold(0.0, |sum, entry| sum + entry);
        let sum = (0..N).fold(of_r, |sum, i| sum + k.beam.data.0[i][i]);
        let sum = (0..M).fold(sum, |sum, i| sum + k.bar.data.0[i][i]);
        if sum.is_finite() {
            return None;
        }
        let residual = r.beam.iter().chain(r.bar.iter()).map(|&entry| ("R", entry));
        let diagonal = (0..N).map(|i| k.beam[(i, i)]).chain((0..M).map(|i| k.bar[(i, i)]));
        residual.chain(diagonal.map(|entry| ("K", entry))).find(|(_, entry)| !entry.is_finite())
    }
}

/// The quantities that the element uses, with their derivatives.
#[derive(Clone, Copy, Debug)]
pub(in crate::contact) struct Kinematics<T, const N: usize, const M: usize> {
    pub(in crate::contact) d: Derivatives<T, N, M>,
    pub(in crate::contact) t: Derivatives<T, N, M>,
    pub(in crate::contact) t_bar: Derivatives<T, N, M>,
    pub(in crate::contact) xi: Derivatives<T, N, M>,
    pub(in crate::contact) xi_bar: Derivatives<T, N, M>,
}
