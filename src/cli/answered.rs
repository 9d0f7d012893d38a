//! What was found of the answers of a program, for people and for programs.

use super::exit::Exit;
use super::human::error;
use super::json;
use super::outcome::{Entry, Outcome, Source, State, Verdict};
use super::verify::Verified;
use beamgap::check::external::{
    Cause, Explanation, Judged, Location, PartFound, Report, explain, locate, other_conventions,
};
use beamgap::check::{Order, look_at};
use beamgap::linearization::Quantity;
use beamgap::report::Table;
use serde_json::{Value, json};
use std::fmt::Write;

/// What the answers amount to.
pub(super) fn verdict(Verified { report, .. }: &Verified) -> Verdict {
    let Report { compared, wrong, doubted, missing, unanswered, vectors, .. } = report;
    let open = missing + unanswered;
    let open =
        if open == 0 { String::new() } else { format!(" {open} of {vectors} cases are not answered.") };
    let (exit, name, words) = match (*compared, *wrong) {
        (0, _) => (
            Exit::Nothing,
            "nothing-compared",
            format!("NOTHING COMPARED: of {vectors} cases none has an answer that can be.{open}"),
        ),
        (_, 0) => (
            Exit::Agree,
            "agree",
            format!("AGREES: at {compared} closest points nothing differs beyond rounding.{open}"),
        ),
        (_, wrong) if wrong == *doubted => (
            Exit::Untrusted,
            "not-trusted",
            format!("NOT TRUSTED: at {doubted} of {compared} closest points the references disagree."),
        ),
        _ => {
            let words = format!("DISAGREES: at {wrong} of {compared} closest points.{open}");
            (Exit::Disagree, "disagree", words)
        }
    };
    Verdict { exit, name, words }
}

