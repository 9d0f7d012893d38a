//! Answers that are broken, and programs that fail: nothing passes, and every document says what happened.

use super::conventions::changed;
use super::programs::{exported, scratch};
use super::{answers, drawing, vectors, verified};
use crate::program::{message, run};
use beamgap::check::external::{Demands, Evaluator, VectorReader, VectorWriter, explain};
use beamgap::check::{Family, Regime};
use serde_json::Value;

/// A Hessian whose error vanishes along the directions of the case is wrong.
#[test]
fn errors_that_cancel_along_the_directions_are_detected() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic], 4));
    let text = answers(&Evaluator::default(), &all);
    let case = |line: &Value| all.iter().find(|vector| line["id"] == vector.id).unwrap();
    let cancelled = changed(&text, |line| {
        let [dq, linear_dq] = case(line).directions();
        // Entries (0, 0) and (1, 1), each with the directions of the other.
        let [one, two] = [0, 1].map(|i| dq[i] * linear_dq[i]);
        for (place, error) in [(0, two), (25, -one)] {
            let entry = &mut line["d"]["hessian"][place];
            *entry = (entry.as_f64().unwrap() + error).into();
        }
    });
    let report = verified(&all, &cancelled, None).unwrap();
    assert_eq!(report.wrong, report.compared, "{report:?}");
    assert!(verified(&all, &text, None).unwrap().agrees());
}

/// A factor can be fitted to any single number, so it explains none.
#[test]
fn one_wrong_number_is_not_explained_by_a_factor() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic], 6));
    let mut is_first = true;
    let text = answers(&Evaluator::default(), &all);
    let lines: Vec<String> = text
        .lines()
        .map(|line| {
            let mut line: Value = serde_json::from_str(line).unwrap();
            if line.get("d").is_some() && std::mem::take(&mut is_first) {
                let entry = &mut line["d"]["hessian"][7];
                *entry = (2.0 * entry.as_f64().unwrap() + 0.1).into();
                line = serde_json::json!({ "id": line["id"], "d": { "hessian": line["d"]["hessian"] } });
            }
            line.to_string()
        })
        .collect();
    let report = verified(&all, &lines.join("\n"), None).unwrap();
    assert_eq!(report.wrong, 1);
    let found = explain(&report.kept, &report.right, &Demands::default()).unwrap();
    assert!(found.causes.is_empty(), "{found:?}");
}

/// Where the cause is not known, the first equation that is not satisfied is told.
#[test]
fn where_to_look_is_told_if_the_cause_is_not_known() {
    let path = exported("unknown.jsonl", &["--family", "segment", "--cases", "4", "--regime", "generic"]);
    let vectors = path.to_str().unwrap();
    let evaluated = String::from_utf8(run(&["evaluate", vectors]).stdout).unwrap();
    let text = changed(&evaluated, |line| {
        let Some(gradient) = line["xi"]["gradient"].as_array() else { return };
        let wrong: Vec<f64> = gradient.iter().map(|entry| entry.as_f64().unwrap().sin()).collect();
        *line = serde_json::json!({
            "id": line["id"], "xi": { "gradient": wrong }, "xi_bar": { "gradient": line["xi_bar"]["gradient"] },
        });
    });
    let output = run(&["verify", vectors, scratch("unknown-answers.jsonl", &text).to_str().unwrap()]);
    let told = String::from_utf8(output.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(output.status.code(), Some(1), "{told}");
    for words in ["Cause: not known. ", "Look there: ", "; the equations before it are satisfied."] {
        assert!(told.contains(words), "{words:?} is not in {told}");
    }
}

#[test]
fn a_number_that_is_not_finite_is_wrong_and_named() {
    let path = exported("finite.jsonl", &["--family", "segment", "--cases", "2", "--expected", "none"]);
    let vectors = path.to_str().unwrap();
    let head = "{\"schema\":\"beamgap-answers/1\"}\n";
    for word in ["NaN", "null", "\"inf\""] {
        let text = format!("{head}{{\"id\":\"0\",\"d\":{{\"value\":{word}}}}}\n");
        let output = run(&["verify", vectors, scratch("finite-answers.jsonl", &text).to_str().unwrap()]);
        let told = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(1), "{told}");
        assert!(told.contains("First wrong number: value of d, case 0"), "{told}");
        assert!(
            told.ends_with("Cause: the first wrong number is not finite. Look for a division by zero.\n")
        );
    }
}

