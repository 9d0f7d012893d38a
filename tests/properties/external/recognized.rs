//! Answers in another form are recognized: triangles, other orders of the dofs, dofs that are not there, few decimals.

use super::complete::{answered, explained, told};
use super::conventions::{changed, map};
use super::programs::scratch;
use super::with_head;
use crate::program::run;
use serde_json::Value;
use std::fmt::Write as _;

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
    let expected = "144 numbers expected, found 78: a triangle alone; state it by the entry \"triangle\"";
    assert!(code == Some(3) && shown.replace("\n  ", " ").contains(expected), "{shown}");
    // Column by column it is a lower triangle. Symmetric numbers in the other triangle are not missed.
    for (head, code) in [
        (r#""triangle":"upper""#, 0),
        (r#""triangle":"lower""#, 1),
        (r#""triangle":"lower","matrix":"column-major""#, 0),
    ] {
        let stated = with_head(&packed, head);
        let (found, shown) = told(&vectors, "stated", &stated, &["--allow-missing"]);
        assert_eq!(found, Some(code), "{head}: {shown}");
    }
    let mut csv = "# schema = beamgap-answers/1\n# triangle = upper\ncase,quantity,value\n".to_owned();
    for line in text.lines().skip(1).map(|line| serde_json::from_str::<Value>(line).unwrap()) {
        for (k, entry) in line["d"]["hessian"].as_array().unwrap().iter().enumerate() {
            if k / 12 <= k % 12 {
                let (id, i, j) = (line["id"].as_str().unwrap(), k / 12, k % 12);
                writeln!(csv, "{id},d:hessian:{i}:{j},{entry}").unwrap();
            }
        }
    }
    assert_eq!(told(&vectors, "upper-csv", &csv, &["--allow-missing"]).0, Some(0));
    let zeros = changed(&text, |line| {
        let of = line["d"]["hessian"].as_array_mut().unwrap().iter_mut().enumerate();
        of.filter(|(k, _)| k / 12 < k % 12).for_each(|(_, entry)| *entry = 0.0.into());
    });
    assert_eq!(
        told(&vectors, "zeros", &with_head(&zeros, r#""triangle":"lower""#), &["--allow-missing"]).0,
        Some(0)
    );
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