/// The same with one entry for each order of each quantity.
pub(super) fn outcome(verified: &Verified) -> Outcome {
    let report = &verified.report;
    let answered = report.parts.iter().map(|((_, quantity, part), found)| {
        let PartFound { numbers, losing, wrong, worst, case, wrong_at, .. } = found;
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
            source: wrong_at.as_ref().and_then(Source::of_answer),
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
    // What is zero to the last bit has all digits.
    let error = if error.is_nan() { 0.0 } else { error };
    format!("{:.1}", (-error.log10()).clamp(0.0, 16.0))
}

/// What is asked, before anything is found.
pub(super) fn head(command: &str, digits: Option<u8>, reason: Option<&str>) -> String {
    let mut text = format!("Answers of {command}\n");
    if let Some(digits) = digits {
        let reason = reason.map_or_else(String::new, |reason| format!(": {reason}"));
        let _ =
            writeln!(text, "{digits} significant digits are asked for, wherever they are attainable{reason}");
    }
    text
}

/// The tables.
pub(super) fn human(verified: &Verified) -> String {
    let Verified { report, command, reason, .. } = verified;
    let mut text = head(command, verified.demands.digits, reason.as_deref());
    let _ = writeln!(text, "{} cases", report.vectors);
    if !report.parts.is_empty() {
        let titles = ["quantity", "order", "numbers", "wrong", "fewer digits", "digits", "attainable"];
        let mut table = Table::new(&titles).left(&[1]);
        for ((_, quantity, part), found) in &report.parts {
            table.row(vec![
                quantity.name().into(),
                (*part).into(),
                found.numbers.to_string(),
                found.wrong.to_string(),
                found.losing.to_string(),
                digits(found.worst.loss / found.worst.scale),
                digits(found.worst.attainable / found.worst.scale),
            ]);
        }
        let _ = write!(text, "\n{table}");
        text += "digits: of the number next to its tolerance or farthest beyond it; attainable: there, by the best formulas\n";
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

fn name_of(comparison: &beamgap::check::Comparison) -> String {
    super::human::name(comparison)
}

/// What was not compared.
fn left_out(report: &Report) -> String {
    let mut text = String::new();
    for (reason, count) in &report.degenerate {
        let _ = writeln!(text, "\nNot compared: {count} cases: {reason}");
    }
    if report.missing > 0 {
        let first = report.first_missing.as_deref().unwrap_or_default();
        let _ = writeln!(text, "\nNot answered: {} cases, the first is {first}", report.missing);
    }
    if report.unanswered > 0 {
        let _ = writeln!(text, "\nAnswered without a number: {} cases", report.unanswered);
    }
    let never = report.never_answered();
    if !never.is_empty() && !report.parts.is_empty() {
        let never: Vec<_> = never.into_iter().map(Quantity::name).collect();
        let _ = writeln!(text, "\nNever answered: {}", never.join(", "));
    }
    text
}

/// What is wrong, and why.
pub(super) fn explained(verified: &Verified) -> String {
    let Verified { report, demands, .. } = verified;
    let mut text = String::new();
    let Some((vector, answers, judged)) = &report.first else { return text };
    text += &first(judged, &vector.id, &answers.place.to_string());
    if let Some(location) = locate(vector, answers, judged, &demands.conventions) {
        text += &entry(&location, demands.conventions.first_index);
    }
    if let Some(((order, quantity, part), count)) = report.beginning() {
        let _ = writeln!(
            text,
            "The first wrong number is {part} of {} in {count} of {} wrong cases: look at {}",
            quantity.name(),
            report.wrong,
            at(order, quantity)
        );
    }
    if judged.is_rounding {
        text += "Rounding of the textbook formulas explains it: the formulas are right, but keep too few digits here.\n";
    } else if let Some(words) = other_conventions(&report.kept, demands) {
        let _ = writeln!(text, "The answers agree if {words}.\nState it in the head of the answers.");
    } else if let Some(explanation) = explain(&report.kept, demands) {
        text += &cause(&explanation);
    }
    text + "\n"
}

/// What is wrong, or that it is not known.
pub(super) fn cause(explanation: &Explanation) -> String {
    let Explanation { causes, before, after, runner_up, cases, is_faint } = explanation;
    let after = after.map_or_else(|| "-".into(), error);
    let runner_up = runner_up.as_ref();
    let mut text = String::new();
    match causes.as_slice() {
        [] if *is_faint => {
            text += "Cause: not known. The answers are so little off that no wrong term is told from right answers by their \
                     digits.\nIf you need fewer digits, ask for these: --digits.\n";
            return text;
        }
        [] => {
            let best = runner_up.map_or_else(String::new, |(words, left)| {
                format!(" The best attempt leaves {}: {words}.", error(*left))
            });
            let _ =
                writeln!(text, "Cause: not known. No fault of the catalogue explains {cases} cases.{best}");
            return text;
        }
        [one] => {
            let _ = writeln!(text, "Cause: {}{}.", one.words, coefficient(one));
        }
        several => {
            let _ = writeln!(text, "Cause: one of {}, which these answers cannot tell apart:", several.len());
            for one in several {
                let _ = writeln!(text, "  - {}{}", one.words, coefficient(one));
            }
        }
    }
    let left = runner_up.map_or_else(|| "none".into(), |(_, left)| error(*left));
    let _ = writeln!(
        text,
        "With it the deviation of {cases} cases falls from {} to {after}; runner-up {left}.",
        error(*before)
    );
    let names: Vec<_> = causes.iter().map(|cause| format!("`{}`", cause.name)).collect();
    let _ = writeln!(text, "In the catalogue: {}", names.join(", "));
    text
}

fn coefficient(cause: &Cause) -> String {
    cause.coefficient.map_or_else(String::new, |of| format!(" (coefficient {of:+.3})"))
}

fn at(order: Order, quantity: Quantity) -> &'static str {
    match (order, quantity) {
        (Order::Value, Quantity::Xi | Quantity::XiBar) => {
            "the closest point: another minimum, or an iteration that has not converged"
        }
        _ => look_at(order, quantity),
    }
}

fn first(judged: &Judged, case: &str, place: &str) -> String {
    let comparison = &judged.comparison;
    format!(
        "First wrong number, {place}, case {case}: {} of {}\n  answered {:e}\n  expected {:e}\n  difference {}, tolerance {}, scaled error {}\n",
        comparison.part,
        name_of(comparison),
        comparison.closed,
        comparison.other,
        error(comparison.difference()),
        error(comparison.tolerance),
        error(comparison.scaled_error())
    )
}

fn entry(location: &Location, first_index: usize) -> String {
    let indices: Vec<_> = location.indices.iter().map(|i| (i + first_index).to_string()).collect();
    let mut text = format!(
        "Entry of the {} that differs most: [{}], {}\n  answered {:e}\n  expected {:e}\n  scaled error {}, {} entries differ\n",
        location.what,
        indices.join(","),
        location.block.join(" x "),
        location.answered,
        location.expected,
        error(location.scaled_error),
        location.differing
    );
    if location.is_antisymmetric {
        text += "The matrix of differences is antisymmetric: a term is transposed.\n";
    }
    text
}

/// The result for programs, of the schema `beamgap-verify/1`.
pub(super) fn json(verified: &Verified, explain: bool) -> anyhow::Result<String> {
    let Verified { report, demands, command, reason } = verified;
    let parts = report.parts.iter().map(|((_, quantity, part), found)| {
        json!({
            "quantity": quantity.name(),
            "order": part,
            "numbers": found.numbers,
            "wrong": found.wrong,
            "losing_digits": found.losing,
            "unclear": found.unclear,
            "worst": {
                "case": found.case,
                "error": json::rounded(found.worst.loss / found.worst.scale),
                "comparison": json::compared(&found.worst.comparison),
            },
        })
    });
    let regimes = report.regimes.iter().map(|(name, found)| {
        json!({
            "regime": name,
            "compared": found.compared,
            "wrong": found.wrong,
            "losing_digits": found.losing,
            "largest_error": found.worst.as_ref().map(|worst| json!({
                "error": json::rounded(worst.error()),
                "attainable": json::rounded(worst.judged.attainable / worst.judged.size),
                "case": worst.case,
                "comparison": json::compared(&worst.judged.comparison),
            })),
            "largest_loss": found.loss.as_ref().map(|loss| json!({
                "digits": json::rounded(loss.digits()),
                "case": loss.case,
                "comparison": json::compared(&loss.judged.comparison),
            })),
        })
    });
    let first = report.first.as_ref().map(|(vector, answers, judged)| {
        let location = locate(vector, answers, judged, &demands.conventions);
        json!({
            "case": vector.id,
            "file": answers.place.file,
            "line": answers.place.line,
            "comparison": json::compared(&judged.comparison),
            "entry": location.map(|location| json!({
                "of": location.what,
                "indices": location.indices,
                "block": location.block,
                "answered": location.answered,
                "expected": location.expected,
                "scaled_error": json::rounded(location.scaled_error),
            })),
        })
    });
    let Verdict { name, words, .. } = verdict(verified);
    let conventions: Option<Value> = (report.wrong > 0)
        .then(|| other_conventions(&report.kept, demands))
        .flatten()
        .map(|words| json!(words));
    let explanation = (explain && conventions.is_none())
        .then(|| self::explain(&report.kept, demands))
        .flatten()
        .map(|of| explanation(&of));
    json::text(&json!({
        "schema": "beamgap-verify/1",
        "version": env!("CARGO_PKG_VERSION"),
        "answers": command,
        "program": { "name": report.program.name, "version": report.program.version },
        "verdict": name,
        "words": words,
        "digits": demands.digits,
        "reason": reason,
        "cases": report.vectors,
        "compared": report.compared,
        "wrong": report.wrong,
        "missing": report.missing,
        "unanswered": report.unanswered,
        "not_compared": report.degenerate,
        "never_answered": report.never_answered().into_iter().map(Quantity::name).collect::<Vec<_>>(),
        "parts": parts.collect::<Vec<_>>(),
        "regimes": regimes.collect::<Vec<_>>(),
        "first": first,
        "agrees_if": conventions,
        "explanation": explanation,
    }))
}

/// An explanation for programs.
pub(super) fn explanation(of: &Explanation) -> Value {
    let causes = of
        .causes
        .iter()
        .map(|cause| json!({ "name": cause.name, "words": cause.words, "coefficient": cause.coefficient }));
    json!({
        "causes": causes.collect::<Vec<_>>(),
        "before": json::rounded(of.before),
        "after": of.after.and_then(json::rounded),
        "runner_up": of.runner_up.as_ref().map(|(words, left)| json!({ "words": words, "left": json::rounded(*left) })),
        "cases": of.cases,
        "is_faint": of.is_faint,
    })
}
