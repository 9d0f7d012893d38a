//! The fit of a change to the answers, case by case. After each case, changes that fit worse than the best are dropped.

use super::answered_case::{AnsweredCase, Predicted};
use super::datum::Datum;
use super::hypothesis::Change;
use rayon::prelude::*;

/// The excess of a sum of squares over the smallest one that distinguishes its change: five standard deviations.
const TOLD_APART: f64 = 25.0;

/// The fit of a change to the answers at the cases where it was tried.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) change: Change,
    /// The place in the order of evaluation.
    pub(super) order: usize,
    /// The largest deviation over its scale.
    pub(super) worst: f64,
    /// The largest deviation over the difference that rounding explains.
    pub(super) over: f64,
    /// The sum of the squares of the deviations over the probable rounding errors.
    pub(super) sum: f64,
    /// The count of the numbers.
    pub(super) count: usize,
}

impl Fit {
    /// A fit that was not tried yet.
    pub(super) fn new(order: usize, change: Change) -> Self {
        Self { change, order, worst: 0.0, over: 0.0, sum: 0.0, count: 0 }
    }

    /// The fit of one change at some cases.
    pub(super) fn of(change: Change, cases: &[&AnsweredCase]) -> Self {
        let mut fit = Self::new(0, change);
        for case in cases {
            fit.add(case, &case.predicted(&fit.change), |_| true);
        }
        fit
    }

    /// Adds a case by the method that fits best. Only the requested numbers are used.
    pub(super) fn add(
        &mut self,
        case: &AnsweredCase,
        predicted: &[Predicted],
        is_asked: impl Fn(&Datum) -> bool,
    ) {
        let asked: Vec<&Datum> = case.data.iter().filter(|datum| is_asked(datum)).collect();
        let of = |predicted: &Predicted| {
            asked.iter().fold([0.0_f64; 3], |[worst, over, sum], datum| {
                let misfit = datum.misfit(AnsweredCase::number(predicted, datum));
                [worst.max(misfit.scaled), over.max(misfit.over), sum + misfit.square]
            })
        };
        let best = predicted.iter().map(of).min_by(|one, two| one[2].total_cmp(&two[2]));
        let [worst, over, sum] = best.unwrap_or([f64::INFINITY; 3]);
        (self.worst, self.over, self.sum) = (self.worst.max(worst), self.over.max(over), self.sum + sum);
        self.count += asked.len();
    }

    /// The mean of the squares.
    #[expect(clippy::cast_precision_loss, reason = "few numbers")]
    pub(super) fn mean(&self) -> f64 {
        self.sum / self.count.max(1) as f64
    }

    /// Whether rounding explains the deviation that remains of `before`, and it is not larger by more than rounding.
    pub(super) fn explains(&self, before: f64) -> bool {
        self.over <= 1.0 && self.worst <= 2.0 * before
    }
}

/// The largest sum of squares that is not distinguished from the smallest. Errors may be larger than expected.
pub(super) fn limit(best: &Fit) -> f64 {
    best.sum + TOLD_APART * best.mean().max(1.0)
}

/// The fits that are not distinguished from the best. The fits are sorted by the sums of squares.
pub(super) fn near(fits: &[Fit]) -> &[Fit] {
    let limit = fits.first().map_or(0.0, limit);
    &fits[..fits.iter().take_while(|fit| fit.sum <= limit).count()]
}

/// Tries changes at one case after the other. Those that are distinguished from the best are dropped, and those that leave more
/// than rounding, except for the `kept` nearest ones. The remaining ones were tried at all cases, and are sorted by the sums of
/// squares.
pub(super) fn race(mut fits: Vec<Fit>, cases: &[&AnsweredCase], kept: usize) -> Vec<Fit> {
    for case in cases {
        fits.par_iter_mut().for_each(|fit| {
            let predicted = case.predicted(&fit.change);
            fit.add(case, &predicted, |_| true);
        });
        fits.sort_by(|one, two| one.sum.total_cmp(&two.sum));
        let near = near(&fits).len();
        let mut place = 0;
        fits.retain(|fit| {
            place += 1;
            place <= kept || (place <= near && fit.over <= 1.0)
        });
    }
    fits
}
