//! Tests of which oracles are used, and of the resulting verdict.

use super::{MATRICES, ROUTES, compare, judged};
use crate::check::arbitration::DIFFERENCES;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::{
    Case, CaseData, CheckConfig, Compared, Comparison, ContactSituation, Inconclusive, Oracles, Order,
    Regime, Selection, TestBeam, Verdict,
};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Formula, Label};
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, Family};
use crate::variant::{Fault, Kind, SCALARS, Variant};
use std::collections::{BTreeMap, BTreeSet};

/// The entries of a pass without the differences: each component by three routes and by symmetry, each matrix.
const ENTRIES: usize = COMPONENTS * (4 * ROUTES.len() + 1) + SCALARS * 3;

/// The library's functions that are compared in a case, each with its number of entries.
fn functions(entries: &[Comparison]) -> BTreeMap<&'static str, usize> {
    let mut functions = BTreeMap::new();
    let known = [MATRICES, DIFFERENCES, "itself, directions exchanged"];
    for entry in
        entries.iter().filter(|entry| !ROUTES.contains(&entry.against) && !known.contains(&entry.against))
    {
        *functions.entry(entry.against).or_default() += 1;
    }
    functions
}

/// The number of their entries.
fn of_functions(entries: &[Comparison]) -> usize {
    functions(entries).into_values().sum()
}

fn asked(entries: &[Comparison]) -> usize {
    entries.iter().filter(|entry| entry.against == DIFFERENCES).count()
}

fn found(oracles: Oracles, seed: u64, number: u64) -> Compared {
    compare(&CheckConfig { oracles, ..CheckConfig::default() }, &Case::draw(seed, number))
}

/// Two segments between these points.
fn segments(ends: [[f64; 6]; 2]) -> Compared {
    CaseData { test_beams: ends.map(segment), contact: Contact::default() }
        .compare(&CheckConfig::default())
        .unwrap()
}

fn segment(ends: [f64; 6]) -> TestBeam {
    let (q, dq, linear_dq) = (ends.into(), vec![0.25; 6], vec![0.5; 6]);
    TestBeam { family: Family::Segment, parameters: Vec::new(), q, dq, linear_dq }
}

#[test]
fn every_number_is_compared_with_every_route() {
    for number in [0, 45, 72] {
        for (_, verdict) in found(Oracles::Ad, 7, number) {
            let Verdict::Pass(entries) = verdict else { panic!("{number}: {verdict:?}") };
            assert_eq!((entries.len(), asked(&entries)), (ENTRIES + of_functions(&entries), 0));
            for route in ROUTES {
                assert_eq!(entries.iter().filter(|entry| entry.against == route).count(), 4 * COMPONENTS);
            }
            assert_eq!(entries.iter().filter(|entry| entry.order == Order::Symmetry).count(), COMPONENTS);
            assert_eq!(entries.iter().filter(|entry| entry.against == MATRICES).count(), 3 * SCALARS);
        }
    }
}

#[test]
fn a_tolerance_holds_the_bounds_of_both_sides() {
    let case = Case::draw(7, 0);
    for (point, verdict) in found(Oracles::All, 7, 0) {
        for entry in verdict.entries() {
            assert!(
                entry.tolerance >= entry.bound && entry.tolerance < 1e-9 * entry.scale.max(1e-3),
                "{entry:?}"
            );
            if entry.order == Order::Symmetry {
                assert_eq!(entry.tolerance.to_bits(), (2.0 * entry.bound).to_bits());
            }
            // Half an ulp is added for the `f64` that shows the double-double number.
            let rounding = 0.5 * f64::EPSILON * entry.other.abs();
            assert!(entry.against != DIFFERENCES || entry.tolerance >= entry.bound + rounding, "{entry:?}");
        }
        let evaluation = EvaluationPoint::new(case.beams(), &case.contact, &point.unwrap()).unwrap();
        let of_other = evaluation.chord().into_iter().flat_map(Varied::parts).map(|part| part.bound[0]);
        let own = || verdict.entries().iter().filter(|entry| entry.against == ROUTES[2]);
        assert_eq!(own().count(), 4 * COMPONENTS);
        for (entry, of_other) in own().zip(of_other) {
            assert_eq!(entry.tolerance.to_bits(), (entry.bound + of_other).to_bits(), "{entry:?}");
        }
        assert!(own().any(|entry| entry.tolerance > 1.5 * entry.bound), "neither side is exact");
    }
}

#[test]
fn differences_are_asked_in_every_case_only_if_all_are_wanted() {
    for (_, verdict) in found(Oracles::All, 7, 0) {
        assert!(matches!(verdict, Verdict::Pass(_)));
        assert_eq!(
            (verdict.entries().len(), asked(verdict.entries())),
            (ENTRIES + of_functions(verdict.entries()) + 4 * COMPONENTS, 4 * COMPONENTS)
        );
    }
    // The ninth case of a regime is in no sample.
    for (_, verdict) in found(Oracles::Sample, 7, 72) {
        assert_eq!(asked(verdict.entries()), 0);
    }
}

