//! Answers of other programs are read in every notation and compared by the same tolerances; what is wrong with them is
//! said.

use crate::command_line::{command, json, run};
use beamgap::check::external::{
    AnswerReader, Conventions, Demands, Drawing, Evaluator, Expected, Formulas, Matching, Report, Vector,
    VectorReader, VectorWriter, explain, other_conventions,
};
use beamgap::check::{Family, Regime};
use beamgap::variant::with_faults;
use proptest::prelude::*;
use std::fmt::Write as _;
use std::io::Write;
use std::path::PathBuf;
use std::process::Stdio;

pub(crate) fn drawing(families: &[Family], regimes: &[Regime], cases: u64) -> Drawing {
    Drawing { seed: 7, regimes: regimes.to_vec(), families: families.to_vec(), cases, penetrating: false }
}

fn vectors(drawing: &Drawing) -> Vec<Vector> {
    (0..drawing.count()).map(|number| drawing.vector(number)).collect()
}

/// What the library answers, as text.
fn answers(evaluator: &Evaluator, vectors: &[Vector]) -> String {
    let lines = vectors.iter().map(|vector| evaluator.line(vector) + "\n");
    format!("{}\n{}", evaluator.head(), lines.collect::<String>())
}

/// What is found of a text of answers.
fn verified(vectors: &[Vector], text: &str, digits: Option<u8>) -> Result<Report, String> {
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").map_err(|error| error.to_string())?;
    let demands = Demands { conventions: *reader.conventions(), digits };
    let (mut matching, mut vectors) = (Matching::new(demands, 64), vectors.iter().cloned());
    let mut next = || Ok::<_, beamgap::check::external::ExternalError>(vectors.next());
    while let Some(answers) = reader.next_answers().map_err(|error| error.to_string())? {
        matching.take(answers, &mut next).map_err(|error| error.to_string())?;
    }
    matching.finish(next).map_err(|error| error.to_string())
}

/// The text with entries added to its head.
fn with_head(text: &str, entries: &str) -> String {
    text.replacen('}', &format!(",{entries}}}"), 1)
}

#[test]
fn cases_are_read_back_to_the_last_bit() {
    let drawing = drawing(&Family::ALL, &Regime::ALL, 7);
    let all = vectors(&drawing);
    for hex in [false, true] {
        for expected in [Expected::None, Expected::All] {
            let writer = VectorWriter { hex, expected };
            let lines = all.iter().map(|vector| writer.line(vector) + "\n");
            let text = format!("{}\n{}", writer.head(&drawing), lines.collect::<String>());
            let mut reader = VectorReader::new(text.as_bytes(), "vectors").unwrap();
            for vector in &all {
                let read = reader.next_vector().unwrap().unwrap();
                assert_eq!(Vector { place: None, ..read }, *vector);
            }
            assert_eq!(reader.next_vector().unwrap(), None);
        }
    }
}

#[test]
fn the_library_agrees_with_itself_in_all_formulations_and_notations() {
    let all = vectors(&drawing(&Family::ALL, &Regime::ALL, 6));
    for formulas in [Formulas::Chosen, Formulas::Paper] {
        for hex in [false, true] {
            let writer = VectorWriter { hex, expected: Expected::None };
            let evaluator = Evaluator { formulas, writer, ..Evaluator::default() };
            let report = verified(&all, &answers(&evaluator, &all), None).unwrap();
            assert!(report.agrees() && report.missing == 0, "{report:?}");
            assert!(report.compared >= 50 && report.never_answered().is_empty());
        }
    }
}

#[test]
fn a_loss_of_digits_is_told_and_fails_only_if_digits_are_asked_for() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::NearlyCrossing], 20));
    let paper = Evaluator { formulas: Formulas::Paper, ..Evaluator::default() };
    let text = answers(&paper, &all);
    let report = verified(&all, &text, None).unwrap();
    let loss = report.regimes["nearly-crossing"].loss.clone().unwrap();
    assert!(report.agrees() && loss.digits() > 2.0, "{loss:?}");
    assert!(!verified(&all, &text, Some(12)).unwrap().agrees());
    let best = answers(&Evaluator::default(), &all);
    assert!(verified(&all, &best, Some(12)).unwrap().agrees());
}

