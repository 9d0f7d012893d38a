//! No reason for a number that is not compared hides a wrong one.

use super::complete::{answered, first_line, spoiled, told};
use super::conventions::{changed, map};
use super::programs::scratch;
use super::{answers, drawing, vectors, verified};
use crate::program::run;
use beamgap::check::external::{Evaluator, Vector};
use beamgap::check::{Family, Regime};
use serde_json::Value;

/// The answers of the library to these cases, changed, and the count of cases at which they are wrong.
fn wrong(all: &[Vector], change: impl Fn(&mut Value)) -> u64 {
    let text = answers(&Evaluator { penalty: Some(250.0), ..Evaluator::default() }, all);
    assert!(verified(all, &text, None).unwrap().agrees());
    verified(all, &changed(&text, change), None).unwrap().wrong
}

#[test]
fn gaps_are_open_and_closed_in_every_regime() {
    for families in [&[Family::Segment][..], &[Family::Hermite, Family::Arc], &Family::ALL] {
        for regime in Regime::ALL {
            let all = vectors(&drawing(families, &[regime], 22));
            let share_of_gap = |vector: &Vector| {
                let text = answers(&Evaluator::default(), std::slice::from_ref(vector));
                let line: Value = serde_json::from_str(text.lines().nth(1).unwrap()).unwrap();
                let [gap, d] = ["g_N", "d"].map(|of| line[of]["value"].as_f64().unwrap());
                gap / d
            };
            let mut closed: Vec<f64> = all.iter().map(share_of_gap).filter(|&share| share < 0.0).collect();
            assert!((8..=14).contains(&closed.len()), "{} {closed:?}", regime.name());
            // With the same share in all cases a term with d could not be told from one with g_N.
            closed.sort_by(f64::total_cmp);
            assert!(closed.windows(2).all(|of| of[1] - of[0] > 1e-6), "{} {closed:?}", regime.name());
        }
    }
}

/// Where the exact answer is zero, another number is wrong.
#[test]
fn a_force_at_an_open_gap_is_wrong() {
    let all = vectors(&drawing(&[Family::Segment], &Regime::ALL, 2));
    let is_open = |line: &Value| line["g_N"]["value"].as_f64().is_some_and(|gap| gap > 0.0);
    let open = wrong(&all, |line| {
        if is_open(line) {
            map(&mut line["residual"], &|_| 1e6);
        }
    });
    assert!(open >= 8, "{open}");
    for (array, number) in [("residual", 1e-6), ("tangent", 7.0), ("tangent", 1e-6)] {
        let found = wrong(&all, |line| {
            if is_open(line) {
                map(&mut line[array], &|_| number);
            }
        });
        // A small number disappears beside a large problem alone.
        assert!(found == open || (number < 1.0 && found >= open - 3), "{array} {number}: {found} of {open}");
    }
}

/// A held parameter does not vary.
#[test]
fn a_variation_of_a_held_parameter_is_wrong() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::NearEnd, Regime::Generic], 40));
    let held: Vec<&str> = all
        .iter()
        .filter(|vector| vector.point.is_some_and(|(xi, _)| xi.abs() >= 1.0))
        .map(|vector| vector.id.as_str())
        .collect();
    assert!(held.len() > 3, "{held:?}");
    for array in ["gradient", "hessian"] {
        let found = wrong(&all, |line| {
            if held.contains(&line["id"].as_str().unwrap()) {
                let entry = &mut line["xi"][array][3];
                *entry = (entry.as_f64().unwrap() + 1e-9).into();
            }
        });
        assert_eq!(found, held.len() as u64, "{array}");
    }
}

/// The rounding of a sum of huge numbers is no reason to leave it out.
#[test]
fn huge_numbers_are_wrong() {
    let all = vectors(&drawing(&[Family::Segment, Family::Hermite], &Regime::ALL, 2));
    for factor in [1e12, 1e18, 1e100] {
        let found = wrong(&all, |line| map(&mut line["d"]["hessian"], &|entry| factor * entry));
        assert_eq!(found, all.len() as u64, "{factor:e}");
    }
}

