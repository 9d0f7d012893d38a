//! Symmetric matrices of which one triangle is answered.

use crate::check::external::answers::Answers;

/// The part of Hessians and tangents that is answered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Triangle {
    /// All entries.
    #[default]
    Both,
    /// Those on and above the diagonal.
    Upper,
    /// Those on and below the diagonal.
    Lower,
}

impl Triangle {
    /// Whether the entry in this row and column is answered.
    pub(in crate::check::external) fn has(self, row: usize, column: usize) -> bool {
        match self {
            Self::Both => true,
            Self::Upper => row <= column,
            Self::Lower => row >= column,
        }
    }

    /// The triangle of the transposed matrix.
    #[must_use]
    fn transposed(self) -> Self {
        match self {
            Self::Both => Self::Both,
            Self::Upper => Self::Lower,
            Self::Lower => Self::Upper,
        }
    }

    /// Completes the Hessians and the tangent of answers. What stands in the other triangle is not read.
    pub(in crate::check::external) fn complete(self, column_major: bool, answers: &mut Answers) {
        if self == Self::Both {
            return;
        }
        // Column by column one triangle is stored as the other one is row by row.
        let stored = if column_major { self.transposed() } else { self };
        let hessians = answers.answers.iter_mut().filter_map(|answer| answer.hessian.as_mut());
        for matrix in hessians.chain(answers.tangent.as_mut()) {
            *matrix = stored.whole(matrix);
        }
    }

    /// The whole matrix of one that is stored in full, or packed row by row. The comparison tells wrong lengths.
    fn whole(self, numbers: &[f64]) -> Vec<f64> {
        let size = numbers.len().isqrt();
        if size * size == numbers.len() {
            let at = |i: usize, j: usize| numbers[if self.has(i, j) { i * size + j } else { j * size + i }];
            return (0..size * size).map(|k| at(k / size, k % size)).collect();
        }
        let size = (2 * numbers.len()).isqrt();
        if size * (size + 1) != 2 * numbers.len() {
            return numbers.to_vec();
        }
        let at = |i: usize, j: usize| {
            let (i, j) = if self.has(i, j) { (i, j) } else { (j, i) };
            // Row i begins after the rows before it: of sizes 1 to i, or from `size` down.
            numbers
                [if self == Self::Lower { i * (i + 1) / 2 + j } else { i * (2 * size - i + 1) / 2 + j - i }]
        };
        (0..size * size).map(|k| at(k / size, k % size)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Triangle;

    #[test]
    fn triangles_are_completed() {
        let whole = [1.0, 2.0, 3.0, 2.0, 4.0, 5.0, 3.0, 5.0, 6.0];
        let upper = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let lower = [1.0, 2.0, 4.0, 3.0, 5.0, 6.0];
        assert_eq!(Triangle::Upper.whole(&upper), whole);
        assert_eq!(Triangle::Lower.whole(&lower), whole);
        let zeros_below = [1.0, 2.0, 3.0, 0.0, 4.0, 5.0, 0.0, 0.0, 6.0];
        assert_eq!(Triangle::Upper.whole(&zeros_below), whole);
        assert_ne!(Triangle::Lower.whole(&zeros_below), whole);
        assert_eq!(Triangle::Upper.whole(&upper[..5]), upper[..5]);
    }
}
