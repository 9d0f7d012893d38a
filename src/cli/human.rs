//! A run as tables for people, 80 columns wide.

use super::arguments::planted;
use super::checked::{Checked, SHOWN, Shown};
use super::count::count;
use super::disagreements;
use super::exit::Exit;
use super::searched;
use super::words::error;
use beamgap::check::{Cell, Differences, Family, Inconclusive, NotCompared, Order, Shard};
use beamgap::linearization::Quantity;
use beamgap::report::Table;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The meaning of the columns.
const COLUMNS: &str = "\
first: delta, Delta; second: Delta-delta; symmetry: of second; matrix: gradient
and Hessian times the directions; function: what linearize and others return
";

/// The text of a run: of one that fails, what fits a screen, unless all is asked for.
pub(super) fn document(shown: &Shown) -> String {
    let fails = matches!(shown.outcome.verdict.exit, Exit::Disagree | Exit::Untrusted);
    if fails && !shown.all { failure(shown) } else { all_tables(shown) }
}

/// A run that fails: the cause, then the first mismatch, then the wrong quantities.
fn failure(shown: &Shown) -> String {
    let (checked, verdict) = (&shown.checked, &shown.outcome.verdict.words);
    let mut text = format!("{}\n{verdict}\n", head(checked));
    if !checked.found.mismatches.is_empty() {
        text += &disagreements::summary(checked);
        let _ = write!(text, "\nFirst mismatch\n{}", disagreements::listed(checked, 1));
    }
    let wrong = checked.found.quantities.iter().filter(|(_, cell)| cell.over_tolerance > 1.0);
    let wrong: BTreeSet<Quantity> = wrong.map(|((quantity, _), _)| *quantity).collect();
    if !wrong.is_empty() {
        let rows = checked.found.quantities.iter().filter(|((quantity, _), _)| wrong.contains(quantity));
        let rows = rows.map(|(key, cell)| (*key, *cell)).collect();
        let table = cells(&rows, &Order::ALL, worst);
        let _ = write!(text, "\nWorst error / scale; !: beyond rounding\n{table}{COLUMNS}");
    }
    text + "\n--all shows all tables and mismatches, and the shrunk cases.\n"
}

fn all_tables(shown: &Shown) -> String {
    let checked = &shown.checked;
    let mut text = head(checked);
    let mut add = |title: &str, body: String| {
        if !body.is_empty() {
            let _ = write!(text, "\n{title}\n{body}");
        }
    };
    let mut errors = cells(&checked.found.quantities, &Order::ALL, worst);
    if !errors.is_empty() {
        errors += COLUMNS;
    }
    if !checked.found.mismatches.is_empty() {
        errors += "!: a number differs beyond rounding\n";
    }
    add("Worst error / scale; the scale is the sum of the absolute values of all terms", errors);
    // A column for the functions would make the table wider than a terminal.
    let orders = Order::ALL.map(|order| (order != Order::Function).then_some(order));
    let orders: Vec<Order> = orders.into_iter().flatten().collect();
    add("The case with this error", cells(&checked.found.quantities, &orders, shown_by));
    add("Regimes: closest points compared, worst error, worst error / tolerance", regimes(checked));
    add(&coverage(checked), families(checked));
    add("Not compared", not_compared(checked));
    add("Differences in double-double", differences(checked));
    add("Closest points: the search, and an independent search", searched::table(checked));
    let summary = disagreements::summary(checked);
    let summary = if summary.is_empty() { summary } else { format!("\n{summary}") };
    let mismatches = disagreements::listed(checked, SHOWN) + &disagreements::more(checked, SHOWN);
    add("Mismatches", mismatches + &summary);
    add("Shrunk mismatches, as a test and as a command", disagreements::made_small(shown));
    text + "\n" + &shown.outcome.verdict.words + "\n"
}

/// The heading: the request.
pub(super) fn head(Checked { planted: plant, seed, selection, shard, .. }: &Checked) -> String {
    let family =
        selection.family.map_or_else(|| "all families".into(), |family| format!("family {}", family.name()));
    let regimes = match selection.regimes.as_slice() {
        [one] => format!("regime {}", one.name()),
        several => count(several.len(), "regime"),
    };
    let part = match selection.count(*shard) {
        _ if *shard == Shard::WHOLE => String::new(),
        cases => format!("shard {shard}, {}\n", count(cases, "case")),
    };
    format!(
        "Contact geometry of two beams: closed form and automatic differentiation\n\
         seed {seed:#x}, {regimes}, {} each, {family}\n{part}{}",
        count(selection.cases, "case"),
        planted(plant),
    )
}

