//! How fast Newton's method converges, from the norms of its increments.
//!
//! Norms of increments tell more than those of residuals: in thin beams bending by δ strains the axis by δ², and the residual is
//! large by this part in one iterate and not in the next.

use super::Step;

/// The order of convergence, ln(d₃/d₂)/ln(d₂/d₁), of a sequence of norms.
///
/// It is measured from the last three norms of which rounding allows it: convergence of order two would leave the third of
/// them above `rounding`. There may be no such norms.
pub fn order(norms: &[f64], rounding: f64) -> Option<f64> {
    let allows = |d: &&[f64]| d[1] < d[0] && d[1] * (d[1] / d[0]).powi(2) > rounding;
    let d = norms.windows(3).rev().find(allows)?;
    Some((d[2].max(rounding) / d[1]).ln() / (d[1] / d[0]).ln())
}

/// The increments of each pair of successive iterates in all steps, from the first below `from` to the last above `rounding`.
fn pairs(steps: &[Step], from: f64, rounding: f64) -> impl Iterator<Item = [f64; 2]> {
    let windows = steps.iter().flat_map(|step| step.increments.windows(2));
    windows.map(|d| [d[0], d[1]]).filter(move |d| d[0] < from && d[1] > rounding)
}

/// The largest d₂/d₁² of successive increments below `from` and above `rounding` in all steps, one over a length.
///
/// It stays of the size of a constant of the problem if convergence is quadratic in every step. If it is linear, it grows as the
/// increments become small.
pub fn quadratic_factor(steps: &[Step], from: f64, rounding: f64) -> f64 {
    pairs(steps, from, rounding).map(|d| d[1] / (d[0] * d[0])).fold(0.0, f64::max)
}

/// The order of convergence over all steps: the slope of ln d₂ over ln d₁ by least squares.
///
/// The order of a single step varies: the factor of d₁² is another one in each direction.
pub fn order_of_all(steps: &[Step], from: f64, rounding: f64) -> Option<f64> {
    let points: Vec<[f64; 2]> = pairs(steps, from, rounding).map(|d| d.map(f64::ln)).collect();
    let count = points.iter().map(|_| 1.0).sum::<f64>();
    let mean = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / count);
    let moment = |i: usize| points.iter().map(|p| (p[0] - mean[0]) * (p[i] - mean[i])).sum::<f64>();
    (points.len() > 2).then(|| moment(1) / moment(0))
}

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn order_is_that_of_the_last_norms_above_rounding() {
        let found = |norms: &[f64]| order(norms, 1e-13).map(|order| (order * 100.0).round() / 100.0);
        assert_eq!(found(&[1.0, 1e-2, 1e-4, 1e-8, 1e-16]), Some(2.0));
        assert_eq!(found(&[1e-1, 1e-2, 1e-3]), Some(1.0));
        assert_eq!(found(&[1e-1, 1e-8, 1e-16]), None);
        assert_eq!(found(&[1e-1, 2e-1, 1e-1]), None);
    }
}
