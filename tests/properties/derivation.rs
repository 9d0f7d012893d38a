//! The page of the derivation states what the program computes, and needs no other file.

use super::reports::{committed, is_committed};
use beamgap::equations::StandardCase;
use beamgap::report::{Derivation, Record};
use serde_json::Value;
use std::collections::HashSet;

/// Numbers may differ in their last digits from machine to machine; everything else must be equal.
fn same(one: &Value, other: &Value, path: &str) {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => {
            let (one, other) = (one.as_f64().unwrap(), other.as_f64().unwrap());
            // Rounding errors of zero are small on every machine. Differences at their best step have rounding errors.
            let loose = path.contains("differences") || path.contains("floors") || path.contains("residuals");
            let tolerance = if loose { one.abs().max(1e-6) } else { 1e-9 * one.abs().max(1.0) };
            assert!((one - other).abs() <= tolerance, "{path}: {one} is {other}");
        }
        (Value::Array(one), Value::Array(other)) => {
            assert_eq!(one.len(), other.len(), "{path}");
            one.iter()
                .zip(other)
                .enumerate()
                .for_each(|(i, (one, other))| same(one, other, &format!("{path}/{i}")));
        }
        (Value::Object(one), Value::Object(other)) => {
            assert!(one.keys().eq(other.keys()), "{path}");
            one.iter().for_each(|(key, value)| same(value, &other[key], &format!("{path}/{key}")));
        }
        _ => assert_eq!(one, other, "{path}"),
    }
}

#[test]
fn the_committed_record_of_the_derivation_is_computed_again() {
    // The commands `equations` and `report` write this record.
    let command = Derivation::from_json(&committed("derivation.json")).unwrap().command;
    let found = Derivation::compute(&command).unwrap().to_json().unwrap();
    if std::env::var_os("BEAMGAP_BLESS").is_some() {
        is_committed("derivation.json", &found);
    }
    let json = |text: &str| serde_json::from_str::<Value>(text).unwrap();
    same(&json(&committed("derivation.json")), &json(&found), "");
}

/// Tests the fractions in the prose.
#[test]
fn the_pair_by_hand_has_the_numbers_of_the_prose() {
    let found = Derivation::compute("").unwrap().by_hand;
    let close =
        |value: f64, by_hand: f64| assert!((value - by_hand).abs() < 1e-14, "{value} is not {by_hand}");
    for (value, by_hand) in [
        (found.at[0], 0.5),
        (found.at[1], 0.0),
        (found.d, 0.25),
        (found.system[0], 1.0),
        (found.system[1], 0.6),
        (found.system[2], -1.0),
        (found.system[3], -16.0 / 25.0),
        (found.gradients[0], 25.0 / 128.0),
        (found.gradients[1], 15.0 / 128.0),
        (found.derivatives[0], -0.75),
        (found.derivatives[1], -25.0 / 256.0),
        (found.by_ad[0], -0.75),
        (found.by_ad[1], -25.0 / 256.0),
    ] {
        close(value, by_hand);
    }
    close(100.0 * (found.derivatives[0].powi(2) - 0.05 * found.derivatives[1]), 56.738_281_25);
}

/// In the standard case every corrected equation agrees, to the digits that the page claims.
#[test]
fn every_equation_agrees_in_the_standard_case() {
    use beamgap::equations::Reading;
    let worked = StandardCase::default().worked().unwrap();
    assert!(worked.iter().map(|equation| equation.number).eq(1..=59));
    let (mut right, mut refuted) = (0, 0);
    for equation in &worked {
        for part in &equation.parts {
            let last = part.readings.iter().rfind(|reading| reading.reading != Reading::Other);
            assert!(last.unwrap().digits(1.0) >= 13.0, "({}) {}", equation.number, part.name);
            right += 1;
            refuted += part.readings.iter().filter(|reading| reading.digits(1.0) < 3.0).count();
        }
    }
    assert!(right > 60 && refuted >= 15, "{right} {refuted}");
}

/// A fault whose name belongs to no term would change nothing.
#[test]
fn every_fault_of_the_self_checks_does_something() {
    for effect in Derivation::compute("").unwrap().effects {
        assert!(effect.deviations.iter().any(|&deviation| deviation > 1e-3), "{effect:?}");
        let is_slower = effect.iterations.is_none_or(|iterations| iterations > 4);
        assert!(!effect.in_hessian || is_slower, "{effect:?}");
        assert_eq!(effect.stopped.is_some(), effect.in_hessian && effect.iterations.is_none());
    }
}

#[test]
fn the_page_needs_no_other_file_and_its_links_lead_somewhere() {
    let page = committed("derivation.html");
    assert!(page.len() < 1_000_000, "{} bytes", page.len());
    assert!(!page.contains("<script") && !page.contains("src="), "nothing is run or fetched");
    assert_eq!(page.matches("http").count(), 1, "the namespace of MathML alone");
    let after = |mark: &'static str| page.split(mark).skip(1).map(|rest| rest.split('"').next().unwrap());
    let ids: Vec<&str> = after(" id=\"").collect();
    let unique: HashSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), unique.len(), "an id is used twice");
    for target in after("href=\"#") {
        assert!(unique.contains(target), "nothing is called {target}");
    }
    for target in after("href=\"../") {
        assert!(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(target).is_file(), "{target}");
    }
}