/// A table with one row for each quantity and one column for each order.
fn cells(
    cells: &BTreeMap<(Quantity, Order), Cell>,
    orders: &[Order],
    show: impl Fn(&Cell) -> String,
) -> String {
    if cells.is_empty() {
        return String::new();
    }
    let mut table = Table::new(
        &["quantity"].into_iter().chain(orders.iter().map(|order| order.name())).collect::<Vec<_>>(),
    );
    for quantity in Quantity::ALL {
        let of = |&order| cells.get(&(quantity, order)).map_or_else(|| "-".into(), &show);
        table.row([quantity.name().into()].into_iter().chain(orders.iter().map(of)).collect());
    }
    table.to_string()
}

/// The error, marked if it exceeds a tolerance.
fn worst(cell: &Cell) -> String {
    error(cell.scaled_error) + if cell.over_tolerance > 1.0 { "!" } else { "" }
}

fn shown_by(cell: &Cell) -> String {
    case_of(cell).unwrap_or_else(|| "-".into())
}

fn regimes(checked: &Checked) -> String {
    let titles = ["regime", "cases", "inside", "at ends", "differ", "error", "case", "/ tol."];
    let mut table = Table::new(&titles);
    for (regime, tally) in &checked.found.regimes {
        let counts =
            [tally.cases, tally.interior, tally.at_end, tally.mismatches].map(|count| count.to_string());
        let worst = match tally.worst.entries {
            0 => ["-"; 3].map(String::from),
            _ => [
                error(tally.worst.scaled_error),
                case_of(&tally.worst).unwrap_or_else(|| "-".into()),
                // Rounded down, so that 1 is shown only if the tolerance is exceeded.
                error(if tally.worst.over_tolerance < 1.0 {
                    tally.worst.over_tolerance.min(0.99)
                } else {
                    tally.worst.over_tolerance
                }),
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
        checked.found.pairs.len()
    )
}

fn families(checked: &Checked) -> String {
    let mut table = Table::default().left(&[0, 2, 4]);
    for families in Family::ALL.chunks(3) {
        let count = |family| checked.found.families.get(family).copied().unwrap_or(0).to_string();
        table.row(families.iter().flat_map(|family| [family.name().into(), count(family)]).collect());
    }
    table.to_string()
}

fn not_compared(checked: &Checked) -> String {
    let mut table = Table::new(&["reason", "count", "first case"]);
    let reasons = reasons(checked);
    for (reason, NotCompared { count, first_case }) in &reasons {
        table.row(vec![reason.reason().into(), count.to_string(), first_case.to_string()]);
    }
    if reasons.is_empty() { String::new() } else { table.to_string() }
}

/// The results of the third oracle.
fn differences(checked: &Checked) -> String {
    let Differences { points, unclear, decided, quantities: of } = &checked.found.differences;
    if *points == 0 {
        return String::new();
    }
    format!(
        "  computed at {}; at {unclear} of them the tolerance for AD is larger\n  \
         than 1e-3 of a scale, and they decided {decided}\n\nWorst difference from them / scale\n{}",
        count(*points, "closest point"),
        cells(of, &[Order::Value, Order::First, Order::Second], worst)
    )
}

/// The reasons why closest points or cases were not compared, over all regimes.
fn reasons(checked: &Checked) -> BTreeMap<Inconclusive, NotCompared> {
    let mut reasons: BTreeMap<Inconclusive, NotCompared> = BTreeMap::new();
    for (&reason, &NotCompared { count, first_case }) in
        checked.found.regimes.values().flat_map(|tally| &tally.not_compared)
    {
        let sum = reasons.entry(reason).or_insert(NotCompared { count: 0, first_case });
        (sum.count, sum.first_case) = (sum.count + count, sum.first_case.min(first_case));
    }
    reasons
}

/// The case with the worst error, if there was an error.
fn case_of(cell: &Cell) -> Option<String> {
    (cell.scaled_error > 0.0).then(|| cell.case.to_string())
}

#[cfg(test)]
mod tests;
