//! Everything that is asked is answered and compared: what is left out is red, and a wrong program is never left out.

use super::conventions::changed;
use super::programs::{exported, scratch};
use super::{drawing, vectors, with_head};
use crate::program::{json, run};
use beamgap::check::external::Outcome;
use beamgap::check::{Family, Regime};
use serde_json::Value;
use std::path::Path;

/// Cases of every regime, with the answers of the library.
pub(super) fn answered(name: &str, more: &[&str]) -> (String, String) {
    let vectors = exported(&format!("{name}-vectors.jsonl"), &["--family", "segment", "--cases", "4"]);
    let vectors = vectors.to_str().unwrap().to_owned();
    let to = scratch(&format!("{name}-right.jsonl"), "");
    let to = to.to_str().unwrap();
    assert!(run(&[&["evaluate", &vectors, "-o", to], more].concat()).status.success());
    let text = std::fs::read_to_string(to).unwrap();
    (vectors, text)
}

/// The exit code, and the verdict with all that follows it, without a search for the cause.
pub(super) fn told(vectors: &str, name: &str, text: &str, more: &[&str]) -> (Option<i32>, String) {
    explained(vectors, name, text, &[&["--no-explanation"], more].concat())
}

/// The exit code, and the verdict with all that follows it.
pub(super) fn explained(vectors: &str, name: &str, text: &str, more: &[&str]) -> (Option<i32>, String) {
    let path = scratch(&format!("{name}-answers.jsonl"), text);
    let output = run(&[&["verify", vectors, path.to_str().unwrap()], more].concat());
    let shown = String::from_utf8(output.stdout).unwrap();
    let verdicts = ["\nAGREE", "\nDISAGREE", "\nINCOMPLETE", "\nNOTHING COMPARED"];
    let start = verdicts.iter().filter_map(|verdict| shown.rfind(verdict)).max();
    let verdict = start.map_or_else(|| shown.clone(), |start| shown[start + 1..].replace("\n  ", " "));
    (output.status.code(), verdict + &String::from_utf8_lossy(&output.stderr))
}

pub(super) fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

/// The answers with another digit in front of their first `count` values.
pub(super) fn spoiled(text: &str, count: usize) -> String {
    let (first, rest) = text.split_once("\"value\":").unwrap();
    let spoil = |(i, after): (usize, &str)| {
        let (sign, number) = after.strip_prefix('-').map_or(("", after), |number| ("-", number));
        let digit = if i < count { "1" } else { "" };
        format!("\"value\":{sign}{digit}{number}")
    };
    std::iter::once(first.to_owned()).chain(rest.split("\"value\":").enumerate().map(spoil)).collect()
}

#[test]
fn a_case_without_an_answer_is_red_unless_it_is_allowed() {
    let (vectors, text) = answered("cut", &[]);
    let (code, verdict) = told(&vectors, "cut", &text, &[]);
    assert!(code == Some(0) && verdict.starts_with("AGREE: at 40 closest points nothing"), "{verdict}");
    let some: String = text.lines().take(18).map(|line| line.to_owned() + "\n").collect();
    let (code, verdict) = told(&vectors, "cut", &some, &[]);
    let expected = "INCOMPLETE: no answer to 23 of 40 cases: the answers end after case 16.";
    assert_eq!((code, first_line(&verdict)), (Some(4), expected), "{verdict}");
    let (code, verdict) = told(&vectors, "cut", &some, &["--allow-missing"]);
    assert!(code == Some(0) && verdict.starts_with("AGREE: at 17 of 40 closest points nothing"), "{verdict}");
    // Cases in between, and an answer without a number.
    let lines: Vec<&str> = text.lines().collect();
    let gaps = [&lines[..5], &lines[7..39], &["{\"id\":\"38\"}"], &lines[40..]].concat().join("\n");
    let (code, verdict) = told(&vectors, "cut", &gaps, &[]);
    let expected =
        "INCOMPLETE: no answer to 3 of 40 cases: the first is 4; 1 of them have an answer without a number.";
    assert!(code == Some(4) && verdict.starts_with(expected), "{verdict}");
    // A wrong number counts more than a missing one.
    let wrong = spoiled(&some, 1);
    let (code, verdict) = told(&vectors, "cut", &wrong, &[]);
    assert!(code == Some(1) && verdict.contains("\nNot answered: 23 of 40 cases"), "{verdict}");
}

#[test]
fn every_format_says_what_is_missing() {
    let (vectors, text) = answered("formats", &[]);
    let some: String = text.lines().take(18).map(|line| line.to_owned() + "\n").collect();
    let expected = "INCOMPLETE: no answer to 23 of 40 cases: the answers end after case 16.";
    for format in ["human", "json", "junit", "sarif", "github", "markdown"] {
        let path = scratch("formats-answers.jsonl", &some);
        let output = run(&["verify", &vectors, path.to_str().unwrap(), "--format", format]);
        let shown = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.code() == Some(4) && shown.contains(expected), "{format}: {shown}");
        let sign = match format {
            "json" => "\"verdict\": \"incomplete\"",
            "junit" => "<failure type=\"incomplete\"",
            "sarif" => "\"level\": \"error\"",
            "github" => "::error ",
            "markdown" => "## ❌",
            _ => "INCOMPLETE",
        };
        assert!(shown.contains(sign), "{format}: {shown}");
    }
}

