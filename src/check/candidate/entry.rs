//! A number of an answer, compared with the reference.

use crate::check::verdict::Comparison;

/// A number of an answer, compared.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct Entry {
    pub(in crate::check) comparison: Comparison,
    /// Its item and its part.
    pub(in crate::check) place: [usize; 2],
    /// Whether it is a gradient or a Hessian, contracted with the directions.
    pub(in crate::check) is_contracted: bool,
    /// The difference from the best formulas.
    pub(in crate::check) loss: f64,
    /// The difference from the best formulas that their careful evaluation explains.
    pub(in crate::check) attainable: f64,
    /// The size of the terms of the best formulas.
    pub(in crate::check) best_scale: f64,
    /// The sum of the absolute values of the contracted terms.
    pub(in crate::check) size: f64,
    /// The root of the sum of their squares: independent errors of the entries add up in this way.
    pub(in crate::check) spread: f64,
    /// The largest change of the number if each number of the answer changes by one.
    pub(in crate::check) sensitivity: f64,
    /// The part of the tolerance that is the rounding of the contraction of the answer.
    pub(in crate::check) own_bound: f64,
    /// The bound of the reference.
    pub(in crate::check) reference_bound: f64,
}

impl Entry {
    /// The size of the number: that of its terms, or of the reference.
    pub(super) fn scale(&self) -> f64 {
        self.comparison.scale.max(self.comparison.other.abs())
    }

    /// Whether the number is wrong by more than its whole size, and by more than twice its tolerance, while the reference
    /// is known. No loss of digits explains it, even if the tolerance is large.
    pub(in crate::check) fn is_beyond(&self) -> bool {
        let (comparison, scale) = (&self.comparison, self.scale());
        let is_known = self.reference_bound <= LEAST * scale;
        is_known && comparison.difference() > 2.0 * comparison.tolerance + scale
    }

    /// Whether a tolerance is meaningful for this number. The rounding of the contraction is no part of it, because a
    /// wrong answer may be so large that its rounding exceeds the scale.
    pub(in crate::check) fn is_meaningful_with(&self, tolerance: f64, size: f64) -> bool {
        let Comparison { closed, other, .. } = self.comparison;
        // A bound that is not a number explains any difference; `f64::max` would drop it.
        let of_references =
            if tolerance.is_nan() { f64::INFINITY } else { (tolerance - self.own_bound).max(0.0) };
        let is_small = of_references <= LEAST * size.max(self.scale()) && of_references.is_finite();
        is_small || (other.is_finite() && !closed.is_finite()) || self.is_beyond()
    }

    /// The comparison, with a tolerance that decides if this number is wrong by more than its size.
    pub(in crate::check) fn decided(self) -> Comparison {
        let is_open = !self.comparison.is_meaningful();
        if is_open && self.is_meaningful_with(self.comparison.tolerance, 0.0) && !self.comparison.agrees() {
            return Comparison { tolerance: LEAST * self.scale(), ..self.comparison };
        }
        self.comparison
    }
}

/// The largest tolerance over the scale of a number that is meaningful.
const LEAST: f64 = 1e-3;

#[cfg(test)]
mod tests {
    use super::Entry;
    use crate::check::Order;
    use crate::check::element::ContactSituations;
    use crate::check::verdict::Comparison;
    use crate::linearization::Quantity;

    #[test]
    fn a_tolerance_that_is_not_a_number_is_not_meaningful() {
        let of = |closed: f64, tolerance: f64| Entry {
            comparison: Comparison {
                quantity: Quantity::GN,
                axis: None,
                order: Order::Second,
                part: "Delta-delta",
                against: "differences",
                closed,
                other: 1.0,
                tolerance,
                scale: 1.0,
                bound: 0.0,
                situations: ContactSituations::NONE,
            },
            place: [20, 3],
            is_contracted: true,
            loss: 0.0,
            attainable: 0.0,
            best_scale: 1.0,
            size: 1.0,
            spread: 1.0,
            sensitivity: 1.0,
            own_bound: 1e-16,
            reference_bound: tolerance,
        };
        assert!(of(1.5, 1e-12).is_meaningful_with(1e-12, 0.0));
        for tolerance in [f64::NAN, f64::INFINITY, 0.1] {
            assert!(!of(1.5, tolerance).is_meaningful_with(tolerance, 0.0), "{tolerance}");
            // An answer that is not a number is wrong, whatever the tolerance.
            assert!(of(f64::NAN, tolerance).is_meaningful_with(tolerance, 0.0), "{tolerance}");
        }
    }
}
