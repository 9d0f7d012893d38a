//! Gradients and Hessians in all dofs of a pair, in the blocks of the two beams.

use crate::number::Real;
use crate::pair::{Contact, DofVector};
use nalgebra::SMatrix;

/// A symmetric matrix over the dofs of both beams: the two square blocks in full, and the block between them.
///
/// The block below the diagonal is the transpose of `mixed`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DofMatrix<T, const N: usize, const M: usize> {
    /// Beam against beam.
    pub beam: SMatrix<T, N, N>,
    /// Beam (rows) against bar beam (columns).
    pub mixed: SMatrix<T, N, M>,
    /// Bar beam against bar beam.
    pub bar: SMatrix<T, M, M>,
}

impl<T: Real, const N: usize, const M: usize> DofMatrix<T, N, M> {
    /// The zero matrix.
    pub fn zeros() -> Self {
        Self { beam: SMatrix::zeros(), mixed: SMatrix::zeros(), bar: SMatrix::zeros() }
    }

    /// Adds factor * other.
    #[inline]
    pub fn add(&mut self, factor: T, other: &Self) {
        self.beam += other.beam * factor;
        self.mixed += other.mixed * factor;
        self.bar += other.bar * factor;
    }

    /// Adds u v^T + v u^T.
    #[inline]
    pub fn add_symmetric(&mut self, u: &DofVector<T, N, M>, v: &DofVector<T, N, M>) {
        for j in 0..N {
            for i in 0..N {
                self.beam[(i, j)] += u.beam[i] * v.beam[j] + v.beam[i] * u.beam[j];
            }
        }
        for j in 0..M {
            for i in 0..N {
                self.mixed[(i, j)] += u.beam[i] * v.bar[j] + v.beam[i] * u.bar[j];
            }
            for i in 0..M {
                self.bar[(i, j)] += u.bar[i] * v.bar[j] + v.bar[i] * u.bar[j];
            }
        }
    }

    /// Multiplies every entry.
    #[inline]
    pub fn scale(&mut self, factor: T) {
        self.beam *= factor;
        self.mixed *= factor;
        self.bar *= factor;
    }

    /// dq^T self Dq: the second variation in two directions.
    pub fn along(&self, dq: &DofVector<T, N, M>, linear_dq: &DofVector<T, N, M>) -> T {
        dq.beam.dot(&(self.beam * linear_dq.beam + self.mixed * linear_dq.bar))
            + linear_dq.beam.dot(&(self.mixed * dq.bar))
            + dq.bar.dot(&(self.bar * linear_dq.bar))
    }

    /// Sets the entry of two dofs and its mirror image, counted through both beams.
    pub fn set(&mut self, i: usize, j: usize, value: T) {
        match (i < N, j < N) {
            (true, true) => {
                self.beam[(i, j)] = value;
                self.beam[(j, i)] = value;
            }
            (true, false) => self.mixed[(i, j - N)] = value,
            (false, true) => self.mixed[(j, i - N)] = value,
            (false, false) => {
                self.bar[(i - N, j - N)] = value;
                self.bar[(j - N, i - N)] = value;
            }
        }
    }

    /// The entry of two dofs, counted through both beams.
    pub fn entry(&self, i: usize, j: usize) -> T {
        match (i < N, j < N) {
            (true, true) => self.beam[(i, j)],
            (true, false) => self.mixed[(i, j - N)],
            (false, true) => self.mixed[(j, i - N)],
            (false, false) => self.bar[(i - N, j - N)],
        }
    }
}

/// A quantity to second order in the dofs: value, gradient and Hessian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expansion<T, const N: usize, const M: usize> {
    /// The value.
    pub value: T,
    /// The gradient.
    pub gradient: DofVector<T, N, M>,
    /// The Hessian.
    pub hessian: DofMatrix<T, N, M>,
}

/// All scalar quantities to second order in all dofs.
///
/// g_N is d less the constant r + r_bar, so their gradients and Hessians are the same: see [`Linearization::g_n`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization<T, const N: usize, const M: usize> {
    /// d.
    pub d: Expansion<T, N, M>,
    /// t.
    pub t: Expansion<T, N, M>,
    /// t_bar.
    pub t_bar: Expansion<T, N, M>,
    /// xi.
    pub xi: Expansion<T, N, M>,
    /// xi_bar.
    pub xi_bar: Expansion<T, N, M>,
    /// g_T.
    pub g_t: Expansion<T, N, M>,
    /// g_T_bar.
    pub g_t_bar: Expansion<T, N, M>,
}

impl<T: Real, const N: usize, const M: usize> Linearization<T, N, M> {
    /// g_N: d less the radii, with the gradient and the Hessian of d.
    #[must_use]
    #[doc(alias = "gap")]
    #[doc(alias = "Eq. (19)")]
    pub fn g_n(&self, contact: &Contact) -> Expansion<T, N, M> {
        // Eq. (11), (18), (19): g_N = d − (r + r̄)   δg_N = δd   Δδg_N = Δδd
        let radii = T::from(contact.radius) + T::from(contact.radius_bar);
        Expansion { value: self.d.value - radii, ..self.d }
    }
}
