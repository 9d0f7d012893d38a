//! Errors of hand-written matrix formulas that are no faults of single terms of the closed form.

use super::conventions::{changed, map};
use super::programs::{exported, scratch};
use super::{answers, drawing, vectors, verified};
use crate::program::{json, run};
use beamgap::check::external::{AnswerReader, Demands, Evaluator, Explanation, explain, other_conventions};
use beamgap::check::{Family, Regime};
use serde_json::Value;

/// The numbers of an array of an answer.
fn numbers(line: &Value, quantity: &str, array: &str) -> Vec<f64> {
    line[quantity][array].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Adds a product of two vectors to the Hessian of a quantity.
fn add(line: &mut Value, quantity: &str, factor: f64, [one, two]: [&[f64]; 2]) {
    let dofs = one.len();
    let sum = numbers(line, quantity, "hessian").into_iter().enumerate();
    let sum: Vec<f64> = sum.map(|(k, entry)| entry + factor * one[k / dofs] * two[k % dofs]).collect();
    line[quantity]["hessian"] = sum.into();
}

/// The explanation of gradients and Hessians that are changed, and printed with `digits` digits.
fn explained(digits: Option<u8>, change: impl Fn(&mut Value)) -> Explanation {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic, Regime::NearEnd], 16));
    let text = changed(&answers(&Evaluator::default(), &all), |line| {
        if !line["d"].is_object() {
            return;
        }
        change(line);
        let mut rest = serde_json::json!({ "id": line["id"] });
        for name in ["d", "xi", "xi_bar", "t", "t_bar", "g_T", "g_T_bar"] {
            for part in ["value", "gradient", "hessian"] {
                rest[name][part] = line[name][part].clone();
                if let Some(digits) = digits {
                    map(&mut rest[name][part], &|x| {
                        format!("{x:.*e}", usize::from(digits) - 1).parse().unwrap()
                    });
                }
            }
        }
        *line = rest;
    });
    let report = verified(&all, &text, digits).unwrap();
    explain(&report.kept, &report.right, &Demands { digits, ..Demands::default() }).unwrap()
}

fn names(found: &Explanation) -> Vec<&str> {
    found.causes.iter().map(|cause| cause.name.as_str()).collect()
}

#[test]
fn a_missing_division_is_named() {
    let value = |line: &Value, name: &str| line[name]["value"].as_f64().unwrap();
    let times = |name: &'static str, array: &'static str| {
        move |line: &mut Value| {
            let length = value(line, name);
            map(&mut line[name][array], &|x| length * x);
        }
    };
    for digits in [None, Some(6)] {
        let found = explained(digits, times("d", "hessian"));
        assert_eq!(names(&found)[0], "in Dd|d|, eq. (40), the division by |d| is left out", "{found:?}");
        let found = explained(digits, times("d", "gradient"));
        assert_eq!(names(&found)[0], "the term d dd is wrong: 1 stands in the place of d", "{found:?}");
        // The normal in the product of normals is d, and not a unit vector.
        let found = explained(digits, |line| {
            let (d, normal) = (value(line, "d"), numbers(line, "d", "gradient"));
            add(line, "d", 1.0 / d - d, [&normal, &normal]);
        });
        assert_eq!(names(&found)[0], "the term dd Dd is wrong: it is multiplied by d^2", "{found:?}");
    }
}

