//! Errors of hand-written matrix formulas that are no faults of single terms of the closed form.

use super::conventions::{changed, map};
use super::programs::{exported, scratch};
use super::{answers, drawing, vectors, verified};
use crate::program::{json, run};
use beamgap::check::external::{AnswerReader, Demands, Evaluator, Explanation, explain, other_conventions};
use beamgap::check::{Family, Regime};
use serde_json::Value;
use std::cell::Cell;

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
        let cause = "in d|d|, eq. (37), the division by |d| is left out, in Dd|d| alone";
        assert_eq!(names(&found)[0], cause, "{found:?}");
    }
}

#[test]
fn a_held_parameter_that_is_moved_is_named() {
    let moved = Cell::new(0);
    let found = explained(None, |line| {
        if line["xi"]["value"].as_f64().is_some_and(|xi| xi.abs() >= 1.0) {
            line["xi"]["value"] = 0.9.into();
            moved.set(moved.get() + 1);
        }
    });
    assert!(moved.get() > 1, "{} cases with a held parameter", moved.get());
    let cause = names(&found).first().copied().unwrap_or_default();
    assert!(cause.starts_with("xi is held at an end of its beam"), "{found:?}");
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
    let mut drawing = drawing(&[Family::Hermite], &[Regime::Generic], 4);
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
    let drawn = ["--family", "hermite", "--cases", "6", "--regime", "generic", "--regime", "near-end"];
    let path = exported("nearer.jsonl", &[&drawn[..], &["--expected", "none"]].concat());
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
    let wrong_term = "in a, eq. (50), the term d.t,xi is missing";
    assert_eq!(document["explanation"]["causes"][0]["name"], wrong_term);
    let told = String::from_utf8(run(&["verify", vectors, answers.to_str().unwrap()]).stdout).unwrap();
    assert!(
        told.contains("Fewer numbers are wrong, ") && told.contains("Cause: in a, eq. (50), the term"),
        "{told}"
    );
    let (_, verdict) = told.split_once("DISAGREE").unwrap();
    assert!(verdict.lines().all(|line| line.chars().count() <= 80), "{told}");
    // The term alone is explained in the stated conventions.
    let document = json(&run(&["verify", vectors, right, "--format", "json"]));
    assert_eq!(document["nearer_if"], Value::Null);
    assert_eq!(document["explanation"]["causes"][0]["name"], wrong_term);
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

/// A number that is wrong by another factor in each case is no term that is missing or doubled. Its term is told.
#[test]
fn a_term_with_a_factor_of_its_own_in_each_case_is_told() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic], 8));
    let text = changed(&answers(&Evaluator::default(), &all), |line| {
        let Some(xi) = line["xi"]["value"].as_f64() else { return };
        let wrong: Vec<f64> = numbers(line, "xi", "gradient").iter().map(|x| (1.5 + 0.3 * xi) * x).collect();
        *line = serde_json::json!({
            "id": line["id"], "xi": { "gradient": wrong }, "xi_bar": { "gradient": line["xi_bar"]["gradient"] },
        });
    });
    let report = verified(&all, &text, None).unwrap();
    let found = explain(&report.kept, &report.right, &Demands::default()).unwrap();
    let words = names(&found).join("; ");
    let told = "the residual is the term b^2 of D times a factor that differs from case to case";
    assert_eq!(words, told);
    assert!(found.beyond.is_empty(), "{found:?}");
}

/// A gap without a radius changes at which cases the beams touch, and the force. It is named from residual and tangent alone.
#[test]
fn a_radius_that_is_missing_in_the_gap_is_named_from_residual_and_tangent_alone() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic, Regime::NearEnd], 16));
    let text = changed(&answers(&Evaluator { penalty: Some(1e3), ..Evaluator::default() }, &all), |line| {
        let Some(vector) = all.iter().find(|vector| line["id"] == vector.id.as_str()) else { return };
        let gap = line["g_N"]["value"].as_f64().unwrap() + vector.case.contact.radius_bar;
        let [gradient, hessian] = ["gradient", "hessian"].map(|part| numbers(line, "d", part));
        let stiffness = if gap < 0.0 { 1e3 } else { 0.0 };
        let residual: Vec<f64> = gradient.iter().map(|x| stiffness * gap * x).collect();
        let product = |k: usize| gradient[k / gradient.len()] * gradient[k % gradient.len()];
        let tangent = hessian.iter().enumerate().map(|(k, h)| stiffness * (product(k) + gap * h));
        let tangent: Vec<f64> = tangent.collect();
        *line = serde_json::json!({ "id": line["id"], "residual": residual, "tangent": tangent });
    });
    let conventions = *AnswerReader::new(text.as_bytes(), "answers").unwrap().conventions();
    let report = verified(&all, &text, None).unwrap();
    let found = explain(&report.kept, &report.right, &Demands { conventions, digits: None }).unwrap();
    let words = names(&found).join("; ");
    assert!(words.contains("r_bar is missing"), "{words}");
}
