//! What does not agree, for people: the numbers, and a small case to paste.

use super::arguments::planting;
use super::case_file;
use super::check::{Checked, SHOWN};
use super::human::{name, repeat};
use beamgap::check::{Case, Comparison, Regime, Shrunk, look_at, test_source};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The first of them, each with the command that repeats it.
pub(super) fn listed(checked: &Checked) -> String {
    let mut text = String::new();
    let (all, first) = (&checked.summary.mismatches, &checked.summary.first);
    // One of each kind, then others.
    let mut kinds = BTreeSet::new();
    let (mut shown, others): (Vec<u64>, Vec<u64>) =
        all.keys().partition(|number| kinds.insert(first.get(number)));
    shown.extend(others);
    shown.truncate(SHOWN);
    for (&number, entry) in shown.iter().filter_map(|number| all.get_key_value(number)) {
        let Case { regime, families: [beam, bar], .. } = Case::draw(checked.seed, number);
        let _ =
            writeln!(text, "  case {number}: {}, {} and {}", Regime::name(regime), beam.name(), bar.name());
        text += &mismatch(entry);
        if let Some(who) = checked.summary.arbitrations.get(&number) {
            let _ = writeln!(text, "    by differences in double-double: {}", who.words());
        }
        let _ =
            writeln!(text, "    repeat with: {}", repeat(checked.seed, number) + &planting(&checked.plant));
    }
    match all.len().saturating_sub(SHOWN) {
        0 => {}
        rest => drop(writeln!(text, "  and {rest} more")),
    }
    let mut counts: BTreeMap<_, usize> = BTreeMap::new();
    for kind in first.values() {
        *counts.entry(kind).or_default() += 1;
    }
    if let Some((&&(order, quantity), count)) = counts.iter().max_by_key(|(_, count)| **count) {
        let (cases, order_name, name) = (first.len(), order.name(), quantity.name());
        let _ = write!(
            text,
            "\n  {count} of {cases} begin with {name} ({order_name}):\n  look at {}\n",
            look_at(order, quantity)
        );
    }
    text
}

/// What is left of the disagreements, wider than a terminal: it is to be pasted.
pub(super) fn made_small(checked: &Checked) -> String {
    let each = checked.shrunk.iter().map(|Shrunk { number, case, finding }| {
        let entry = &finding.entry;
        format!(
            "\n// From case {number}: {} of {} ({}) is the first wrong number.\n{}{}\n",
            entry.part,
            name(entry),
            entry.order.name(),
            test_source(case, finding.minimum, entry),
            case_file::command(case) + &planting(&checked.plant)
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