#[test]
fn a_product_without_its_transpose_is_named() {
    for digits in [None, Some(6)] {
        // H_d has b(g g_bar' + g_bar g')/d.
        let change = |line: &mut Value, once: f64, transposed: f64| {
            let sum = |name: &str, other: &str| -> f64 {
                let value = |name: &str, axis| line[format!("{name}.{axis}")]["value"].as_f64().unwrap();
                ["x", "y", "z"].map(|axis| value(name, axis) * value(other, axis)).iter().sum()
            };
            let factor = sum("t_vector", "t_bar_vector") / line["d"]["value"].as_f64().unwrap();
            let [g, g_bar] = ["xi", "xi_bar"].map(|name| numbers(line, name, "gradient"));
            add(line, "d", once * factor, [&g, &g_bar]);
            add(line, "d", transposed * factor, [&g_bar, &g]);
        };
        let found = explained(digits, |line| change(line, 0.0, -1.0));
        assert_eq!(names(&found), ["the term b dxi_bar Dxi is missing"], "{digits:?} {found:?}");
        assert!((found.causes[0].coefficient.unwrap() + 1.0).abs() < 1e-3);
        // The same product twice, instead of the product and its transpose.
        let found = explained(digits, |line| change(line, 1.0, -1.0));
        assert!(
            names(&found).contains(&"in Dd|d|, eq. (40), the term b dxi_bar Dxi is transposed"),
            "{found:?}"
        );
        // One line of a program serves both beams.
        let found = explained(digits, |line| {
            for bar in ["", "_bar"] {
                let [g, grad_t] =
                    [format!("xi{bar}"), format!("t{bar}")].map(|name| numbers(line, &name, "gradient"));
                let slip = format!("g_T{bar}");
                add(line, &slip, -1.0, [&g, &grad_t]);
            }
        });
        assert_eq!(
            names(&found),
            ["in Ddg_T and Ddg_T_bar, eq. (21), the term D|t| dxi is missing"],
            "{found:?}"
        );
        assert!(found.beyond.is_empty(), "{found:?}");
    }
}

#[test]
fn wrong_parts_of_a_contact_element_are_named() {
    let mut drawing = drawing(&[Family::Hermite], &[Regime::Generic], 8);
    drawing.penetrating = true;
    let all = vectors(&drawing);
    let text = answers(&Evaluator { penalty: Some(250.0), ..Evaluator::default() }, &all);
    let named = |text: &str| {
        let reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
        let report = verified(&all, text, None).unwrap();
        let demands = Demands { conventions: *reader.conventions(), digits: None };
        explain(&report.kept, &report.right, &demands).unwrap().causes.remove(0)
    };
    let stiffness = text.replace("\"penalty_stiffness\":250", "\"penalty_stiffness\":125");
    let cause = named(&stiffness);
    assert_eq!(cause.name, "penalty-stiffness = times 2.000000");
    assert_eq!(cause.words, "the penalty stiffness is 2.000000 times the stated one");
    let product = changed(&text, |line| {
        if let Some(tangent) = line["tangent"].as_array() {
            let g = numbers(line, "d", "gradient");
            let is_active = line["g_N"]["value"].as_f64().unwrap() < 0.0;
            let more = |k: usize| if is_active { 0.7 * 250.0 * g[k / 24] * g[k % 24] } else { 0.0 };
            let tangent: Vec<f64> =
                tangent.iter().enumerate().map(|(k, entry)| entry.as_f64().unwrap() + more(k)).collect();
            line["tangent"] = tangent.into();
        }
    });
    assert_eq!(named(&product).name, "material-stiffness = times 1.700000");
}

