//! How fast Newton's method converges.
//!
//! In a straight thin beam two effects alternate: bending by b strains the axis by b², and a strain s changes the bending of the next
//! iterate by b s. So ln b and ln s follow the matrix [[1, 1], [2, 0]] with the eigenvalues 2 and -1. The first is the order. The
//! second makes the norms alternately larger and smaller than C e², by a constant factor.

use super::Step;

/// Norms below this multiple of the last one are rounding.
const ROUNDING: f64 = 100.0;

/// The order of convergence, ln(e₄/e₂)/ln(e₃/e₁), of norms the last of which is rounding.
///
/// It is measured from the last four norms above rounding. A factor by which they alternate has no effect on it. There may
/// be no such norms.
pub fn order(norms: &[f64]) -> Option<f64> {
    let rounding = ROUNDING * norms.last()?;
    let of = norms.windows(4).rev().find(|e| e[2] < e[0] && e[3] < e[1] && e[3] > rounding)?;
    Some((of[3] / of[1]).ln() / (of[2] / of[0]).ln())
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

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn order_is_that_of_the_last_norms_above_rounding() {
        let found = |norms: &[f64]| order(norms).map(|order| (order * 100.0).round() / 100.0);
        assert_eq!(found(&[1e-1, 1e-2, 1e-4, 1e-8, 1e-16, 3e-29]), Some(2.0));
        // Alternately 10 times larger and smaller.
        assert_eq!(found(&[1e-1, 1e-1, 1e-5, 1e-7, 1e-17, 3e-29]), Some(2.0));
        assert_eq!(found(&[1e-1, 1e-2, 1e-3, 1e-4, 1e-9]), Some(1.0));
        assert_eq!(found(&[1e-1, 1e-2, 1e-4, 1e-8]), None);
        assert_eq!(found(&[1e-28, 2e-28, 1e-28, 1e-28, 2e-28]), None);
        assert_eq!(found(&[]), None);
    }
}