#[test]
fn differences_decide_what_ad_cannot() {
    let decided = |oracles| {
        let found = found(oracles, 7, 518);
        found.into_iter().map(|(_, verdict)| (asked(verdict.entries()), verdict)).next().unwrap()
    };
    let (told, verdict) = decided(Oracles::Ad);
    assert!(told == 0 && matches!(verdict, Verdict::Inconclusive(Inconclusive::NotMeaningful, _)));
    let (told, verdict) = decided(Oracles::Sample);
    assert!(told > 0 && matches!(verdict, Verdict::Pass(_)));
}

#[test]
fn a_fault_is_a_mismatch_and_the_differences_are_asked() {
    let fault = Fault { label: Label::of_beam(Formula::SecondDVector, "Dd x"), kind: Kind::Dropped };
    let config = CheckConfig { variant: Variant::Faulty(vec![fault]), oracles: Oracles::Ad };
    let mismatch = (0..9).flat_map(|number| compare(&config, &Case::draw(7, number)));
    let mut mismatches = mismatch.filter(|(_, verdict)| matches!(verdict, Verdict::Mismatch(_))).peekable();
    assert!(mismatches.peek().is_some(), "{fault}");
    assert!(mismatches.all(|(_, verdict)| asked(verdict.entries()) == 4 * COMPONENTS));
}

#[test]
fn a_case_that_cannot_be_compared_has_a_reason() {
    let reasons = |found: Compared| -> Vec<_> {
        let reason = |(point, verdict): (Option<_>, Verdict)| match verdict {
            Verdict::Inconclusive(reason, _) if point.is_none() => Some(reason),
            _ => None,
        };
        found.into_iter().filter_map(reason).collect()
    };
    let along = |y: f64, end: f64| [-end, y, 0.0, end, y, 0.0];
    // Directions whose product overflows, and such whose product underflows.
    for size in [1e261, 1e-150] {
        let ends = [along(0.0, 1.0), [0.0, -1.0, 1.0, 0.5, 1.0, 1.0]];
        let directions = |of: TestBeam| TestBeam {
            dq: vec![size; 6],
            linear_dq: vec![-size, size, size, size, size, size],
            ..of
        };
        let test_beams = ends.map(|ends| directions(segment(ends)));
        let found =
            CaseData { test_beams, contact: Contact::default() }.compare(&CheckConfig::default()).unwrap();
        assert!(matches!(found[0].1, Verdict::Inconclusive(Inconclusive::OutOfRange, _)), "{size:e}");
    }
    assert_eq!(reasons(segments([along(0.0, 1.0), [0.0, -1.0, 1.0, 0.5, 1.0, 1.0]])), []);
    assert_eq!(reasons(segments([along(0.0, 1.0), along(0.0, 0.0)])), [Inconclusive::ZeroTangent]);
    assert_eq!(reasons(segments([along(0.0, 1e300), along(1.0, 1.0)])), [Inconclusive::SearchFailed]);
    assert_eq!(reasons(segments([along(0.0, 1.0), along(1.0, 1.0)])), [Inconclusive::Unresolved]);
}

#[test]
fn a_verdict_needs_every_number_and_one_mismatch() {
    let Verdict::Pass(entries) = found(Oracles::Ad, 7, 0).remove(0).1 else { panic!("case 0 passes") };
    assert!(matches!(judged(entries.clone()), Verdict::Pass(_)));
    let with = |change: &dyn Fn(&mut Comparison)| {
        let mut entries = entries.clone();
        let number = (entries[0].part, entries[0].quantity, entries[0].axis);
        let same = |entry: &&mut Comparison| (entry.part, entry.quantity, entry.axis) == number;
        entries.iter_mut().filter(same).for_each(change);
        judged(entries)
    };
    assert!(matches!(with(&|entry| entry.closed += 2.0 * entry.tolerance), Verdict::Mismatch(_)));
    let unknown = with(&|entry| entry.tolerance = 1e9);
    assert!(matches!(unknown, Verdict::Inconclusive(Inconclusive::NotMeaningful, _)));
    let far_but_unknown = with(&|entry| (entry.closed, entry.tolerance) = (1e10, 1e9));
    assert!(matches!(far_but_unknown, Verdict::Inconclusive(Inconclusive::NotMeaningful, _)));
}

