//! A mismatch is shrunk, and its diagnosis does not change.

use beamgap::check::{
    Case, CaseData, CheckConfig, Comparison, Diagnosis, Family, Finding, Order, TestBeam, Verdict, shrink,
};
use beamgap::linearization::Quantity;
use beamgap::pair::Contact;
use proptest::prelude::*;

/// The diagnosis of the check for a case that can pass, if `fault` changes the closed form's numbers.
fn diagnosed(case: &CaseData, fault: impl Fn(&mut Comparison)) -> Option<Diagnosis> {
    let mut compared = case.compare(&CheckConfig::default()).ok()?;
    for (_, verdict) in &mut compared {
        if let Verdict::Pass(entries) = verdict {
            let mut entries = std::mem::take(entries);
            entries.iter_mut().for_each(&fault);
            let wrong = entries.iter().any(|entry| entry.is_meaningful() && !entry.agrees());
            *verdict = if wrong { Verdict::Mismatch(entries) } else { Verdict::Pass(entries) };
        }
    }
    Some(Finding::of(&compared).filter(|finding| finding.is_clear)?.diagnosis)
}

/// A fault: a wrong sign.
fn flipped(quantity: Quantity, order: Order) -> impl Fn(&mut Comparison) {
    move |entry| {
        // The kernel's values are compared for some families only, so the fault does not change them.
        let is_value = entry.order == Order::Matrix && entry.part == "value";
        if (entry.quantity, entry.order) == (quantity, order) && !is_value {
            entry.closed = -entry.closed;
        }
    }
}

/// The numbers of dofs that are not zero, in q and in both directions.
fn counts(case: &CaseData) -> [usize; 3] {
    let lists: [fn(&TestBeam) -> &Vec<f64>; 3] = [|s| &s.q, |s| &s.dq, |s| &s.linear_dq];
    lists.map(|list| case.test_beams.iter().flat_map(list).filter(|&&number| number != 0.0).count())
}

/// The length of the longest dof when written.
fn digits(case: &CaseData) -> usize {
    let numbers = case.test_beams.iter().flat_map(|s| s.q.iter().chain(&s.dq).chain(&s.linear_dq));
    numbers.map(|number| number.to_string().len()).max().unwrap_or(0)
}

#[test]
fn faults_are_shown_by_few_small_numbers() {
    let faults = [
        (Quantity::Xi, Order::First),
        (Quantity::Xi, Order::Second),
        (Quantity::GT, Order::Second),
        (Quantity::TVector, Order::Second),
        (Quantity::XiBar, Order::Matrix),
    ];
    let mut shown = [0; 5];
    for number in (0..1089).step_by(52) {
        let case = Case::draw(1, number).data();
        for (i, (quantity, order)) in faults.into_iter().enumerate() {
            let diagnose = |case: &CaseData| diagnosed(case, flipped(quantity, order));
            let Some(diagnosis) = diagnose(&case) else { continue };
            shown[i] += 1;
            let small = shrink(&case, diagnose);
            assert_eq!(diagnose(&small), Some(diagnosis));
            let [q, dq, linear_dq] = counts(&small);
            assert!(q <= 10 && dq + linear_dq <= 2 && digits(&small) <= 6, "case {number}: {small:?}");
            assert_eq!(small.contact, Contact::default());
            if quantity != Quantity::TVector {
                let straight = small.test_beams.iter().filter(|beam| beam.family == Family::Segment).count();
                assert!(
                    straight >= 1 && small.test_beams.iter().all(|beam| beam.family <= Family::Quadratic)
                );
            }
        }
    }
    assert!(shown.iter().all(|&shown| shown > 12), "{shown:?}");
}

/// With several faults, shrinking never replaces the first by another.
#[test]
fn a_diagnosis_does_not_drift() {
    let faults = |entry: &mut Comparison| {
        flipped(Quantity::DVector, Order::Second)(entry);
        flipped(Quantity::GTBar, Order::First)(entry);
        flipped(Quantity::Xi, Order::Value)(entry);
    };
    let mut kinds = Vec::new();
    for number in (4..400).step_by(36) {
        let case = Case::draw(3, number).data();
        let Some(diagnosis) = diagnosed(&case, faults) else { continue };
        let small = shrink(&case, |case| diagnosed(case, faults));
        assert_eq!(diagnosed(&small, faults).as_ref(), Some(&diagnosis));
        kinds.push((diagnosis.order, diagnosis.quantity));
    }
    assert!(kinds.contains(&(Order::Value, Quantity::Xi)), "{kinds:?}");
}

