//! Gradients and Hessians in all dofs of a pair, in the blocks of the two beams.

use super::dispatch::dispatch_simd;
use crate::number::Real;
use crate::pair::{DofVector, LengthError};
use nalgebra::{ArrayStorage, DMatrix, SMatrix, SVector};

/// A symmetric matrix over the dofs of both beams: the two square blocks in full, and the block between them.
///
/// The block below the diagonal is the transpose of `mixed`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct BlockHessian<T, const N: usize, const M: usize> {
    /// Beam against beam.
    pub beam: SMatrix<T, N, N>,
    /// Beam (rows) against bar beam (columns).
    pub mixed: SMatrix<T, N, M>,
    /// Bar beam against bar beam.
    pub bar: SMatrix<T, M, M>,
}

impl<T: Real, const N: usize, const M: usize> BlockHessian<T, N, M> {
    /// The zero matrix.
    #[inline]
    pub fn zeros() -> Self {
        Self { beam: SMatrix::zeros(), mixed: SMatrix::zeros(), bar: SMatrix::zeros() }
    }

    /// Sets it to the sum of factor * matrix over all `matrices` and of u v^T + v u^T over all `pairs` (u, v).
    #[inline]
    pub fn set_sum(&mut self, matrices: &[(T, &Self)], pairs: &[[&DofVector<T, N, M>; 2]]) {
        let Self { beam, mixed, bar } = self;
        dispatch_simd!({
            set_block(beam, (matrices, |m| &m.beam), pairs, (|v| &v.beam, |v| &v.beam));
            set_block(mixed, (matrices, |m| &m.mixed), pairs, (|v| &v.beam, |v| &v.bar));
            set_block(bar, (matrices, |m| &m.bar), pairs, (|v| &v.bar, |v| &v.bar));
        });
    }

    /// dq^T self Dq: the second variation in two directions.
    pub fn along(&self, dq: &DofVector<T, N, M>, linear_dq: &DofVector<T, N, M>) -> T {
        bilinear(&dq.beam, &self.beam, &linear_dq.beam)
            + bilinear(&dq.beam, &self.mixed, &linear_dq.bar)
            + bilinear(&linear_dq.beam, &self.mixed, &dq.bar)
            + bilinear(&dq.bar, &self.bar, &linear_dq.bar)
    }

    /// The whole matrix, beam before bar beam.
    pub fn to_dense(&self) -> DMatrix<T> {
        DMatrix::from_fn(N + M, N + M, |i, j| self.entry(i, j))
    }

    /// Writes the whole matrix row by row; as it is symmetric, that is column by column.
    ///
    /// # Errors
    /// [`LengthError`] if `to` does not have exactly (`N` + `M`)² numbers.
    pub fn write_dense(&self, to: &mut [T]) -> Result<(), LengthError> {
        let size = N + M;
        LengthError::check(to, size * size)?;
        for (i, row) in to.chunks_exact_mut(size).enumerate() {
            for (j, to) in row.iter_mut().enumerate() {
                *to = self.entry(i, j);
            }
        }
        Ok(())
    }

