//! The scene of the hidden error.

use super::{chosen, frame, text};
use beamgap_explorer::hidden;
use serde_json::{Value, json};

/// The number of displaced pairs that the text states for the differences of one pair of directions.
#[test]
fn differences_displace_the_beams_as_often_as_the_text_says() {
    let library = include_str!("../../../../src/check/oracle.rs");
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
    let text = include_str!("../../page/learn/detective.html");
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
