//! The results of the checks, one after the other.

use crate::html::{Outcome, linked, table};
use crate::numbers::{is_ad, letter, name, outcome};
use crate::prediction::Prediction;
use beamgap::check::{Comparison, Finding, Order, Verdict, look_at};
use beamgap::closest_point::ClosestPoint;
use std::fmt::Write;

/// The entries that a check compares.
type Pick = fn(&Comparison) -> bool;

/// The checks that compare numbers: the name, the description, the compared entries.
const CHECKS: [(&str, &str, Pick); 4] = [
    ("automatic differentiation", "all numbers, by three methods of hyper-dual numbers", is_ad),
    ("gradients and Hessians", "the matrices, times δq and Δq, against the variations", |entry| {
        entry.order == Order::Matrix
    }),
    ("symmetry", "Δδ against itself with δq and Δq exchanged", |entry| entry.order == Order::Symmetry),
    ("differences", "differences of the values in double-double", |entry| {
        entry.against.starts_with("differences")
    }),
];

/// The table of the checks, and the conclusion as a paragraph.
pub(crate) fn checks(
    point: &ClosestPoint,
    verdict: &Verdict,
    prediction: Option<&Prediction>,
    fault: Option<&str>,
) -> (String, String) {
    let entries = verdict.entries();
    let mut rows = String::new();
    let mut outcomes = Vec::new();
    for (check, what, pick) in CHECKS {
        let of_check = || entries.iter().filter(|entry| pick(entry));
        let outcome = outcome(of_check());
        let (count, wrong) = (of_check().count(), of_check().filter(|entry| entry.is_wrong()).count());
        outcomes.push(outcome);
        // The differences are computed only if an entry is wrong.
        if count > 0 {
            row(&mut rows, check, what, outcome, &format!("{wrong} of {count}"));
        }
    }
    let taylor = match prediction {
        None => Outcome::NotCompared,
        Some(prediction) if prediction.passes() => Outcome::Agrees,
        Some(_) => Outcome::Wrong,
    };
    let rate = prediction.map(|prediction| {
        prediction.rate(1).map_or_else(|| "rounding only".to_owned(), |rate| format!("slope {rate:.2}"))
    });
    row(
        &mut rows,
        "Taylor test",
        "the error of the second-order prediction of g<sub>N</sub> falls with the third power of the step",
        taylor,
        &rate.unwrap_or_default(),
    );
    let heads = ["check", "what it compares", "says", "wrong"];
    let lesson = lesson(point, verdict, [outcomes[0], outcomes[2], taylor], fault);
    (table("checks", &heads, &rows), lesson)
}

fn row(rows: &mut String, check: &str, what: &str, outcome: Outcome, count: &str) {
    let _ = writeln!(
        rows,
        "<tr><th scope=\"row\">{check}</th><td>{what}</td><td>{}</td><td>{count}</td></tr>",
        outcome.html()
    );
}

/// The conclusion from the outcomes of AD, symmetry and Taylor's test.
fn lesson(
    point: &ClosestPoint,
    verdict: &Verdict,
    [ad, symmetry, taylor]: [Outcome; 3],
    fault: Option<&str>,
) -> String {
    let first = Finding::of(&[(Some(*point), verdict.clone())]);
    let mut words = match (verdict, fault) {
        (Verdict::Inconclusive(reason, _), _) => format!("Not compared: {}.", reason.reason()),
        (_, None) => "The closed form is as it is in the library. Click a term of the formula to break it.".to_owned(),
        (_, Some(_)) if ad != Outcome::Wrong => {
            "The fault changes nothing here: at this point, or along these directions, its term is zero. Choose \
             another pair of beams."
                .to_owned()
        }
        (_, Some(_)) => {
            let mut blind = Vec::new();
            if symmetry == Outcome::Agrees {
                blind.push("symmetry");
            }
            if taylor == Outcome::Agrees {
                blind.push("the Taylor test of the gap");
            }
            match &blind[..] {
                [] => "AD, symmetry and the Taylor test detect this fault.".to_owned(),
                blind => format!(
                    "AD detects this fault; here it is not detected by {}. A check that passes proves only what it can detect.",
                    blind.join(" and ")
                ),
            }
        }
    };
    if let Some(finding) = first {
        let diagnosis = finding.diagnosis;
        let _ = write!(
            words,
            " The first wrong number is {} {}: look at {}.",
            letter(diagnosis.part),
            name(diagnosis.quantity),
            linked(look_at(diagnosis.order, diagnosis.quantity))
        );
    }
    format!("<p class=\"lesson\">{words}</p>\n")
}
