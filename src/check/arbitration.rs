//! Which side is wrong: where the closed form and automatic differentiation disagree, the third oracle decides.
//!
//! The closed form is checked. Automatic differentiation and the differences in double-double are the oracles.
//! Where the two oracles agree and the closed form does not, the closed form is wrong. Where the oracles, or the routes
//! of automatic differentiation, disagree among themselves, the check itself cannot be trusted, and the closed form is
//! not judged. Where the differences have too large an error estimate, no side is wrong, but the disagreement stands.

use super::serialized::by_name;
use super::verdict::{Comparison, Order, Verdict};
use std::collections::BTreeMap;

/// The name of the third oracle in [`Comparison::against`].
pub(super) const DIFFERENCES: &str = "differences in double-double";

enumeration! {
    /// The side that the third oracle finds wrong.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Arbitration {
        /// The oracles agree with each other and not with the closed form; or the closed form contradicts itself.
        ClosedForm => "closed-form-wrong",
        /// The differences agree with the closed form and not with AD; or AD's routes contradict each other.
        Ad => "ad-wrong",
        /// The differences agree with neither.
        Both => "both-wrong",
        /// The differences are not accurate enough to decide, or are not known.
        Undecided => "undecided",
    }
}

by_name!(Arbitration);

impl Arbitration {
    /// The wrong side, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::ClosedForm => "the closed form is wrong",
            Self::Ad => "automatic differentiation is wrong",
            Self::Both => "both are wrong, or the differences are",
            Self::Undecided => "undecided",
        }
    }

    /// Whether the oracles disagree among themselves.
    pub fn is_untrusted(self) -> bool {
        matches!(self, Self::Ad | Self::Both)
    }

    /// Arbitrates over a closest point that disagrees; nothing at a point that agrees or is not compared.
    ///
    /// Beyond the range of `f64` automatic differentiation overflows, which says nothing about it.
    pub fn of_mismatch(verdict: &Verdict) -> Option<Self> {
        match verdict {
            Verdict::Mismatch(entries) => Self::of(entries),
            Verdict::Pass(_) | Verdict::Inconclusive(..) => None,
        }
    }

    /// Arbitrates over all entries of a closest point; nothing if all meaningful comparisons agree.
    pub fn of(entries: &[Comparison]) -> Option<Self> {
        let mut groups: BTreeMap<_, Vec<&Comparison>> = BTreeMap::new();
        for entry in entries {
            groups.entry((entry.quantity, entry.axis, entry.order, entry.part)).or_default().push(entry);
        }
        groups.into_values().filter_map(|group| Self::of_entry(&group)).reduce(Self::and)
    }

    /// Arbitrates over all comparisons of one entry.
    fn of_entry(entries: &[&Comparison]) -> Option<Self> {
        if !entries.iter().any(|entry| entry.is_wrong()) {
            return None;
        }
        if matches!(entries[0].order, Order::Symmetry | Order::Matrix | Order::Function) {
            return Some(Self::ClosedForm);
        }
        let (differences, ad): (Vec<&Comparison>, Vec<&Comparison>) =
            entries.iter().copied().partition(|entry| entry.against == DIFFERENCES);
        let routes_agree = ad.iter().enumerate().all(|(i, one)| ad[..i].iter().all(|two| one.is_near(two)));
        let Some(differences) = differences.first() else {
            return Some(if routes_agree { Self::Undecided } else { Self::Ad });
        };
        let ad_right = routes_agree && ad.iter().all(|entry| entry.is_near(differences));
        Some(match (differences.agrees(), ad_right) {
            (true, true) => Self::Undecided,
            (false, true) => Self::ClosedForm,
            (true, false) => Self::Ad,
            (false, false) => Self::Both,
        })
    }

    /// The result of two arbitrations.
    pub(super) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Undecided, one) | (one, Self::Undecided) => one,
            (one, two) if one == two => one,
            _ => Self::Both,
        }
    }
}

impl Comparison {
    /// Whether the other numbers of both comparisons agree within their own bounds.
    fn is_near(&self, with: &Self) -> bool {
        let own = |entry: &Self| entry.tolerance - entry.bound;
        (self.other - with.other).abs() <= own(self) + own(with)
    }
}

#[cfg(test)]
mod tests {
    use super::{Arbitration, Comparison, DIFFERENCES, Order};
    use crate::check::element::ContactSituations;
    use crate::linearization::Quantity;

    const ROUTES: [&str; 3] = ["newton", "stationary", "chord"];

    fn entry(against: &'static str, other: f64, bound: f64) -> Comparison {
        Comparison {
            quantity: Quantity::D,
            axis: None,
            order: Order::Second,
            part: "Delta-delta",
            against,
            closed: 1.0,
            other,
            scale: 1.0,
            bound: 1e-12,
            tolerance: 1e-12 + bound,
            situations: ContactSituations::NONE,
        }
    }