    /// Writes the upper triangle column by column, the packed storage of LAPACK's `uplo = 'U'`: the entry of rows i <= j at
    /// i + j (j + 1)/2.
    ///
    /// # Errors
    /// [`LengthError`] if `to` does not have exactly S (S + 1)/2 numbers with S = `N` + `M`.
    pub fn write_packed(&self, to: &mut [T]) -> Result<(), LengthError> {
        let size = N + M;
        LengthError::check(to, size * (size + 1) / 2)?;
        let entries = (0..size).flat_map(|j| (0..=j).map(move |i| (i, j)));
        for (to, (i, j)) in to.iter_mut().zip(entries) {
            *to = self.entry(i, j);
        }
        Ok(())
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

/// u^T block v.
#[inline]
fn bilinear<T: Real, const N: usize, const M: usize>(
    u: &SVector<T, N>,
    block: &SMatrix<T, N, M>,
    v: &SVector<T, M>,
) -> T {
    dispatch_simd!({
        let mut products = [T::zero(); N];
        for (column, &v) in block.data.0.iter().zip(&v.data.0[0]) {
            add_multiple(&mut products, column, v);
        }
        products.iter().zip(&u.data.0[0]).fold(T::zero(), |sum, (&product, &u)| sum + product * u)
    })
}

/// Sets a block in [`BlockHessian::set_sum`]. The functions return the block of a matrix, and the rows and columns of a
/// vector.
///
/// The loops run along the columns, in the order of memory, and term by term, so that the compiler takes several
/// entries at once.
#[inline(always)]
fn set_block<T: Real, H, D, const N: usize, const M: usize>(
    block: &mut SMatrix<T, N, M>,
    (matrices, block_of): (&[(T, &H)], impl Fn(&H) -> &SMatrix<T, N, M>),
    pairs: &[[&D; 2]],
    (rows, columns): (impl Fn(&D) -> &SVector<T, N>, impl Fn(&D) -> &SVector<T, M>),
) {
    for (j, column) in block.data.0.iter_mut().enumerate() {
        let mut sums = [T::zero(); N];
        for (factor, matrix) in matrices {
            add_multiple(&mut sums, &block_of(matrix).data.0[j], *factor);
        }
        for [u, v] in pairs {
            let (of_u, of_v) = (columns(u)[j], columns(v)[j]);
            for (sum, (&u, &v)) in sums.iter_mut().zip(rows(u).data.0[0].iter().zip(&rows(v).data.0[0])) {
                *sum += u * of_v + v * of_u;
            }
        }
        *column = sums;
    }
}

/// Adds a multiple of a column.
#[inline(always)]
fn add_multiple<T: Real, const N: usize>(to: &mut [T; N], column: &[T; N], factor: T) {
    for (sum, &entry) in to.iter_mut().zip(column) {
        *sum += entry * factor;
    }
}

/// A quantity to second order in the dofs: value, gradient and Hessian.
///
/// It starts on a cache line, so that no vector store crosses a cache line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Derivatives<T, const N: usize, const M: usize> {
    /// The Hessian.
    pub hessian: BlockHessian<T, N, M>,
    /// The gradient.
    pub gradient: DofVector<T, N, M>,
    /// The value.
    pub value: T,
}

impl<T: Real, const N: usize, const M: usize> Derivatives<T, N, M> {
    /// The number zero.
    #[inline]
    pub fn zero() -> Self {
        Self { value: T::zero(), gradient: DofVector::zeros(), hessian: BlockHessian::zeros() }
    }
}

/// All scalar quantities to second order in all dofs.
///
/// g_N is d less the constant r + r_bar, so their gradients and Hessians are the same: see [`Linearization::g_n`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Linearization<T, const N: usize, const M: usize> {
    /// d.
    pub d: Derivatives<T, N, M>,
    /// t.
    pub t: Derivatives<T, N, M>,
    /// t_bar.
    pub t_bar: Derivatives<T, N, M>,
    /// xi.
    pub xi: Derivatives<T, N, M>,
    /// xi_bar.
    pub xi_bar: Derivatives<T, N, M>,
    /// g_T.
    pub g_t: Derivatives<T, N, M>,
    /// g_T_bar.
    pub g_t_bar: Derivatives<T, N, M>,
    /// r + r_bar, the sum of the radii.
    pub radii: T,
}

impl<T: Real, const N: usize, const M: usize> Linearization<T, N, M> {
    /// g_N: d less the radii, with the gradient and the Hessian of d.
    #[must_use]
    #[doc(alias = "gap")]
    #[doc(alias = "Eq. (19)")]
    #[doc(alias = "normal gap")]
    #[doc(alias = "penetration")]
    pub fn g_n(&self) -> Derivatives<T, N, M> {
        // Eq. (11), (18), (19): g_N = d − (r + r̄)   δg_N = δd   Δδg_N = Δδd
        Derivatives { value: self.d.value - self.radii, ..self.d }
    }

    /// Zeros, to be overwritten by [`Matrices::write_all`](crate::linearization::closed_form::Matrices::write_all).
    #[inline]
    pub fn zeros() -> Self {
        let zero = Derivatives::zero;
        Self {
            d: zero(),
            t: zero(),
            t_bar: zero(),
            xi: zero(),
            xi_bar: zero(),
            g_t: zero(),
            g_t_bar: zero(),
            radii: T::zero(),
        }
    }
}

impl<const N: usize, const M: usize> Linearization<f64, N, M> {
    /// [`Linearization::zeros`] as a constant, so that zeros are written once, to where the result is returned.
    pub(super) const ZEROS: Self = {
        const fn matrix<const R: usize, const C: usize>() -> SMatrix<f64, R, C> {
            SMatrix::from_array_storage(ArrayStorage([[0.0; R]; C]))
        }
        let zero = Derivatives {
            hessian: BlockHessian { beam: matrix(), mixed: matrix(), bar: matrix() },
            gradient: DofVector { beam: matrix(), bar: matrix() },
            value: 0.0,
        };
        Self { d: zero, t: zero, t_bar: zero, xi: zero, xi_bar: zero, g_t: zero, g_t_bar: zero, radii: 0.0 }
    };
}

#[cfg(test)]
mod tests;
