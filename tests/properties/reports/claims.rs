//! What README and guides claim, from the committed records.

use super::committed;
use beamgap::check;
use beamgap::equations;
use beamgap::faults::{Check, Operations};
use beamgap::report::{Accuracy, Bounds, Crosscheck, Equations, Faults, Record};
use beamgap::variant::{Code, Rewrite};

/// What README and docs/check.md state.
pub(super) fn claims() -> [String; 8] {
    let crosscheck = Crosscheck::from_json(&committed("crosscheck.json")).unwrap();
    let bounds = Bounds::from_json(&committed("bounds.json")).unwrap();
    let faults = Faults::from_json(&committed("faults.json")).unwrap();
    let equations = Equations::from_json(&committed("equations.json")).unwrap();
    let accuracy = Accuracy::from_json(&committed("accuracy.json")).unwrap();
    let at =
        |rows: &[check::Level], at: f64| *rows.iter().find(|row| (row.at / at - 1.0).abs() < 1e-9).unwrap();
    let (gap, angle) = (at(&accuracy.found.gaps, 1e-6), at(&accuracy.found.angles, 1e-5));
    let error = |error: Option<f64>| format!("{:.1e}", error.unwrap());
    let (crosscheck, bounds) = (crosscheck.found, bounds.found);
    let numbers: u64 = crosscheck.quantities.values().map(|cell| cell.entries).sum();
    let left = crosscheck.regimes.values().map(check::Tally::left_out);
    let of_terms = faults.terms.faults();
    let detections = || faults.terms.detections.iter();
    let of_gate = || detections().filter(|row| row.check == Check::Gate);
    assert!(of_gate().all(|row| row.detected == of_terms && row.false_positives.is_empty()));
    let one_sided = faults.one_sided.as_ref().unwrap();
    let operations: usize = faults.operations.iter().map(|row| row.faults).sum();
    let detected: usize = faults.operations.iter().map(|row| row.detected).sum();
    assert!(faults.operations.iter().all(Operations::is_whole), "each undetected fault has a reason");
    let of_sample = |code: Code| {
        let rows = faults.sampled.iter().filter(|row| row.code == code);
        rows.fold([0_usize; 2], |[detected, all], row| [detected + row.detected, all + row.faults])
            .map(|number| count(number as u64))
    };
    let [equations_in_f64, matrices_in_f64] = [Code::Equations, Code::Matrices].map(of_sample);
    let misprints =
        equations.table.equations.iter().filter(|row| row.verdict == equations::Verdict::Misprint).count();
    [
        format!(
            "| Closed form and automatic differentiation agree. | {} closest points, {} numbers, {} regimes, {} pairs of \
             curve families: {} mismatches. {} points or cases are not compared, each with its reason. | \
             [crosscheck](reports/crosscheck.md) |",
            count(crosscheck.compared()),
            count(numbers),
            crosscheck.regimes.len(),
            crosscheck.pairs.len(),
            crosscheck.mismatches.len(),
            count(left.sum())
        ),
        format!(
            "| The tolerances are bounds on rounding error. | {} closest points: {} errors exceed their bound. | [bounds](reports/bounds.md) |",
            count(bounds.points.values().map(|points| points.measured).sum()),
            bounds.violations.len()
        ),
        format!(
            "| The check detects wrong terms. | {} of {} injected faults in each regime; {} of {} equivalent formulas rejected. | \
             [faults](reports/faults.md) |",
            count(of_terms as u64),
            count(of_terms as u64),
            of_gate().map(|row| row.false_positives.len()).max().unwrap(),
            Rewrite::ALL.len()
        ),
        format!(
            "Of {} faults that act on one side of a symmetry only and change a number, {} are detected.",
            count((one_sided.planted - one_sided.neither) as u64),
            count(one_sided.detected as u64)
        ),
        format!(
            "Of {} faults of a single operation over a prime field, {} are detected. The other {} change no result, each for a \
             stated reason. In f64, of a sample of faults that change a number, {} are detected in the equations and {} in \
             the matrices.",
            count(operations as u64),
            count(detected as u64),
            count((operations - detected) as u64),
            equations_in_f64.join(" of "),
            matrices_in_f64.join(" of ")
        ),
        format!(
            "The paper has {} equations, of which {misprints} are misprinted in the scan: [equations](reports/equations.md).",
            equations.table.equations.len()
        ),
        format!("AGREE: at {} closest points nothing differs beyond rounding.", crosscheck.compared()),
        format!(
            "At a distance of 1e-6 beam lengths the second variation of d has a median relative error of {}; the paper's formula has \
             {}. Between straight beams at an angle of 1e-5 rad the second variation of xi has a median relative \
             error of {}; the paper's formula has {}.",
            error(gap.d.chosen),
            error(gap.d.paper),
            error(angle.xi.chosen),
            error(angle.xi.paper)
        ),
    ]
}

/// A count with separators between thousands.
pub(super) fn count(number: u64) -> String {
    let digits = number.to_string();
    let grouped: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| std::str::from_utf8(group).unwrap()).collect();
    grouped.join(",")
}
