//! The explanation names the wrong term.

use super::conventions::changed;
use super::{answers, drawing, vectors, verified};
use beamgap::check::external::{AnswerReader, Demands, Evaluator, Formulas, Vector, explain};
use beamgap::check::{Family, Regime};
use beamgap::variant::with_faults;

/// The cause of the errors in the answers of a program with these faults, in words.
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
    let found = explain(&report.kept, &report.right, &Demands { digits, ..Demands::default() }).unwrap();
    found.causes.into_iter().map(|cause| cause.words).collect::<Vec<_>>().join(", ")
}

#[test]
fn the_wrong_term_is_named() {
    let all = vectors(&drawing(&[Family::Quadratic], &[Regime::Generic], 6));
    for (fault, words) in [
        ("a: d.t,xi = dropped", "in a, eq. (50), the term d.t,xi is missing"),
        (
            "Dd|d|: d.du,xi Dxi = sign",
            "in the second order of d the term Dxi du of the beam, eq. (40), has the wrong sign",
        ),
        ("H_d: b gg_bar' = doubled", "in the second order of d the term b, eq. (40), counts twice"),
        ("R2: t.rest = halved", "in the second order of xi and xi_bar the term t.Ddd, eq. (55), is halved"),
    ] {
        assert_eq!(cause(&all, &[fault], None), words);
    }
    let words = "in a_bar, eq. (50), the term d.t_bar,xi has the wrong sign";
    assert_eq!(cause(&all, &["a_bar: d.t_bar,xi = sign"], Some(6)), words);
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
    let found = explain(&report.kept, &report.right, &Demands::default()).unwrap();
    assert_eq!(found.causes[0].name, "the term b is halved", "{found:?}");
    assert_eq!(
        found.beyond,
        ["Beyond it in the second order of t the term du,xi.Du,xi, eq. (42), is missing."]
    );
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
    let found = explain(&report.kept, &report.right, &Demands::default()).unwrap();
    let names: Vec<_> = found.causes.iter().map(|cause| cause.name.as_str()).collect();
    assert_eq!(
        names,
        ["the term du_hat.t Dxi is missing and the term dd Dd has the wrong sign"],
        "{found:?}"
    );
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
        let found =
            explain(&report.kept, &report.right, &Demands { digits: Some(6), ..Demands::default() }).unwrap();
        assert!(!found.is_faint);
        found.causes.into_iter().map(|cause| cause.name).collect::<Vec<_>>()
    };
    // For straight beams a is t.t.
    let alike = ["the term t.t of a has the wrong sign", "the term a dxi Dxi has the wrong sign"];
    assert_eq!(arrays("H_d: a gg' = sign"), alike);
    assert_eq!(arrays("H_d: A0'A0 = doubled"), ["the term du.Du counts twice"]);
}

/// For straight beams the terms of curvature are zero, so a fault in them changes no answer.
#[test]
fn a_cause_is_not_named_where_nothing_is_wrong() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 1));
    let text = answers(&Evaluator { formulas: Formulas::Paper, ..Evaluator::default() }, &all);
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
    let cases: Vec<_> =
        all.iter().map(|vector| (vector.clone(), reader.next_answers().unwrap().unwrap())).collect();
    let found = explain(&cases, &[], &Demands::default()).unwrap();
    assert!(found.is_faint && found.causes.is_empty(), "{found:?}");
}

#[test]
fn simplifications_and_factors_are_named() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::Generic], 8));
    let text = answers(&Evaluator { formulas: Formulas::Paper, ..Evaluator::default() }, &all);
    let named = |text: &str| {
        let report = verified(&all, text, None).unwrap();
        explain(&report.kept, &report.right, &Demands::default()).unwrap()
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
