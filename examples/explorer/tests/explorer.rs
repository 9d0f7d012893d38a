//! What the explorer shows and changes, compared with what the library says.

use beamgap::linearization::Quantity;
use beamgap::variant::{Fault, catalogue};
use beamgap_explorer::{Answer, Formula, State, formulas, learn};
use serde_json::{Value, json};

fn frame(state: &Value, action: &Value) -> Value {
    let request = json!({ "scene": "explorer", "state": state, "action": action });
    serde_json::from_str(&learn(&request.to_string())).unwrap()
}

fn chosen(settings: &[(&str, &str)]) -> Value {
    let mut found = frame(&Value::Null, &Value::Null);
    for (name, value) in settings {
        found = frame(&found["state"], &json!({ "choose": { "name": name, "value": value } }));
        assert_eq!(found["error"], Value::Null, "{name} {value}");
    }
    found
}

fn text<'a>(frame: &'a Value, name: &str) -> &'a str {
    frame["values"][name].as_str().unwrap_or_else(|| panic!("no value {name}"))
}

fn number(frame: &Value, name: &str) -> f64 {
    text(frame, name)
        .replace('−', "-")
        .parse()
        .unwrap_or_else(|_| panic!("{name} is {:?}", text(frame, name)))
}

/// The name of a term's value.
fn term(name: &str) -> String {
    let found = formulas().iter().flat_map(Formula::terms).find(|term| term.name == name);
    format!("term{}", found.unwrap().number)
}

/// The name of a result's value, in a formula that is visible.
fn result(frame: &Value, of: (Quantity, usize)) -> String {
    let is_shown = |visible: &str| frame["shown"][visible] == Value::Bool(true);
    let found = formulas().iter().position(|formula| formula.result == Some(of) && is_shown(formula.visible));
    format!("result{}", found.unwrap())
}

#[test]
fn every_term_of_the_catalogue_is_in_a_formula_and_no_other() {
    let mut named: Vec<&str> = formulas().iter().flat_map(Formula::terms).map(|term| term.name).collect();
    let mut known: Vec<String> = catalogue().iter().map(|fault: &Fault| fault.label.to_string()).collect();
    known.sort();
    known.dedup();
    named.sort_unstable();
    named.dedup();
    assert_eq!(named, known);
}

/// The situations reach both formulations and all held parameters.
#[test]
fn every_term_has_a_value_where_its_formula_is_visible() {
    for situation in ["standard", "nearly parallel", "at an end", "two minima", "overlap"] {
        for shown in ["gap", "xi", "x", "d", "t", "length", "slip"] {
            for order in ["1", "2"] {
                let frame = chosen(&[("situation", situation), ("shown", shown), ("order", order)]);
                let mut count = 0;
                for formula in formulas() {
                    if frame["shown"][formula.visible] != Value::Bool(true) {
                        continue;
                    }
                    for term in formula.terms().filter(|term| term.value.is_some()) {
                        let value = text(&frame, &format!("term{}", term.number));
                        assert!(!value.is_empty(), "{situation}, {shown}{order}: {} has no value", term.name);
                        count += 1;
                    }
                }
                assert!(count > 0, "{situation}, {shown}{order}: no formula");
            }
        }
    }
}

#[test]
fn the_terms_of_a_formula_add_up_to_its_result() {
    let gap = chosen(&[]);
    let of = |frame: &Value, name: &str| number(frame, &term(name));
    let radii = of(&gap, "g_N: r") + of(&gap, "g_N: r_bar");
    assert!((of(&gap, "|d|: n.d") - radii - number(&gap, &result(&gap, (Quantity::GN, 0)))).abs() < 2e-3);
    let slip = chosen(&[("shown", "slip"), ("order", "2")]);
    let terms = ["Ddg_T: Ddt slip", "Ddg_T: dt Dxi", "Ddg_T: Dt dxi", "Ddg_T: t Ddxi"];
    let sum: f64 = terms.iter().map(|name| of(&slip, name)).sum();
    assert!((sum - number(&slip, &result(&slip, (Quantity::GT, 3)))).abs() < 3e-3);
    let parameters = chosen(&[("shown", "xi")]);
    let det = of(&parameters, "D: a a_bar") + of(&parameters, "D: b b");
    let xi = (of(&parameters, "xi: a_bar R") + of(&parameters, "xi: b R_bar")) / det;
    assert!((xi - number(&parameters, &result(&parameters, (Quantity::Xi, 1)))).abs() < 3e-3);
}

#[test]
fn a_fault_is_seen_in_the_numbers_and_in_the_picture() {
    let right = chosen(&[("shown", "xi"), ("step", "1")]);
    let faulty = chosen(&[("shown", "xi"), ("step", "1"), ("fault", "a: d.t,xi = dropped")]);
    let name = term("a: d.t,xi");
    assert_eq!(text(&faulty, &name), "0.000");
    assert_eq!(text(&faulty, &format!("right-{name}")), text(&right, &name));
    let xi = result(&faulty, (Quantity::Xi, 1));
    assert_ne!(text(&faulty, &xi), text(&right, &xi));
    assert_eq!(text(&faulty, &format!("right-{xi}")), text(&right, &xi));
    for path in ["predicted0", "map_predicted"] {
        assert_ne!(faulty["paths"][path], right["paths"][path], "{path}");
    }
    // The ghost is the prediction without the fault.
    assert_eq!(faulty["paths"]["right0"], right["paths"]["predicted0"]);
    assert_eq!(faulty["paths"]["map_right"], right["paths"]["map_predicted"]);
    assert_eq!(right["paths"]["right0"], json!(""));
    assert_eq!(text(&right, &format!("right-{name}")), "");
}

