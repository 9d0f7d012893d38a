//! The results of a comparison: single entries, and the verdict on a closest point.

use super::element::ContactSituations;
use super::serialized::{Name, by_name, name, number};
use crate::linearization::Quantity;
use crate::source_fault::source_fault;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

enumeration! {
    /// The part of a quantity that is compared.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Order {
        /// The value.
        Value => "value",
        /// The first variations, delta and Delta.
        First => "first",
        /// The second variation, Delta-delta.
        Second => "second",
        /// Delta-delta against itself with the directions exchanged.
        Symmetry => "symmetry",
        /// Gradient and Hessian, contracted with the directions, against the variations.
        Matrix => "matrix",
        /// What the library's public functions return, contracted with the directions, against the variations.
        Function => "function",
    }
}

by_name!(Order);

/// One entry, with the numbers of both sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// The quantity.
    pub quantity: Quantity,
    /// The component, if the quantity is a vector.
    #[serde(rename = "component")]
    pub axis: Option<char>,
    /// The part of the quantity.
    pub order: Order,
    /// Its name in [`Varied::PARTS`](crate::linearization::Varied::PARTS), which differs for the two first variations.
    #[serde(deserialize_with = "name")]
    pub part: Name,
    /// The reference.
    #[serde(deserialize_with = "name")]
    pub against: Name,
    /// The closed form's number.
    #[serde(with = "number")]
    pub closed: f64,
    /// The other number.
    #[serde(with = "number")]
    pub other: f64,
    /// The sum of the absolute values of the closed form's terms.
    #[serde(with = "number")]
    pub scale: f64,
    /// The largest rounding error of the closed form's number.
    #[serde(with = "number")]
    pub bound: f64,
    /// The largest difference that the rounding of both explains.
    #[serde(with = "number")]
    pub tolerance: f64,
    /// What the contact element is an example of, if the number is one of an element.
    #[serde(skip)]
    pub(super) situations: ContactSituations,
}

impl Comparison {
    /// The absolute difference. It is infinite if one of the two is not a number.
    pub fn difference(&self) -> f64 {
        let error = (self.closed - self.other).abs();
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// The difference relative to the scale.
    pub fn scaled_error(&self) -> f64 {
        relative(self.difference(), self.scale)
    }

    /// The difference relative to the tolerance; above 1 the two disagree.
    pub fn over_tolerance(&self) -> f64 {
        relative(self.difference(), self.tolerance)
    }

    /// Whether the two agree. A value that is not a number agrees with none.
    pub fn agrees(&self) -> bool {
        let difference = self.difference();
        let tolerance = source_fault!("wide-tolerance": 1e6 * self.tolerance, self.tolerance);
        difference == 0.0 || (difference.is_finite() && difference <= tolerance)
    }

    /// Whether the two differ beyond rounding.
    pub fn is_wrong(&self) -> bool {
        self.is_meaningful() && !self.agrees()
    }

    /// Whether the tolerance is meaningful: below a thousandth of the scale, or of the other number. The scale alone
    /// does not suffice, because it belongs to the closed form and may be wrong.
    ///
    /// A closed form that is infinite or not a number while the other one is finite is wrong, for any tolerance.
    pub fn is_meaningful(&self) -> bool {
        let size = self.scale.max(self.other.abs());
        let is_small = self.tolerance <= 1e-3 * size && self.tolerance.is_finite();
        is_small || self.tolerance == 0.0 || (self.other.is_finite() && !self.closed.is_finite())
    }
}

fn relative(error: f64, to: f64) -> f64 {
    let ratio = error / to;
    match (error == 0.0, ratio.is_nan()) {
        (true, _) => 0.0,
        (false, true) => f64::INFINITY,
        (false, false) => ratio,
    }
}

/// The reason why a closest point, or a whole case, was not compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Inconclusive {
    /// The search ended in an error.
    SearchFailed,
    /// The search left regions open: the centroids are too nearly parallel to be resolved.
    Unresolved,
    /// D = 0 to rounding.
    Singular,
    /// d = 0 to rounding.
    Crossing,
    /// A tangent has no length.
    ZeroTangent,
    /// A parameter is about to leave its end: a kink.
    WeakEnd,
    /// The projection is regular, but not over the region that contains the closest point.
    IllConditioned,
    /// Rounding explains differences of more than a thousandth of some scale.
    NotMeaningful,
    /// A number, or a product in its computation, is beyond the range of `f64`. Bounds on rounding are not meaningful.
    OutOfRange,
}

impl Inconclusive {
    /// The reason in words.
    pub fn reason(self) -> &'static str {
        match self {
            Self::SearchFailed => "the search for closest points failed",
            Self::Unresolved => "nearly parallel: the search left regions open",
            Self::Singular => "singular: D = 0 to rounding",
            Self::Crossing => "crossing centroids: d = 0 to rounding",
            Self::ZeroTangent => "a tangent has no length",
            Self::WeakEnd => "kink: a parameter just leaves an end",
            Self::IllConditioned => "the closest point is not known well enough",
            Self::NotMeaningful => "the rounding bound exceeds 1e-3 of a scale",
            Self::OutOfRange => "overflow or underflow: beyond the range of f64",
        }
    }
}