#[test]
fn a_beam_that_must_bend_bends_in_few_numbers() {
    let passes = |case: &CaseData| {
        case.compare(&CheckConfig::default()).is_ok_and(|compared| {
            compared.iter().any(|(point, verdict)| point.is_some() && matches!(verdict, Verdict::Pass(_)))
        })
    };
    // Quadratics with a second difference of more than a tenth of the chord.
    let bent = |case: &CaseData| {
        let TestBeam { family: Family::Quadratic, q, .. } = &case.test_beams[0] else { return false };
        let size = |of: fn(&[f64], usize) -> f64| (0..3).map(|i| of(q, i).powi(2)).sum::<f64>().sqrt();
        passes(case) && size(|q, i| q[i] - 2.0 * q[i + 3] + q[i + 6]) > 0.1 * size(|q, i| q[i + 6] - q[i])
    };
    let mut cases = (0..20_000).map(|number| Case::draw(2, number).data());
    let case = cases.find(|case| bent(case)).unwrap();
    let small = shrink(&case, bent);
    assert!(bent(&small) && small.test_beams[1].family == Family::Segment, "{small:?}");
    assert!(counts(&small)[0] <= 6 && counts(&small)[1..] == [0, 0] && digits(&small) <= 2, "{small:?}");
}

#[test]
fn every_family_becomes_plain() {
    for (k, family) in (0..).zip(Family::ALL) {
        let kept = |case: &CaseData| {
            let families = case.test_beams.each_ref().map(|beam| beam.family) == [family; 2];
            families && diagnosed(case, flipped(Quantity::Xi, Order::First)).is_some()
        };
        // The cases of a regime cycle through the 121 pairs of families. In some cases xi is held.
        let mut cases = (0..20).map(|round| Case::draw(2, 9 * (12 * k + 121 * round)).data());
        let case = cases.find(|case| kept(case)).unwrap();
        let small = shrink(&case, kept);
        let [beam, bar] = &small.test_beams;
        let [_, dq, linear_dq] = counts(&small);
        assert!(kept(&small) && dq + linear_dq == 1 && digits(&small) <= 5, "{small:?}");
        for test_beam in [beam, bar] {
            let short = test_beam.parameters.iter().all(|number| number.to_string().len() <= 4);
            assert!(short && test_beam.q.contains(&0.0), "{test_beam:?}");
        }
    }
}

#[test]
fn what_makes_no_beam_is_left_alone() {
    let mut case = Case::draw(2, 0).data();
    case.test_beams[0].q.pop();
    assert_eq!(shrink(&case, |_| 0), case);
}

/// Any number that JSON can represent.
fn number() -> impl Strategy<Value = f64> {
    let extreme =
        proptest::sample::select(vec![0.0, -0.0, 1.0, -1.0, 5e-324, 1e-300, 1e-160, 1e154, 1e300, f64::MAX]);
    prop_oneof![2 => extreme, 2 => -2.0..2.0, 1 => proptest::num::f64::NORMAL]
}

fn test_beam() -> impl Strategy<Value = TestBeam> {
    proptest::sample::select(Family::ALL.to_vec()).prop_flat_map(|family| {
        let dofs = family.units().len();
        let parameters = family.parameters().iter().map(|(_, count)| count).sum::<usize>();
        let numbers = |count: usize| proptest::collection::vec(number(), count);
        (numbers(parameters), numbers(dofs), numbers(dofs), numbers(dofs))
            .prop_map(move |(parameters, q, dq, linear_dq)| TestBeam { family, parameters, q, dq, linear_dq })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Any numbers give a verdict or an error, and no panic.
    #[test]
    fn any_numbers_can_be_compared_and_shrunk(beam in test_beam(), bar in test_beam(), radius in number()) {
        let contact = Contact { radius, ..Contact::default() };
        let case = CaseData { test_beams: [beam, bar], contact };
        if let Ok(compared) = case.compare(&CheckConfig::default()) {
            prop_assert!(!compared.is_empty());
        }
        let small = shrink(&case, |case| case.compare(&CheckConfig::default()).map_or(0, |compared| compared.len()));
        prop_assert_eq!(small.compare(&CheckConfig::default()).is_ok(), case.compare(&CheckConfig::default()).is_ok());
    }
}