#[test]
fn six_digits_are_enough_if_six_are_asked_for() {
    let all = vectors(&drawing(&[Family::Hermite, Family::Arc], &[Regime::Generic], 16));
    let rounded = Evaluator { digits: Some(6), ..Evaluator::default() };
    let text = answers(&rounded, &all);
    assert!(verified(&all, &text, Some(6)).unwrap().agrees());
    assert!(!verified(&all, &text, None).unwrap().agrees());
}

#[test]
fn what_is_not_answered_is_told() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 10));
    let text = answers(&Evaluator::default(), &all);
    let some: String =
        text.lines().enumerate().filter(|(i, _)| i % 3 == 0).map(|(_, l)| l.to_owned() + "\n").collect();
    let report = verified(&all, &some, None).unwrap();
    assert_eq!((report.vectors, report.compared, report.missing), (10, 3, 7));
    assert_eq!(report.first_missing.as_deref(), Some("0"));
    // In another order, and one that says that there is nothing.
    let mut lines: Vec<&str> = text.lines().collect();
    lines[1..].reverse();
    lines[5] = "{\"id\":5,\"result\":\"degenerate\"}";
    let report = verified(&all, &lines.join("\n"), None).unwrap();
    assert_eq!((report.compared, report.unanswered, report.missing), (9, 1, 0));
    // Twice, or of no case.
    let twice = format!("{text}{}\n", lines[3]);
    assert!(
        verified(&all, &twice, None).unwrap_err().contains("a case that is still open expected, found \"7\"")
    );
    // The value alone.
    let value = "{\"schema\":\"beamgap-answers/1\"}\n{\"id\":\"0\",\"d\":1e3,\"x\":{\"value\":[0,0,0]}}\n";
    let report = verified(&all, value, None).unwrap();
    assert_eq!((report.wrong, report.parts.len()), (1, 2));
}

#[test]
fn csv_says_the_same_as_json() {
    let all = vectors(&drawing(&[Family::Quadratic], &[Regime::Generic], 4));
    let text = answers(&Evaluator::default(), &all);
    let mut csv = "# schema = beamgap-answers/1\r\n# first_index = 1\r\ncase,quantity,value\r\n".to_owned();
    for line in text.lines().skip(1) {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        let (id, d) = (line["id"].as_str().unwrap(), &line["d"]);
        let _ = write!(csv, "{id},d,{}\r\n", d["value"]);
        // As Fortran prints it.
        let delta = format!("{:.16e}", line["xi"]["delta"].as_f64().unwrap()).replace('e', "D");
        let _ = write!(csv, "{id}, xi:delta, {delta}\r\n");
        for i in 0..18 {
            let _ = write!(csv, "{id},d:gradient:{},{}\r\n", i + 1, d["gradient"][i]);
            for j in 0..18 {
                let _ = write!(csv, "{id},d:hessian:{}:{},{}\r\n", i + 1, j + 1, d["hessian"][18 * i + j]);
            }
        }
    }
    let report = verified(&all, &csv, None).unwrap();
    assert!(report.agrees() && report.compared == 4 && report.parts.len() == 4, "{report:?}");
    let wrong = csv.replacen("0,d:hessian:3:4,", "0,d:hessian:3:4,1", 1);
    assert_eq!(verified(&all, &wrong, None).unwrap().wrong, 1);
    let missing: String = csv
        .lines()
        .filter(|line| !line.starts_with("1,d:gradient:5,"))
        .map(|l| l.to_owned() + "\n")
        .collect();
    let told = verified(&all, &missing, None).unwrap_err();
    assert!(told.contains("case 1: d:gradient: 18 entries expected for 18 dofs, found 17"), "{told}");
}