/// The verdict on a closest point.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// All entries agree.
    Pass(Vec<Comparison>),
    /// Some entries do not agree.
    Mismatch(Vec<Comparison>),
    /// They could not be compared, or not meaningfully. In the second case the entries show where.
    Inconclusive(Inconclusive, Vec<Comparison>),
}

impl Verdict {
    /// The compared entries.
    pub fn entries(&self) -> &[Comparison] {
        match self {
            Self::Pass(entries) | Self::Mismatch(entries) | Self::Inconclusive(_, entries) => entries,
        }
    }
}

/// Whether each number was compared with at least one oracle to a meaningful tolerance.
pub(super) fn is_decided<'a>(mut entries: impl Iterator<Item = &'a Comparison> + Clone) -> bool {
    if entries.clone().all(Comparison::is_meaningful) {
        return true;
    }
    let name = |entry: &Comparison| (entry.quantity, entry.axis, entry.order, entry.part);
    let of_meaning = entries.clone().filter(|entry| entry.is_meaningful());
    let decided: BTreeSet<_> = of_meaning.map(name).collect();
    entries.all(|entry| entry.is_meaningful() || decided.contains(&name(entry)))
}

#[cfg(test)]
mod tests {
    use super::{Comparison, Inconclusive, Order, Verdict, is_decided};
    use crate::check::element::ContactSituations;
    use crate::linearization::Quantity;
    use std::collections::BTreeSet;

    const NUMBERS: Comparison = Comparison {
        quantity: Quantity::D,
        axis: None,
        order: Order::Value,
        part: "value",
        against: "AD",
        closed: 2.0,
        other: 2.5,
        scale: 4.0,
        bound: 0.125,
        tolerance: 0.25,
        situations: ContactSituations::NONE,
    };

    #[test]
    fn an_error_is_told_in_three_measures() {
        let told = |entry: Comparison| (entry.difference(), entry.scaled_error(), entry.over_tolerance());
        assert_eq!(told(NUMBERS), (0.5, 0.125, 2.0));
        let infinite = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        assert_eq!(told(Comparison { closed: f64::NAN, ..NUMBERS }), infinite);
        assert_eq!(told(Comparison { closed: f64::NAN, tolerance: f64::INFINITY, ..NUMBERS }), infinite);
        assert_eq!(told(Comparison { scale: 0.0, tolerance: 0.0, other: 2.0, ..NUMBERS }), (0.0, 0.0, 0.0));
    }

    #[test]
    fn a_difference_up_to_the_tolerance_agrees() {
        assert!(!NUMBERS.agrees());
        assert!(Comparison { tolerance: 0.5, ..NUMBERS }.agrees());
        assert!(!Comparison { closed: f64::NAN, tolerance: f64::INFINITY, ..NUMBERS }.agrees());
        assert!(Comparison { other: 2.0, tolerance: 0.0, ..NUMBERS }.agrees());
    }

    #[test]
    fn a_tolerance_above_a_thousandth_means_nothing() {
        let with = |tolerance, scale, other| Comparison { other, scale, tolerance, ..NUMBERS };
        assert!(with(4e-3, 4.0, 2.5).is_meaningful() && !with(4.1e-3, 4.0, 2.5).is_meaningful());
        // The scale of the closed form may itself be wrong.
        assert!(with(8e-3, 4.0, -8.0).is_meaningful() && !with(8.1e-3, 4.0, -8.0).is_meaningful());
        assert!(
            with(0.0, 0.0, 0.0).is_meaningful() && !with(f64::INFINITY, f64::INFINITY, 0.0).is_meaningful()
        );
        let [closed, tolerance] = [f64::NAN; 2];
        assert!(Comparison { closed, tolerance, ..NUMBERS }.is_meaningful());
        assert!(!Comparison { closed, tolerance, other: f64::INFINITY, ..NUMBERS }.is_meaningful());
        assert!(!Comparison { tolerance, ..NUMBERS }.is_meaningful());
    }

    #[test]
    fn one_oracle_that_knows_decides_a_number() {
        let clear = Comparison { tolerance: 1e-9, ..NUMBERS };
        let second = Comparison { part: "Delta-delta", order: Order::Second, ..NUMBERS };
        assert!(is_decided([clear, clear].iter()) && is_decided([clear, NUMBERS].iter()));
        assert!(!is_decided([NUMBERS, NUMBERS].iter()) && !is_decided([clear, second].iter()));
        assert!(!is_decided([clear, Comparison { axis: Some('x'), ..NUMBERS }].iter()));
    }

    #[test]
    fn every_order_and_every_reason_has_its_own_words() {
        let names: BTreeSet<_> = Order::ALL.map(Order::name).into();
        assert_eq!(names, ["value", "first", "second", "symmetry", "matrix", "function"].into());
        assert!(Inconclusive::Crossing.reason().starts_with("crossing"));
        assert!(Inconclusive::WeakEnd.reason().starts_with("kink"));
    }

    #[test]
    fn a_verdict_shows_what_was_compared() {
        let entries = vec![NUMBERS];
        let inconclusive = Verdict::Inconclusive(Inconclusive::NotMeaningful, entries.clone());
        for verdict in [Verdict::Pass(entries.clone()), Verdict::Mismatch(entries.clone()), inconclusive] {
            assert_eq!(verdict.entries(), entries);
        }
    }
}
