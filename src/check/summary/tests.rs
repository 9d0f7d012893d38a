//! Tests that counts add up, and that the case of a worst error can be found again.

use super::{Cell, Differences, NotCompared, Summary, Tally};
use crate::check::arbitration::DIFFERENCES;
use crate::check::element::ContactSituations;
use crate::check::{
    Arbitration, Case, CheckConfig, Compared, Comparison, Inconclusive, Order, Regime, Symmetry, Verdict,
    compare,
};
use crate::closest_point::ClosestPoint;
use crate::linearization::Quantity;

/// A comparison with this difference, a scale of 1 and a tolerance of 1e-3. A larger difference is a mismatch.
fn off(by: f64) -> Comparison {
    Comparison {
        quantity: Quantity::D,
        axis: None,
        order: Order::Second,
        part: "Delta-delta",
        against: "AD",
        closed: by,
        other: 0.0,
        scale: 1.0,
        bound: 0.0,
        tolerance: 1e-3,
        situations: ContactSituations::NONE,
    }
}

/// A tolerance that is not meaningful.
fn unclear() -> Comparison {
    Comparison { tolerance: 1.0, ..off(0.5) }
}

/// The coverage of the regime of metres alone.
fn covered(summary: &Summary) -> Tally {
    let Tally { coverage, coverage_of_families, .. } = summary.regimes[&Regime::Metres].clone();
    Tally { coverage, coverage_of_families, ..Tally::default() }
}

/// A case of the regime of metres, with a closest point inside and one at an end.
fn case() -> (Case, [ClosestPoint; 2]) {
    let metres = |&number: &u64| number % 9 == Regime::Metres as u64;
    let points = |case: &Case| -> Vec<ClosestPoint> {
        compare(&CheckConfig::default(), case).into_iter().filter_map(|(point, _)| point).collect()
    };
    let cases = || (0..2000).filter(metres).map(|number| Case::draw(7, number));
    let at_end = cases().flat_map(|case| points(&case)).find(|point| !point.is_interior()).unwrap();
    let (case, inside) = cases()
        .map(|case| {
            let inside = points(&case).into_iter().find(ClosestPoint::is_interior);
            (case, inside)
        })
        .find(|(_, inside)| inside.is_some())
        .unwrap();
    (case, [inside.unwrap(), at_end])
}

#[test]
fn points_are_counted_where_they_belong() {
    let (case, [inside, at_end]) = case();
    let pass = || Verdict::Pass(vec![off(1e-4), off(2e-4), unclear()]);
    let not = |reason| (None, Verdict::Inconclusive(reason, vec![off(0.5)]));
    let verdicts: Compared = vec![
        (Some(inside), pass()),
        (Some(inside), pass()),
        (Some(at_end), pass()),
        not(Inconclusive::Unresolved),
        not(Inconclusive::Unresolved),
        not(Inconclusive::Crossing),
    ];
    let summary = Summary::of(&case, &verdicts);
    let worst = Cell { scaled_error: 2e-4, case: case.number, over_tolerance: 0.2, entries: 6 };
    let tally = Tally {
        cases: 1,
        interior: 2,
        at_end: 1,
        mismatches: 0,
        worst,
        not_compared: [
            (Inconclusive::Unresolved, NotCompared { count: 2, first_case: case.number }),
            (Inconclusive::Crossing, NotCompared { count: 1, first_case: case.number }),
        ]
        .into(),
        ..covered(&summary)
    };
    // Three points, each on one side of every symmetry that applies.
    assert_eq!(tally.coverage.counts[&Symmetry::Xi].iter().sum::<u64>(), 3);
    assert_eq!(tally.coverage.counts[&Symmetry::End].iter().sum::<u64>(), 1);
    assert!(case.families.iter().all(|family| tally.coverage_of_families[family] == tally.coverage));
    assert_eq!(summary.regimes, [(Regime::Metres, tally)].into());
    assert_eq!(summary.quantities, [((Quantity::D, Order::Second), worst)].into());
    assert_eq!(summary.pairs, [((case.families[0], case.families[1]), 3)].into());
    assert_eq!(summary.families.values().sum::<u64>(), 6);
    assert_eq!(summary.compared(), 3);
    assert!(summary.mismatches.is_empty());
}

#[test]
fn of_mismatches_the_furthest_off_is_kept_and_all_are_arbitrated() {
    let (case, [inside, at_end]) = case();
    let agreeing = Comparison { against: DIFFERENCES, other: 0.25, ..off(0.25) };
    let ad_is_wrong = Verdict::Mismatch(vec![off(0.25), agreeing]);
    let nobody_knows = Verdict::Mismatch(vec![off(0.125), unclear()]);
    let far = Verdict::Mismatch(vec![off(0.5), off(0.0)]);
    let verdicts = vec![(Some(inside), ad_is_wrong), (Some(inside), far), (Some(at_end), nobody_knows)];
    let summary = Summary::of(&case, &verdicts);
    let told: Vec<_> =
        summary.mismatches.iter().map(|(&case, of)| (case, of.worst, of.arbitration)).collect();
    assert_eq!(told, [(case.number, off(0.5), Some(Arbitration::Ad))]);
    let tally = &summary.regimes[&Regime::Metres];
    assert_eq!((tally.mismatches, tally.interior, tally.at_end), (3, 2, 1));
}