#[test]
fn errors_say_where_and_what_was_expected() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 2));
    let head = "{\"schema\":\"beamgap-answers/1\"}\n";
    for (text, expected) in [
        (String::new(), "answers:1:1: a head {\"schema\":\"beamgap-answers/1\", ..} expected"),
        (
            "{\"schema\":\"other\"}".into(),
            "answers:1:11: schema: \"beamgap-answers/1\" expected, found \"other\"",
        ),
        (
            "{\"schema\":\"beamgap-answers/1\",\"paramter\":\"x\"}".into(),
            "answers:1:42: paramter: no such entry",
        ),
        (
            "{\"schema\":\"beamgap-answers/1\",\"parameter\":\"[0,2]\"}".into(),
            "parameter: one of [\"[-1,1]\", \"[0,1]\"] expected",
        ),
        (
            format!("{head}{{\"id\":\"0\",\"d\":{{\"value\":abc}}}}\n"),
            "answers:2:24: a number expected, found \"abc\"",
        ),
        (
            format!("{head}{{\"id\":\"0\",\"d\":{{\"gradient\":[1,2]}}}}\n"),
            "answers:2: case 0: gradient of d: 12 numbers expected, found 2",
        ),
        (format!("{head}{{\"id\":\"0\",\"e\":1}}\n"), "answers:2:15: one of x, x_bar,"),
        (
            format!("{head}{{\"id\":\"0\",\"d\":{{\"values\":1}}}}\n"),
            "one of value, gradient, hessian, delta, Delta, Delta-delta expected",
        ),
        (format!("{head}{{\"d\":1}}\n"), "answers:2:1: id expected, found none"),
        (
            format!("{head}{{\"id\":\"0\",\"d\":1"),
            "answers:2:16: a comma or a closing brace expected, found the end of the line",
        ),
        (format!("{head}{{\"id\":\"0\",\"residual\":[1]}}"), "penalty_stiffness expected in the head"),
        (
            "# schema = beamgap-answers/1\nquantity,value\n".into(),
            "answers:2:1: the titles `case,quantity,value`",
        ),
        ("# schema = beamgap-answers/1\ncase,quantity,value\n0,d,1,2\n".into(), "answers:3:1: three cells"),
        (
            "# schema = beamgap-answers/1\ncase,quantity,value\n0,d,*****\n".into(),
            "answers:3:5: a number expected, found asterisks",
        ),
        (
            "# schema = beamgap-answers/1\ncase,quantity,value\n0,d:hessian:1,1\n".into(),
            "2 indices expected, found 1",
        ),
        (
            "# schema = beamgap-answers/1\ncase,quantity,value\n0,d,1\n1,d,1\n0,d,1\n".into(),
            "answers:5:1: the rows of case \"0\" expected one after another",
        ),
        (
            "case,quantity,value\n".into(),
            "a comment `# schema = beamgap-answers/1` expected before the titles",
        ),
    ] {
        let told = verified(&all, &text, None).unwrap_err();
        assert!(told.contains(expected), "{told}\n{expected}");
    }
}

#[test]
fn numbers_that_are_none_are_wrong() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 3));
    for word in ["NaN", "null", "\"-inf\"", "Infinity"] {
        let text = format!(
            "{{\"schema\":\"beamgap-answers/1\"}}\n{{\"id\":\"0\",\"d\":{{\"gradient\":[{word},0,0,0,0,0,0,0,0,0,0,0]}}}}\n"
        );
        assert_eq!(verified(&all, &text, None).unwrap().wrong, 1, "{word}");
    }
}

/// The answers of the library with the numbers of a quantity changed.
fn changed(text: &str, change: impl Fn(&mut serde_json::Value)) -> String {
    let mut lines = text.lines();
    let mut changed = lines.next().unwrap().to_owned() + "\n";
    for line in lines {
        let mut line: serde_json::Value = serde_json::from_str(line).unwrap();
        change(&mut line);
        let _ = writeln!(changed, "{line}");
    }
    changed
}

