//! Pairs of faults that may explain the answers.
//!
//! Numbers are evaluated in an order, and a fault changes only later numbers. Therefore, either one fault explains the
//! first wrong numbers and the other changes later ones, or both change the first wrong numbers and nothing before.

use super::answered_case::{AnsweredCase, Predicted};
use super::datum::Datum;
use super::fit::Fit;
use super::hypothesis::{Change, of_faults, singles};
use crate::check::verdict::Order;
use crate::parallel;
use crate::variant::{Fault, Variant};
use std::cmp::Reverse;
use std::collections::HashSet;

/// The number of cases at which the first of two faults has to explain the first wrong numbers.
const SCREENED: usize = 4;
/// The number of cases at which both may change the first wrong numbers: one of each kind, as terms differ by kind.
const KINDS: usize = 6;
/// The number of first faults that are combined with all second faults.
const FIRST: usize = 12;
/// The number of pairs that both change the first wrong numbers and are kept.
const BOTH: usize = 2000;

/// The place of a quantity in the order of evaluation.
type Key = (Order, usize);

/// The changes of the first wrong numbers, by each method.
type Changes = Vec<Vec<f64>>;

fn key(datum: &Datum) -> Key {
    (datum.rank.0, datum.rank.1)
}

/// The pairs to be tried.
pub(super) fn pairs(cases: &[&AnsweredCase]) -> Vec<Change> {
    let screened = &cases[..cases.len().min(SCREENED)];
    let none = Change::Variant(Variant::Unmodified);
    let Some(start) = first_wrong(screened, &none) else { return Vec::new() };
    let singles = singles();
    let mut firsts: Vec<(Key, Fault)> = parallel::filter_map(&singles, |&fault| {
        let change = of_faults(&[fault]);
        let end = first_wrong(screened, &change)?;
        (end > start).then_some((end, fault))
    });
    firsts.sort_by_key(|(end, _)| Reverse(*end));
    firsts.truncate(FIRST);
    let with_first = |&(_, first): &(Key, Fault)| {
        singles.iter().filter(move |second| second.label != first.label).map(move |&second| [first, second])
    };
    let mut all: Vec<_> = firsts.iter().flat_map(with_first).collect();
    all.extend(both(&kinds(cases, start), &singles, start));
    all.iter().map(|pair| of_faults(pair)).collect()
}

/// The first wrong numbers after a change, at any of these cases.
fn first_wrong(cases: &[&AnsweredCase], change: &Change) -> Option<Key> {
    let of_case = |case: &&AnsweredCase| {
        let wrong = |predicted: &Predicted| {
            let is_wrong = |datum: &&Datum| datum.misfit(AnsweredCase::number(predicted, datum)).over > 1.0;
            case.data.iter().filter(is_wrong).map(key).min()
        };
        // The method whose first wrong number comes last. A method without a wrong number comes after all others.
        let methods = case.predicted(change);
        methods.iter().map(wrong).max_by_key(|wrong| (wrong.is_none(), *wrong)).flatten()
    };
    cases.iter().filter_map(of_case).min()
}

/// The first case of each kind with such a wrong number.
fn kinds<'a>(cases: &[&'a AnsweredCase<'a>], start: Key) -> Vec<&'a AnsweredCase<'a>> {
    let mut chosen: Vec<&AnsweredCase> = Vec::new();
    for case in cases {
        let has_wrong = case.data.iter().any(|datum| datum.is_wrong && key(datum) == start);
        if has_wrong && chosen.len() < KINDS && chosen.iter().all(|known| known.kind() != case.kind()) {
            chosen.push(case);
        }
    }
    chosen
}

/// The pairs of faults that change nothing before the first wrong numbers, and explain these.
fn both(cases: &[&AnsweredCase], singles: &[Fault], start: Key) -> Vec<[Fault; 2]> {
    // By chance, some pairs explain these numbers in a formulation that the program does not have. All are tried once.
    let count = cases.iter().map(|case| case.formulations()).max().unwrap_or(0);
    let mut known = HashSet::new();
    (0..count)
        .flat_map(|formulation| both_in(formulation, cases, singles, start))
        .filter(|pair| known.insert(*pair))
        .collect()
}