#[test]
fn differences_count_what_they_decide() {
    let (case, [inside, _]) = case();
    let told = Comparison { against: DIFFERENCES, ..off(0.0) };
    let not = |entries| Verdict::Inconclusive(Inconclusive::NotMeaningful, entries);
    let verdicts: Compared = [
        Verdict::Pass(vec![off(0.0)]),
        Verdict::Pass(vec![off(0.0), told]),
        Verdict::Pass(vec![unclear(), told]),
        Verdict::Mismatch(vec![unclear(), Comparison { closed: 0.5, ..told }]),
        not(vec![unclear(), Comparison { against: DIFFERENCES, ..unclear() }]),
        not(vec![unclear()]),
    ]
    .map(|verdict| (Some(inside), verdict))
    .into();
    let summary = Summary::of(&case, &verdicts);
    let Differences { points, unclear, decided, quantities } = &summary.differences;
    assert_eq!((*points, *unclear, *decided), (4, 3, 2));
    let of_differences = quantities[&(Quantity::D, Order::Second)];
    assert_eq!((of_differences.entries, of_differences.scaled_error), (3, 0.5));
    // Their errors have their own cells, and are named only if no other number is wrong.
    assert_eq!(summary.quantities[&(Quantity::D, Order::Second)].scaled_error.to_bits(), 0);
    assert_eq!(summary.mismatches[&case.number].worst.against, DIFFERENCES);
    let both = vec![off(0.25), Comparison { closed: 0.5, ..told }];
    let both = Summary::of(&case, &[(Some(inside), Verdict::Mismatch(both))]);
    assert_eq!(both.mismatches[&case.number].worst, off(0.25));
}

#[test]
fn two_summaries_add_up_in_any_order() {
    let (case, [inside, at_end]) = case();
    let of = |number: u64, verdicts: &[(Option<ClosestPoint>, Verdict)]| {
        let mut other = Case::draw(7, case.number);
        other.number = number;
        Summary::of(&other, verdicts)
    };
    let told = Comparison { against: DIFFERENCES, ..off(0.0) };
    let unresolved = (None, Verdict::Inconclusive(Inconclusive::Unresolved, Vec::new()));
    let one = of(
        30,
        &[
            (Some(inside), Verdict::Pass(vec![off(2e-4), told])),
            unresolved.clone(),
            (Some(at_end), Verdict::Mismatch(vec![off(0.25)])),
        ],
    );
    let two = of(
        20,
        &[
            (Some(inside), Verdict::Pass(vec![Comparison { tolerance: 5e-4, ..off(0.25) }, unclear(), told])),
            unresolved.clone(),
            unresolved,
        ],
    );
    let both = one.clone().merge(two.clone());
    assert_eq!(both, two.clone().merge(one.clone()));
    assert_eq!(both, Summary::default().merge(one.clone()).merge(two));
    // Of equal errors the smaller case number is kept, of two tolerances the smaller.
    let worst = Cell { scaled_error: 0.25, case: 20, over_tolerance: 500.0, entries: 3 };
    let tally = Tally {
        cases: 2,
        interior: 2,
        at_end: 1,
        mismatches: 1,
        worst,
        not_compared: [(Inconclusive::Unresolved, NotCompared { count: 3, first_case: 20 })].into(),
        ..covered(&both)
    };
    assert_eq!(tally.coverage.counts[&Symmetry::Xi].iter().sum::<u64>(), 3);
    assert_eq!(both.regimes, [(Regime::Metres, tally)].into());
    assert_eq!(both.quantities[&(Quantity::D, Order::Second)], worst);
    assert_eq!((both.compared(), both.pairs.values().sum::<u64>()), (3, 3));
    assert_eq!(both.families.values().sum::<u64>(), 6);
    assert_eq!(both.mismatches.keys().collect::<Vec<_>>(), [&30]);
    assert_eq!(both.mismatches, one.mismatches);
    assert_eq!((both.differences.points, both.differences.unclear, both.differences.decided), (2, 0, 0));
}

#[test]
fn differences_add_up() {
    let worst = |scaled_error, entries| {
        let cell = Cell { scaled_error, case: 1, over_tolerance: scaled_error, entries };
        [((Quantity::D, Order::Second), cell)].into()
    };
    let mut one = Differences { points: 5, unclear: 3, decided: 2, quantities: worst(0.5, 1) };
    one.merge(&Differences { points: 50, unclear: 30, decided: 20, quantities: worst(0.25, 2) });
    assert_eq!(one, Differences { points: 55, unclear: 33, decided: 22, quantities: worst(0.5, 3) });
}

#[test]
fn a_summary_is_read_back_as_it_was() {
    let (case, [inside, at_end]) = case();
    let infinite = Comparison { closed: f64::NEG_INFINITY, tolerance: f64::INFINITY, ..off(0.5) };
    let told = Comparison { against: DIFFERENCES, ..off(0.0) };
    let verdicts: Compared = vec![
        (Some(inside), Verdict::Mismatch(vec![off(0.1 + 0.2), told])),
        (Some(at_end), Verdict::Mismatch(vec![infinite])),
        (None, Verdict::Inconclusive(Inconclusive::NotMeaningful, Vec::new())),
    ];
    let summary = Summary::of(&case, &verdicts);
    let text = serde_json::to_string(&summary).unwrap();
    assert_eq!(serde_json::from_str::<Summary>(&text).unwrap(), summary);
    for told in ["\"not-meaningful\":{", "\"-inf\"", "\"metres\":{\"cases\":1,"] {
        assert!(text.contains(told), "{text}");
    }
}
