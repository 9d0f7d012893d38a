//! The search for wrong terms of the closed form: each fault of the catalogue, simplifications and factors of it as a whole,
//! and pairs of faults.

use super::answered_case::{AnsweredCase, Known, Predicted};
use super::datum::Datum;
use super::element_search::elements;
use super::fit::{Fit, limit, near, race};
use super::hypothesis::{Change, of_faults, singles};
use super::pairs::pairs;
use crate::check::evaluation_point::Structure;
use crate::check::external::conventions::ENERGY;
use crate::check::verdict::Order;
use crate::linearization::Quantity;
use crate::parallel;
use crate::variant::{Fault, Variant};
use std::collections::BTreeSet;

/// The number of changes that are tried at all cases even if they explain the answers worse than others.
pub(super) const KEPT: usize = 16;
/// The number of wrong numbers below which neither a factor nor two faults are looked for.
const FEW: usize = 3;
/// The mean of the squares up to which only rounding remains.
const LIKELY: f64 = 2.0;

/// The predictions at a case that every search uses.
pub(super) fn memo(case: &AnsweredCase) -> Known {
    parallel::map(&singles(), |&fault| (fault, case.computed(&of_faults(&[fault])))).into_iter().collect()
}

/// The changes that are tried first: one fault of the catalogue, a simplification, a factor, and no change.
fn candidates(cases: &[&AnsweredCase]) -> Vec<Change> {
    let mut all: Vec<_> = singles().iter().map(|&fault| of_faults(&[fault])).collect();
    all.push(Change::Variant(Variant::Unmodified));
    all.extend(Structure::ALL.map(Change::Structure));
    all.extend(elements(cases));
    all.push(Change::BeamsExchanged);
    let wrong: BTreeSet<_> = of(cases).filter(|datum| datum.is_wrong).map(|datum| datum.quantity).collect();
    for quantity in wrong {
        all.extend(
            [Order::Value, Order::First, Order::Second, Order::Matrix]
                .into_iter()
                .filter_map(|order| Some(Change::Factor(quantity, order, factor(cases, quantity, order)?))),
        );
    }
    all
}

fn of<'a>(cases: &'a [&AnsweredCase]) -> impl Iterator<Item = &'a Datum> {
    cases.iter().flat_map(|case| &case.data)
}

/// The factor that fits best. For the order [`Order::Matrix`], first and second variations are fitted together.
fn factor(cases: &[&AnsweredCase], quantity: Quantity, order: Order) -> Option<f64> {
    let is_of = |datum: &&Datum| {
        let is_order = datum.order == order || (order == Order::Matrix && datum.order != Order::Value);
        datum.quantity == quantity
            && datum.place[0] != ENERGY
            && is_order
            && datum.scale > 0.0
            && datum.answer.is_finite()
    };
    if of(cases).filter(is_of).filter(|datum| datum.is_wrong).count() < FEW {
        return None;
    }
    let sums = of(cases).filter(is_of).fold([0.0, 0.0], |[one, two], datum| {
        let (answer, reference) = (datum.answer / datum.scale, datum.reference / datum.scale);
        [one + answer * reference, two + reference * reference]
    });
    (sums[1] > 0.0).then_some(sums[0] / sums[1]).filter(|factor| (factor - 1.0).abs() > 1e-9)
}

/// An explanation.
pub(super) struct Equal {
    pub(super) fit: Fit,
    /// Other kinds of faults of the same terms that predict the same numbers.
    pub(super) alike: Vec<Change>,
}

/// The result of the search.
pub(super) struct Found {
    /// The deviation of the answers without a change.
    pub(super) before: f64,
    /// The explanations that these answers cannot distinguish from the first.
    pub(super) equal: Vec<Equal>,
    /// The best of the others.
    pub(super) runner_up: Option<Fit>,
    /// Whether correct answers explain these as well, within their digits.
    pub(super) is_faint: bool,
}

/// The changes that explain the answers best, by the sums of squares, tried at all these cases. Two faults are tried if this
/// is asked and no single fault explains the answers.
pub(super) fn search(cases: &[&AnsweredCase], with_pairs: bool) -> Vec<Fit> {
    let before = before(cases);
    let is_found = |fits: &[Fit]| {
        // If correct answers are among the best, two faults explain no more. If a fault explains all, but leaves more
        // than is likely, a second fault may be small.
        near(fits).iter().any(|of| of.explains(before) && (of.change.is_none() || of.mean() <= LIKELY))
    };
    let raced = |first: usize, changes: Vec<Change>| {
        let fits = changes.into_iter().enumerate().map(|(i, change)| Fit::new(first + i, change));
        race(fits.collect(), cases, KEPT)
    };
    let mut fits = raced(0, candidates(cases));
    // Two faults can be fitted to a few wrong numbers, whatever their cause, and to numbers that are not finite none.
    let wrong: usize = cases.iter().map(|case| case.wrong()).sum();
    let is_finite = of(cases).all(|datum| datum.answer.is_finite());
    if with_pairs && !is_found(&fits) && wrong >= FEW && is_finite {
        fits.extend(raced(2 * singles().len(), pairs(cases)));
        fits.sort_by(|one, two| one.sum.total_cmp(&two.sum));
    }
    fits
}