fn both_in(formulation: usize, cases: &[&AnsweredCase], singles: &[Fault], start: Key) -> Vec<[Fault; 2]> {
    // The changes of the first wrong numbers by a fault, by each method; nothing if it changes others before.
    let changes = |case: &AnsweredCase, fault: Fault| -> Option<Changes> {
        let off =
            |predicted: &Predicted, datum: &Datum| AnsweredCase::number(predicted, datum) - datum.reference;
        let is_same = |predicted: &Predicted, datum: &Datum| {
            off(predicted, datum).abs() <= 1e-9 * datum.scale + 8.0 * datum.tolerance
        };
        let of_start = || case.data.iter().filter(|datum| key(datum) == start);
        let mut before = case.data.iter().filter(|datum| key(datum) < start);
        let all = case.computed_in(formulation, &of_faults(&[fault]));
        let changes_start_alone = |predicted: &Predicted| {
            !of_start().all(|datum| is_same(predicted, datum))
                && before.all(|datum| is_same(predicted, datum))
        };
        let changes = |predicted: &Predicted| of_start().map(|datum| off(predicted, datum)).collect();
        all.iter().any(changes_start_alone).then(|| all.iter().map(changes).collect())
    };
    // The faults that change the first wrong numbers, each with its changes at the cases where it does.
    let changing = |&fault: &Fault| {
        let at: Vec<_> = cases.iter().map(|case| changes(case, fault)).collect();
        at.iter().any(Option::is_some).then_some((fault, at))
    };
    let changing = parallel::filter_map(singles, changing);
    let pairs: Vec<[usize; 2]> =
        (0..changing.len()).flat_map(|i| (i + 1..changing.len()).map(move |j| [i, j])).collect();
    let explained = |&[i, j]: &[usize; 2]| {
        let [(one, at_one), (two, at_two)] = [&changing[i], &changing[j]];
        if one.label == two.label {
            return None;
        }
        // First the cases where both have an effect, then those where one has.
        let both = (0..cases.len()).find(|&k| at_one[k].is_some() && at_two[k].is_some());
        let other = (0..cases.len()).find(|&k| at_one[k].is_some() != at_two[k].is_some());
        let tried = [both, other].into_iter().flatten();
        // Changes of terms of one sum add up. Pairs in which one term multiplies the other are given up.
        if !tried.clone().all(|k| add_up(cases[k], start, [&at_one[k], &at_two[k]])) {
            return None;
        }
        let mut fit = Fit::new(0, of_faults(&[*one, *two]));
        for k in tried {
            let predicted = cases[k].computed_in(formulation, &fit.change);
            fit.add(cases[k], &predicted, |datum| key(datum) <= start);
            if !fit.explains(f64::INFINITY) {
                return None;
            }
        }
        Some((fit.sum, [*one, *two]))
    };
    let mut explained = parallel::filter_map(&pairs, explained);
    explained.sort_by(|one, two| one.0.total_cmp(&two.0));
    explained.into_iter().take(BOTH).map(|(_, pair)| pair).collect()
}

/// Whether the changes of two faults, by one of the methods, are together those of the answers.
fn add_up(case: &AnsweredCase, start: Key, faults: [&Option<Changes>; 2]) -> bool {
    let methods = faults.iter().filter_map(|of| of.as_ref().map(Vec::len)).max().unwrap_or(0);
    (0..methods).any(|method| {
        let changes = faults.map(|of| of.as_ref().and_then(|of| of.get(method)));
        case.data.iter().filter(|datum| key(datum) == start).enumerate().all(|(i, datum)| {
            let by = changes.map(|of| of.map_or(0.0, |of| of[i]));
            let size = by[0].abs() + by[1].abs();
            let left = datum.answer - datum.reference - by[0] - by[1];
            left.abs() <= 16.0 * datum.tolerance + 1e-11 * datum.scale + 1e-8 * size
        })
    })
}
