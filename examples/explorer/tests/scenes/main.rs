//! What the scenes say, compared with what the library and the derivation say.

mod detective;
mod friction;
mod race;

use beamgap_explorer::{SCENES, learn, opening};
use serde_json::{Value, json};

fn frame(scene: &str, state: &Value, action: &Value) -> Value {
    let request = json!({ "scene": scene, "state": state, "action": action });
    let frame: Value = serde_json::from_str(&learn(&request.to_string())).unwrap();
    assert_eq!(frame["error"], Value::Null, "{request}");
    frame
}

fn chosen(scene: &str, settings: &[(&str, &str)]) -> Value {
    let mut found = frame(scene, &Value::Null, &Value::Null);
    for (name, value) in settings {
        found = frame(scene, &found["state"], &json!({ "choose": { "name": name, "value": value } }));
    }
    found
}

fn text(frame: &Value, name: &str) -> String {
    frame["values"][name].as_str().unwrap_or_else(|| panic!("no value {name}")).to_owned()
}

fn number(frame: &Value, name: &str) -> f64 {
    text(frame, name).replace('−', "-").parse().unwrap()
}

#[test]
fn every_scene_opens_and_keeps_its_state() {
    for scene in SCENES {
        let first = opening(scene).unwrap();
        let again = frame(scene, &first.state, &Value::Null);
        assert_eq!(again, serde_json::to_value(&first).unwrap(), "{scene}");
    }
}

#[test]
fn what_is_no_request_is_told() {
    for request in ["", "{}", "{\"scene\":\"none\"}", "{\"scene\":\"valley\",\"state\":{\"at\":[0,0]}}"] {
        let frame: Value = serde_json::from_str(&learn(request)).unwrap();
        assert!(frame["error"].is_string(), "{request}");
    }
    // A state that is out of range is drawn as the nearest that is in range.
    for scene in SCENES {
        let mut state = opening(scene).unwrap().state;
        for (_, entry) in state.as_object_mut().unwrap() {
            match entry {
                Value::Array(list) => list.iter_mut().filter(|x| x.is_f64()).for_each(|x| *x = json!(1e30)),
                Value::Number(x) if x.is_f64() => *entry = json!(-1e30),
                _ => {}
            }
        }
        learn(&json!({ "scene": scene, "state": state }).to_string());
    }
}

#[test]
fn the_valley_has_the_minima_that_the_text_names() {
    let found = |situation| text(&chosen("valley", &[("situation", situation)]), "found");
    assert!(found("crossing").contains("one minimum inside"));
    assert!(found("waves").contains("minima inside") && found("waves").contains("saddle"));
    assert!(found("straight").starts_with("A trough") && found("arcs").starts_with("A trough"));
    let walked = chosen("valley", &[("walk", "end")]);
    assert!(number(&walked, "F_xi").abs() < 2e-3 && number(&walked, "F_xi_bar").abs() < 2e-3);
}

#[test]
fn the_parts_of_the_second_variation_add_up() {
    let frame = chosen("envelope", &[]);
    let [whole, held, mixed, last] = ["ddd", "f_QQ", "f_Qp", "f_pp"].map(|name| number(&frame, name));
    assert!((whole - held - 2.0 * mixed - last).abs() < 2e-3);
    assert!(last > 0.0 && (mixed + last).abs() < 1e-9);
    // Half a step has a quarter of the drop.
    let at = |x: f64| frame_at("envelope", "step", [x, 0.0]);
    let [half, full] = [at(196.0 + 37.0), at(196.0 + 74.0)].map(|frame| number(&frame, "apart"));
    assert!((full / half - 4.0).abs() < 0.6, "{full} {half}");
}

fn frame_at(scene: &str, handle: &str, to: [f64; 2]) -> Value {
    frame(scene, &Value::Null, &json!({ "drag": { "handle": handle, "to": to } }))
}