/// The functions of the first cases of two regimes: all pairs of families.
#[test]
fn every_function_of_the_library_is_compared() {
    let selection = Selection { regimes: vec![Regime::Generic, Regime::NearEnd], family: None, cases: 121 };
    let cases = selection.numbers().into_iter().map(|number| Case::draw(7, number));
    let (mut all, mut dofs) = (BTreeMap::new(), BTreeSet::new());
    for case in cases {
        let [beam, bar] = case.beams().map(AnyBeam::dofs);
        let is_linear = case.families.into_iter().all(Family::is_linear);
        for (_, verdict) in compare(&CheckConfig::default(), &case) {
            let of_case = functions(verdict.entries());
            let own = |function: &str| of_case.get(&*format!("{function}, {beam} + {bar} dofs")).copied();
            if is_linear && !verdict.entries().is_empty() {
                // Value, both first variations and the second of seven scalars and of g_N.
                assert_eq!(
                    [own("linearize"), own("linearize_into"), own("write DistanceAlone")],
                    [Some(32), Some(32), Some(4)]
                );
                dofs.insert([beam, bar]);
            }
            all.extend(of_case);
        }
    }
    assert_eq!(dofs.len(), 16, "each pair of numbers of dofs that the families have: {dofs:?}");
    let count = |start: &str| all.keys().filter(|function| function.starts_with(start)).count();
    // Two pairs with 15 dofs, which no family has.
    assert_eq!((count("linearize, "), count("linearize, 15"), count("linearize, 12 + 15")), (19, 1, 1));
    // Three pairs in every layout, and in batches.
    let starts = [
        "write WithSlips, ",
        "write WithoutSlips, ",
        "write DistanceAlone, full",
        "write DistanceAlone, packed",
        "write_d_batch of",
    ];
    assert_eq!(starts.map(count), [12, 3 + 1, 3, 3, 12]);
    assert_eq!(
        ["write_over WithSlips", "write_over WithoutSlips", "write_over DistanceAlone"].map(count),
        [3; 3]
    );
    let any = [
        ("closed_form::vary", 92),
        ("linearize, by matrices", 32),
        ("write WithoutSlips, by matrices", 20),
        ("write DistanceAlone, by matrices", 4),
        ("write_d_batch, by matrices", 4),
        ("Matrices::vector", 60),
        ("expand_d_by_orders", 4),
    ];
    let routes = ["ad::vary, Newton", "ad::vary, stationary", "ad::vary, chord"].map(|route| (route, 92));
    let sweeps = ["sweep", "vector_dual", "rows", "orders"].map(|by| (by, 32));
    for (function, entries) in any.into_iter().chain(routes) {
        assert_eq!(all[function], entries, "{function}");
    }
    for (by, entries) in sweeps {
        assert_eq!(all[&*format!("expand_by_{by}")], entries, "{by}");
    }
    // Four scalars of d in each lane.
    assert_eq!(
        [4, 5, 6, 7].map(|pairs| all[&*format!("write_d_batch of {pairs}, 12 + 12")]),
        [16, 20, 24, 28]
    );
}

/// In each case with all routes: the pair in every state, and inside of both beams the centroids moved until they cross.
#[test]
fn a_contact_element_is_compared_at_every_point() {
    let (mut points, mut inside, mut crossing, mut at_cone) = (0, 0, 0, 0);
    let mut elements: BTreeMap<&str, usize> = BTreeMap::new();
    let mut situations: BTreeMap<ContactSituation, usize> = BTreeMap::new();
    for number in (0..1210).filter(|&number| super::compares_routes(number)) {
        for (point, verdict) in found(Oracles::Ad, 7, number) {
            let (Verdict::Pass(entries) | Verdict::Mismatch(entries)) = verdict else { continue };
            points += 1;
            inside += usize::from(point.is_some_and(|point| point.is_interior()));
            let of_element = |entry: &&Comparison| entry.against.starts_with("contact::Element, ");
            for entry in entries.iter().filter(of_element).step_by(4) {
                if entry.against.ends_with("d = 0") {
                    crossing += 1;
                    let is_at_cone =
                        |of| matches!(of, ContactSituation::StickAtCone | ContactSituation::SlipAtCone);
                    at_cone += usize::from(entry.situations.iter().any(is_at_cone));
                } else {
                    *elements.entry(entry.against).or_default() += 1;
                }
                entry.situations.iter().for_each(|situation| *situations.entry(situation).or_default() += 1);
            }
        }
    }
    assert_eq!(elements.values().sum::<usize>(), points);
    // Where a dof is very large, its rounding leaves a distance.
    assert!(100 * crossing > 95 * inside, "{crossing} of {inside}");
    // Two of twelve situations are open. The contact is open, too, where rounding hides the numbers of all others.
    let percent = |state: &str| 100 * elements[&*format!("contact::Element, {state}")] / points;
    assert!(percent("open") < 25 && percent("frictionless") > 12, "{elements:?}");
    assert!(percent("stick") > 12 && percent("slip") > 30, "{elements:?}");
    assert_eq!(situations[&ContactSituation::ZeroDistance], crossing);
    // Two of twelve situations are at the cone.
    assert!(12 * at_cone > crossing, "{at_cone} of {crossing}");
    assert!(
        ContactSituation::ALL.iter().all(|of| situations.get(of).is_some_and(|&n| n > 1)),
        "{situations:?}"
    );
}