/// What a CI job shows is an error too, at the line of the answers if the text is wrong.
#[test]
fn programs_and_texts_that_fail_are_errors_in_every_document() {
    let path = exported("failing.jsonl", &["--family", "segment", "--cases", "2", "--expected", "none"]);
    let vectors = path.to_str().unwrap();
    let right = scratch("failing-right.jsonl", "");
    let right = right.to_str().unwrap();
    assert!(run(&["evaluate", vectors, "-o", right]).status.success());
    let text = std::fs::read_to_string(right).unwrap();
    let cut = scratch("failing-cut.jsonl", &text[..text.len() - 40]);
    let line = text.lines().count();
    let program = format!("sh -c 'head -4 {right}; exit 7'");
    let annotation = format!("::error file={},line={line},", cut.display());
    for (more, told) in [
        (vec!["--run", &program], "::error title=beamgap verify::ERROR: sh: exit status: 7"),
        (vec![cut.to_str().unwrap()], annotation.as_str()),
    ] {
        let files = ["junit", "sarif", "json"].map(|format| scratch(&format!("failing.{format}"), ""));
        let outputs = files
            .iter()
            .map(|path| format!("{}={}", path.extension().unwrap().to_str().unwrap(), path.display()));
        let outputs: Vec<String> = outputs.flat_map(|output| ["--output".to_owned(), output]).collect();
        let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
        let arguments = [&["verify", vectors, "--format", "github"], &more[..], &outputs].concat();
        let output = run(&arguments);
        let shown = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(3), "{shown}");
        assert!(shown.contains(told) && !shown.contains("::notice"), "{told} {shown}");
        let [junit, sarif, json] = files.map(|path| std::fs::read_to_string(path).unwrap());
        assert!(junit.contains("<failure type=\"error\"") && !junit.contains("failures=\"0\""), "{junit}");
        let [sarif, json] = [sarif, json].map(|text| serde_json::from_str::<Value>(&text).unwrap());
        let run = &sarif["runs"][0];
        assert_eq!(run["invocations"][0]["executionSuccessful"], false);
        assert!(!run["results"].as_array().unwrap().is_empty() && json["verdict"] == "error", "{json}");
    }
}

#[test]
fn an_output_replaces_no_input_and_no_other_output() {
    let path = exported("own.jsonl", &["--family", "segment", "--cases", "1", "--expected", "none"]);
    let vectors = path.to_str().unwrap();
    let before = std::fs::read(&path).unwrap();
    let json = format!("json={vectors}");
    let twice = scratch("own-twice", "");
    let [one, two] = ["json", "junit"].map(|format| format!("{format}={}", twice.display()));
    for arguments in [
        vec!["evaluate", vectors, "-o", vectors],
        vec!["verify", vectors, vectors, "--output", &json],
        vec!["verify", vectors, "--run", "true", "--output", &one, "--output", &two],
        vec!["verify", "-", "-"],
        vec!["check", "--case", "0", "--plant", "a: t.t = dropped", "--plant", "a: t.t = sign"],
    ] {
        let output = run(&arguments);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
    }
    assert_eq!(std::fs::read(&path).unwrap(), before);
}

/// Two cases of one name are an error of the cases, not of the answers.
#[test]
fn a_case_has_a_name_of_its_own() {
    let drawing = drawing(&[Family::Segment], &[Regime::Generic], 2);
    let writer = VectorWriter::default();
    let line = writer.line(&drawing.vector(0));
    let text = format!("{}\n{line}\n{}\n{line}\n", writer.head(&drawing), writer.line(&drawing.vector(1)));
    let path = scratch("twice.jsonl", &text);
    let none = scratch("twice-answers.jsonl", "{\"schema\":\"beamgap-answers/1\"}\n");
    let (path, none) = (path.to_str().unwrap(), none.to_str().unwrap());
    let program = format!("cat '{none}'");
    for arguments in [&["verify", path, none][..], &["verify", path, "--run", &program], &["evaluate", path]]
    {
        let output = run(arguments);
        let told = format!("{path}:4: id: a name of its own expected, found \"0\" as in line 2");
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        assert!(message(&output).contains(&told), "{output:?}");
    }
}

/// A radius is not negative, neither in cases for programs nor in a case file.
#[test]
fn a_radius_is_not_negative() {
    let drawing = drawing(&[Family::Segment], &[Regime::Generic], 1);
    let writer = VectorWriter::default();
    let mut line: serde_json::Value = serde_json::from_str(&writer.line(&drawing.vector(0))).unwrap();
    for (radius, expected) in
        [("-0.5", "a number from 0 on expected, found -0.5"), ("inf", "a finite number expected, found inf")]
    {
        line["contact"] = serde_json::json!({ "radius_bar": radius });
        let text = format!("{}\n{line}\n", writer.head(&drawing));
        let mut reader = VectorReader::new(text.as_bytes(), "vectors").unwrap();
        let told = reader.next_vector().unwrap_err().to_string();
        let column = line.to_string().find("radius_bar").unwrap() + "radius_bar\":".len() + 1;
        assert_eq!(told, format!("vectors:2:{column}: radius_bar: {expected}"));
    }
}
