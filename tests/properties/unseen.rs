//! `beamgap export` names the sides of the symmetries that no case shows.

use crate::program::{run, stdout};
use nalgebra::Vector3;
use serde_json::Value;

/// An export without the expected answers: its cases, and what it says.
fn exported(more: &[&str]) -> (Vec<Value>, String) {
    let output = run(&[&["export", "--expected", "none"], more].concat());
    assert!(output.status.success(), "{output:?}");
    let cases = stdout(&output).lines().skip(1).map(|line| serde_json::from_str(line).unwrap()).collect();
    (cases, String::from_utf8(output.stderr).unwrap())
}

/// The sides in the list, and the first line.
fn unseen(told: &str) -> (String, Vec<String>) {
    let (first, list) = told.split_once('\n').unwrap();
    let list = list.split_whitespace().collect::<Vec<_>>().join(" ");
    (first.to_owned(), list.split(", ").map(str::to_owned).collect())
}

fn vector(of: &Value) -> Vector3<f64> {
    Vector3::from_fn(|i, _| of[i].as_f64().unwrap())
}

/// Some quantities whose signs are exchanged by a symmetry, from the written numbers alone; zero where there is none.
fn quantities(case: &Value) -> [f64; 7] {
    let [beam, bar] = ["beam", "bar"].map(|name| &case["jets"][name]);
    let [x, t, x_bar, t_bar] = [&beam["x"], &beam["t"], &bar["x"], &bar["t"]].map(vector);
    let d = x - x_bar;
    let number = |of: &Value| of.as_f64().unwrap();
    let held = case["held"].as_str().unwrap();
    let [xi, xi_bar] = ["xi", "xi_bar"].map(|name| number(&case["point"][name]));
    let [r, r_bar] = ["radius", "radius_bar"].map(|name| number(&case["contact"][name]));
    let end = if matches!(held, "xi" | "both") { xi } else { 0.0 };
    let end_bar = if matches!(held, "xi_bar" | "both") { xi_bar } else { 0.0 };
    let side = d.dot(&t.cross(&t_bar)) / (d.norm() * t.norm() * t_bar.norm());
    let side = if side.abs() > 1e-9 { side } else { 0.0 };
    [side, t.dot(&t_bar), xi, end, end_bar, r - r_bar, d.norm() - r - r_bar]
}

const SIDES: [[&str; 2]; 7] = [
    ["d along t × t̄", "d against t × t̄"],
    ["acute crossing", "obtuse crossing"],
    ["upper half of the beam", "lower half of the beam"],
    ["held at ξ = 1", "held at ξ = -1"],
    ["held at ξ̄ = 1", "held at ξ̄ = -1"],
    ["beam is thicker", "bar beam is thicker"],
    ["open gap", "closed gap"],
];

#[test]
fn the_smallest_export_names_exactly_the_sides_that_it_does_not_show() {
    let mut named = 0;
    for seed in ["1", "2", "3", "4", "5", "6"] {
        for family in [&[][..], &["--family", "hermite"]] {
            let (cases, told) = exported(&[&["--cases", "1", "--seed", seed], family].concat());
            assert_eq!(cases.len(), 10);
            let (first, list) = unseen(&told);
            let sides = if list.len() == 1 { "1 side".into() } else { format!("{} sides", list.len()) };
            let expected =
                format!("Not seen by 10 cases: {sides} of the symmetries. More --cases show more.");
            assert_eq!(first, expected);
            assert!(told.lines().all(|line| line.chars().count() <= 80), "{told}");
            for (i, sides) in SIDES.iter().enumerate() {
                for (side, sign) in sides.iter().zip([1.0, -1.0]) {
                    let is_seen = cases.iter().any(|case| quantities(case)[i] * sign > 0.0);
                    assert_eq!(list.iter().any(|of| of == side), !is_seen, "seed {seed}: {side}: {told}");
                    named += usize::from(!is_seen);
                }
            }
        }
    }
    assert!(named > 10, "{named}");
}

#[test]
fn an_export_that_shows_all_sides_says_nothing() {
    for more in
        [&[][..], &["--family", "segment"], &["--family", "arc"], &["--family", "segment", "--penetrating"]]
    {
        let (_, told) = exported(&[&["--cases", "40"], more].concat());
        assert_eq!(told, "", "{more:?}");
    }
}

/// Of contact elements the states, and in which of them a parameter becomes held.
#[test]
fn an_export_of_elements_names_the_situations_that_it_does_not_show() {
    let mut named = 0;
    for more in [
        &["--cases", "1"][..],
        &["--cases", "3"],
        &["--cases", "4"],
        &["--cases", "4", "--regime", "generic"],
    ] {
        let output = run(&[&["export", "--element"], more].concat());
        let cases: Vec<Value> =
            stdout(&output).lines().skip(1).map(|line| serde_json::from_str(line).unwrap()).collect();
        let told = String::from_utf8(output.stderr).unwrap();
        let told = told.split_once("No contact element shows").map_or("", |(_, told)| told);
        let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
        let shows = |is_meant: &dyn Fn(&Value) -> bool| cases.iter().any(is_meant);
        for state in ["open", "frictionless", "stick", "slip"] {
            let is_shown = shows(&|case| case["expected"]["state"] == state);
            assert_eq!(told.contains(&format!("the state {state}")), !is_shown, "{more:?}: {told}");
            named += usize::from(!is_shown);
        }
        for (name, words) in [("xi", "ξ"), ("xi_bar", "ξ̄")] {
            let is_held = |of: &Value| of == name || of == "both";
            for state in ["stick", "slip"] {
                let is_shown = shows(&|case| {
                    let before = &case["element"]["history"]["slips"]["held"];
                    case["expected"]["state"] == state
                        && is_held(&case["held"])
                        && before.is_string()
                        && !is_held(before)
                });
                let words = format!("{words} becomes held in {state}");
                assert_eq!(told.contains(&words), !is_shown, "{more:?}: {told}");
                named += usize::from(!is_shown);
            }
        }
    }
    assert!(named > 4, "{named}");
}
