//! A matrix over the dofs of both beams that need not be symmetric.

use crate::number::Real;
use crate::pair::{DofVector, LengthError};
use nalgebra::{DMatrix, SMatrix};

/// A square matrix over the dofs of both beams, in four blocks: rows first, columns second.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct BlockMatrix<T, const N: usize, const M: usize> {
    /// Beam against beam.
    pub beam: SMatrix<T, N, N>,
    /// Bar beam (rows) against beam (columns).
    pub bar_beam: SMatrix<T, M, N>,
    /// Beam (rows) against bar beam (columns).
    pub beam_bar: SMatrix<T, N, M>,
    /// Bar beam against bar beam.
    pub bar: SMatrix<T, M, M>,
}

/// The residual along both directions, and the tangent between them in both orders.
#[cfg(feature = "check")]
pub(crate) fn contracted<T: Real, const N: usize, const M: usize>(
    residual: &DofVector<T, N, M>,
    tangent: &BlockMatrix<T, N, M>,
    [delta, linear]: &[DofVector<T, N, M>; 2],
) -> [T; 4] {
    [
        residual.along(delta),
        residual.along(linear),
        delta.along(&tangent.times(linear)),
        linear.along(&tangent.times(delta)),
    ]
}

impl<T: Real, const N: usize, const M: usize> BlockMatrix<T, N, M> {
    /// The zero matrix.
    #[inline]
    pub fn zeros() -> Self {
        Self {
            beam: SMatrix::zeros(),
            bar_beam: SMatrix::zeros(),
            beam_bar: SMatrix::zeros(),
            bar: SMatrix::zeros(),
        }
    }

    /// Sets all entries to zero.
    #[inline]
    pub fn set_zero(&mut self) {
        self.beam.fill(T::zero());
        self.bar_beam.fill(T::zero());
        self.beam_bar.fill(T::zero());
        self.bar.fill(T::zero());
    }

    /// The entry in row `i` and column `j`, both counted through both beams.
    pub fn entry(&self, i: usize, j: usize) -> T {
        match (i < N, j < N) {
            (true, true) => self.beam[(i, j)],
            (false, true) => self.bar_beam[(i - N, j)],
            (true, false) => self.beam_bar[(i, j - N)],
            (false, false) => self.bar[(i - N, j - N)],
        }
    }

    /// Sets the entry in row `i` and column `j`, both counted through both beams.
    pub fn set(&mut self, i: usize, j: usize, value: T) {
        match (i < N, j < N) {
            (true, true) => self.beam[(i, j)] = value,
            (false, true) => self.bar_beam[(i - N, j)] = value,
            (true, false) => self.beam_bar[(i, j - N)] = value,
            (false, false) => self.bar[(i - N, j - N)] = value,
        }
    }

    /// The product with a vector.
    #[must_use]
    pub fn times(&self, v: &DofVector<T, N, M>) -> DofVector<T, N, M> {
        DofVector {
            beam: self.beam * v.beam + self.beam_bar * v.bar,
            bar: self.bar_beam * v.beam + self.bar * v.bar,
        }
    }

    /// The transposed matrix.
    #[must_use]
    pub fn transposed(&self) -> Self {
        Self {
            beam: self.beam.transpose(),
            bar_beam: self.beam_bar.transpose(),
            beam_bar: self.bar_beam.transpose(),
            bar: self.bar.transpose(),
        }
    }

    /// The whole matrix, beam before bar beam.
    pub fn to_dense(&self) -> DMatrix<T> {
        DMatrix::from_fn(N + M, N + M, |i, j| self.entry(i, j))
    }

    /// Writes the whole matrix column by column, beam before bar beam.
    ///
    /// # Errors
    /// [`LengthError`] if `to` does not have exactly (`N` + `M`)² numbers.
    pub fn write_by_columns(&self, to: &mut [T]) -> Result<(), LengthError> {
        let size = N + M;
        LengthError::check(to, size * size)?;
        for (j, column) in to.chunks_exact_mut(size).enumerate() {
            let (beam, bar) = column.split_at_mut(N);
            let (of_beam, of_bar) = if j < N {
                (&self.beam.data.0[j], &self.bar_beam.data.0[j])
            } else {
                (&self.beam_bar.data.0[j - N], &self.bar.data.0[j - N])
            };
            beam.copy_from_slice(of_beam);
            bar.copy_from_slice(of_bar);
        }
        Ok(())
    }

    /// Writes the whole matrix row by row, beam before bar beam.
    ///
    /// # Errors
    /// [`LengthError`] if `to` does not have exactly (`N` + `M`)² numbers.
    pub fn write_by_rows(&self, to: &mut [T]) -> Result<(), LengthError> {
        let size = N + M;
        LengthError::check(to, size * size)?;
        for (i, row) in to.chunks_exact_mut(size).enumerate() {
            for (j, to) in row.iter_mut().enumerate() {
                *to = self.entry(i, j);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::BlockMatrix;
    use crate::pair::{DofVector, LengthError};

    #[test]
    #[expect(clippy::float_cmp, reason = "copied numbers")]
    fn all_layouts_have_the_same_entries() {
        let mut matrix = BlockMatrix::<f64, 3, 2>::zeros();
        let number = |i: usize, j: usize| f64::from(u8::try_from(10 * i + j).unwrap());
        for i in 0..5 {
            for j in 0..5 {
                matrix.set(i, j, number(i, j));
            }
        }
        let (mut rows, mut columns) = ([0.0; 25], [0.0; 25]);
        matrix.write_by_rows(&mut rows).unwrap();
        matrix.write_by_columns(&mut columns).unwrap();
        let (dense, transposed) = (matrix.to_dense(), matrix.transposed());
        for i in 0..5 {
            for j in 0..5 {
                let expected = number(i, j);
                let found = [rows[5 * i + j], columns[5 * j + i], dense[(i, j)], transposed.entry(j, i)];
                assert_eq!(found, [expected; 4]);
                let along = DofVector::unit(i).along(&matrix.times(&DofVector::unit(j)));
                assert_eq!(along, expected);
            }
        }
        assert_eq!(matrix.write_by_rows(&mut [0.0; 24]), Err(LengthError { expected: 25, found: 24 }));
        matrix.set_zero();
        assert_eq!(matrix, BlockMatrix::zeros());
    }
}