/// The deviation of the answers without a change.
pub(super) fn before(cases: &[&AnsweredCase]) -> f64 {
    Fit::of(Change::Variant(Variant::Unmodified), cases).worst
}

/// The explanations among the results.
pub(super) fn ranked(fits: Vec<Fit>, cases: &[&AnsweredCase]) -> Found {
    let before = before(cases);
    // A simpler change is preferred to a better one, up to a limit, because two faults can imitate rounding.
    let best = fits.first().map_or((0.0, 0.0, 0), |best| (best.sum, limit(best), best.change.class()));
    let is_near = |of: &Fit| {
        let (sum, limit, class) = best;
        of.sum <= if of.change.class() < class { sum + 3.0 * (limit - sum) } else { limit }
    };
    // If correct answers are not distinguished better than this, the cause is unknown.
    let is_faint = fits.iter().any(|of| is_near(of) && of.change.is_none() && of.explains(before));
    // Two faults that leave more than is likely are not the faults of the program.
    let is_likely = |of: &Fit| !of.change.has_two_faults() || of.mean() <= LIKELY;
    let explains = |of: &Fit| !is_faint && is_near(of) && of.explains(before) && is_likely(of);
    let (mut equal, mut others): (Vec<_>, Vec<_>) = fits.into_iter().partition(explains);
    equal.sort_by_key(|of| (of.change.class(), of.order));
    if let Some(simplest) = equal.first().map(|of| of.change.class()) {
        equal.retain(|of| of.change.class() == simplest);
    }
    let equal = alike_together(equal, cases);
    others.sort_by(|one, two| one.worst.total_cmp(&two.worst));
    // A change without effect is no runner-up.
    let runner_up = others.into_iter().find(|of| !of.change.is_none() && of.worst < before);
    Found { before, equal, runner_up, is_faint }
}

/// Groups kinds of faults of the same terms that predict the same numbers.
fn alike_together(equal: Vec<Fit>, cases: &[&AnsweredCase]) -> Vec<Equal> {
    let labels = |of: &Change| match of {
        Change::Variant(Variant::Faulty(faults)) => faults.iter().map(|fault| fault.label).collect(),
        _ => Vec::new(),
    };
    let mut together: Vec<Equal> = Vec::new();
    for fit in equal {
        let is_alike = |known: &&mut Equal| {
            let (one, two) = (&known.fit.change, &fit.change);
            !labels(one).is_empty() && labels(one) == labels(two) && predict_the_same(one, two, cases)
        };
        match together.iter_mut().find(is_alike) {
            Some(known) => known.alike.push(fit.change),
            None => together.push(Equal { fit, alike: Vec::new() }),
        }
    }
    together
}

fn predict_the_same(one: &Change, two: &Change, cases: &[&AnsweredCase]) -> bool {
    cases.iter().all(|case| {
        let (one, two) = (case.predicted(one), case.predicted(two));
        case.data.iter().all(|datum| {
            one.iter().zip(two.iter()).all(|(one, two)| {
                let (one, two) = (AnsweredCase::number(one, datum), AnsweredCase::number(two, datum));
                (one - two).abs() <= 1e-9 * datum.scale.max(one.abs()) || one.to_bits() == two.to_bits()
            })
        })
    })
}

/// The factor of the term less one, as the numbers show it near that of a fault; nothing if the fault is no factor.
pub(super) fn coefficient(cases: &[&AnsweredCase], fault: Fault) -> Option<f64> {
    let nominal = fault.kind.factor()? - 1.0;
    let change = of_faults(&[fault]);
    let of_case = |case: &&AnsweredCase| {
        let sums = |predicted: &Predicted| {
            let finite = case.data.iter().filter(|datum| datum.answer.is_finite() && datum.scale > 0.0);
            finite.fold([0.0, 0.0, 0.0], |[product, square, left], datum| {
                let number = AnsweredCase::number(predicted, datum);
                let [found, caused] = [datum.answer, number].map(|of| (of - datum.reference) / datum.scale);
                [product + found * caused, square + caused * caused, left + (found - caused).powi(2)]
            })
        };
        let all: Vec<_> = case.predicted(&change).iter().map(sums).collect();
        all.into_iter().min_by(|one, two| one[2].total_cmp(&two[2])).unwrap_or_default()
    };
    let [product, square] =
        cases.iter().map(of_case).fold([0.0; 2], |sum, [p, s, _]| [sum[0] + p, sum[1] + s]);
    (square > 0.0).then_some(nominal * product / square)
}
