//! Answers of few digits, and digits that are asked for.

use super::conventions::{changed, map};
use super::programs::{exported, scratch};
use super::{answers, drawing, vectors, verified};
use crate::program::run;
use beamgap::check::external::Evaluator;
use beamgap::check::{Family, Regime};
use serde_json::Value;

/// Answers of few digits are recognized, and a wrong term is found in them.
#[test]
fn few_digits_are_recognized() {
    let drawn = ["--family", "hermite", "--cases", "5", "--regime", "generic", "--regime", "near-end"];
    let path = exported("few.jsonl", &[&drawn[..], &["--expected", "none"]].concat());
    let vectors = path.to_str().unwrap();
    let right = scratch("few-right.jsonl", "");
    let wrong = scratch("few-wrong.jsonl", "");
    let evaluated = |more: &[&str], to: &std::path::Path| {
        let output = run(&[&["evaluate", vectors, "-o", to.to_str().unwrap()], more].concat());
        assert!(output.status.success(), "{output:?}");
        std::fs::read_to_string(to).unwrap()
    };
    let text = evaluated(&[], &right);
    let faulty = evaluated(&["--plant", "a: d.t,xi = dropped"], &wrong);
    let with = |text: &str, round: &dyn Fn(f64) -> f64| {
        changed(text, |line| {
            for (_, quantity) in line.as_object_mut().unwrap().iter_mut().filter(|(key, _)| *key != "id") {
                if let Some(parts) = quantity.as_object_mut() {
                    parts.values_mut().for_each(|part| map(part, round));
                }
            }
        })
    };
    let six = |x: f64| format!("{x:.5e}").parse().unwrap();
    #[expect(clippy::cast_possible_truncation, reason = "single precision")]
    let single = |x: f64| f64::from(x as f32);
    let verified = |text: &str, more: &[&str]| {
        let answers = scratch("few-answers.jsonl", text);
        let output = run(&[&["verify", vectors, answers.to_str().unwrap()], more].concat());
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    for (round, told) in [
        (&six as &dyn Fn(f64) -> f64, "All answers have at most 6 significant digits"),
        (&single, "All answers are numbers of single precision"),
    ] {
        let (code, shown) = verified(&with(&text, round), &[]);
        assert_eq!(code, Some(1), "{shown}");
        assert!(
            shown.ends_with(&format!(
                "{told}. If 6 are required,\nthe wrong cases that were tried agree: --digits 6.\n"
            )),
            "{shown}"
        );
        assert_eq!(verified(&with(&text, round), &["--digits", "6"]).0, Some(0));
        let (code, shown) = verified(&with(&faulty, round), &[]);
        assert_eq!(code, Some(1), "{shown}");
        assert!(shown.contains("They differ in the first 6 digits too."), "{shown}");
        assert!(shown.contains("Cause: in a, eq. (50), the term d.t,xi is missing."), "{shown}");
    }
    let document: Value =
        serde_json::from_str(&verified(&with(&text, &six), &["--format", "json"]).1).unwrap();
    assert_eq!(document["answered_digits"], 6);
    // One wrong case is not hidden by many before it that have few digits.
    let lines = with(&text, &six);
    let late: Value = serde_json::from_str(lines.lines().nth(9).unwrap()).unwrap();
    let one_wrong = changed(&lines, |line| {
        if line["id"] == late["id"] {
            map(&mut line["d"]["hessian"], &|x| six(1.5 * x));
        }
    });
    let (code, shown) = verified(&one_wrong, &[]);
    assert!(code == Some(1) && shown.contains("They differ in the first 6 digits too."), "{shown}");
    // Answers with all digits have no such hint.
    let (_, told) = verified(&faulty, &[]);
    assert!(!told.contains("significant digits") && told.contains("Cause: "), "{told}");
}

/// An error is told although rounding explains the first wrong numbers.
#[test]
fn rounding_does_not_hide_an_error() {
    let drawn = ["--family", "hermite", "--cases", "5", "--regime", "generic", "--regime", "nearly-crossing"];
    let path = exported("rounding.jsonl", &[&drawn[..], &["--expected", "none"]].concat());
    let vectors = path.to_str().unwrap();
    let answers = scratch("rounding-answers.jsonl", "");
    let files = [vectors, answers.to_str().unwrap()];
    let evaluated = run(&["evaluate", files[0], "-o", files[1], "--formulas", "paper"]);
    assert!(evaluated.status.success());
    let told = || {
        let output = run(&["verify", files[0], files[1], "--digits", "10"]);
        assert_eq!(output.status.code(), Some(1));
        String::from_utf8(output.stdout).unwrap()
    };
    let right = "The formulas are right, but keep too few digits here.";
    assert!(told().contains(right));
    let wrong = changed(&std::fs::read_to_string(&answers).unwrap(), |line| {
        if line["id"] == "8" {
            map(&mut line["d"]["hessian"], &|x| 1.001 * x);
        }
    });
    std::fs::write(&answers, wrong).unwrap();
    let told = told();
    assert!(!told.contains(right) && told.contains("of the Hessian of d, case 8"), "{told}");
}

/// The digits that are asked for are those of the number. Its terms may be so much larger that an error of half of it is
/// less than six digits of them.
#[test]
fn no_wrong_hessian_has_the_digits_that_are_asked_for() {
    let all = vectors(&drawing(&[Family::Hermite], &Regime::ALL, 4));
    let text = |factor: f64| {
        changed(&answers(&Evaluator { digits: Some(6), ..Evaluator::default() }, &all), |line| {
            if line["d"].is_object() {
                map(&mut line["d"]["hessian"], &|x| factor * x);
            }
        })
    };
    let found = |factor| verified(&all, &text(factor), Some(6)).unwrap();
    let [right, wrong] = [1.0, 1.5].map(found);
    assert!(right.compared > 30, "{}", right.compared);
    assert_eq!((right.wrong, wrong.wrong, wrong.compared), (0, right.compared, right.compared));
}
