//! The entries of fault injection, for the formats of programs.

use crate::cli::count::count as counted;
use crate::cli::exit::Exit;
use crate::cli::outcome::{Entry, Outcome, Source, State, Verdict};
use beamgap::check::Regime;
use beamgap::closest_point::SearchFault;
use beamgap::faults::{Check, Gate, OneSided, Operations, SearchFaults};
use beamgap::number::Formula;
use beamgap::report::Faults;
use beamgap::variant::{Rewrite, catalogue};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The outcome of a record, with one entry for each formula of the closed form, and one for each code in whose single
/// operations faults were injected.
pub(super) fn outcome(record: &Faults) -> Outcome {
    let mut formulas: BTreeMap<Formula, usize> = BTreeMap::new();
    for fault in catalogue() {
        *formulas.entry(fault.label.formula).or_default() += 1;
    }
    let ours = record.terms.detections.iter().filter(|of| matches!(of.check, Check::Gate | Check::Exact));
    let missed: Vec<_> = ours
        .flat_map(|of| record.terms.missed_by(of.check, of.regime).map(move |fault| (of, fault)))
        .collect();
    let of_formulas = formulas.into_iter().map(|(formula, count)| {
        let missed: BTreeSet<_> = missed
            .iter()
            .filter(|(_, fault)| Formula::of_term(fault).is_some_and(|(of, _)| of == formula))
            .map(|(of, fault)| {
                format!("{fault} ({}, {})", of.check.name(), of.regime.map_or("-", Regime::name))
            })
            .collect();
        let state = State::of(count as u64, missed.len() as u64);
        let message = match state {
            State::Differs => format!("not detected: {}", missed.into_iter().collect::<Vec<_>>().join("; ")),
            _ if count == 1 => "the only fault is detected".to_owned(),
            _ => format!("all {count} faults are detected"),
        };
        let number = formula.equations().first().copied();
        let (group, name) = ("formula".into(), formula.name().to_owned());
        Entry { group, name, state, message, source: Source::of_equation(number) }
    });
    let of_operations = record.operations.iter().map(of_operations);
    let of_search = record.search.iter().map(of_search);
    let of_sides = record.one_sided.iter().map(of_sides);
    let of_gate = record.gate.iter().map(of_gate);
    let (exit, name) =
        if record.holds { (Exit::Agree, "detected") } else { (Exit::Untrusted, "not-detected") };
    let verdict = Verdict::new(exit, name, words(record));
    let entries = of_formulas.chain(of_operations).chain(of_search).chain(of_sides).chain(of_gate).collect();
    Outcome { command: "faults", verdict, entries }
}

/// The entry of the faults in single operations of a code.
fn of_operations(of: &Operations) -> Entry {
    let open: usize = of.undetected.iter().filter(|of| of.reason.is_none()).map(|of| of.operations).sum();
    Entry {
        group: "operations".into(),
        name: format!("{}, {}", of.code, of.place),
        state: State::of(of.faults as u64, open as u64),
        message: format!(
            "{} of {} detected; {} without a reason",
            of.detected,
            counted(of.faults, "fault"),
            counted(open, "operation")
        ),
        source: None,
    }
}

/// The entry of the faults of the search in a regime.
fn of_search(of: &SearchFaults) -> Entry {
    let missed: Vec<_> = of.missed.iter().map(|fault| fault.name()).collect();
    let message = match (missed.is_empty(), of.rejected) {
        (true, 0) => format!("all {} faults are detected", of.detected.len()),
        (true, rejected) => format!("the unmodified search is rejected at {}", counted(rejected, "pair")),
        _ => format!("not detected: {}", missed.join(", ")),
    };
    let wrong = missed.len() as u64 + of.rejected;
    let (group, name) = ("search".into(), of.regime.name().to_owned());
    let source = Some(Source { file: "src/closest_point.rs".to_owned(), line: 1 });
    Entry { group, name, state: State::of(SearchFault::ALL.len() as u64, wrong), message, source }
}

/// The entry of the faults that act on one side only.
fn of_sides(of: &OneSided) -> Entry {
    let message = match of.missed.as_slice() {
        [] => format!("all {} that act at all are detected", counted(of.detected, "fault")),
        missed => {
            let missed = missed.iter().map(|(fault, side)| format!("{fault} ({side})"));
            format!("not detected: {}", missed.collect::<Vec<_>>().join("; "))
        }
    };
    let state = State::of(of.planted as u64, u64::from(!of.holds()));
    Entry { group: "sides".into(), name: "on one side only".into(), state, message, source: None }
}

/// The entry of the gate in a regime.
fn of_gate(of: &Gate) -> Entry {
    let short = of.counts.iter().filter(|(_, [found, wanted])| found != wanted);
    let short: Vec<_> =
        short.map(|(of, [found, wanted])| format!("{found} of {wanted} {}", of.name())).collect();
    let message = match (short.is_empty(), of.holds()) {
        (true, true) => "everything is compared, within narrow tolerances".to_owned(),
        (true, false) => format!(
            "{} of {} small changes of terms are rejected; the median of the smallest is {:.1e}",
            of.rejected, of.terms, of.median.0
        ),
        (false, _) => format!("compared: {}", short.join(", ")),
    };
    let source = Some(Source { file: "src/check/compare.rs".to_owned(), line: 1 });
    let state = State::of(of.terms as u64, u64::from(!of.holds()));
    Entry { group: "gate".into(), name: of.regime.name().to_owned(), state, message, source }
}

pub(super) fn words(record: &Faults) -> String {
    let faults = record.terms.faults();
    if !record.holds {
        return "NOT DETECTED: the check misses a fault, rejects an equivalent formula or the\n\
                search, does not cover an operation, does not compare everything, or a part of\n\
                this run is missing."
            .into();
    }
    let rewrites = Rewrite::ALL.len();
    let mut of_terms = format!(
        "DETECTED: all {faults} faults of terms; none of {rewrites} equivalent formulas is rejected."
    );
    if !record.search.is_empty() {
        let _ = write!(
            of_terms,
            "\nAll {} of the search are detected.",
            counted(SearchFault::ALL.len(), "fault")
        );
    }
    if let Some(of) = record.elements.first() {
        let _ =
            write!(of_terms, "\nAll {} of the contact element are detected.", counted(of.planted, "fault"));
    }
    if let Some(of) = &record.one_sided {
        let count = counted(of.detected, "fault");
        let _ = write!(of_terms, "\nAll {count} on one side of a symmetry only are detected.");
    }
    if !record.gate.is_empty() {
        of_terms += "\nThe gate compares everything, within narrow tolerances.";
    }
    let count: usize = record.operations.iter().map(|row| row.faults).sum();
    if count == 0 {
        return of_terms;
    }
    let count = counted(count, "fault");
    format!("{of_terms}\nOf {count} of single operations, each is detected or has a reason.")
}