#[test]
fn the_lines_become_parallel_as_the_beams_do() {
    let frame = chosen("lines", &[]);
    let [a, b, a_bar, r, r_bar] = ["a", "b", "a_bar", "R", "R_bar"].map(|name| number(&frame, name));
    let [xi, xi_bar, det] = ["dxi", "dxi_bar", "D"].map(|name| number(&frame, name));
    assert!((a * xi - b * xi_bar - r).abs() < 3e-3 && (b * xi + a_bar * xi_bar - r_bar).abs() < 3e-3);
    assert!((a * a_bar + b * b - det).abs() < 3e-3 && det < 0.0);
    let mut state = opening("lines").unwrap().state;
    state["turn"] = json!([1.0, 0.0]);
    let parallel = self::frame("lines", &state, &Value::Null);
    assert_eq!((text(&parallel, "D").as_str(), text(&parallel, "dxi").as_str()), ("0.000", "none"));
    // The beam is tilted towards the bar beam.
    assert!(number(&frame, "dd") < 0.0);
    assert_eq!(text(&parallel, "dd"), "none");
    assert_eq!(parallel["shown"]["has_dd"], json!(false));
    // The prediction gets worse, and then a closest point is at an end.
    let mut apart = 0.0;
    for degrees in [60.0_f64, 45.0, 30.0, 26.0] {
        state["turn"] = json!([degrees.to_radians().cos(), degrees.to_radians().sin()]);
        let turned = self::frame("lines", &state, &Value::Null);
        let at = |name: &str| [0, 1].map(|i| turned["places"][name][i].as_f64().unwrap());
        let ([x, y], [u, v]) = (at("solved"), at("crossing"));
        let more = (x - u).hypot(y - v);
        assert!(more > apart + 3.0, "{degrees}: {more} {apart}");
        apart = more;
        assert_eq!((text(&turned, "dd"), &turned["shown"]["ends"]), (text(&frame, "dd"), &json!(false)));
    }
    state["turn"] = json!([10.0_f64.to_radians().cos(), 10.0_f64.to_radians().sin()]);
    let nearly = self::frame("lines", &state, &Value::Null);
    assert_eq!((&nearly["places"]["solved"], &nearly["places"]["again"]), (&Value::Null, &Value::Null));
    assert_eq!(nearly["shown"]["ends"], json!(true));
    assert_eq!(text(&nearly, "dd"), text(&frame, "dd"));
    state["turn"] = json!([1.0, 0.0]);
    // Without a tilt nothing is wrong but the number of solutions.
    state["lift"] = json!(0.0);
    let at_rest = self::frame("lines", &state, &Value::Null);
    assert_eq!(text(&at_rest, "dd"), "0.000");
    assert!(text(&at_rest, "says").contains("every pair"));
}

/// If the end moves vertically, the sliding is 0.38 of the motion of the material; if it moves along x, 0.78, backwards.
#[test]
fn a_motion_of_the_end_slides_the_contact_point() {
    let entries = |frame: &Value, name: &str| {
        let numbers = text(frame, name).replace('−', "-");
        let numbers = numbers.trim_matches(['(', ')']).split(',').map(|x| x.trim().parse::<f64>().unwrap());
        numbers.collect::<Vec<_>>()
    };
    let before = chosen("slide", &[]);
    assert_eq!(text(&before, "ratio"), "0.38");
    let [x, y] =
        before["places"]["end"].as_array().map(|at| [0, 1].map(|i| at[i].as_f64().unwrap())).unwrap();
    for up in [-55.0, -40.0, 10.0, 14.0] {
        let tilted = frame_at("slide", "end", [x, y - up]);
        assert_eq!(text(&tilted, "ratio"), "0.38", "{up}");
        assert_eq!(entries(&tilted, "du")[..2], [0.0, 0.0], "{up}");
    }
    let along = chosen("slide", &[("move", "along")]);
    assert_eq!(text(&along, "ratio"), "0.78");
    let [slides, moves] = ["t_dxi", "du"].map(|name| entries(&along, name)[0]);
    assert!(slides < 0.0 && moves > 0.0 && number(&along, "dxi_bar") != 0.0);
}

/// The trough has a smallest distance: half, along a line.
#[test]
fn the_smallest_distance_of_a_trough_is_told() {
    let smallest = |situation| text(&chosen("valley", &[("situation", situation)]), "smallest");
    assert_eq!([smallest("straight"), smallest("arcs")], ["0.500", "0.450"]);
}

/// A handle that is pressed without being moved changes nothing but rounding.
#[test]
fn handles_do_not_jump() {
    for situation in ["crossing", "waves", "straight", "arcs"] {
        let before = chosen("valley", &[("situation", situation)]);
        let drag = json!({ "drag": { "handle": "turn", "to": before["places"]["turn"] } });
        let after = frame("valley", &before["state"], &drag);
        for i in [0, 1] {
            let [one, other] = [&before, &after].map(|frame| frame["state"]["turn"][i].as_f64().unwrap());
            assert!((one - other).abs() < 5e-3, "{situation}: {one} {other}");
        }
    }
}