    /// The closed form is 1 + 0 ± 1e-12, the routes of AD and the differences are 1 + these. Only the bound of each is
    /// known besides.
    fn arbitrated(ad: [f64; 3], differences: Option<(f64, f64)>) -> Option<Arbitration> {
        let routes = ROUTES.into_iter().zip(ad).map(|(route, off)| entry(route, 1.0 + off, 1e-11));
        let third = differences.map(|(off, bound)| entry(DIFFERENCES, 1.0 + off, bound));
        Arbitration::of(&routes.chain(third).collect::<Vec<_>>())
    }

    #[test]
    fn who_agrees_is_not_blamed() {
        assert_eq!(arbitrated([0.0; 3], None), None);
        assert_eq!(arbitrated([1e-12; 3], Some((1e-13, 1e-12))), None);
        // A tolerance that is not meaningful rejects no side.
        assert_eq!(arbitrated([0.0; 3], Some((0.5, 0.1))), None);
    }

    #[test]
    fn two_oracles_against_the_closed_form_blame_it() {
        assert_eq!(arbitrated([1e-6; 3], Some((1e-6, 1e-15))), Some(Arbitration::ClosedForm));
        assert!(!Arbitration::ClosedForm.is_untrusted());
    }

    #[test]
    fn oracles_that_disagree_among_themselves_blame_the_check() {
        assert_eq!(arbitrated([1e-6; 3], Some((0.0, 1e-15))), Some(Arbitration::Ad));
        assert_eq!(arbitrated([1e-6; 3], Some((2e-6, 1e-15))), Some(Arbitration::Both));
        assert_eq!(arbitrated([0.0; 3], Some((2e-6, 1e-15))), Some(Arbitration::Both));
        assert_eq!(arbitrated([0.0, 1e-6, 0.0], Some((0.0, 1e-15))), Some(Arbitration::Ad));
        assert_eq!(arbitrated([0.0, f64::NAN, 0.0], None), Some(Arbitration::Ad));
        assert_eq!(arbitrated([0.0, 1e-6, 0.0], Some((1e-6, 1e-15))), Some(Arbitration::Both));
        assert!(Arbitration::Ad.is_untrusted() && Arbitration::Both.is_untrusted());
    }

    #[test]
    fn an_oracle_that_does_not_know_blames_nobody() {
        assert_eq!(arbitrated([1e-6; 3], None), Some(Arbitration::Undecided));
        assert_eq!(arbitrated([1e-6; 3], Some((5e-7, 1e-6))), Some(Arbitration::Undecided));
        assert!(!Arbitration::Undecided.is_untrusted());
    }

    #[test]
    fn a_closed_form_that_contradicts_itself_is_wrong() {
        let matrix = Comparison { order: Order::Matrix, ..entry("contracted", 1.1, 1e-12) };
        assert_eq!(Arbitration::of(&[matrix]), Some(Arbitration::ClosedForm));
    }

    #[test]
    fn entries_are_judged_together() {
        use Arbitration::{Ad, Both, ClosedForm, Undecided};
        for (one, two, both) in [
            (ClosedForm, ClosedForm, ClosedForm),
            (ClosedForm, Undecided, ClosedForm),
            (Undecided, Ad, Ad),
            (ClosedForm, Ad, Both),
            (Both, ClosedForm, Both),
            (Undecided, Undecided, Undecided),
        ] {
            assert_eq!((one.and(two), two.and(one)), (both, both));
        }
        // The closed form is wrong in one entry, AD in another.
        let at = |quantity, ad: f64, third: f64| {
            let of = ROUTES.map(|route| entry(route, ad, 1e-11)).into_iter();
            of.chain([entry(DIFFERENCES, third, 1e-15)]).map(move |entry| Comparison { quantity, ..entry })
        };
        let entries: Vec<_> = at(Quantity::D, 1.1, 1.1).chain(at(Quantity::T, 1.1, 1.0)).collect();
        assert_eq!(Arbitration::of(&entries), Some(Both));
        assert_eq!(Arbitration::of(&entries[..4]), Some(ClosedForm));
        assert_eq!(Arbitration::of(&entries[4..]), Some(Ad));
    }

    #[test]
    fn every_judgement_has_its_own_words() {
        use Arbitration::{Ad, ClosedForm};
        let all = Arbitration::ALL;
        assert_eq!(all.map(Arbitration::name), ["closed-form-wrong", "ad-wrong", "both-wrong", "undecided"]);
        assert!(ClosedForm.words().starts_with("the closed form") && Ad.words().starts_with("automatic"));
    }

    #[test]
    fn routes_are_near_within_their_own_bounds() {
        // The bound of the closed form does not excuse a difference between two routes.
        let route = |other| Comparison { bound: 1e-4, tolerance: 1e-4 + 1e-11, ..entry("route", other, 0.0) };
        assert_eq!(Arbitration::of(&[route(1.01), route(1.01)]), Some(Arbitration::Undecided));
        assert_eq!(Arbitration::of(&[route(1.01), route(1.010_05)]), Some(Arbitration::Ad));
    }
}