/// A program can have an unstated convention, and a wrong term as well.
#[test]
fn unstated_conventions_and_a_wrong_term_are_named_together() {
    let path = exported("nearer.jsonl", &["--family", "hermite", "--cases", "4", "--expected", "none"]);
    let vectors = path.to_str().unwrap();
    let right = scratch("nearer-right.jsonl", "");
    let right = right.to_str().unwrap();
    assert!(run(&["evaluate", vectors, "--plant", "a: d.t,xi = dropped", "-o", right]).status.success());
    let text = std::fs::read_to_string(right).unwrap();
    // Component by component, and the bar beam first.
    let place = |k: usize| (k / 12 * 12 + (k % 4) * 3 + k % 12 / 4 + 12) % 24;
    let others = |text: &str| {
        changed(text, |line| {
            let mut rest = serde_json::json!({ "id": line["id"] });
            for name in ["d", "xi", "xi_bar"].into_iter().filter(|name| line[name].is_object()) {
                let (g, h) = (numbers(line, name, "gradient"), numbers(line, name, "hessian"));
                let g: Vec<f64> = (0..24).map(|i| g[place(i)]).collect();
                let h: Vec<f64> = (0..576).map(|k| h[24 * place(k / 24) + place(k % 24)]).collect();
                rest[name] = serde_json::json!({ "gradient": g, "hessian": h });
            }
            if rest.as_object().unwrap().len() == 1 {
                rest = line.clone();
            }
            *line = rest;
        })
    };
    let answers = scratch("nearer-answers.jsonl", &others(&text));
    let output = run(&["verify", vectors, answers.to_str().unwrap(), "--format", "json"]);
    let document = json(&output);
    let expected = "the dofs come component by component (\"dofs\":\"component-major\") and the dofs of the bar beam \
                    come first (\"beams\":\"bar first\")";
    assert_eq!((&document["agrees_if"], &document["nearer_if"]), (&Value::Null, &expected.into()));
    assert_eq!(document["explanation"]["causes"][0]["name"], "a: d.t,xi = dropped");
    let told = String::from_utf8(run(&["verify", vectors, answers.to_str().unwrap()]).stdout).unwrap();
    assert!(
        told.contains("Fewer numbers are wrong, ") && told.contains("Cause: the term d.t,xi of a"),
        "{told}"
    );
    let (_, verdict) = told.split_once("DISAGREE").unwrap();
    assert!(verdict.lines().all(|line| line.chars().count() <= 80), "{told}");
    // The term alone is explained in the stated conventions.
    let document = json(&run(&["verify", vectors, right, "--format", "json"]));
    assert_eq!(document["nearer_if"], Value::Null);
    assert_eq!(document["explanation"]["causes"][0]["name"], "a: d.t,xi = dropped");
    assert_eq!(other_conventions(&[], &Demands::default()), None);
}

/// What is wrong inside of the Hessian of the gap is named from residual and tangent alone.
#[test]
fn a_term_of_the_gap_is_named_from_residual_and_tangent_alone() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic, Regime::NearEnd], 16));
    let found = |factor: f64| {
        let text =
            changed(&answers(&Evaluator { penalty: Some(1e3), ..Evaluator::default() }, &all), |line| {
                if !line["d"].is_object() {
                    return;
                }
                let [d, gap] = ["d", "g_N"].map(|name| line[name]["value"].as_f64().unwrap());
                let normal = numbers(line, "d", "gradient");
                let force = 1e3 * gap.min(0.0);
                let tangent = line["tangent"].as_array().unwrap().iter().enumerate();
                let product = |k: usize| normal[k / normal.len()] * normal[k % normal.len()];
                let tangent: Vec<f64> = tangent
                    .map(|(k, entry)| entry.as_f64().unwrap() + factor * force * product(k) / d)
                    .collect();
                *line =
                    serde_json::json!({ "id": line["id"], "residual": line["residual"], "tangent": tangent });
            });
        let conventions = *AnswerReader::new(text.as_bytes(), "answers").unwrap().conventions();
        let report = verified(&all, &text, None).unwrap();
        explain(&report.kept, &report.right, &Demands { conventions, digits: None })
    };
    assert!(found(0.0).is_none());
    let words = names(&found(1.0).unwrap()).join("; ");
    assert!(words.contains("in Dd|d|, eq. (40), the term d|d| D|d| is missing"), "{words}");
}

/// Answers of few digits are recognized, and a wrong term is found in them.
#[test]
fn few_digits_are_recognized() {
    let path = exported("few.jsonl", &["--family", "hermite", "--cases", "4", "--expected", "none"]);
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
        assert!(shown.contains("In the catalogue: `a: d.t,xi = dropped`"), "{shown}");
    }
    let document: Value =
        serde_json::from_str(&verified(&with(&text, &six), &["--format", "json"]).1).unwrap();
    assert_eq!(document["answered_digits"], 6);
    // One wrong case is not hidden by many before it that have few digits.
    let lines = with(&text, &six);
    let late: Value = serde_json::from_str(lines.lines().nth(33).unwrap()).unwrap();
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
