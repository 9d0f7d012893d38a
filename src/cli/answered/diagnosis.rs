//! The first wrong number in the answers of a program, and the cause, for people.

use super::name_of;
use crate::cli::human::error;
use crate::cli::terminal::folded;
use crate::cli::verify::Verified;
use beamgap::check::external::{
    self, Cause, Demands, Explanation, Judged, Location, OtherConventions, RunnerUp, locate,
    other_conventions,
};
use beamgap::check::{Order, look_at};
use beamgap::linearization::Quantity;
use beamgap::variant::with_faults;
use std::fmt::Write;

const ANTISYMMETRIC: &str = "The matrix of differences is antisymmetric: a term is transposed.\n";
const NOT_FINITE: &str = "Cause: the first wrong number is not finite. Look for a division by zero.";

/// The cause of wrong answers.
#[derive(Default)]
pub(in crate::cli) struct Diagnosed {
    /// Rounding of the textbook formulas explains the first wrong number.
    is_rounding: bool,
    /// The first wrong number is not finite.
    is_not_finite: bool,
    /// The differences of the first wrong Hessian are antisymmetric.
    is_antisymmetric: bool,
    /// The conventions in which the answers agree, or in which the explanation is valid.
    pub(in crate::cli) conventions: Option<OtherConventions>,
    /// The wrong term, if it was looked for.
    pub(in crate::cli) explanation: Option<Explanation>,
}

impl Diagnosed {
    /// Looks for conventions in which the answers agree, and if `explain` for the wrong term.
    pub(in crate::cli) fn of(Verified { report, demands, .. }: &Verified, explain: bool) -> Self {
        let Some((vector, answers, judged)) = &report.first else { return Self::default() };
        if judged.is_rounding {
            return Self { is_rounding: true, ..Self::default() };
        }
        let is_not_finite = !judged.comparison.closed.is_finite();
        let location = explain.then(|| locate(vector, answers, judged, &demands.conventions)).flatten();
        let is_antisymmetric = location.is_some_and(|location| location.is_antisymmetric);
        let other = other_conventions(&report.kept, demands);
        let found = Self { is_not_finite, is_antisymmetric, ..Self::default() };
        // Several terms lead to one number that is not finite.
        if !explain
            || other.as_ref().is_some_and(OtherConventions::agree)
            || (is_not_finite && report.wrong < 3)
        {
            return Self { conventions: other.filter(OtherConventions::agree), ..found };
        }
        let explained = |other: Option<OtherConventions>| {
            let conventions = other.as_ref().map_or(demands.conventions, |other| other.conventions);
            let explanation = external::explain(&report.kept, &Demands { conventions, ..*demands });
            Self { conventions: other, explanation, ..found }
        };
        // A term seldom comes nearer in other conventions, so these are tried first.
        let Some(other) = other else { return explained(None) };
        let corrects_most = 2 * other.wrong <= other.wrong_before;
        let nearer = explained(Some(other));
        if nearer.has_cause() {
            return nearer;
        }
        let stated = explained(None);
        if corrects_most && !stated.has_cause() { nearer } else { stated }
    }

    fn has_cause(&self) -> bool {
        self.explanation.as_ref().is_some_and(|explanation| !explanation.causes.is_empty())
    }

    /// The cause in words, each line after a line break; empty if nothing is known of it.
    pub(in crate::cli) fn words(&self) -> String {
        let text = match self {
            Self { is_rounding: true, .. } => {
                "Rounding of the textbook formulas explains it.\nThe formulas are right, but keep too few digits here."
                    .to_owned()
            }
            Self { conventions: Some(other), .. } if other.agree() => {
                folded(&format!("The answers agree if {}.", other.words), "", "  ")
                    + "\nState it in the first line of the answers."
            }
            Self { is_not_finite: true, explanation, .. }
                if explanation.as_ref().is_none_or(|explanation| explanation.causes.is_empty()) =>
            {
                NOT_FINITE.to_owned()
            }
            Self { explanation: Some(explanation), is_antisymmetric, conventions, .. } => {
                let nearer = conventions.as_ref().map_or_else(String::new, nearer);
                let transposed = if *is_antisymmetric && explanation.causes.is_empty() { ANTISYMMETRIC } else { "" };
                nearer + &cause(explanation) + transposed
            }
            _ => return String::new(),
        };
        format!("\n{}", text.trim_end())
    }
}

/// The conventions in which fewer numbers are wrong.
fn nearer(OtherConventions { words, wrong, wrong_before, .. }: &OtherConventions) -> String {
    let text = format!(
        "Fewer numbers are wrong, {wrong} instead of {wrong_before} at the first wrong cases, if {words}."
    );
    folded(&text, "", "  ")
        + "\nState it in the first line of the answers. What follows is valid in these conventions.\n"
}

/// The first wrong number, and where to look.
pub(in crate::cli) fn first_wrong(verified: &Verified) -> String {
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
            "In {count} of {} wrong cases the first wrong number is {part} of {}:\nlook at {}",
            report.wrong,
            quantity.name(),
            at(order, quantity)
        );
    }
    text + "\n"
}

/// The cause, or that it is not known, 80 columns wide.
fn cause(explanation: &Explanation) -> String {
    let of_line = |line: &str| match line.strip_prefix("  - ") {
        Some(item) => folded(item, "  - ", "    ") + "\n",
        None => folded(line, "", "  ") + "\n",
    };
    cause_in_long_lines(explanation).lines().map(of_line).collect()
}

fn cause_in_long_lines(explanation: &Explanation) -> String {
    let Explanation { causes, before, after, runner_up, cases, is_faint } = explanation;
    let after = after.map_or_else(|| "-".into(), error);
    let runner_up = runner_up.as_ref();
    let mut text = String::new();
    match causes.as_slice() {
        [] if *is_faint => {
            text += "Cause: not known. The answers differ so little that their digits do not show which term is wrong.\nIf \
                     you need fewer digits, ask for these: --digits.\n";
            return text;
        }
        [] => {
            // An attempt that leaves much says nothing of the cause.
            let close = runner_up.filter(|attempt| attempt.left <= 0.1 * before);
            let best = close.map_or_else(String::new, |RunnerUp { words, left }| {
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
            let _ =
                writeln!(text, "Cause: one of {}, which these answers do not distinguish:", several.len());
            for one in several {
                let _ = writeln!(text, "  - {}{}", one.words, coefficient(one));
            }
        }
    }
    let left = runner_up.map_or_else(|| "none".into(), |second| error(second.left));
    let _ = writeln!(
        text,
        "With it the deviation of {cases} cases falls from {} to {after}; the next best cause leaves {left}.",
        error(*before)
    );
    let quoted =
        |names: &[String]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let names: Vec<_> = causes.iter().map(|cause| cause.name.clone()).collect();
    let is_in_catalogue = |name: &String| {
        let faults: Vec<String> = name.split(" and ").map(ToOwned::to_owned).collect();
        with_faults(&faults).is_ok()
    };
    let title = if names.iter().any(is_in_catalogue) { "In the catalogue" } else { "Name" };
    let _ = writeln!(text, "{title}: {}", quoted(&names));
    let alike: Vec<_> = causes.iter().flat_map(|cause| cause.alike.clone()).collect();
    if !alike.is_empty() {
        let _ = writeln!(text, "The same numbers at these cases: {}", quoted(&alike));
    }
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
        "First wrong number: {} of {}, case {case}\n  in {place}\n  answered {:e}\n  expected {:e}\n  \
         difference {}, tolerance {}, scaled error {}\n",
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
        text += ANTISYMMETRIC;
    }
    text
}
