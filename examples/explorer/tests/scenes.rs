//! What the scenes say, compared with what the library and the derivation say.

use beamgap_explorer::{SCENES, hidden, learn, opening};
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
    assert!(number(&frame, "dd") > 0.0);
    assert_eq!(text(&parallel, "dd"), "none");
    // Without a tilt nothing is wrong but the number of solutions.
    state["lift"] = json!(0.0);
    let at_rest = self::frame("lines", &state, &Value::Null);
    assert_eq!(text(&at_rest, "dd"), "0.000");
    assert!(text(&at_rest, "says").contains("every pair"));
}

/// The sliding is 0.2 to 0.8 of the motion of the material if the beam tilts.
#[test]
fn a_tilt_slides_the_contact_point() {
    let size = |frame: &Value, name: &str| {
        let numbers = text(frame, name).replace('−', "-");
        let numbers = numbers.trim_matches(['(', ')']).split(',').map(|x| x.trim().parse::<f64>().unwrap());
        numbers.map(|x| x * x).sum::<f64>().sqrt()
    };
    let before = chosen("slide", &[]);
    let [x, y] =
        before["places"]["end"].as_array().map(|at| [0, 1].map(|i| at[i].as_f64().unwrap())).unwrap();
    for up in [-40.0, 20.0, 40.0] {
        let tilted = frame_at("slide", "end", [x, y - up]);
        let ratio = size(&tilted, "t_dxi") / size(&tilted, "du");
        assert!((0.2..0.8).contains(&ratio), "{up}: {ratio}");
    }
}

#[test]
fn newton_needs_the_iterations_that_the_derivation_states() {
    let words = |tangent| text(&chosen("race", &[("tangent", tangent)]), "wrong_words");
    assert_eq!(words("exact"), "4 iterations");
    assert_eq!(words("no_curvature"), "13 iterations");
    assert!(words("frozen").starts_with("stops") && words("sign_a").starts_with("stops"));
}

/// All errors cost less with a small push, and all runs that converge end at the same gap.
#[test]
fn a_wrong_tangent_costs_iterations_or_ruins_the_method() {
    let run = |tangent: &str, push: &str| {
        let last = chosen("race", &[("tangent", tangent), ("push", push)]);
        let words = text(&last, "wrong_words");
        let iterations: Option<u32> = words.strip_suffix(" iterations").and_then(|n| n.parse().ok());
        let mut state = last["state"].clone();
        state["iteration"] = json!(30);
        (iterations, text(&frame("race", &state, &Value::Null), "gap"))
    };
    let (_, gap) = run("exact", "0.8");
    for tangent in ["no_curvature", "sign_curvature", "no_normal", "sign_b", "sign_right", "sign_a", "frozen"]
    {
        let (small, large) = (run(tangent, "0.2"), run(tangent, "0.8"));
        let is_ruined = ["sign_a", "frozen"].contains(&tangent);
        assert_eq!(large.0.is_none(), is_ruined, "{tangent}");
        assert!(large.0.is_none_or(|n| small.0.unwrap() < n), "{tangent}");
        assert!(is_ruined || large.1 == gap, "{tangent}: {} and {gap}", large.1);
    }
}

fn tables(settings: &[(&str, &str)], bend: Option<f64>) -> Vec<String> {
    let mut state = chosen("detective", settings)["state"].clone();
    if let Some(bend) = bend {
        state["bend"] = json!(bend);
    }
    let frame = frame("detective", &state, &Value::Null);
    (0..20).map(|cell| text(&frame, &format!("cell{}{}", cell / 4, cell % 4))).collect()
}

/// Two cases mark the same numbers, and one error is invisible if the beam is straight.
#[test]
fn the_detective_has_two_equal_tables_and_one_error_that_a_straight_beam_hides() {
    let all = |case: usize, bend| {
        let mut settings = vec![("next", ""); case];
        settings.extend([("check", "0"), ("check", "1"), ("check", "2"), ("check", "3")]);
        tables(&settings, bend)
    };
    let of_bent: Vec<_> = (0..6).map(|case| all(case, None)).collect();
    let equal = (0..6).flat_map(|i| (0..i).map(move |k| (k, i))).filter(|(k, i)| of_bent[*k] == of_bent[*i]);
    assert_eq!(equal.collect::<Vec<_>>(), [(1, 3)]);
    let hidden: Vec<usize> = (0..6).filter(|case| !all(*case, Some(0.0)).contains(&"✗".to_owned())).collect();
    assert_eq!(hidden, [1]);
}

#[test]
fn the_checks_see_what_the_answer_of_the_detective_says() {
    // The order in which the page hides the errors, and whether symmetry and AD detect each.
    for (case, (error, by_symmetry)) in
        [(4, true), (0, false), (3, false), (1, false), (5, true), (2, false)].into_iter().enumerate()
    {
        let mut settings = vec![("next", ""); case];
        settings.extend([("check", "0"), ("check", "1"), ("check", "2"), ("check", "3")]);
        let frame = chosen("detective", &settings);
        let column =
            |check: usize| (0..5).map(|row| text(&frame, &format!("cell{row}{check}"))).collect::<Vec<_>>();
        let wrong = |check: usize| column(check).contains(&"✗".to_owned());
        assert_eq!(wrong(0), by_symmetry, "case {case}: {:?}", column(0));
        assert!(wrong(1) || wrong(2), "case {case}");
        assert!(wrong(3), "case {case}: {:?}", column(3));
        let suspect = |i: usize| {
            let i = i.to_string();
            let action = json!({ "choose": { "name": "suspect", "value": i } });
            text(&self::frame("detective", &frame["state"], &action), "judgement")
        };
        assert_eq!(suspect(error), "This is the term.");
        assert_ne!(suspect((error + 1) % 6), "This is the term.");
    }
}

#[test]
fn every_hidden_error_is_explained() {
    for error in hidden() {
        assert!(error.explanation.contains("eq. ("), "{error:?}");
    }
}

#[test]
fn friction_sticks_and_then_slips() {
    let first = chosen("friction", &[]);
    assert!(text(&first, "state").contains("sticks") && number(&first, "Phi") < 0.0);
    let [x, y] =
        first["places"]["move"].as_array().map(|at| [0, 1].map(|i| at[i].as_f64().unwrap())).unwrap();
    let moved = frame_at("friction", "move", [x + 25.0, y]);
    assert!(text(&moved, "state").contains("slips") && number(&moved, "Phi") > 0.0);
    assert_eq!(text(&moved, "T"), text(&moved, "mu_F_N"));
    // After the step the same place is at the edge of the cone, and the way back sticks.
    let accepted =
        frame("friction", &moved["state"], &json!({ "choose": { "name": "accept", "value": "" } }));
    assert!(number(&accepted, "Phi").abs() < 5e-3);
    let back =
        frame("friction", &accepted["state"], &json!({ "drag": { "handle": "move", "to": [x + 20.0, y] } }));
    assert!(text(&back, "state").contains("sticks"), "{back}");
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
