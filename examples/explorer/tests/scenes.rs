//! What the scenes say, compared with what the library and the derivation say.

use beamgap_explorer::{SCENES, asymmetry, hidden, learn, opening, spectral_radius};
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

#[test]
fn newton_needs_the_iterations_that_the_derivation_states() {
    let words = |tangent| text(&chosen("race", &[("tangent", tangent)]), "wrong_words");
    assert_eq!(words("exact"), "4 iterations");
    assert_eq!(words("no_curvature"), "13 iterations");
    assert!(words("frozen").starts_with("stops") && words("sign_a").starts_with("stops"));
}

const ERRORS: [&str; 7] =
    ["no_curvature", "sign_curvature", "no_normal", "sign_b", "sign_right", "sign_a", "frozen"];

/// A run: its iterations if it converges, its gap and that of the exact run, and its spectral radius.
fn run(tangent: &str, push: &str) -> (Option<u32>, [String; 2], f64) {
    let last = chosen("race", &[("tangent", tangent), ("push", push), ("iteration", "300")]);
    let words = text(&last, "wrong_words");
    let iterations = words.strip_suffix(" iterations").and_then(|n| n.parse().ok());
    (
        iterations,
        ["gap", "gap_exact"].map(|name| text(&last, name)),
        spectral_radius(tangent, push.parse().unwrap()).unwrap(),
    )
}

/// The spectral radius tells which errors ruin Newton's method, at every push. Which ones do depends on the push.
#[test]
fn a_wrong_tangent_costs_iterations_or_ruins_the_method() {
    for (push, ruinous) in [
        ("0.2", &[][..]),
        ("0.3", &[]),
        ("0.4", &["sign_a"]),
        ("0.5", &["sign_a"]),
        ("0.6", &["sign_a", "frozen"]),
        ("0.7", &["sign_a", "frozen"]),
        ("0.8", &["sign_a", "frozen"]),
        ("0.9", &["sign_a", "frozen"]),
        ("1.0", &["sign_b", "sign_a", "frozen"]),
    ] {
        for tangent in ERRORS {
            let (iterations, [gap, exact], radius) = run(tangent, push);
            let is_ruined = ruinous.contains(&tangent);
            assert_eq!(radius > 1.0, is_ruined, "{tangent} {push}: {radius}");
            if (tangent, push) == ("sign_b", "1.0") {
                // It leaves the equilibrium and finds another one.
                assert!(iterations.is_some() && gap != exact, "{gap}");
            } else {
                assert_eq!(iterations.is_none(), is_ruined, "{tangent} {push}");
                assert!(is_ruined || gap == exact, "{tangent} {push}: {gap} and {exact}");
            }
        }
        assert!(run("exact", push).2 < 1e-9, "{push}");
    }
}

/// What the answer says of the pushes 0.2 and 0.8.
#[test]
fn a_small_push_hides_a_wrong_tangent() {
    let slowest = ERRORS.into_iter().max_by_key(|tangent| run(tangent, "0.2").0).unwrap();
    assert_eq!(slowest, "sign_a");
    for tangent in ERRORS {
        let [small, large] = ["0.2", "0.8"].map(|push| run(tangent, push).0);
        assert!(large.is_none_or(|n| small.unwrap() < n), "{tangent}");
    }
    // The observed factor is the spectral radius, for the runs that are long enough.
    for tangent in ["no_normal", "sign_b", "sign_right"] {
        let run = chosen("race", &[("tangent", tangent), ("push", "0.8")]);
        let radius = spectral_radius(tangent, 0.8).unwrap();
        assert!((number(&run, "factor") - radius).abs() < 0.02, "{tangent}: {radius}");
    }
}

