//! A run as one JSON document, of the schema `beamgap-check/1`.
//!
//! Names and meanings stay; entries may be added. Errors have two digits; what is infinite or not a number is null.

use super::case_file;
use super::check::{Checked, Verdict};
use super::disagreements;
use super::human::repeat;
use beamgap::check::{Cell, Comparison, Order, Shrunk, Tally};
use beamgap::linearization::Quantity;
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// All that is to be said about a run.
pub(super) fn document(checked: &Checked, verdict: &Verdict) -> anyhow::Result<String> {
    let Checked { plant, seed, selection, summary, .. } = checked;
    let regimes = summary.regimes.iter().map(|(regime, tally)| tallied(regime.name(), tally));
    let families =
        summary.families.iter().map(|(family, count)| json!({ "family": family.name(), "compared": count }));
    let pairs = summary
        .pairs
        .iter()
        .map(|((beam, bar), count)| json!({ "beam": beam.name(), "bar": bar.name(), "compared": count }));
    let mismatches = summary.mismatches.iter().map(|(&number, entry)| {
        let who = summary.arbitrations.get(&number).map(|who| who.name());
        let case = json!({
            "case": number,
            "repeat": repeat(*seed, number) + &checked.options(),
            "arbitration": who,
            "candidate": summary.kinds.get(&number).map(|kind| kind.candidate),
        });
        with(case, compared(entry))
    });
    let shrunk = checked.shrunk.iter().map(|shrunk| {
        let Shrunk { number, case, finding } = shrunk;
        let found = json!({
            "case": number,
            "minimum": finding.minimum,
            "test": disagreements::test(shrunk, plant),
            "repeat": case_file::command(case) + &checked.options(),
            "shrunk": case_file::object(case),
        });
        with(found, compared(&finding.entry))
    });
    text(&json!({
        "schema": "beamgap-check/1",
        "version": env!("CARGO_PKG_VERSION"),
        "seed": format!("{seed:#x}"),
        "planted": plant,
        "selection": {
            "regimes": selection.regimes.iter().map(|regime| regime.name()).collect::<Vec<_>>(),
            "family": selection.family.map(beamgap::check::Family::name),
            "cases": selection.cases,
        },
        "verdict": verdict.name,
        "compared": summary.compared(),
        "quantities": quantities(&summary.cells),
        "regimes": regimes.collect::<Vec<_>>(),
        "families": families.collect::<Vec<_>>(),
        "pairs": pairs.collect::<Vec<_>>(),
        "differences": {
            "points": summary.differences.points,
            "unclear": summary.differences.unclear,
            "decided": summary.differences.decided,
            "quantities": quantities(&summary.differences.cells),
        },
        "mismatches": mismatches.collect::<Vec<_>>(),
        "shrunk": shrunk.collect::<Vec<_>>(),
    }))
}

fn quantities(cells: &BTreeMap<(Quantity, Order), Cell>) -> Vec<Value> {
    let each = cells.iter().map(|((quantity, order), cell)| {
        with(json!({ "quantity": quantity.name(), "order": order.name() }), worst(cell))
    });
    each.collect()
}

fn tallied(regime: &str, tally: &Tally) -> Value {
    let not_compared = tally.inconclusive.iter().map(
        |(reason, (count, first))| json!({ "reason": reason.reason(), "count": count, "first_case": first }),
    );
    json!({
        "regime": regime,
        "cases": tally.cases,
        "interior": tally.interior,
        "at_end": tally.at_end,
        "mismatches": tally.mismatches,
        "worst": worst(&tally.worst),
        "not_compared": not_compared.collect::<Vec<_>>(),
    })
}

fn worst(cell: &Cell) -> Value {
    json!({
        "entries": cell.entries,
        "scaled_error": rounded(cell.scaled_error),
        "case": (cell.scaled_error > 0.0).then_some(cell.case),
        "over_tolerance": rounded(cell.over_tolerance),
    })
}

/// One entry, with all digits.
pub(super) fn compared(entry: &Comparison) -> Value {
    json!({
        "quantity": entry.quantity.name(),
        "component": entry.axis,
        "order": entry.order.name(),
        "part": entry.part,
        "against": entry.against,
        "closed": entry.closed,
        "other": entry.other,
        "difference": entry.difference(),
        "scale": entry.scale,
        "bound": entry.bound,
        "tolerance": entry.tolerance,
        "agrees": entry.agrees(),
    })
}

/// The document as text: indented, with a final newline.
pub(super) fn text(document: &impl Serialize) -> anyhow::Result<String> {
    Ok(serde_json::to_string_pretty(document)? + "\n")
}

/// Both objects in one.
fn with(mut object: Value, more: Value) -> Value {
    if let (Value::Object(object), Value::Object(more)) = (&mut object, more) {
        object.extend(more);
    }
    object
}

/// Two digits: the others depend on the machine.
pub(super) fn rounded(error: f64) -> Option<f64> {
    format!("{error:.1e}").parse().ok().filter(|error: &f64| error.is_finite())
}
