//! The result for the answers of a program, as JSON.

use super::diagnosis::Diagnosed;
use super::verdict;
use crate::cli::json;
use crate::cli::outcome::Verdict;
use crate::cli::verify::Verified;
use beamgap::check::external::{Explanation, locate};
use beamgap::linearization::Quantity;
use serde_json::{Value, json};

/// The result as JSON, of the schema `beamgap-verify/1`.
pub(in crate::cli) fn json(verified: &Verified, diagnosed: &Diagnosed) -> anyhow::Result<String> {
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
        "agrees_if": diagnosed.conventions,
        "explanation": diagnosed.explanation.as_ref().map(explanation),
    }))
}

/// An explanation as JSON.
pub(in crate::cli) fn explanation(of: &Explanation) -> Value {
    let causes = of
        .causes
        .iter()
        .map(|cause| json!({ "name": cause.name, "words": cause.words, "coefficient": cause.coefficient, "alike": cause.alike }));
    json!({
        "causes": causes.collect::<Vec<_>>(),
        "before": json::rounded(of.before),
        "after": of.after.and_then(json::rounded),
        "runner_up": of.runner_up.as_ref().map(|(words, left)| json!({ "words": words, "left": json::rounded(*left) })),
        "cases": of.cases,
        "is_faint": of.is_faint,
    })
}
