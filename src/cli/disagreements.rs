//! Mismatches, for people: the numbers, and a minimal case as a test and as a command.

use super::case_file;
use super::checked::{Checked, Shown};
use super::count;
use super::terminal::folded;
use super::words::{error, name, repeat};
use beamgap::check::external::{Cause, Explanation};
use beamgap::check::{
    Case, Comparison, LikelyCause, Mismatch, MismatchKind, Regime, Shrunk, layer, look_at, test_source,
};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// The first mismatches, at most `count`, each with the command that repeats it.
pub(super) fn listed(checked: &Checked, count: usize) -> String {
    let mut text = String::new();
    let all = &checked.found.mismatches;
    // First one mismatch of each kind, then others.
    let mut met = BTreeSet::new();
    let (mut shown, others): (Vec<_>, Vec<_>) = all
        .iter()
        .map(|(number, mismatch)| (*number, mismatch.kind))
        .partition(|(_, kind)| met.insert(*kind));
    shown.extend(others);
    shown.truncate(count);
    for (&number, Mismatch { arbitration, worst, .. }) in
        shown.iter().filter_map(|(number, _)| all.get_key_value(number))
    {
        let Case { regime, families: [beam, bar], .. } = Case::draw(checked.seed, number);
        let _ =
            writeln!(text, "  case {number}: {}, {} and {}", Regime::name(regime), beam.name(), bar.name());
        text += &mismatch(worst);
        if let Some(who) = arbitration {
            let _ = writeln!(text, "    by differences in double-double: {}", who.words());
        }
        let command = repeat(checked.seed, number) + &checked.options();
        let _ = writeln!(text, "    repeat with:\n    {command}");
    }
    text
}

/// The number of mismatches that are not among the first `count`.
pub(super) fn more(checked: &Checked, count: usize) -> String {
    match checked.found.mismatches.len().saturating_sub(count) {
        0 => String::new(),
        rest => format!("  and {rest} more\n"),
    }
}

/// The first wrong number of most cases, and where to look; empty if nothing is wrong.
pub(super) fn summary(checked: &Checked) -> String {
    let mut text = String::new();
    let mut counts: BTreeMap<_, usize> = BTreeMap::new();
    for kind in checked.found.mismatches.values().filter_map(|mismatch| mismatch.kind) {
        *counts.entry(kind).or_default() += 1;
    }
    if let Some((MismatchKind { candidate, order, quantity }, count)) =
        counts.iter().max_by_key(|(_, count)| **count)
    {
        let cases: usize = counts.values().sum();
        let (order_name, name, cases) = (order.name(), quantity.name(), count::count(cases, "case"));
        let _ = write!(
            text,
            "In {count} of {cases} the first wrong number is {name} ({order_name}) of: {candidate}\n  \
             wrong layer: {}\n  look at {}\n",
            layer(*order),
            look_at(*order, *quantity)
        );
    }
    text
}

/// The likely cause in a sentence, 80 columns wide.
pub(super) fn likely(LikelyCause { explanation }: &LikelyCause) -> String {
    let Explanation { causes, runner_up, .. } = explanation;
    let Some(Cause { words, coefficient, .. }) = causes.first() else {
        return "Likely cause: not known. No known error explains the mismatches.".into();
    };
    let coefficient = coefficient.map(|of| format!("coefficient {of:+.3}"));
    let second =
        runner_up.as_ref().map(|second| format!("the next best cause leaves {}", error(second.left)));
    let others = match causes.len() {
        1 => None,
        2 => Some("or 1 other, which has the same results here".to_owned()),
        count => Some(format!("or {} others, which have the same results here", count - 1)),
    };
    let details: Vec<_> = [others, coefficient, second].into_iter().flatten().collect();
    let details = if details.is_empty() { String::new() } else { format!(" ({})", details.join("; ")) };
    folded(&format!("Likely cause: {words}{details}."), "", "  ")
}

/// The shrunk mismatches, wider than a terminal because they are copied and pasted.
pub(super) fn made_small(Shown { checked, shrunk, .. }: &Shown) -> String {
    let each = shrunk.iter().map(|shrunk| {
        let Shrunk { number, case, finding } = shrunk;
        let entry = &finding.entry;
        format!(
            "\n// From case {number}: {} of {} ({}) is the first wrong number.\n{}{}\n",
            entry.part,
            name(entry),
            entry.order.name(),
            test(shrunk, &checked.planted),
            case_file::command(case) + &checked.options()
        )
    });
    each.collect()
}

/// The test of a shrunk case; a comment says if the fault is only injected.
pub(super) fn test(Shrunk { number, case, finding }: &Shrunk, plant: &[String]) -> String {
    let without = match plant {
        [] => "",
        _ => "// The fault is injected by the command below. Without it this test passes.\n",
    };
    without.to_owned() + &test_source(case, finding.minimum, &finding.entry, Some(*number))
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
