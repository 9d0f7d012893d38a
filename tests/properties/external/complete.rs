//! Everything that is asked is answered and compared: what is left out is red, and a wrong program is never left out.

use super::conventions::{changed, map};
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
fn explained(vectors: &str, name: &str, text: &str, more: &[&str]) -> (Option<i32>, String) {
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

#[test]
fn triangles_and_doubled_entries_are_named() {
    let (vectors, text) = answered("shapes", &[]);
    let with = |name: &str, entry: &dyn Fn(usize, usize, f64) -> f64| {
        let text = changed(&text, |line| {
            let of: Vec<f64> =
                line["d"]["hessian"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
            let of: Vec<f64> = of.iter().enumerate().map(|(k, x)| entry(k / 12, k % 12, *x)).collect();
            *line = serde_json::json!({ "id": line["id"], "d": { "hessian": of } });
        });
        let path = scratch(&format!("shapes-{name}.jsonl"), &text);
        let output = run(&["verify", &vectors, path.to_str().unwrap()]);
        String::from_utf8(output.stdout).unwrap().replace("\n  ", " ")
    };
    for (name, factors, words) in [
        ("upper", [1.0, 0.0], "is an upper triangle alone: zero stands below the diagonal"),
        ("lower", [0.0, 1.0], "is a lower triangle alone: zero stands above the diagonal"),
        ("doubled", [2.0, 2.0], "has doubled entries beside the diagonal"),
        ("both", [2.0, 0.0], "is an upper triangle alone, with doubled entries beside the diagonal"),
    ] {
        let shown = with(name, &|i, j, x| if i == j { x } else { x * factors[usize::from(i > j)] });
        assert!(shown.contains(&format!("Cause: the Hessian of d {words}.")), "{name}: {shown}");
    }
    let packed = changed(&text, |line| {
        let of = line["d"]["hessian"].as_array().unwrap();
        let of: Vec<Value> = (0..144).filter(|k| k / 12 <= k % 12).map(|k| of[k].clone()).collect();
        *line = serde_json::json!({ "id": line["id"], "d": { "hessian": of } });
    });
    let (code, shown) = told(&vectors, "packed", &packed, &[]);
    let expected = "144 numbers expected, found 78: a triangle alone; the whole matrix is expected";
    assert!(code == Some(3) && shown.replace("\n  ", " ").contains(expected), "{shown}");
}

/// An element may lack dofs, and may order those of both beams by components.
#[test]
fn dofs_that_are_not_there_and_a_permutation_over_both_beams_are_stated() {
    let (vectors, text) = answered("dofs", &[]);
    let arrays = |line: &Value| {
        let of = |part: &str| line["d"][part].as_array().unwrap().clone();
        (of("gradient"), of("hessian"))
    };
    let is_missing = |i: usize| i == 2 || i == 7;
    let lacking = |error: f64| {
        changed(&text, |line| {
            let (mut gradient, mut hessian) = arrays(line);
            hessian[5] = (hessian[5].as_f64().unwrap() + error).into();
            (0..12).filter(|i| is_missing(*i)).for_each(|i| gradient[i] = Value::Null);
            for k in (0..144).filter(|k| is_missing(k / 12) || is_missing(k % 12)) {
                hessian[k] = Value::Null;
            }
            *line =
                serde_json::json!({ "id": line["id"], "d": { "gradient": gradient, "hessian": hessian } });
        })
    };
    let state =
        |text: &str, head: &str| with_head(text, &format!("\"only\":[\"d:first\",\"d:second\"]{head}"));
    assert_eq!(told(&vectors, "dofs", &state(&lacking(0.0), ""), &[]).0, Some(1));
    let (code, verdict) = told(&vectors, "dofs", &state(&lacking(0.0), ",\"null\":\"no dof\""), &[]);
    assert_eq!(code, Some(0), "{verdict}");
    assert_eq!(told(&vectors, "dofs", &state(&lacking(0.1), ",\"null\":\"no dof\""), &[]).0, Some(1));
    // null in a gradient alone is an error.
    let uneven =
        state(&lacking(0.0), ",\"null\":\"no dof\"").replacen("\"gradient\":[", "\"gradient\":[null,", 1);
    let (code, shown) = told(&vectors, "dofs", &uneven.replacen(",null,", ",", 1), &[]);
    let expected = "null expected for the same dofs";
    assert!(code == Some(3) && shown.replace("\n  ", " ").contains(expected), "{shown}");
    let place = |k: usize| 3 * (k % 4) + k / 4;
    let by_component = changed(&text, |line| {
        let (gradient, hessian) = arrays(line);
        let gradient: Vec<&Value> = (0..12).map(|i| &gradient[place(i)]).collect();
        let hessian: Vec<&Value> = (0..144).map(|k| &hessian[12 * place(k / 12) + place(k % 12)]).collect();
        *line = serde_json::json!({ "id": line["id"], "d": { "gradient": gradient, "hessian": hessian } });
    });
    let (code, verdict) = explained(&vectors, "dofs", &state(&by_component, ""), &[]);
    let named = "The answers agree if the dofs of both beams come component by component";
    assert!(code == Some(1) && verdict.contains(named), "{verdict}");
    let stated = state(&by_component, ",\"dofs\":\"component-major over both beams\"");
    assert_eq!(told(&vectors, "dofs", &stated, &[]).0, Some(0));
}

/// Numbers with few decimals are no numbers of few digits, and answers that are half of few digits are not all so.
#[test]
fn few_decimals_and_half_the_answers_are_said_as_they_are() {
    let (vectors, text) = answered("decimals", &[]);
    let with = |round: &dyn Fn(f64) -> f64, is_changed: &dyn Fn(usize) -> bool| {
        let count = std::cell::Cell::new(0);
        changed(&text, |line| {
            count.set(count.get() + 1);
            for (_, quantity) in line.as_object_mut().unwrap().iter_mut().filter(|_| is_changed(count.get()))
            {
                if let Some(parts) = quantity.as_object_mut() {
                    parts.values_mut().for_each(|part| map(part, round));
                }
            }
        })
    };
    for decimals in [4, 6, 9, 12] {
        let rounded = with(&|x| format!("{x:.decimals$}").parse().unwrap(), &|_| true);
        let (code, verdict) = explained(&vectors, "decimals", &rounded, &[]);
        let expected = format!("All answers have at most {decimals} decimals. To so many decimals");
        assert!(code == Some(1) && verdict.contains(&expected) && !verdict.contains("Cause"), "{verdict}");
    }
    let half = with(&|x| format!("{x:.5e}").parse().unwrap(), &|k| k % 2 == 0);
    let (code, verdict) = explained(&vectors, "decimals", &half, &[]);
    assert!(
        code == Some(1) && verdict.contains("The wrong answers have at most 6 significant digits"),
        "{verdict}"
    );
    assert!(
        verdict.contains("Other answers have more digits.") && !verdict.contains("All answers"),
        "{verdict}"
    );
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
}
