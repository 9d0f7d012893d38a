//! The error of a result.

use beamgap::number::DoubleDouble;

/// An exact number and its tolerance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    pub(crate) value: DoubleDouble,
    pub(crate) tolerance: f64,
}

/// A row contains numbers of one kind. Errors are relative to the largest number of the row.
pub(crate) type Rows = Vec<Vec<f64>>;

/// The error of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Error {
    /// The largest error, relative to the largest number of its kind (a value, a gradient or a Hessian).
    pub(crate) relative: f64,
    /// The largest error divided by its tolerance. It is at most one if the result is correct.
    pub(crate) share: f64,
}

impl Error {
    /// No error.
    pub(crate) const NONE: Self = Self { relative: 0.0, share: 0.0 };

    /// The larger of both errors; NaN is the largest.
    pub(crate) fn worse(self, other: Self) -> Self {
        let worse = |a: f64, b: f64| if a >= b { a } else { b };
        Self { relative: worse(self.relative, other.relative), share: worse(self.share, other.share) }
    }

    /// Compares a result with the exact numbers; `more` is added to the tolerances of a row.
    pub(crate) fn of(rows: &Rows, truth: &[Vec<Exact>], more: impl Fn(usize) -> f64) -> Self {
        assert_eq!(rows.len(), truth.len(), "the same quantities");
        let of_row = |(row, (numbers, exact)): (usize, (&Vec<f64>, &Vec<Exact>))| {
            assert_eq!(numbers.len(), exact.len(), "the same numbers");
            let largest = exact.iter().fold(0.0_f64, |largest, e| largest.max(e.value.value().abs()));
            let more = more(row);
            numbers.iter().zip(exact).fold(Self::NONE, |worst, (number, exact)| {
                let error = (DoubleDouble::from(*number) - exact.value).abs().value();
                let over = |by: f64| match error / by {
                    _ if error == 0.0 => 0.0,
                    part if part.is_nan() => f64::INFINITY,
                    part => part,
                };
                worst.worse(Self { relative: over(largest), share: over(exact.tolerance + more) })
            })
        };
        rows.iter().zip(truth).enumerate().map(of_row).fold(Self::NONE, Self::worse)
    }
}
