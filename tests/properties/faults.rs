//! Injected faults: the checks fail for each of them, and for nothing else.

use crate::program::{json, message, run, stdout};
use beamgap::check::Regime;
use beamgap::faults::Check;
use beamgap::prove::Draw;
use beamgap::report::{Faults, Record};
use beamgap::test_beam::Family;
use beamgap::variant::{Fault, Kind, Rewrite, Variant, catalogue, catalogue_in_parts};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

fn record(reports: &Path) -> Faults {
    Faults::from_json(&fs::read_to_string(reports.join("faults.json")).unwrap()).unwrap()
}

fn committed() -> Faults {
    record(&Path::new(env!("CARGO_MANIFEST_DIR")).join("reports"))
}

#[test]
fn the_catalogue_has_every_kind_of_fault_of_every_formula() {
    let faults = catalogue();
    assert!(faults.len() >= 200, "{} faults", faults.len());
    let names: BTreeSet<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(names.len(), faults.len(), "two faults have one name");
    let mut kinds = BTreeMap::<_, usize>::new();
    for fault in &faults {
        *kinds.entry(fault.kind).or_default() += 1;
    }
    assert_eq!(kinds.len(), Kind::ALL.len(), "{kinds:?}");
    // A missing term is a fault for every term. The exception is the root of a square that is missing.
    let terms: BTreeSet<_> = faults.iter().map(|fault| fault.label).collect();
    assert_eq!(kinds[&Kind::Dropped], terms.len());
    let formulas: BTreeSet<_> = terms.iter().map(|label| label.formula.name()).collect();
    for formula in
        ["a", "a_bar", "b", "D", "R", "R_bar", "R2", "xi", "Dd x", "Dd t", "Dd|d|", "Ddg_T", "H_d", "C"]
    {
        assert!(formulas.contains(formula), "{formulas:?}");
    }
}

/// Draws inside both beams, in both formulations, and at an end of either beam.
#[test]
fn the_proof_is_red_for_every_fault() {
    let pairs = [[Family::NurbsWeighted, Family::Helix], [Family::Arc, Family::NurbsWeighted]];
    let is_refuted = |variant: &Variant| {
        let mut draws = pairs.iter().flat_map(|&families| [0, 1, 5, 6].map(|number| (families, number)));
        draws.any(|(families, number)| Draw::new(variant, 3, families, number).unequal().next().is_some())
    };
    assert!(!is_refuted(&Variant::Unmodified));
    let faults = catalogue();
    let undetected: Vec<&Fault> =
        faults.par_iter().filter(|&&fault| !is_refuted(&Variant::Faulty(vec![fault]))).collect();
    assert!(undetected.is_empty(), "{undetected:?}");
}

#[test]
fn committed_faults_are_detected_by_the_gate_alone() {
    let committed = committed();
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/faults.md")).unwrap();
    assert!(committed.page().to_markdown() == page, "faults.md is stale");
    for row in &committed.terms.detections {
        let whole = row.detected == row.planted && row.rejected == 0 && row.false_positives.is_empty();
        let ours = matches!(row.check, Check::Gate | Check::Exact);
        assert_eq!(whole && row.pairs_detected == row.pairs, ours, "{row:?}");
    }
    assert!(Rewrite::ALL.len() >= 20);
    // Undetected faults in single operations have a reason. The equations and the most used kernel have none.
    assert!(committed.operations.len() > 30);
    for row in &committed.operations {
        assert!(row.undetected.iter().all(|undetected| undetected.reason.is_some()), "{row:?}");
        let is_inside = row.place.ends_with("determinants") || row.place.ends_with("cross");
        if (row.code == "equations" && is_inside)
            || (row.code == "kernel, full" && row.place == "normal, determinants")
        {
            assert_eq!((row.detected, row.undetected.len()), (row.faults, 0), "{row:?}");
        }
    }
    // For every term and every regime, the smallest detected error is less than 1e-5 of the term.
    for (term, limits) in &committed.limits {
        assert_eq!(limits.len(), Regime::ALL.len());
        assert!(limits.values().all(|limit| limit.0 < 1e-5), "{term}: {limits:?}");
    }
}

#[test]
fn a_planted_fault_is_shrunk_and_attributed_to_the_closed_form() {
    let fault = ["--plant", "Dd|d|: d.turned = sign"];
    let few = ["--cases", "200", "--regime", "generic", "--family", "hermite"];
    let output = run(&[&["check", "--format", "json"], &few[..], &fault].concat());
    assert_eq!(output.status.code(), Some(1));
    let told = json(&output);
    assert_eq!(told["verdict"], "disagree");
    let mismatches = told["found"]["mismatches"].as_object().unwrap();
    assert!(mismatches.len() > 10);
    for (case, mismatch) in mismatches {
        assert_eq!(mismatch["arbitration"], "closed-form-wrong", "case {case}: {mismatch}");
    }
    assert_eq!(told["shrunk"][0]["quantity"], "d");
    let cause = &told["likely_cause"];
    assert_eq!(cause["explanation"]["causes"][0]["name"], "Dd|d|: d.turned = sign", "{cause}");
    assert_eq!(told["planted"], serde_json::json!(["Dd|d|: d.turned = sign"]));
    let repeat = told["repeat"].as_str().unwrap();
    assert!(repeat.ends_with(" --plant 'Dd|d|: d.turned = sign' --case"), "{repeat}");

    // Of two faults both are named.
    let two = ["--plant", "Dd|d|: du_hat.t Dxi = dropped", "--plant", "Dd|d|: dd Dd = sign"];
    let told = json(&run(&[&["check", "--format", "json"], &few[..], &two].concat()));
    let name = &told["likely_cause"]["explanation"]["causes"][0]["name"];
    assert_eq!(name, "Dd|d|: du_hat.t Dxi = dropped and Dd|d|: dd Dd = sign");

    let output = run(&[&["prove", "--draws", "4", "--family", "hermite"], &fault[..]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().contains("REFUTED"));

    let wrong = run(&["check", "--plant", "Dd|d|: d.turned = wrong"]);
    assert_eq!(wrong.status.code(), Some(2));
    let expected =
        "error: invalid value 'Dd|d|: d.turned = wrong' for '--plant <FAULT>': a term and a kind expected";
    assert!(message(&wrong).starts_with(expected), "{wrong:?}");
}

#[test]
fn the_list_of_faults_is_the_catalogue() {
    let listed = stdout(&run(&["faults", "--list"]));
    let names: Vec<String> = catalogue().iter().map(ToString::to_string).collect();
    assert_eq!(listed.lines().collect::<Vec<_>>(), names);
    // The first faults are listed while the others are still sought.
    assert!(catalogue_in_parts().next().is_some_and(|first| !first.is_empty() && first.len() < 20));
}

/// `.ci/run`, which is optimized, compares the result of a run with the committed record.
#[test]
fn the_committed_record_covers_the_catalogue() {
    let committed = committed();
    assert!(committed.holds);
    let mut kinds = BTreeMap::<_, usize>::new();
    for fault in catalogue() {
        *kinds.entry(fault.kind).or_default() += 1;
    }
    assert_eq!(committed.terms.kinds, kinds);
    for row in &committed.terms.detections {
        let missed = committed.terms.missed_by(row.check, row.regime).count();
        assert_eq!(missed, row.planted - row.detected);
    }
    assert_eq!(committed.sampled.len(), 2 * Regime::ALL.len());
    let wrong = run(&["faults", "--list", "--regime", "metres"]);
    assert_eq!(wrong.status.code(), Some(2));
}
