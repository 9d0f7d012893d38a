//! A run as tables for people, 80 columns wide.

use super::case_file;
use super::check::{Checked, SHOWN, Verdict};
use super::table::Table;
use beamgap::check::{
    Case, Cell, Comparison, Differences, Family, Inconclusive, Order, Regime, Shrunk, test_source,
};
use beamgap::linearization::Quantity;
use std::collections::BTreeMap;
use std::fmt::Write;

/// All that is to be said about a run.
pub(super) fn document(checked: &Checked, verdict: &Verdict) -> String {
    let mut text = title(checked);
    let mut add = |title: &str, body: String| {
        if !body.is_empty() {
            let _ = write!(text, "\n{title}\n{body}");
        }
    };
    add(
        "Worst error over scale, the sum of the sizes of its terms",
        cells(checked, |cell| error(cell.scaled_error)),
    );
    add("The case that showed it", cells(checked, |cell| case_of(cell).unwrap_or_else(|| "-".into())));
    add("Regimes: closest points compared, worst error, and most of a tolerance used", regimes(checked));
    add(&coverage(checked), families(checked));
    add("Not compared", not_compared(checked));
    add("Differences in double-double", differences(checked));
    add("Disagreements", mismatches(checked));
    add("Made small: as a test, and as a command", shrunk(checked));
    text + "\n" + &verdict.words + "\n"
}

fn title(Checked { seed, selection, .. }: &Checked) -> String {
    let family =
        selection.family.map_or_else(|| "all families".into(), |family| format!("family {}", family.name()));
    let regimes = match selection.regimes.as_slice() {
        [one] => format!("regime {}", one.name()),
        several => format!("{} regimes", several.len()),
    };
    format!(
        "Contact geometry of two beams: closed form against automatic differentiation\n\
         seed {seed:#x}, {regimes}, {} cases each, {family}\n\n\
         first: delta and Delta; second: Delta-delta; symmetry: second, with the\n\
         directions exchanged; matrix: gradient and Hessian times the directions\n",
        selection.cases
    )
}

fn cells(checked: &Checked, show: impl Fn(&Cell) -> String) -> String {
    let cells = &checked.summary.cells;
    if cells.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&[&["quantity"], &Order::ALL.map(Order::name)[..]].concat());
    for quantity in Quantity::ALL {
        let of = |order| cells.get(&(quantity, order)).map_or_else(|| "-".into(), &show);
        table.row([quantity.name().into()].into_iter().chain(Order::ALL.map(of)).collect());
    }
    table.to_string()
}

fn regimes(checked: &Checked) -> String {
    let titles = ["regime", "cases", "inside", "at ends", "differ", "error", "case", "of tol."];
    let mut table = Table::new(&titles);
    for (regime, tally) in &checked.summary.regimes {
        let counts =
            [tally.cases, tally.interior, tally.at_end, tally.mismatches].map(|count| count.to_string());
        let worst = match tally.worst.entries {
            0 => ["-"; 3].map(String::from),
            _ => [
                error(tally.worst.scaled_error),
                case_of(&tally.worst).unwrap_or_else(|| "-".into()),
                error(tally.worst.over_tolerance),
            ],
        };
        table.row([regime.name().into()].into_iter().chain(counts).chain(worst).collect());
    }
    table.to_string()
}

fn coverage(checked: &Checked) -> String {
    let of = Family::ALL.len().pow(2);
    format!(
        "Families: closest points compared; {} of {of} ordered pairs of families",
        checked.summary.pairs.len()
    )
}

fn families(checked: &Checked) -> String {
    let mut table = Table::default().left(&[0, 2, 4]);
    for families in Family::ALL.chunks(3) {
        let count = |family| checked.summary.families.get(family).copied().unwrap_or(0).to_string();
        table.row(families.iter().flat_map(|family| [family.name().into(), count(family)]).collect());
    }
    table.to_string()
}

fn not_compared(checked: &Checked) -> String {
    let mut table = Table::new(&["reason", "count", "first case"]);
    let reasons = reasons(checked);
    for (reason, (count, case)) in &reasons {
        table.row(vec![reason.reason().into(), count.to_string(), case.to_string()]);
    }
    if reasons.is_empty() { String::new() } else { table.to_string() }
}

/// What the third oracle was asked.
fn differences(checked: &Checked) -> String {
    let Differences { points, unclear, decided } = checked.summary.differences;
    if points == 0 {
        return String::new();
    }
    format!(
        "  asked at {points} closest points; of {unclear} where the tolerance for AD means nothing,\n  \
         they decided {decided}\n"
    )
}

/// Why closest points or cases were not compared, over all regimes.
fn reasons(checked: &Checked) -> BTreeMap<Inconclusive, (u64, u64)> {
    let mut reasons = BTreeMap::new();
    for (&reason, &(count, case)) in checked.summary.regimes.values().flat_map(|tally| &tally.inconclusive) {
        let sum = reasons.entry(reason).or_insert((0, case));
        *sum = (sum.0 + count, sum.1.min(case));
    }
    reasons
}

fn mismatches(checked: &Checked) -> String {
    let mut text = String::new();
    let all = &checked.summary.mismatches;
    for (&number, entry) in all.iter().take(SHOWN) {
        let Case { regime, families: [beam, bar], .. } = Case::draw(checked.seed, number);
        let _ =
            writeln!(text, "  case {number}: {}, {} and {}", Regime::name(regime), beam.name(), bar.name());
        text += &mismatch(entry);
        if let Some(who) = checked.summary.arbitrations.get(&number) {
            let _ = writeln!(text, "    by differences in double-double: {}", who.words());
        }
        let _ = writeln!(text, "    repeat with: {}", repeat(checked.seed, number));
    }
    match all.len().saturating_sub(SHOWN) {
        0 => {}
        rest => drop(writeln!(text, "  and {rest} more")),
    }
    text
}

/// What is left of the disagreements, wider than a terminal: it is to be pasted.
fn shrunk(checked: &Checked) -> String {
    let each = checked.shrunk.iter().map(|Shrunk { number, case, finding }| {
        let entry = &finding.entry;
        format!(
            "\n// From case {number}: {} of {} ({}) is the first wrong number.\n{}{}\n",
            entry.part,
            name(entry),
            entry.order.name(),
            test_source(case, finding.minimum, entry),
            case_file::command(case)
        )
    });
    each.collect()
}

fn mismatch(entry: &Comparison) -> String {
    format!(
        "    {} of {} ({}), against: {}\n    closed form {:e}, other {:e}\n    \
         difference {:.1e}, tolerance {:.1e}, scale {:.1e}\n",
        entry.part,
        name(entry),
        entry.order.name(),
        entry.against,
        entry.closed,
        entry.other,
        entry.difference(),
        entry.tolerance,
        entry.scale
    )
}

/// The quantity with its component.
pub(super) fn name(entry: &Comparison) -> String {
    entry
        .axis
        .map_or_else(|| entry.quantity.name().into(), |axis| format!("{}.{axis}", entry.quantity.name()))
}

/// The command that shows one case again.
pub(super) fn repeat(seed: u64, number: u64) -> String {
    format!("beamgap check --seed {seed:#x} --case {number}")
}

/// Two digits.
pub(super) fn error(error: f64) -> String {
    if error == 0.0 { "0".into() } else { format!("{error:.1e}") }
}

/// The case that showed the worst error, if there was an error.
fn case_of(cell: &Cell) -> Option<String> {
    (cell.scaled_error > 0.0).then(|| cell.case.to_string())
}

#[cfg(test)]
mod tests;