fn map(value: &mut serde_json::Value, f: &dyn Fn(f64) -> f64) {
    match value {
        serde_json::Value::Array(values) => values.iter_mut().for_each(|value| map(value, f)),
        other => *other = f(other.as_f64().unwrap()).into(),
    }
}

#[test]
fn other_conventions_are_converted_if_they_are_stated_and_named_if_not() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic], 6));
    let text = answers(&Evaluator::default(), &all);
    let parts = ["delta", "Delta", "Delta-delta", "gradient", "hessian"];
    let unit = changed(&text, |line| {
        for name in ["xi", "xi_bar"] {
            map(&mut line[name]["value"], &|xi| 0.5 * (xi + 1.0));
            for part in &parts {
                map(&mut line[name][part], &|x| 0.5 * x);
            }
        }
        for name in ["t", "t_bar"] {
            map(&mut line[name]["value"], &|x| 2.0 * x);
            for part in &parts {
                map(&mut line[name][part], &|x| 2.0 * x);
            }
        }
        for name in
            ["t_vector", "t_bar_vector"].iter().flat_map(|v| ["x", "y", "z"].map(|c| format!("{v}.{c}")))
        {
            map(&mut line[&name]["value"], &|x| 2.0 * x);
            for part in &parts[..3] {
                map(&mut line[&name][part], &|x| 2.0 * x);
            }
        }
    });
    let negative = changed(&text, |line| {
        for name in ["x", "y", "z"].map(|c| format!("d_vector.{c}")) {
            for part in ["value", "delta", "Delta", "Delta-delta"] {
                map(&mut line[&name][part], &|x| -x);
            }
        }
    });
    let square = changed(&text, |line| {
        let d = line["d"].clone();
        let of = |part: &str| d[part].as_f64().unwrap();
        let list =
            |part: &str| d[part].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>();
        let (value, gradient, hessian) = (of("value"), list("gradient"), list("hessian"));
        let hessian: Vec<f64> =
            (0..576).map(|k| 2.0 * (gradient[k / 24] * gradient[k % 24] + value * hessian[k])).collect();
        line["d"] = serde_json::json!({
            "value": value * value,
            "delta": 2.0 * value * of("delta"),
            "Delta-delta": 2.0 * (of("delta") * of("Delta") + value * of("Delta-delta")),
            "gradient": gradient.iter().map(|g| 2.0 * value * g).collect::<Vec<_>>(),
            "hessian": hessian,
        });
    });
    // Of the dof k of the program the place among ours.
    let reordered = |place: &dyn Fn(usize) -> usize, factor: &dyn Fn(usize) -> f64| {
        changed(&text, |line| {
            for name in ["d", "t", "t_bar", "xi", "xi_bar", "g_N", "g_T", "g_T_bar"] {
                let of = line[name].clone();
                let at = |part: &str, k: usize| of[part][k].as_f64().unwrap();
                let gradient: Vec<f64> =
                    (0..24).map(|k| at("gradient", place(k)) * factor(place(k))).collect();
                let entry = |k: usize| {
                    let (i, j) = (place(k / 24), place(k % 24));
                    at("hessian", 24 * i + j) * factor(i) * factor(j)
                };
                line[name]["gradient"] = gradient.into();
                line[name]["hessian"] = (0..576).map(entry).collect::<Vec<f64>>().into();
            }
        })
    };
    let one = |_: usize| 1.0;
    let by_component = reordered(&|k| k / 12 * 12 + (k % 12 % 4) * 3 + k % 12 / 4, &one);
    let bar_first = reordered(&|k| (k + 12) % 24, &one);
    let tangents = reordered(&|k| k, &|k| if k % 6 >= 3 { 0.5 } else { 1.0 });
    for (text, head, words) in [
        (unit, "\"parameter\":[0,1]", "the parameters run over [0,1]"),
        (negative, "\"d\":\"x_bar - x\"", "d is x_bar - x"),
        (square, "\"distance\":\"d^2\"", "d is the squared distance"),
        (by_component, "\"dofs\":\"component-major\"", "the dofs come component by component"),
        (bar_first, "\"beams\":\"bar first\"", "the dofs of the bar beam come first"),
        (tangents, "\"hermite_tangent\":0.5", "dx/dxi is 0.5 times the tangent dofs"),
    ] {
        let stated = verified(&all, &with_head(&text, head), None).unwrap();
        assert!(stated.agrees(), "{head}: {:?}", stated.first);
        let silent = verified(&all, &text, None).unwrap();
        assert!(silent.wrong > 0, "{head}");
        let told = other_conventions(&silent.kept, &Demands::default()).unwrap();
        assert!(told.contains(words), "{head}: {told}");
    }
}

