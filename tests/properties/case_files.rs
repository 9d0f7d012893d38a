//! Cases as files: they are read back without a change, or rejected with the place of the error.

use crate::program::{command, message, run, stdout};
use serde_json::{Value, json};
use std::io::Write as _;
use std::process::{Output, Stdio};

/// Checks the case on standard input.
fn check(case: &str, more: &[&str]) -> Output {
    let mut command = command(&[&["check", "--case-file", "-"], more].concat());
    let piped = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = piped.spawn().unwrap();
    child.stdin.take().unwrap().write_all(case.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn a_case_is_read_back_to_the_last_bit() {
    // One case for each family, and all regimes.
    for k in 0..11 {
        let drawn = run(&["check", "--case", &(109 * k).to_string(), "--format", "json"]);
        let text = String::from_utf8(drawn.stdout).unwrap();
        let read = check(&text, &["--format", "json"]);
        assert_eq!((read.status.code(), read.stderr), (drawn.status.code(), Vec::new()));
        let mut drawn: Value = serde_json::from_str(&text).unwrap();
        for origin in ["seed", "case", "regime"] {
            assert!(drawn.as_object_mut().unwrap().remove(origin).is_some());
        }
        assert!(drawn == serde_json::from_slice::<Value>(&read.stdout).unwrap(), "case {}", 109 * k);
    }
}

#[test]
fn a_file_is_as_good_as_standard_input() {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("case.json");
    let case = run(&["check", "--case", "17", "--format", "json"]).stdout;
    std::fs::write(&path, &case).unwrap();
    let from_file = run(&["check", "--case-file", path.to_str().unwrap()]);
    let from_stdin = check(std::str::from_utf8(&case).unwrap(), &[]);
    assert!(from_file.status.success() && from_file.stdout == from_stdin.stdout);
    let text = String::from_utf8(from_file.stdout).unwrap();
    assert!(text.starts_with("segment and quadratic\n") && text.contains("\nAGREE: "), "{text}");
}

/// The document of a small case.
fn document() -> Value {
    let line = |q: [f64; 6]| json!({ "family": "segment", "q": q, "dq": [1.0, 0.0, 0.0, 0.0, 0.0, 0.0], "linear_dq": vec![0; 6] });
    json!({
        "schema": "beamgap-case/1",
        "beam": line([-1.0, 0.0, 2.0, 1.0, 0.0, 2.0]),
        "bar": line([0.0, -1.0, 1.0, 0.0, 1.0, 1.0]),
    })
}

fn refused(text: &str) -> String {
    let output = check(text, &[]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(3), 0), "{output:?}");
    let told = message(&output);
    assert_eq!(told.lines().count(), 1, "{told}");
    let told = told.trim_end().strip_prefix("error: standard input is not ").unwrap_or(&told).to_owned();
    told.strip_prefix("a case: ").map(str::to_owned).unwrap_or(told)
}

#[test]
fn a_bad_case_is_refused_with_its_place() {
    assert!(check(&document().to_string(), &[]).status.success());
    let families = "segment, quadratic, cubic, hermite, hermite-scaled, bezier, bspline, nurbs, nurbs-weighted, \
                    arc, helix";
    let knots = |knots: [f64; 6]| json!({ "knots": knots });
    let curved = |family: &str, curve: Value, dofs: usize| {
        let zero = vec![0; dofs];
        json!({ "family": family, "curve": curve, "q": zero, "dq": zero, "linear_dq": zero })
    };
    let spline = |curve: Value| curved("bspline", curve, 12);
    let nurbs = |weights: Value| curved("nurbs", json!({ "knots": [0, 1, 2, 3], "weights": weights }), 9);
    let told = [
        (
            "/schema",
            json!("beamgap-check/1"),
            "schema: \"beamgap-case/1\" expected, found \"beamgap-check/1\"".into(),
        ),
        ("/schema", json!(1), "schema: \"beamgap-case/1\" expected, found 1".into()),
        ("/beam", json!(7), "beam: an object expected, found 7".into()),
        ("/bar/family", json!("rope"), format!("bar.family: one of {families} expected, found \"rope\"")),
        ("/bar/family", json!(null), format!("bar.family: one of {families} expected, found null")),
        ("/bar/q", json!([1, 2]), "bar.q: 6 numbers expected, found 2".into()),
        ("/bar/dq", json!({}), "bar.dq: 6 numbers expected, found an object".into()),
        ("/beam/linear_dq/3", json!("x"), "beam.linear_dq[3]: a number expected, found \"x\"".into()),
        ("/beam/q/5", json!(null), "beam.q[5]: a number expected, found null".into()),
        ("/beam", spline(json!({})), "beam.curve.knots: missing, 6 numbers expected".into()),
        ("/beam", spline(json!([])), "beam.curve: an object expected, found a list".into()),
        ("/beam", spline(json!({ "knots": 1 })), "beam.curve.knots: 6 numbers expected, found 1".into()),
        (
            "/beam",
            spline(knots([0.0, 1.0, 2.0, 1.5, 3.0, 4.0])),
            "beam: the parameters make no curve: knot 3 is less than the knot before it; knots must not decrease".into(),
        ),
        ("/beam", spline(knots([1.0; 6])), "beam: the parameters make no curve: the span from 1 to 1 has no length".into()),
        (
            "/bar",
            nurbs(json!([1, 0, 1])),
            "bar: the parameters make no curve: weight 1 is 0, but weights must be positive and finite".into(),
        ),
    ];
    for (place, value, expected) in told {
        let mut document = document();
        *document.pointer_mut(place).unwrap() = value;
        assert_eq!(refused(&document.to_string()), expected);
    }
    let without = [
        ("", "schema", "schema: missing, \"beamgap-case/1\" expected".into()),
        ("", "bar", "bar: missing".into()),
        ("/beam", "family", format!("beam.family: missing, one of {families} expected")),
        ("/beam", "dq", "beam.dq: missing, 6 numbers expected".into()),
    ];
    for (place, name, expected) in without {
        let mut document = document();
        document.pointer_mut(place).unwrap().as_object_mut().unwrap().remove(name);
        assert_eq!(refused(&document.to_string()), expected);
    }
    let with = [
        ("", "contct", json!({}), "contct: no such entry, expected beam, bar, contact, "),
        ("/beam", "Dq", json!([]), "beam.Dq: no such entry, expected family, curve, q, dq, linear_dq"),
        ("/beam", "curve", json!({ "knots": [] }), "beam.curve.knots: no such entry, expected nothing"),
        (
            "",
            "contact",
            json!({ "xi": 0 }),
            "contact.xi: no such entry, expected radius, radius_bar, xi_0, xi_bar_0",
        ),
        ("", "contact", json!({ "radius": "1" }), "contact.radius: a number expected, found \"1\""),
        (
            "",
            "contact",
            json!({ "radius_bar": -0.5 }),
            "contact.radius_bar: a number from 0 on expected, found -0.5",
        ),
    ];
    for (place, name, value, expected) in with {
        let mut document = document();
        document.pointer_mut(place).unwrap()[name] = value;
        let told = refused(&document.to_string());
        assert!(told.starts_with(expected), "{told}");
    }
}

#[test]
fn what_is_no_case_at_all_is_refused() {
    assert_eq!(refused(""), "JSON: EOF while parsing a value at line 1 column 0");
    assert_eq!(refused("{\"beam\":\n NaN}"), "JSON: expected value at line 2 column 2");
    assert_eq!(refused("[1e999]"), "JSON: number out of range at line 1 column 6");
    assert_eq!(refused("[]"), "the document: an object expected, found a list");
    let output = run(&["check", "--case-file", "/nowhere"]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(told, "error: cannot read /nowhere: No such file or directory (os error 2)\n");
    assert_eq!(output.status.code(), Some(3));
    let output = run(&["check", "--case-file", "-", "--seed", "1"]);
    assert_eq!(output.status.code(), Some(2));
}

/// Two lines that cross above the origin. There x is zero, and it is compared as elsewhere.
#[test]
fn a_closest_point_at_the_origin_is_compared() {
    let line = |q: [f64; 6], dq: [f64; 6], linear_dq: [f64; 6]| json!({ "family": "segment", "q": q, "dq": dq, "linear_dq": linear_dq });
    let varied = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let beam = line([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], varied, [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    let bar = line([0.0, -1.0, 1.0, 0.0, 1.0, 1.0], [0.0; 6], [0.0; 6]);
    let output = check(
        &json!({ "schema": "beamgap-case/1", "beam": beam, "bar": bar }).to_string(),
        &["--format", "json"],
    );
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&found["closest_points"][0]["point"]["xi"], &found["verdict"]),
        (&json!(0.0), &json!("agree"))
    );
}

/// Automatic differentiation overflows in these directions. Nothing can be compared, and no one is accused.
#[test]
fn directions_beyond_the_range_are_not_compared() {
    let line = |q: [f64; 6], dq: [f64; 6], linear_dq: [f64; 6]| json!({ "family": "segment", "q": q, "dq": dq, "linear_dq": linear_dq });
    for huge in [1e200, 1e300, 1e307, 1e308] {
        for other in [0.0, 1.0, 1e-300, huge] {
            let along = |size: f64| [size, 0.0, 0.0, -0.5 * size, size, 0.0];
            let beam = line([-1.0, 0.0, 0.0, 1.0, 0.0, 0.1], [0.3 * huge; 6], along(other));
            let bar = line([0.0, -1.0, 1.0, 0.0, 1.0, 1.3], along(other), along(huge));
            let document = json!({ "schema": "beamgap-case/1", "beam": beam, "bar": bar }).to_string();
            let output = check(&document, &["--format", "json"]);
            assert_eq!(output.status.code(), Some(4), "{huge:e}, {other:e}");
            let found: Value = serde_json::from_slice(&output.stdout).unwrap();
            let point = &found["closest_points"][0];
            assert_eq!(
                (&found["verdict"], &point["reason"], &point["arbitration"]),
                (
                    &json!("nothing-compared"),
                    &json!("overflow or underflow: beyond the range of f64"),
                    &Value::Null
                )
            );
        }
    }
}

/// The search leaves the whole square of two parallel beams open. The distance is by hand.
#[test]
fn an_open_region_is_shown_with_its_distance() {
    let line =
        |q: [f64; 6]| json!({ "family": "segment", "q": q, "dq": vec![0.5; 6], "linear_dq": vec![0.25; 6] });
    let beam = line([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    let bar = line([0.999, 0.001, 0.0, 10.999, 0.001, 0.0]);
    let document = json!({ "schema": "beamgap-case/1", "beam": beam, "bar": bar }).to_string();
    let output = check(&document, &["--format", "json"]);
    assert_eq!(output.status.code(), Some(4));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let region = &found["open_regions"][0];
    assert_eq!(region["reason"], "the centroids are parallel");
    let [low, high] = [0, 1].map(|i| region["smallest_distance"][i].as_f64().unwrap());
    assert!(low <= 0.001 && low > 0.001 - 1e-11 && (high - 0.001).abs() < 1e-15, "{region}");
    let text = String::from_utf8(check(&document, &[]).stdout).unwrap();
    assert!(text.contains("\nopen region: the centroids are parallel\n  xi from -1e0 to 1e0\n"), "{text}");
    // The document is a case file again.
    assert_eq!(check(&found.to_string(), &[]).status.code(), Some(4));
}

/// Reports identify cases by their numbers alone, so a number must always draw the same beams.
#[test]
fn a_number_draws_the_case_that_it_always_drew() {
    let golden = include_str!("../golden/case.txt");
    let now = stdout(&run(&["check", "--case", "17"]));
    let dofs = |text: &str| -> Vec<(String, f64)> {
        let dof = |line: &str| {
            let (name, number) = line.trim().split_once(" = ")?;
            name.ends_with(']').then(|| (name.to_owned(), number.parse().unwrap()))
        };
        text.lines().filter_map(dof).collect()
    };
    let (now, then) = (dofs(&now), dofs(golden));
    assert_eq!(then.len(), 3 * (6 + 9));
    for ((name, now), (known, then)) in now.iter().zip(&then) {
        assert!(name == known && (now - then).abs() <= 1e-9 * then.abs(), "{name} = {now}, {known} = {then}");
    }
}

#[test]
fn what_is_not_compared_is_shown_with_what_was_tried() {
    let output = run(&["check", "--seed", "7", "--case", "518"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("\nNot compared: the rounding bound exceeds 1e-3 of a scale\n"), "{text}");
    let rows = |told: &str| text.lines().filter(|line| line.ends_with(told)).count();
    assert!(rows(" unclear") > 0 && rows(" agrees") > 0 && rows(" WRONG") == 0, "{text}");
}