#[test]
fn a_regular_point_is_not_degenerate() {
    let (vectors, text) = answered("denied", &[]);
    let line = text.lines().nth(4).unwrap();
    let denied = text.replacen(line, "{\"id\":\"3\",\"result\":\"degenerate\"}", 1);
    for more in [&[][..], &["--allow-missing"]] {
        let (code, verdict) = told(&vectors, "denied", &denied, more);
        assert_eq!(code, Some(1), "{verdict}");
        assert!(
            verdict.starts_with("DISAGREE: at 1 case a regular closest point is denied. The first is case 3")
        );
    }
}

#[test]
fn the_head_states_what_is_answered() {
    let (vectors, text) = answered("only", &[]);
    let only = |keep: &dyn Fn(&Value) -> bool| {
        changed(&text, |line| {
            let first =
                serde_json::json!({ "value": line["xi"]["value"], "gradient": line["xi"]["gradient"] });
            let rest = serde_json::json!({ "id": line["id"], "d": line["d"], "xi": first });
            *line = if keep(line) { rest } else { serde_json::json!({ "id": line["id"] }) };
        })
    };
    let all = only(&|_| true);
    let (code, verdict) = told(&vectors, "only", &all, &[]);
    assert_eq!(
        (code, first_line(&verdict)),
        (Some(4), "INCOMPLETE: 11 of 13 quantities are never answered.")
    );
    let hint = "state \"only\":[\"d\",\"xi:value\",\"xi:first\"] in the first line of the answers";
    assert!(verdict.contains(hint), "{verdict}");
    // What the verdict proposes is accepted.
    let stated = with_head(&all, "\"only\":[\"d\",\"xi:value\",\"xi:first\"]");
    let (code, verdict) = told(&vectors, "only", &stated, &[]);
    let expected = "AGREE: at 40 closest points, for 2 of 13 quantities (1 in part), nothing differs";
    assert!(code == Some(0) && verdict.starts_with(expected), "{verdict}");
    // More is stated than answered.
    let more = with_head(&all, "\"only\":\"d, xi\"");
    assert_eq!(told(&vectors, "only", &more, &[]).0, Some(4));
    // Cases.
    let few = only(&|line| line["id"] == "0" || line["id"] == "7");
    let few = with_head(&few, "\"only\":\"d\",\"only_cases\":\"0,7\"");
    let (code, verdict) = told(&vectors, "only", &few, &[]);
    assert!(
        code == Some(0) && verdict.starts_with("AGREE: at 2 of 40 closest points, for 2 of 13"),
        "{verdict}"
    );
    let third = few.replace("\"0,7\"", "\"0,7,8\"");
    assert_eq!(told(&vectors, "only", &third, &[]).0, Some(4));
    let cases = std::fs::read_to_string(&vectors).unwrap();
    let held = |line: &Value| {
        let case = cases.lines().find(|case| case.starts_with(&format!("{{\"id\":{}", line["id"])));
        case.unwrap().contains("\"held\":\"none\"")
    };
    let inside = only(&held);
    assert_eq!(told(&vectors, "only", &with_head(&inside, "\"only\":\"d\""), &[]).0, Some(4));
    let inside = with_head(&inside, "\"only\":\"d\",\"only_held\":\"none\"");
    assert_eq!(told(&vectors, "only", &inside, &[]).0, Some(0));
}

#[test]
fn a_quantity_at_some_cases_and_not_at_others_is_said() {
    let (vectors, text) = answered("partly", &[]);
    let partly = changed(&text, |line| {
        if line["id"].as_str().unwrap().len() == 1 {
            line["xi"]["delta"] = Value::Null;
            let rest = line["xi"]["value"].clone();
            line["xi"] = serde_json::json!({ "value": rest });
        }
    });
    let said =
        "Answered at some cases and not at others: xi:first at 30, xi:second at 30 of 40 answered cases.";
    let (code, verdict) = told(&vectors, "partly", &partly, &[]);
    assert!(code == Some(4) && verdict.contains(said), "{verdict}");
    let (code, verdict) = told(&vectors, "partly", &partly, &["--allow-missing"]);
    assert!(code == Some(0) && verdict.contains(said), "{verdict}");
}

/// Every exported case can be compared.
#[test]
fn exported_cases_are_regular() {
    let all = vectors(&drawing(&Family::ALL, &Regime::ALL, 11));
    assert!(all.iter().all(|vector| vector.outcome() == Outcome::Valid));
}

/// In the document the share, the warning and the completeness are entries.
#[test]
fn the_document_says_what_is_complete() {
    let (vectors, text) = answered("document", &[]);
    let path = scratch("document-answers.jsonl", &text);
    assert!(Path::new(&vectors).is_file());
    let document = json(&run(&["verify", &vectors, path.to_str().unwrap(), "--format", "json"]));
    assert_eq!(
        (&document["is_complete"], &document["warning"], &document["asked"]),
        (&true.into(), &Value::Null, &40.into())
    );
    assert_eq!(document["search"], serde_json::json!({ "compared": 40, "differing": 0, "first": null }));
}
