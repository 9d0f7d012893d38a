//! A number of an answer, and its distance from a prediction.

use crate::check::verdict::Order;
use crate::linearization::Quantity;

/// A number of an answer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Datum {
    /// Item and part.
    pub(super) place: [usize; 2],
    pub(super) quantity: Quantity,
    pub(super) order: Order,
    /// The place in the order of evaluation.
    pub(super) rank: (Order, usize, usize),
    /// Whether it is a gradient or a Hessian, contracted with the directions.
    pub(super) is_contracted: bool,
    pub(super) answer: f64,
    pub(super) reference: f64,
    pub(super) scale: f64,
    pub(super) tolerance: f64,
    /// The size of the probable rounding error.
    pub(super) sigma: f64,
    pub(super) is_wrong: bool,
}

/// The distance of a prediction from an answer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Misfit {
    /// The distance over the scale.
    pub(super) scaled: f64,
    /// The distance over the largest difference that rounding explains.
    pub(super) over: f64,
    /// The distance over the probable rounding error, squared.
    pub(super) square: f64,
}

/// The square of a misfit that is not finite. It exceeds every other one, and its sums are finite.
const BEYOND: f64 = 1e30;

impl Datum {
    /// The distance of a prediction from the answer.
    pub(super) fn misfit(&self, predicted: f64) -> Misfit {
        let off = (self.answer - predicted).abs();
        if !off.is_finite() {
            // A number that is not finite is explained only by the same one.
            let both = self.answer.is_nan() && predicted.is_nan();
            let is_same = both || self.answer.to_bits() == predicted.to_bits();
            let [beyond, square] = if is_same { [0.0; 2] } else { [f64::INFINITY, BEYOND] };
            return Misfit { scaled: beyond, over: beyond, square };
        }
        let rounding = 8.0 * self.tolerance + 1e-12 * self.scale + 1e-9 * (predicted - self.reference).abs();
        let likely = ratio(off, self.sigma);
        Misfit {
            scaled: ratio(off, self.scale.max(predicted.abs())),
            over: ratio(off, rounding),
            square: (likely * likely).min(BEYOND),
        }
    }
}

/// A number that is infinite on both sides is no fit.
pub(super) fn ratio(one: f64, two: f64) -> f64 {
    let ratio = if one == 0.0 { 0.0 } else { one / two };
    if ratio.is_nan() { f64::INFINITY } else { ratio }
}