/// At a gap of zero the element has two tangents, and one residual.
#[test]
fn a_contact_element_is_compared_at_a_gap_of_zero() {
    let mut all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 6));
    for vector in &mut all {
        let text = answers(&Evaluator::default(), std::slice::from_ref(vector));
        let line: Value = serde_json::from_str(text.lines().nth(1).unwrap()).unwrap();
        let d = line["d"]["value"].as_f64().unwrap();
        (vector.case.contact.radius, vector.case.contact.radius_bar) = (0.5 * d, 0.5 * d);
    }
    assert_eq!(wrong(&all, |line| map(&mut line["residual"], &|_| 1e-3)), 6);
    assert_eq!(wrong(&all, |line| map(&mut line["tangent"], &|entry| entry + 1.0)), 6);
    // Both tangents are right.
    let of_closed = |line: &mut Value| {
        let gradient: Vec<f64> =
            line["d"]["gradient"].as_array().unwrap().iter().map(|g| g.as_f64().unwrap()).collect();
        let products = gradient.iter().flat_map(|g| gradient.iter().map(move |h| 250.0 * g * h));
        line["tangent"] = products.collect::<Vec<f64>>().into();
    };
    assert_eq!(wrong(&all, of_closed), 0);
    assert_eq!(wrong(&all, |line| map(&mut line["tangent"], &|_| 0.0)), 0);
}

/// Cases without a reference are left out with a warning, and a wrong program is red at the others, and without others.
#[test]
fn cases_without_a_reference_are_three_messages_and_a_warning() {
    let (vectors, text) = answered("left-out", &[]);
    let cases = std::fs::read_to_string(&vectors).unwrap();
    let mut lines: Vec<Value> = cases.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    lines[1]["point"] = serde_json::json!({ "xi": 0.5, "xi_bar": -0.3 });
    lines[2]["beam"]["q"] = [0, 0, 0, 1, 0, 0].map(f64::from).to_vec().into();
    lines[2]["bar"]["q"] = [0, 1, 0, 1, 1, 0].map(f64::from).to_vec().into();
    lines[2].as_object_mut().unwrap().remove("point");
    lines[3]["beam"]["q"] = [1, 2, 3, 1, 2, 3].map(f64::from).to_vec().into();
    let write =
        |lines: &[Value]| lines.iter().flat_map(|line| [line.to_string(), "\n".into()]).collect::<String>();
    let path = scratch("left-out-cases.jsonl", &write(&lines));
    let path = path.to_str().unwrap();
    let answers = scratch("left-out-answers.jsonl", &text);
    let output = run(&["verify", path, answers.to_str().unwrap()]);
    let shown = String::from_utf8(output.stdout).unwrap().replace("\n  ", " ");
    assert_eq!(output.status.code(), Some(0), "{shown}");
    for reason in [
        "1 case: the given point is not a closest point of the beams",
        "1 case: nearly parallel: the search left regions open",
        "1 case: a beam has no length",
    ] {
        assert!(shown.contains(&format!("Not compared: {reason}\n")), "{reason}: {shown}");
    }
    let verdict = &shown[shown.rfind("\nAGREE").unwrap()..];
    assert!(first_line(&verdict[1..]).starts_with("AGREE, WITH A WARNING: 1 of 4 cases of "), "{verdict}");
    assert!(verdict.contains("\nAt 37 closest points nothing differs beyond rounding.\n"), "{verdict}");
    for (format, sign) in
        [("github", "::warning "), ("markdown", "## ⚠️"), ("sarif", "\"level\": \"warning\"")]
    {
        let output = run(&["verify", path, answers.to_str().unwrap(), "--format", format]);
        let shown = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success() && shown.contains(sign), "{shown}");
    }
    // A wrong program is red, with other cases and without.
    let wrong = spoiled(&text, usize::MAX);
    assert_eq!(told(path, "left-out", &wrong, &[]).0, Some(1));
    let alone = scratch("left-out-alone.jsonl", &write(&lines[..4]));
    let (few, alone) = (wrong.lines().take(4).map(|l| l.to_owned() + "\n").collect::<String>(), alone);
    let (code, verdict) = told(alone.to_str().unwrap(), "left-out", &few, &[]);
    assert!(code == Some(4) && verdict.starts_with("NOTHING COMPARED"), "{verdict}");
}
