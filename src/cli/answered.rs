//! The result for the answers of a program, for people and for programs.

mod diagnosis;
mod json;
mod verdict;
mod verified;

use super::count::count as counted;
use super::outcome::{Entry, Outcome, Source, State};
use super::terminal::folded;
use super::words::{error, name as name_of};
use beamgap::check::external::{PartFound, Report, is_of_element};
use beamgap::linearization::Quantity;
use beamgap::report::Table;
pub(super) use diagnosis::{Diagnosed, first_wrong};
pub(super) use json::json;
use std::fmt::Write;
pub(super) use verdict::verdict;
pub(super) use verified::Verified;

/// The verdict with one entry for each order of each quantity.
pub(super) fn outcome(verified: &Verified) -> Outcome {
    let report = &verified.report;
    let answered = report.parts.iter().map(|((_, quantity, part), found)| {
        let PartFound { numbers, losing, wrong, worst, case, place, .. } = found;
        let shown = if *wrong > 0 {
            let comparison = &worst.comparison;
            format!(
                "; case {case}: answered {:e}, expected {:e}, tolerance {}",
                comparison.closed,
                comparison.other,
                error(comparison.tolerance)
            )
        } else {
            format!("; {losing} have fewer digits than are attainable")
        };
        Entry {
            group: (*part).to_owned(),
            name: quantity.name().to_owned(),
            state: State::of(*numbers, *wrong),
            message: format!("{wrong} of {numbers} numbers are wrong{shown}"),
            source: if *wrong > 0 { Source::of_answer(place) } else { None },
        }
    });
    let never = report.never_answered().into_iter().map(|quantity| Entry {
        group: "answers".to_owned(),
        name: quantity.name().to_owned(),
        state: State::NotCompared,
        message: "never answered".to_owned(),
        source: None,
    });
    Outcome { command: "verify", verdict: verdict(verified), entries: answered.chain(never).collect() }
}

/// Decimal digits of a relative error.
fn digits(error: f64) -> String {
    // An error of zero counts as all digits.
    let error = if error.is_nan() { 0.0 } else { error };
    format!("{:.1}", (-error.log10()).clamp(0.0, 16.0).abs())
}

/// The heading: the command, and the requested digits with the reason.
pub(super) fn head(command: &str, digits: Option<u8>, reason: Option<&str>) -> String {
    let mut text = format!("Answers of {command}\n");
    if let Some(digits) = digits {
        let reason = reason.map_or_else(String::new, |reason| format!(": {reason}"));
        let _ = writeln!(text, "{digits} significant digits are required where they are attainable{reason}");
    }
    text
}

/// The tables.
pub(super) fn human(verified: &Verified) -> String {
    let Verified { report, command, reason, .. } = verified;
    let mut text = head(command, verified.demands.digits, reason.as_deref());
    let _ = writeln!(text, "{}", counted(report.vectors, "case"));
    if !report.parts.is_empty() {
        let titles = ["quantity", "order", "numbers", "wrong", "fewer digits", "digits", "bound"];
        let mut table = Table::new(&titles).left(&[1]);
        for ((_, quantity, part), found) in &report.parts {
            let owner = if is_of_element(part) { "element" } else { quantity.name() };
            table.row(vec![
                owner.into(),
                (*part).into(),
                found.numbers.to_string(),
                found.wrong.to_string(),
                found.losing.to_string(),
                digits(found.largest_error.error()),
                digits(found.largest_error.judged.attainable / found.largest_error.judged.size),
            ]);
        }
        let _ = write!(text, "\n{table}");
        text += "digits: correct digits of the number with the fewest\n\
                 bound: digits that the best formulas keep there at least\n";
    }
    let losing: Vec<_> =
        report.regimes.iter().filter_map(|(name, of)| Some((name, of, of.loss.as_ref()?))).collect();
    if !losing.is_empty() {
        text += "\nRight, but with fewer digits than are attainable\n";
        let mut table = Table::new(&["regime", "cases", "fewer", "at most lost", "of", "case"]).left(&[4]);
        for (name, of, loss) in losing {
            let comparison = &loss.judged.comparison;
            table.row(vec![
                name.clone(),
                of.compared.to_string(),
                of.losing.to_string(),
                format!("{:.1} digits", loss.digits()),
                format!("{} of {}", comparison.part, name_of(comparison)),
                loss.case.clone(),
            ]);
        }
        let _ = write!(text, "{table}");
    }
    text += &left_out(report);
    text + "\n"
}

/// The cases and answers that were not compared.
fn left_out(report: &Report) -> String {
    let mut text = String::new();
    for (reason, count) in &report.degenerate {
        let _ = writeln!(text, "\nNot compared: {}: {reason}", counted(*count, "case"));
    }
    if report.missing > 0 {
        let first = report.first_missing.as_deref().unwrap_or_default();
        let _ = writeln!(text, "\nNot answered: {}, the first is {first}", counted(report.missing, "case"));
    }
    if report.unanswered > 0 {
        let _ = writeln!(text, "\nAnswered without a number: {}", counted(report.unanswered, "case"));
    }
    let never = report.never_answered();
    if !never.is_empty() && !report.parts.is_empty() {
        let never: Vec<_> = never.into_iter().map(Quantity::name).collect();
        let _ = write!(text, "\n{}\n", folded(&format!("Never answered: {}", never.join(", ")), "", "  "));
    }
    text
}
