//! The command line measures its own tolerances, and uses a third oracle.

use crate::program::{json, run, stdout};
use serde_json::Value;

#[test]
fn measured_bounds_hold() {
    let arguments = ["bounds", "--cases", "3", "--family", "arc", "--regime", "near-end"];
    let text = stdout(&run(&arguments));
    assert!(text.contains("BOUNDS HOLD") && text.lines().all(|line| line.chars().count() <= 80), "{text}");
    let document = json(&run(&[&arguments[..], &["--format", "json"]].concat()));
    assert_eq!(document["schema"], "beamgap-bounds/3");
    assert_eq!(document["found"]["violations"], serde_json::json!({}));
    let command = document["environment"]["command"].as_str().unwrap();
    assert_eq!(command, "beamgap bounds --seed 0x5eed --cases 3 --regime near-end --family arc");
}

#[test]
fn bounds_are_shown_for_each_side_and_regime() {
    let arguments = ["bounds", "--cases", "1", "--family", "segment"];
    let document = json(&run(&[&arguments[..], &["--format", "json"]].concat()));
    let command = document["environment"]["command"].as_str().unwrap();
    assert_eq!(command, "beamgap bounds --seed 0x5eed --cases 1 --family segment");
    assert_eq!(document["found"]["points"].as_object().unwrap().len(), 10);

    let text = stdout(&run(&arguments));
    let (_, sides) = text.split_once("\nBy regime: closed form\n").unwrap();
    let (closed_form, ad) = sides.split_once("\nBy regime: AD\n").unwrap();
    let (ad, kernel) = ad.split_once("\nBy regime: kernel\n").unwrap();
    let (kernel, _) = kernel.split_once("\nPoints whose tolerance is too wide\n").unwrap();
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    for (side, shown) in [("closed form", closed_form), ("AD", ad), ("kernel", kernel)] {
        let has_order = |line: &&str| {
            line.split_whitespace().nth(1).is_some_and(|order| ["value", "first", "second"].contains(&order))
        };
        let told: Vec<_> = shown.lines().filter(has_order).collect();
        let of_order = |order: &str| document["found"]["regimes"][side][order].as_object().unwrap().len();
        assert_eq!(told.len(), ["value", "first", "second"].map(of_order).iter().sum::<usize>(), "{shown}");
        for line in told {
            let names: Vec<_> = line.split_whitespace().take(2).collect();
            let row = &document["found"]["regimes"][side][names[1]][names[0]];
            let error = row["error"]["max"].as_f64().unwrap();
            let last: f64 = line.split_whitespace().last().unwrap().parse().unwrap();
            assert!((last - error).abs() <= 0.06 * error, "{line}: {row}");
        }
    }
}

#[test]
fn the_third_oracle_is_asked_on_demand() {
    let arguments = ["check", "--cases", "14", "--regime", "nearly-parallel", "--oracle", "all"];
    let document = json(&run(&[&arguments[..], &["--format", "json"]].concat()));
    let counts = &document["found"]["differences"];
    assert!(counts["points"].as_u64() > Some(0), "{counts}");
    assert!(stdout(&run(&arguments)).contains("\nDifferences in double-double\n  computed at "));

    let case = json(&run(&["check", "--case", "45", "--oracle", "all", "--format", "json"]));
    let entries = case["closest_points"][0]["entries"].as_array().unwrap();
    let asked = entries.iter().filter(|entry| entry["against"] == "differences in double-double");
    assert_eq!(asked.clone().count(), 4 * 23);
    assert!(asked.clone().all(|entry| entry["agrees"] == true));
    let own = |entry: &Value| {
        let [bound, tolerance] = [&entry["bound"], &entry["tolerance"]].map(|x| x.as_f64().unwrap());
        tolerance < 2.0 * bound
    };
    assert!(asked.filter(|entry| own(entry)).count() >= 80, "the estimates are no wider than the bounds");
    assert!(case["closest_points"][0]["arbitration"].is_null());
}

/// Where AD's tolerance is not meaningful, that of the third oracle is.
#[test]
fn the_third_oracle_decides_what_ad_cannot() {
    let case = ["check", "--seed", "7", "--case", "518"];
    assert_eq!(run(&case).status.code(), Some(4));
    assert!(stdout(&run(&[&case[..], &["--oracle", "all"]].concat())).contains("\nAGREE"));
}
