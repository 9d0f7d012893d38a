//! Medians with intervals that do not assume a distribution.

use beamgap::report::number::number;

/// The summary of measured times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The median.
    pub median: f64,
    /// The 95 % interval of the median.
    pub interval: [f64; 2],
}

/// The summary of times; none if there are no times.
pub fn spread(samples: &[f64]) -> Option<Spread> {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    let upper = *sorted.get(middle)?;
    let median = if sorted.len().is_multiple_of(2) { 0.5 * (sorted[middle - 1] + upper) } else { upper };
    Some(Spread { median, interval: median_interval(&sorted, 0.95) })
}

/// The interval that contains the median with at least the probability `level`, from two of the `sorted` samples.
///
/// The number of samples below the true median is binomial with p = 1/2, for any distribution of the samples. With too few
/// samples for the level, the interval contains all samples.
///
/// # Panics
/// If there are no samples.
///
/// Source: W. Conover, *Practical Nonparametric Statistics*, 1999, section 3.2.
pub fn median_interval(sorted: &[f64], level: f64) -> [f64; 2] {
    let n = sorted.len();
    // P(at most k below) = Σ C(n, j) / 2ⁿ over j ≤ k. Each end may exclude half of 1 − level.
    let (mut rank, mut term, mut below) = (0, 0.5_f64.powi(i32::try_from(n).unwrap_or(i32::MAX)), 0.0);
    while rank < n / 2 {
        below += term;
        if below > 0.5 * (1.0 - level) {
            break;
        }
        rank += 1;
        term *= number(n - rank + 1) / number(rank);
    }
    let outer = rank.saturating_sub(1);
    [sorted[outer], sorted[n - 1 - outer]]
}