#[test]
fn two_wrong_conventions_are_named_together() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 6));
    let text = changed(&answers(&Evaluator::default(), &all), |line| {
        let xi = line["xi"]["value"].as_f64().unwrap();
        let d: Vec<f64> = ["x", "y", "z"]
            .iter()
            .map(|c| -line[&format!("d_vector.{c}")]["value"].as_f64().unwrap())
            .collect();
        *line = serde_json::json!({ "id": line["id"], "xi": 0.5 * (xi + 1.0), "d_vector": d });
    });
    let report = verified(&all, &text, None).unwrap();
    let told = other_conventions(&report.kept, &Demands::default()).unwrap();
    assert_eq!(told, "the parameters run over [0,1] (parameter) and d is x_bar - x (d)");
    assert_eq!(other_conventions(&[], &Demands { conventions: Conventions::default(), digits: None }), None);
}

#[test]
fn a_contact_element_is_checked_by_its_residual_and_tangent() {
    let mut drawing = drawing(&[Family::Hermite], &[Regime::Generic], 8);
    drawing.penetrating = true;
    let all = vectors(&drawing);
    let element = Evaluator { penalty: Some(250.0), ..Evaluator::default() };
    let only = |text: &str, tangent: &dyn Fn(&serde_json::Value, usize) -> f64| {
        changed(text, |line| {
            let of: Vec<f64> = (0..576).map(|k| tangent(line, k)).collect();
            *line = serde_json::json!({ "id": line["id"], "residual": line["residual"], "tangent": of });
        })
    };
    let text = answers(&element, &all);
    let right = only(&text, &|line, k| line["tangent"][k].as_f64().unwrap());
    let report = verified(&all, &right, None).unwrap();
    assert!(report.agrees() && report.parts.len() == 2, "{report:?}");
    // Without the geometric part.
    let gauss_newton = only(&text, &|line, k| {
        let g = |i: usize| line["d"]["gradient"][i].as_f64().unwrap();
        250.0 * g(k / 24) * g(k % 24)
    });
    let report = verified(&all, &gauss_newton, None).unwrap();
    let reader = AnswerReader::new(gauss_newton.as_bytes(), "answers").unwrap();
    let found = explain(&report.kept, &Demands { conventions: *reader.conventions(), digits: None }).unwrap();
    assert_eq!(found.causes[0].name, "geometric-stiffness-missing", "{found:?}");
    // With the other sign.
    let negative = only(&text, &|line, k| -line["tangent"][k].as_f64().unwrap());
    assert!(verified(&all, &with_head(&negative, "\"tangent_sign\":\"-\""), None).unwrap().agrees());
    let report = verified(&all, &negative, None).unwrap();
    let demands = Demands { conventions: *reader.conventions(), digits: None };
    assert!(other_conventions(&report.kept, &demands).unwrap().contains("the tangent has the other sign"));
}

