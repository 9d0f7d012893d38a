//! Stated conventions are converted, and unstated ones are named.

use super::{answers, drawing, vectors, verified, with_head};
use beamgap::check::external::{
    AnswerReader, Conventions, Demands, Evaluator, OtherConventions, explain, other_conventions,
};
use beamgap::check::{Family, Regime};
use std::fmt::Write as _;

/// The answers of the library with changed numbers.
pub(super) fn changed(text: &str, change: impl Fn(&mut serde_json::Value)) -> String {
    let mut lines = text.lines();
    let mut changed = lines.next().unwrap().to_owned() + "\n";
    for line in lines {
        let mut line: serde_json::Value = serde_json::from_str(line).unwrap();
        change(&mut line);
        let _ = writeln!(changed, "{line}");
    }
    changed
}

pub(super) fn map(value: &mut serde_json::Value, f: &dyn Fn(f64) -> f64) {
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
    let penetration = changed(&text, |line| {
        for part in ["value"].iter().chain(&parts) {
            map(&mut line["g_N"][part], &|x| -x);
        }
    });
    // `place` maps a dof k of the program to its place in the library.
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
        (penetration, "\"gap\":\"r + r_bar - d\"", "the gap is r + r_bar - d (\"gap\":\"r + r_bar - d\")"),
        (by_component, "\"dofs\":\"component-major\"", "the dofs come component by component"),
        (bar_first, "\"beams\":\"bar first\"", "the dofs of the bar beam come first"),
        (tangents, "\"hermite_tangent\":0.5", "dx/dxi is 0.5 times the tangent dofs"),
    ] {
        let stated = verified(&all, &with_head(&text, head), None).unwrap();
        assert!(stated.agrees(), "{head}: {:?}", stated.first);
        let silent = verified(&all, &text, None).unwrap();
        assert!(silent.wrong > 0, "{head}");
        let told = other_conventions(&silent.kept, &Demands::default())
            .filter(OtherConventions::agree)
            .unwrap()
            .words;
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
    let told =
        other_conventions(&report.kept, &Demands::default()).filter(OtherConventions::agree).unwrap().words;
    assert_eq!(
        told,
        "the vector d is x_bar - x (\"d\":\"x_bar - x\") and the parameters run over [0,1] (\"parameter\":\"[0,1]\")"
    );
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
    // The tangent without the geometric part.
    let gauss_newton = only(&text, &|line, k| {
        let g = |i: usize| line["d"]["gradient"][i].as_f64().unwrap();
        250.0 * g(k / 24) * g(k % 24)
    });
    let report = verified(&all, &gauss_newton, None).unwrap();
    let reader = AnswerReader::new(gauss_newton.as_bytes(), "answers").unwrap();
    let found =
        explain(&report.kept, &report.right, &Demands { conventions: *reader.conventions(), digits: None })
            .unwrap();
    assert_eq!(found.causes[0].name, "the term k g_N Ddg_N is missing", "{found:?}");
    // The tangent with the opposite sign.
    let negative = only(&text, &|line, k| -line["tangent"][k].as_f64().unwrap());
    assert!(verified(&all, &with_head(&negative, "\"tangent_sign\":\"-\""), None).unwrap().agrees());
    let report = verified(&all, &negative, None).unwrap();
    let demands = Demands { conventions: *reader.conventions(), digits: None };
    let told = other_conventions(&report.kept, &demands).filter(OtherConventions::agree).unwrap().words;
    assert!(told.contains("the tangent has the other sign"), "{told}");
}

#[test]
fn forces_of_other_conventions_are_converted_if_they_are_stated_and_named_if_not() {
    let mut drawing = drawing(&[Family::Hermite], &[Regime::Generic], 12);
    drawing.elements = true;
    let all = vectors(&drawing);
    let text = answers(&Evaluator::default(), &all);
    let vector = |line: &serde_json::Value, name: &str| {
        ["x", "y", "z"].map(|c| line[format!("{name}.{c}")]["value"].as_f64().unwrap())
    };
    let dot = |v: [f64; 3], w: [f64; 3]| v.iter().zip(w).map(|(v, w)| v * w).sum::<f64>();
    // T = f t/|t| - f_bar t_bar/|t_bar| is solved for f and f_bar. A held parameter has no force.
    let contravariant = changed(&text, |line| {
        let (t, t_bar) = (vector(line, "t_vector"), vector(line, "t_bar_vector"));
        let c = dot(t, t_bar) / (dot(t, t).sqrt() * dot(t_bar, t_bar).sqrt());
        let [f, f_bar] = ["F", "F_bar"].map(|name| line[name].as_f64().unwrap());
        if f != 0.0 && f_bar != 0.0 {
            let solved = |own: f64, other: f64| ((own + c * other) / (1.0 - c * c)).into();
            (line["F"], line["F_bar"]) = (solved(f, f_bar), solved(f_bar, f));
        }
    });
    let negative =
        |names: &[&str]| changed(&text, |line| names.iter().for_each(|name| map(&mut line[*name], &|x| -x)));
    for (text, head, words) in [
        (contravariant, "\"friction_components\":\"contravariant\"", "F and F_bar are other components"),
        (negative(&["F_N"]), "\"normal_force\":\"negative in compression\"", "F_N has the other sign"),
        (negative(&["F", "F_bar"]), "\"friction_force\":\"on the bar beam\"", "that on the other beam"),
        (negative(&["F_bar"]), "\"F_bar\":\"along t_bar\"", "F_bar has the other sign"),
    ] {
        let stated = verified(&all, &with_head(&text, head), None).unwrap();
        assert!(stated.agrees(), "{head}: {:?}", stated.first);
        let silent = verified(&all, &text, None).unwrap();
        assert!(silent.wrong > 0, "{head}");
        let told = other_conventions(&silent.kept, &Demands::default()).unwrap();
        assert!(told.agree() && told.words.contains(words) && told.words.contains(head), "{told:?}");
    }
}