#[test]
fn a_prediction_that_is_not_finite_is_not_drawn() {
    let frame = chosen(&[("order", "2"), ("fault", "dn: c.c = dropped")]);
    assert_eq!(frame["places"]["predicted_tip0"], Value::Null);
    assert_eq!(frame["paths"]["predicted0"], json!(""));
    assert_ne!(frame["paths"]["right0"], json!(""));
}

#[test]
fn a_lesson_shows_its_formula_and_a_fault_elsewhere_is_said() {
    let lesson = chosen(&[("lesson", "Ddg_T: dt Dxi = dropped")]);
    assert_eq!(
        (lesson["state"]["shown"].as_str(), lesson["state"]["order"].as_u64()),
        (Some("slip"), Some(2))
    );
    assert_eq!(lesson["shown"]["elsewhere"], json!(false));
    let other = chosen(&[("lesson", "Ddg_T: dt Dxi = dropped"), ("shown", "x")]);
    assert_eq!(other["shown"]["elsewhere"], json!(true));
    assert_eq!(text(&other, "elsewhere"), "Ddg_T: dt Dxi = dropped");
}

#[test]
fn a_sentence_says_what_is_special() {
    let sentence = |situation: &str| text(&chosen(&[("situation", situation)]), "sentence").to_owned();
    assert!(sentence("standard").contains("all equations of the paper hold"));
    assert!(sentence("parallel").contains("parallel along a part"));
    let nearly = sentence("nearly parallel");
    assert!(nearly.contains("nearly parallel: D is −1.4e−6") && nearly.contains("−84225"), "{nearly}");
    assert!(sentence("crossing").contains("d = 0"));
    assert!(sentence("at an end").contains("second end of the beam"));
    assert!(sentence("two minima").contains("2 minima"));
    assert!(sentence("overlap").contains("overlap"));
    let words = |situation: &str| {
        let state = serde_json::from_value(chosen(&[("situation", situation)])["state"].clone()).unwrap();
        Answer::of(&state).unwrap().words
    };
    assert!(
        !words("nearly parallel").contains("all equations") && words("nearly parallel").contains("−84225")
    );
}

#[test]
fn the_overlap_is_drawn_where_the_beams_penetrate_alone() {
    for (situation, is_drawn) in [("overlap", true), ("crossing", true), ("standard", false)] {
        let frame = chosen(&[("situation", situation)]);
        assert_eq!(frame["paths"]["overlap"] != json!(""), is_drawn, "{situation}");
    }
}

#[test]
fn a_handle_goes_where_it_is_dragged() {
    for (handle, dragged) in [("b0", "q"), ("r3", "q"), ("b1", "dq"), ("r2", "linear_dq")] {
        let before = chosen(&[("dragged", dragged), ("view", "30 50")]);
        let at = |frame: &Value| [0, 1].map(|i| frame["places"][handle][i].as_f64().unwrap());
        let to = at(&before).map(|x| x + 37.0);
        let after = frame(&before["state"], &json!({ "drag": { "handle": handle, "to": to } }));
        for (at, to) in at(&after).into_iter().zip(to) {
            // The numbers have three decimals.
            assert!((at - to).abs() < 0.4, "{handle}: {at} {to}");
        }
        let pushed = frame(&after["state"], &json!({ "push": { "handle": handle, "by": 0.1 } }));
        assert_ne!(pushed["state"], after["state"]);
        for (one, other) in at(&after).into_iter().zip(at(&pushed)) {
            assert!((one - other).abs() < 0.4, "{handle} is pushed along the view");
        }
    }
}

#[test]
fn a_case_is_written_and_read_again() {
    let bent =
        chosen(&[("family-beam", "nurbs"), ("family-bar", "helix"), ("radius", "0.2"), ("bar q 4", "0.3")]);
    let state: State = serde_json::from_value(bent["state"].clone()).unwrap();
    let answer = Answer::of(&state).unwrap();
    for file in [&answer.case, &answer.vectors] {
        let opened = chosen(&[("case", file)]);
        for part in ["beam", "bar", "contact"] {
            assert_eq!(opened["state"][part], bent["state"][part], "{file}");
        }
    }
}

#[test]
fn what_cannot_be_taken_is_told() {
    let standard = frame(&Value::Null, &Value::Null);
    for (name, value, words) in [
        ("case", "{}", "not a case"),
        ("radius", "wide", "a number expected"),
        ("family-bar", "rope", "no family"),
        ("order", "4", "an order from 1 to 3"),
        ("bar dq 99", "1", "no control"),
        ("colour", "red", "no control"),
        ("fault", "a = b", "a = b"),
    ] {
        let told = frame(&standard["state"], &json!({ "choose": { "name": name, "value": value } }));
        let error = told["error"].as_str().unwrap_or_else(|| panic!("{name} {value}"));
        assert!(error.contains(words), "{error}");
    }
}

/// Every tube is drawn in full, whatever covers it.
#[test]
fn the_layers_of_a_tube_have_all_its_pieces() {
    for (azimuth, situation) in [("14", "standard"), ("200", "overlap"), ("75", "two minima")] {
        let frame = chosen(&[("situation", situation), ("azimuth", azimuth)]);
        for beam in ["b", "r"] {
            let points: usize = (0..3)
                .map(|layer| frame["paths"][format!("tube{layer}{beam}")].as_str().unwrap())
                .map(|path| path.matches(['M', 'L']).count())
                .sum();
            assert!(points >= 33, "{situation}: {points}");
        }
        let front: usize = (1..3)
            .flat_map(|layer| ["b", "r"].map(|beam| format!("tube{layer}{beam}")))
            .map(|name| frame["paths"][name].as_str().unwrap().len())
            .sum();
        assert!(situation == "standard" || front > 0, "{situation}: no beam is in front");
    }
}