/// What explains the answers of a program with these faults.
fn cause(all: &[Vector], faults: &[&str], digits: Option<u8>) -> String {
    let names: Vec<String> = faults.iter().map(|fault| (*fault).to_owned()).collect();
    let variant = with_faults(&names).unwrap();
    let program = Evaluator {
        variant,
        formulas: Formulas::Paper,
        digits: digits.map(usize::from),
        ..Evaluator::default()
    };
    let report = verified(all, &answers(&program, all), digits).unwrap();
    let found = explain(&report.kept, &Demands { digits, ..Demands::default() }).unwrap();
    found.causes.into_iter().map(|cause| cause.name).collect::<Vec<_>>().join(", ")
}

#[test]
fn the_wrong_term_is_named() {
    let all = vectors(&drawing(&[Family::Quadratic], &[Regime::Generic], 6));
    for fault in [
        "a: d.t,xi = dropped",
        "Dd|d|: d.du,xi Dxi = sign",
        "H_d: b gg_bar' = doubled",
        "R2: t.rest = halved",
    ] {
        assert_eq!(cause(&all, &[fault], None), fault);
    }
    assert_eq!(cause(&all, &["a_bar: d.t_bar,xi = sign"], Some(6)), "a_bar: d.t_bar,xi = sign");
}

#[test]
fn two_wrong_terms_are_named() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 6));
    let faults = ["b: t.t_bar = halved", "Dd|t|: Dt.dt = dropped"];
    let variant = with_faults(&faults.map(ToOwned::to_owned)).unwrap();
    let program = Evaluator { variant, formulas: Formulas::Paper, ..Evaluator::default() };
    let text = changed(&answers(&program, &all), |line| {
        let only = |name: &str| {
            let parts = ["delta", "Delta", "Delta-delta"];
            let [delta, linear, second] = parts.map(|part| line[name][part].clone());
            serde_json::json!({ "delta": delta, "Delta": linear, "Delta-delta": second })
        };
        let (xi, xi_bar, t) = (only("xi"), only("xi_bar"), only("t"));
        *line = serde_json::json!({ "id": line["id"], "xi": xi, "xi_bar": xi_bar, "t": t });
    });
    let report = verified(&all, &text, None).unwrap();
    let found = explain(&report.kept, &Demands::default()).unwrap();
    assert_eq!(found.causes[0].name, faults.join(" and "), "{found:?}");
}

#[test]
fn two_wrong_terms_of_one_quantity_are_named() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 6));
    let faults = ["Dd|d|: du_hat.t Dxi = dropped", "Dd|d|: dd Dd = sign"];
    let variant = with_faults(&faults.map(ToOwned::to_owned)).unwrap();
    let program = Evaluator { variant, formulas: Formulas::Paper, ..Evaluator::default() };
    let text = changed(&answers(&program, &all), |line| {
        let d = serde_json::json!({ "Delta-delta": line["d"]["Delta-delta"] });
        *line = serde_json::json!({ "id": line["id"], "d": d });
    });
    let report = verified(&all, &text, None).unwrap();
    let found = explain(&report.kept, &Demands::default()).unwrap();
    assert!(found.causes.iter().any(|cause| cause.name == faults.join(" and ")), "{found:?}");
}

#[test]
fn gradients_and_hessians_of_few_digits_tell_terms_apart() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 6));
    let arrays = |fault: &str| {
        let variant = with_faults(&[fault.to_owned()]).unwrap();
        let program =
            Evaluator { variant, formulas: Formulas::Paper, digits: Some(6), ..Evaluator::default() };
        let text = changed(&answers(&program, &all), |line| {
            let d = serde_json::json!({ "gradient": line["d"]["gradient"], "hessian": line["d"]["hessian"] });
            *line = serde_json::json!({ "id": line["id"], "d": d });
        });
        let report = verified(&all, &text, Some(6)).unwrap();
        let found = explain(&report.kept, &Demands { digits: Some(6), ..Demands::default() }).unwrap();
        assert!(!found.is_faint);
        found.causes.into_iter().map(|cause| cause.name).collect::<Vec<_>>()
    };
    assert_eq!(arrays("H_d: a gg' = sign"), ["H_d: a gg' = sign"]);
    assert_eq!(arrays("H_d: A0'A0 = doubled"), ["H_d: A0'A0 = doubled"]);
}