/// The number of displaced pairs that the text states for the differences of one pair of directions.
#[test]
fn differences_displace_the_beams_as_often_as_the_text_says() {
    let library = include_str!("../../../src/check/oracle.rs");
    let body = |name: &str| {
        let (_, from) = library.split_once(name).unwrap();
        from.split("\n}").next().unwrap()
    };
    let differences = body("fn differences(");
    let (_, steps) = differences.split_once("levels.iter_mut().zip([").unwrap();
    let (steps, after) = steps.split_once("])").unwrap();
    assert!(after.contains("corners(") && differences.matches("corners(").count() == 1);
    let corners = body("fn corners(");
    assert_eq!(corners.matches("base.moved(").count(), 1);
    let signs =
        corners.lines().find(|line| line.contains("let (pp, pm, mp, mm)")).unwrap().matches("at(").count();
    let displaced = steps.split(',').count() * signs;
    let text = include_str!("../page/learn/detective.html");
    let least = displaced + differences.matches("base.radius(").count();
    let words = format!("at least {least} displaced positions: {displaced} for the difference");
    assert!(text.contains(&words), "{words}");
    assert_eq!((signs, steps.split(',').count()), (4, 3));
    assert!(text.contains("four combinations of signs for each of three steps"));
    // Each measurement of a radius displaces the beams at least once.
    assert_eq!(differences.matches("base.radius(").count(), 2);
    assert!(text.contains("and 2 or more to choose the steps"));
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
    // Not every number that is computed from a wrong one is wrong: cells are rows of symmetry, AD first, AD second, differences.
    let [d, xi, t] = [0, 1, 3].map(|row| 4 * row);
    assert_eq!([&of_bent[1][d + 1], &of_bent[1][xi + 1]], ["✓", "✗"]);
    let straight = all(0, Some(0.0));
    assert_eq!([&straight[xi + 2], &straight[t + 2]], ["✗", "✓"]);
    // The page explains two marks, and no other occurs.
    for bend in [-0.5, 0.0, 0.25, 0.5] {
        for case in 0..6 {
            let marks = all(case, Some(bend));
            assert!(marks.iter().all(|mark| mark == "✓" || mark == "✗"), "{case} {bend}: {marks:?}");
        }
    }
}

/// The sentence names a wrong number only of a check that was run.
#[test]
fn the_detective_tells_only_what_was_run() {
    let first = |settings: &[(&str, &str)]| text(&chosen("detective", settings), "first");
    assert!(first(&[("check", "0"), ("check", "3")]).starts_with("Run automatic"));
    assert!(first(&[("check", "1")]).starts_with("No number is wrong"));
    assert!(first(&[("check", "2")]).starts_with("The first wrong number is Δδξ"));
    assert!(first(&[("next", ""), ("check", "1")]).starts_with("The first wrong number is δξ"));
    // The first wrong number has the wrong term in its formula.
    for (case, number) in ["Δδξ", "δξ", "Δδt", "δξ", "Δδg_T", "δξ"].into_iter().enumerate() {
        let mut settings = vec![("next", ""); case];
        settings.extend([("check", "1"), ("check", "2")]);
        assert!(first(&settings).starts_with(&format!("The first wrong number is {number}:")), "{case}");
    }
    // A beam that hides the error: nothing is said of the term.
    let mut state = chosen("detective", &[("next", ""), ("check", "1"), ("check", "2")])["state"].clone();
    state["bend"] = json!(0.0);
    let hidden = text(&frame("detective", &state, &Value::Null), "first");
    assert!(hidden.starts_with("No number is wrong"), "{hidden}");
}

/// The trough has a smallest distance: half, along a line.
#[test]
fn the_smallest_distance_of_a_trough_is_told() {
    let smallest = |situation| text(&chosen("valley", &[("situation", situation)]), "smallest");
    assert_eq!([smallest("straight"), smallest("arcs")], ["0.500", "0.450"]);
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
    assert_eq!(text(&accepted, "state"), "The trial force is on the edge of the cone.");
    // The slip of the step is zero, and the spring keeps its stretch.
    assert!(number(&accepted, "g_T").abs() < 1e-3 && number(&accepted, "trial_size") > 0.2);
    let back =
        frame("friction", &accepted["state"], &json!({ "drag": { "handle": "move", "to": [x + 20.0, y] } }));
    assert!(text(&back, "state").contains("sticks"), "{back}");
    // Farther back the force along the beam has changed its sign, and the contact still sticks.
    let farther =
        frame("friction", &accepted["state"], &json!({ "drag": { "handle": "move", "to": [x + 10.0, y] } }));
    assert!(text(&farther, "state").contains("sticks"), "{farther}");
    assert!(number(&accepted, "F") * number(&farther, "F") < 0.0, "{farther}");
}

/// The tangent of friction is nearly symmetric in stick, and not in slip.
#[test]
fn the_tangent_of_friction_is_not_symmetric() {
    let opening = opening("friction").unwrap().state;
    assert_eq!(opening["moved"], json!([0.04, 0.01]));
    let mut shifted = opening;
    shifted["moved"] = json!([0.1, 0.0]);
    let slips = frame("friction", &shifted, &Value::Null);
    assert!(
        text(&slips, "state").contains("slips") && text(&chosen("friction", &[]), "state").contains("sticks")
    );
    assert!(asymmetry([0.04, 0.01]).unwrap() < 0.01 && asymmetry([0.1, 0.0]).unwrap() > 0.3);
    // The normal force is that of the penalty.
    let frame = chosen("friction", &[]);
    assert!((number(&frame, "F_N") + 20.0 * number(&frame, "g_N")).abs() < 0.02);
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
