//! Tests: tables fit a terminal, and mismatches can be repeated.

use super::{case_of, document, error};
use crate::cli::arguments::program;
use crate::cli::checked::{Checked, Oracle, Shown};
use crate::cli::exit::Exit;
use crate::cli::words::name;
use beamgap::check::{
    Case, Cell, CheckConfig, Comparison, Family, Finding, Inconclusive, NotCompared, Order, Regime,
    Selection, Shard, Shrunk, Summary, Tally, Verdict, compare,
};
use beamgap::linearization::Quantity;
use std::collections::BTreeMap;

fn shown(found: Summary) -> (Exit, String) {
    let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 1_000_000 };
    let mut checked = Checked::new(u64::MAX, Vec::new(), Oracle::Ad, selection, Shard::WHOLE);
    checked.found = found;
    let shown = Shown { outcome: checked.outcome(), checked, shrunk: Vec::new(), cause: None, all: true };
    let text = document(&shown);
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    (shown.outcome.verdict.exit, text)
}

#[test]
fn the_largest_run_fits_a_terminal() {
    let worst = Cell { scaled_error: 1e-12, case: 51_857_137, over_tolerance: 1e-12, entries: 1 };
    let count = 1_000_000;
    let tally = Tally {
        cases: count,
        interior: count,
        at_end: count,
        mismatches: count,
        worst,
        not_compared: BTreeMap::from([(
            Inconclusive::Unresolved,
            NotCompared { count, first_case: worst.case },
        )]),
        ..Tally::default()
    };
    let cells = Quantity::ALL.iter().flat_map(|&q| Order::ALL.map(|order| ((q, order), worst)));
    shown(Summary {
        quantities: cells.collect(),
        regimes: Regime::ALL.map(|regime| (regime, tally.clone())).into(),
        families: Family::ALL.map(|family| (family, 18 * count)).into(),
        ..Summary::default()
    });
}

#[test]
fn a_disagreement_is_shown_with_the_command_that_repeats_it() {
    let case = Case::draw(u64::MAX, 17);
    let mut points = compare(&CheckConfig::default(), &case);
    let Verdict::Pass(mut entries) = points.remove(0).1 else { panic!("case 17 is a plain one") };
    let of_x = |entry: &&mut Comparison| name(entry) == "x.x" && entry.part == "value";
    for entry in entries.iter_mut().filter(of_x) {
        entry.other *= 1.0 + 1e-3;
    }
    let wrong = (None, Verdict::Mismatch(entries.clone()));
    let (exit, text) = shown(Summary::of(&case, &[wrong]));
    assert_eq!(exit, Exit::Disagree);
    assert!(text.contains("by differences in double-double: undecided"), "{text}");
    let told = format!("    repeat with:\n    {} check --seed 0xffffffffffffffff --case 17\n", program());
    assert!(text.contains(&told) && text.contains("value of x.x (value), against"), "{text}");
    assert!(text.contains("DISAGREE: 1 of 1 closest point"), "{text}");

    // One route of AD alone is wrong: the routes contradict each other, and the closed form is not rejected.
    let route = entries[0].against;
    for entry in entries.iter_mut().filter(|entry| name(entry) == "x.x" && entry.against != route) {
        entry.other = entry.closed;
    }
    let (exit, text) = shown(Summary::of(&case, &[(None, Verdict::Mismatch(entries))]));
    assert_eq!(exit, Exit::Untrusted);
    assert!(text.contains("by differences in double-double: automatic differentiation is wrong"), "{text}");
    assert!(text.contains("UNTRUSTED: in 1 case"), "{text}");
}

#[test]
fn a_disagreement_made_small_is_a_test_and_a_command() {
    let case = Case::draw(u64::MAX, 17).data();
    let (point, Verdict::Pass(mut entries)) = case.compare(&CheckConfig::default()).unwrap().remove(0) else {
        panic!("case 17 is a plain one")
    };
    let wrong = entries.iter_mut().find(|entry| entry.quantity == Quantity::Xi && entry.part == "Delta");
    wrong.unwrap().closed += 1.0;
    let finding = Finding::of(&[(point, Verdict::Mismatch(entries))]).unwrap();
    let shrunk = vec![Shrunk { number: 17, finding, case }];
    let selection = Selection { regimes: Vec::new(), family: None, cases: 1 };
    let checked = Checked::new(1, Vec::new(), Oracle::All, selection, Shard::WHOLE);
    let mut shown = Shown { outcome: checked.outcome(), checked, shrunk, cause: None, all: true };
    let text = document(&shown);
    assert!(
        text.contains("\n// From case 17: Delta of xi (first) is the first wrong number.\n#[test]\n"),
        "{text}"
    );
    assert!(text.contains("(&pair, &q, point, &dq, &linear_dq).xi.linear;\n"), "{text}");
    let planted = "// The fault is injected by the command below. Without it this test passes.\n#[test]\n";
    assert!(!text.contains(planted), "{text}");
    assert!(text.contains("\n}\necho '{") && text.contains("check --case-file - --oracle all\n"), "{text}");
    let told: serde_json::Value = serde_json::from_str(&shown.json().unwrap()).unwrap();
    let told = &told["shrunk"][0];
    assert_eq!(
        (&told["quantity"], &told["part"], &told["case"]),
        (&"xi".into(), &"Delta".into(), &17.into())
    );
    for pasted in ["test", "repeat"] {
        assert!(text.contains(told[pasted].as_str().unwrap()), "{pasted}");
    }
    assert_eq!(told["shrunk"]["beam"]["family"], "segment");
    shown.checked.planted = vec!["a: d.t,xi = dropped".into()];
    assert!(document(&shown).contains(planted));
}

#[test]
fn nothing_at_all_is_no_agreement() {
    assert_eq!(shown(Summary::default()).0, Exit::Nothing);
}

#[test]
fn a_regime_in_which_nothing_was_compared_has_no_worst() {
    let tally = Tally { cases: 3, ..Tally::default() };
    let (exit, text) = shown(Summary { regimes: [(Regime::Generic, tally)].into(), ..Summary::default() });
    assert_eq!(exit, Exit::Nothing);
    let row = text.lines().find(|line| line.starts_with("  generic")).unwrap();
    assert_eq!(row.split_whitespace().collect::<Vec<_>>(), ["generic", "3", "0", "0", "0", "-", "-", "-"]);
}

#[test]
fn reasons_add_up_over_the_regimes_and_show_their_first_case() {
    let reason = Inconclusive::Crossing;
    let tally = |count, case| {
        let what = NotCompared { count, first_case: case };
        Tally { not_compared: [(reason, what)].into(), ..Tally::default() }
    };
    let regimes = [(Regime::Generic, tally(30, 90)), (Regime::Slender, tally(5, 10))].into();
    let (_, text) = shown(Summary { regimes, ..Summary::default() });
    let row = text.lines().find(|line| line.contains(reason.reason())).unwrap();
    assert!(row.split_whitespace().rev().take(2).eq(["10", "35"]), "{row}");
    assert!(!shown(Summary::default()).1.contains("\nNot compared\n"));
}

#[test]
fn errors_have_two_digits_and_the_case_that_showed_them() {
    assert_eq!((error(0.0), error(0.123)), ("0".to_owned(), "1.2e-1".to_owned()));
    let cell = |scaled_error| Cell { scaled_error, case: 7, over_tolerance: 0.0, entries: 1 };
    assert_eq!((case_of(&cell(1e-9)), case_of(&cell(0.0))), (Some("7".to_owned()), None));
}