/// Straight beams keep the terms of curvature at zero: a fault in them is none here.
#[test]
fn a_cause_is_not_named_where_nothing_is_wrong() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 1));
    let text = answers(&Evaluator { formulas: Formulas::Paper, ..Evaluator::default() }, &all);
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
    let cases: Vec<_> =
        all.iter().map(|vector| (vector.clone(), reader.next_answers().unwrap().unwrap())).collect();
    let found = explain(&cases, &Demands::default()).unwrap();
    assert!(found.is_faint && found.causes.is_empty(), "{found:?}");
}

#[test]
fn simplifications_and_factors_are_named() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic], 8));
    let text = answers(&Evaluator { formulas: Formulas::Paper, ..Evaluator::default() }, &all);
    let named = |text: &str| {
        let report = verified(&all, text, None).unwrap();
        explain(&report.kept, &Demands::default()).unwrap()
    };
    let third = changed(&text, |line| {
        *line = serde_json::json!({ "id": line["id"], "d": line["d"]["value"], "xi": {
            "delta": line["xi"]["delta"].as_f64().unwrap() / 3.0, "Delta": line["xi"]["Delta"].as_f64().unwrap() / 3.0 } });
    });
    assert_eq!(named(&third).causes[0].name, "first of xi = times 0.333333");
    let random = changed(&text, |line| {
        let delta = (line["xi"]["delta"].as_f64().unwrap() * 1e3).sin();
        *line = serde_json::json!({ "id": line["id"], "xi": { "delta": delta } });
    });
    let found = named(&random);
    assert!(found.causes.is_empty() && found.runner_up.is_some(), "{found:?}");
}

fn scratch(name: &str, text: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn exported(name: &str, more: &[&str]) -> PathBuf {
    let path = scratch(name, "");
    let output = run(&[&["export", "-o", path.to_str().unwrap()], more].concat());
    assert!(output.status.success(), "{output:?}");
    path
}

#[test]
fn a_program_is_run_and_its_exit_status_time_and_words_are_told() {
    let path = exported("run.jsonl", &["--family", "segment", "--cases", "3", "--expected", "none"]);
    let vectors = path.to_str().unwrap();
    let own = format!("'{}' evaluate", env!("CARGO_BIN_EXE_beamgap"));
    let verify = |program: &str, more: &[&str]| {
        let output = run(&[&["verify", vectors, "--run", program], more].concat());
        let told = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), told(&output.stdout), told(&output.stderr))
    };
    let (code, text, _) = verify(&own, &[]);
    assert!(code == Some(0) && text.contains("AGREES: at "), "{text}");
    let (code, text, _) = verify(&format!("{own} --plant 'b: t.t_bar = halved'"), &[]);
    assert!(
        code == Some(1) && text.contains("Cause: the term t.t_bar of b, eq. (50), counts half"),
        "{text}"
    );
    assert!(
        text.contains("`b: t.t_bar = halved`") && text.contains("Entry of the gradient that differs most: ["),
        "{text}"
    );
    for (program, expected) in [
        (
            "sh -c 'echo broken >&2; exit 7'",
            "exit status: 7, after 0 answers\nIts standard error ends:\nbroken",
        ),
        ("sh -c 'echo no; cat >/dev/null'", "standard output of sh:1:1: the titles `case,quantity,value`"),
        ("/no/such/program", "cannot start /no/such/program"),
        ("sh -c 'exit", "a program, with its arguments, expected"),
        ("true", "expected, found the end of the text"),
    ] {
        let (code, _, told) = verify(program, &[]);
        assert!(code == Some(3) && told.contains(expected), "{program}: {told}");
    }
    let (code, _, told) = verify("sleep 30", &["--time-out", "1"]);
    assert!(code == Some(3) && told.contains("no answer within 1 s"), "{told}");
}

