//! The result for the answers of a program, as JSON.

use super::diagnosis::Diagnosed;
use super::verified::Verified;
use crate::cli::json;
use crate::cli::outcome::Verdict;
use beamgap::check::external::{Explanation, Location, Place, Report, locate};
use beamgap::linearization::Quantity;
use serde::Serialize;
use serde_json::Value;

/// The result as JSON: the request, the result, and what follows from it.
pub(in crate::cli) fn json(
    verified: &Verified,
    diagnosed: &Diagnosed,
    verdict: &Verdict,
) -> anyhow::Result<String> {
    #[derive(Serialize)]
    struct Document<'a> {
        schema: &'static str,
        version: &'static str,
        answers: &'a str,
        verdict: &'static str,
        words: &'a str,
        digits: Option<u8>,
        reason: Option<&'a str>,
        #[serde(flatten)]
        report: &'a Report,
        allow_missing: bool,
        /// Whether all that was asked is answered.
        is_complete: bool,
        /// Why the success is one to look at.
        warning: Option<String>,
        never_answered: Vec<Quantity>,
        /// The parts that are answered at some cases and not at others, each with the count of cases.
        partly_answered: Vec<(String, u64)>,
        first: Option<First<'a>>,
        agrees_if: Option<&'a str>,
        /// The conventions that the explanation is valid in, if they are not the stated ones.
        nearer_if: Option<&'a str>,
        /// The significant digits of the answers, if they are few and none were requested.
        answered_digits: Option<u8>,
        explanation: Option<&'a Explanation>,
    }
    let Verified { report, demands, command, reason, allow_missing } = verified;
    let of = |agree: bool| {
        let other = diagnosed.conventions.as_ref().filter(|other| other.agree() == agree)?;
        Some(other.words.as_str())
    };
    json::text(&Document {
        schema: "beamgap-verify/2",
        version: env!("CARGO_PKG_VERSION"),
        answers: command,
        verdict: verdict.name,
        words: &verdict.words,
        digits: demands.digits,
        reason: reason.as_deref(),
        report,
        allow_missing: *allow_missing,
        is_complete: report.is_complete(),
        warning: report.warning(),
        never_answered: report.never_answered(),
        partly_answered: report.coverage.partly(),
        first: First::of(verified),
        agrees_if: of(true),
        nearer_if: of(false),
        answered_digits: diagnosed.few_digits.as_ref().map(|few| few.digits),
        explanation: diagnosed.explanation.as_ref(),
    })
}

/// The first wrong number.
#[derive(Serialize)]
struct First<'a> {
    case: &'a str,
    place: &'a Place,
    comparison: Value,
    entry: Option<Location>,
}

impl<'a> First<'a> {
    fn of(Verified { report, demands, .. }: &'a Verified) -> Option<Self> {
        let (vector, answers, judged) = report.first.as_ref()?;
        Some(Self {
            case: &vector.id,
            place: &answers.place,
            comparison: json::compared(&judged.comparison),
            entry: locate(vector, answers, judged, &demands.conventions),
        })
    }
}
