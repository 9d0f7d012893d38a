//! What does not agree, for people: the numbers, and a small case to paste.

use super::arguments::planting;
use super::case_file;
use super::check::{Checked, SHOWN};
use super::human::{name, repeat};
use beamgap::check::{Case, Comparison, Regime, Shrunk, test_source};
use std::fmt::Write;

/// The first of them, each with the command that repeats it.
pub(super) fn listed(checked: &Checked) -> String {
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
        let _ =
            writeln!(text, "    repeat with: {}", repeat(checked.seed, number) + &planting(&checked.plant));
    }
    match all.len().saturating_sub(SHOWN) {
        0 => {}
        rest => drop(writeln!(text, "  and {rest} more")),
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