#[test]
fn results_are_written_for_programs_too() {
    let path = exported("json.jsonl", &["--family", "hermite", "--cases", "2", "--expected", "all"]);
    let answers = scratch("json-answers.jsonl", "");
    let (vectors, answered) = (path.to_str().unwrap(), answers.to_str().unwrap());
    let output = run(&["evaluate", vectors, "--plant", "a: t.t = doubled", "-o", answered]);
    assert!(output.status.success(), "{output:?}");
    let output = run(&["verify", vectors, answered, "--format", "json"]);
    let document = json(&output);
    assert_eq!((output.status.code(), &document["verdict"]), (Some(1), &"disagree".into()));
    assert_eq!(document["schema"], "beamgap-verify/1");
    assert_eq!(document["explanation"]["causes"][0]["name"], "a: t.t = doubled");
    assert!(
        document["first"]["line"].as_u64().unwrap() >= 2 && document["first"]["entry"]["of"] == "gradient"
    );
    // What is expected is accepted as an answer.
    let text = std::fs::read_to_string(&path).unwrap();
    let mut expected = "{\"schema\":\"beamgap-answers/1\"}\n".to_owned();
    for line in text.lines().skip(1) {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        let mut answer = line["expected"].clone();
        if answer.is_object() {
            answer["id"] = line["id"].clone();
            let _ = writeln!(expected, "{answer}");
        }
    }
    let expected = scratch("json-expected.jsonl", &expected);
    let output = run(&["verify", vectors, expected.to_str().unwrap(), "--format", "json"]);
    assert_eq!(json(&output)["verdict"], "agree", "{output:?}");
    // Nothing compared is no success.
    let none = scratch("json-none.jsonl", "{\"schema\":\"beamgap-answers/1\"}\n");
    let output = run(&["verify", vectors, none.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(4), "{output:?}");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child = command(&["evaluate"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let all = drawing(&[Family::Segment], &[Regime::Generic], 30);
    let writer = VectorWriter::default();
    let mut stdin = child.stdin.take().unwrap();
    let _ = writeln!(stdin, "{}", writer.head(&all));
    for vector in vectors(&all) {
        let _ = writeln!(stdin, "{}", writer.line(&vector));
    }
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn no_bytes_make_the_readers_panic(bytes in prop::collection::vec(any::<u8>(), 0..200), at in 0.0..1.0, is_csv in any::<bool>()) {
        let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 1));
        let json = answers(&Evaluator::default(), &all);
        let csv = "# schema = beamgap-answers/1\ncase,quantity,value\n0,d,1\n0,d:gradient:0,1\n".to_owned();
        let mut text = if is_csv { csv } else { json }.into_bytes();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "a place in a text")]
        let start = (at * text.len() as f64) as usize;
        let end = (start + bytes.len() / 2).min(text.len());
        text.splice(start..end, bytes.iter().copied());
        if let Ok(mut reader) = AnswerReader::new(&text[..], "answers") {
            while let Ok(Some(_)) = reader.next_answers() {}
        }
        let writer = VectorWriter::default();
        let mut text = format!("{}\n{}\n", writer.head(&drawing(&[Family::Segment], &[Regime::Generic], 1)), writer.line(&all[0])).into_bytes();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "a place in a text")]
        let start = (at * text.len() as f64) as usize;
        let end = (start + bytes.len() / 2).min(text.len());
        text.splice(start..end, bytes);
        if let Ok(mut reader) = VectorReader::new(&text[..], "vectors") {
            while let Ok(Some(vector)) = reader.next_vector() {
                let _ = vector.outcome();
            }
        }
    }
}
