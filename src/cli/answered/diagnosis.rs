//! The first wrong number in the answers of a program, and the cause, for people.

mod few_digits;
mod first_wrong;

use super::verified::Verified;
use crate::cli::count::count as counted;
use crate::cli::terminal::folded;
use crate::cli::words::error;
use beamgap::check::external::{
    self, Cause, Demands, Explanation, FewDigits, Location, OtherConventions, RunnerUp, Shape, few_digits,
    locate, other_conventions,
};
use beamgap::variant::with_faults;
use few_digits::of_few;
use first_wrong::{ANTISYMMETRIC, matrix_name};
use std::fmt::Write;

pub(in crate::cli) use first_wrong::first_wrong;

const NOT_FINITE: &str = "Cause: the first wrong number is not finite. Look for a division by zero.";

/// The cause of wrong answers.
#[derive(Clone, Default)]
pub(in crate::cli) struct Diagnosed {
    /// Rounding of the textbook formulas explains the first wrong number.
    is_rounding: bool,
    /// The first wrong number is not finite.
    is_not_finite: bool,
    /// The differences of the first wrong Hessian are antisymmetric.
    is_antisymmetric: bool,
    /// What is wrong with the first wrong matrix, if it is a triangle, has doubled entries or another order.
    of_matrix: Option<String>,
    /// Where to look by the forces, if they are answered with residual or tangent and the cause is not known.
    place_of_force: Option<&'static str>,
    /// The names of state and forces, if nothing else is wrong.
    forces: Option<Vec<&'static str>>,
    /// The conventions in which the answers agree, or in which the explanation is valid.
    pub(in crate::cli) conventions: Option<OtherConventions>,
    /// The digits of the answers, if they are few and none were requested.
    pub(in crate::cli) few_digits: Option<FewDigits>,
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
        let few_digits = few_digits(&report.kept, &report.precision, demands);
        if few_digits.as_ref().is_some_and(FewDigits::settles) {
            return Self { few_digits, ..Self::default() };
        }
        // What is wrong is looked for with the digits that the answers have.
        let demands =
            &Demands { digits: demands.digits.or(few_digits.as_ref().map(|few| few.digits)), ..*demands };
        let is_not_finite = !judged.comparison.closed.is_finite();
        let location = explain.then(|| locate(vector, answers, judged, &demands.conventions)).flatten();
        let is_antisymmetric = location.as_ref().is_some_and(|location| location.is_antisymmetric);
        let of_matrix = |words: &dyn Fn(&Location) -> Option<String>| {
            let location = location.as_ref()?;
            Some(format!("{} {}", matrix_name(location, &judged.comparison), words(location)?))
        };
        let of_shape = of_matrix(&|location| {
            let shape = location.shape.filter(|shape| *shape != Shape::Unsymmetric)?;
            Some(format!("{}. Both triangles are expected", shape.words()))
        });
        if of_shape.is_some() {
            return Self { of_matrix: of_shape, few_digits, ..Self::default() };
        }
        let other = other_conventions(&report.kept, demands);
        let of_order = of_matrix(&|location| Some(format!("has its {}", location.order.as_ref()?)));
        if of_order.is_some() && !other.as_ref().is_some_and(OtherConventions::agree) {
            return Self { of_matrix: of_order, few_digits, ..Self::default() };
        }
        let forces = report.forces().filter(|_| report.coverage.is_of_element());
        let place_of_force = forces.map(|wrong| place_of_force(&wrong));
        let found = Self { is_not_finite, is_antisymmetric, place_of_force, few_digits, ..Self::default() };
        let forces = report.wrong_forces();
        if forces.is_some() && !other.as_ref().is_some_and(OtherConventions::agree) {
            return Self { forces, ..found };
        }
        // Several terms lead to one number that is not finite.
        if !explain
            || other.as_ref().is_some_and(OtherConventions::agree)
            || (is_not_finite && report.wrong < 3)
        {
            return Self { conventions: other.filter(OtherConventions::agree), ..found };
        }
        let explained = |other: Option<OtherConventions>| {
            let conventions = other.as_ref().map_or(demands.conventions, |other| other.conventions);
            let explanation =
                external::explain(&report.kept, &report.right, &Demands { conventions, ..*demands });
            Self { conventions: other, explanation, ..found.clone() }
        };
        let Some(other) = other else { return explained(None) };
        // One error that explains all numbers of an element is meant rather than a convention that explains some of them.
        if report.kept.iter().all(|(vector, _)| vector.element.is_some()) {
            let stated = explained(None);
            if stated.explanation.as_ref().is_some_and(|of| !of.causes.is_empty() && of.beyond.is_empty()) {
                return stated;
            }
        }
        // A term seldom comes nearer in other conventions, so these are tried first.
        let corrects_most = 2 * other.wrong <= other.wrong_before;
        let nearer = explained(Some(other));
        if nearer.has_cause() && !nearer.has_two_errors() {
            return nearer;
        }
        let stated = explained(None);
        if (corrects_most || nearer.has_cause()) && !stated.has_cause() { nearer } else { stated }
    }

    fn has_cause(&self) -> bool {
        self.explanation.as_ref().is_some_and(|explanation| !explanation.causes.is_empty())
    }

    /// Whether the cause is two errors in the equations of the answers.
    fn has_two_errors(&self) -> bool {
        let is_pair = |of: &Explanation| of.place.is_some() && of.causes[0].name.contains(" and ");
        self.has_cause() && self.explanation.as_ref().is_some_and(is_pair)
    }

    /// The cause in words, each line after a line break; empty if nothing is known of it.
    pub(in crate::cli) fn words(&self) -> String {
        let text = match self {
            Self { is_rounding: true, .. } => {
                "Rounding of the textbook formulas explains it.\nThe formulas are right, but keep too few digits here."
                    .to_owned()
            }
            Self { of_matrix: Some(words), .. } => folded(&format!("Cause: the {words}."), "", "  "),
            Self { few_digits: Some(few), .. } if few.settles() => String::new(),
            Self { forces: Some(names), .. } => {
                let words = format!(
                    "Cause: what is answered beside residual and tangent, which are right, is wrong: {}.",
                    names.join(", ")
                );
                folded(&words, "", "  ")
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
            Self { explanation: Some(explanation), is_antisymmetric, conventions, place_of_force, .. } => {
                let nearer = conventions.as_ref().map_or_else(String::new, nearer);
                let transposed = if *is_antisymmetric && explanation.causes.is_empty() { ANTISYMMETRIC } else { "" };
                nearer + &cause(explanation, *place_of_force) + transposed
            }
            _ => return String::new(),
        };
        let few = self.few_digits.as_ref().map_or_else(String::new, of_few);
        format!("\n{}", (few + &text).trim_end())
    }
}

/// The conventions in which fewer numbers are wrong.
fn nearer(OtherConventions { words, wrong, wrong_before, .. }: &OtherConventions) -> String {
    let text = format!(
        "Fewer numbers are wrong, {wrong} instead of {wrong_before} at the first wrong cases, if {words}."
    );
    folded(&text, "", "  ")
        + "\nState it in the first line of the answers.\nWhat follows is valid in these conventions.\n"
}

/// Where to look if these forces are wrong.
fn place_of_force(wrong: &[&str]) -> &'static str {
    if wrong.contains(&"F_N") {
        "F_N is wrong already: look at the gap, the side of the normal, and the law."
    } else if wrong.is_empty() {
        "The forces are right."
    } else {
        "F_N is right, and what is told of friction is wrong: look at the slip, the history, and the cone."
    }
}

/// Said of an equation that follows others. A number before it can satisfy its equation and be wrong.
const BEFORE: &str = "equations before it are satisfied";

/// The cause, or that it is not known, 80 columns wide. `place_of_force` says what the forces show.
fn cause(explanation: &Explanation, place_of_force: Option<&str>) -> String {
    let of_line = |line: &str| match line.strip_prefix("  - ") {
        Some(item) => folded(item, "  - ", "    ") + "\n",
        None => folded(line, "", "  ") + "\n",
    };
    cause_in_long_lines(explanation, place_of_force).lines().map(of_line).collect()
}

fn cause_in_long_lines(explanation: &Explanation, place_of_force: Option<&str>) -> String {
    let Explanation { causes, before, after, runner_up, cases, is_faint, place, beyond, is_of_formulas } =
        explanation;
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
            let close = runner_up.filter(|attempt| attempt.left <= (0.1 * before).min(1e-2));
            let best = close.map_or_else(String::new, |RunnerUp { words, left }| {
                format!(" The best attempt leaves {}: {words}.", error(*left))
            });
            let _ = writeln!(
                text,
                "Cause: not known. No known error explains {}.{best}",
                counted(*cases, "case")
            );
            match (place, place_of_force) {
                (Some(place), Some(of_force)) => {
                    let _ = writeln!(text, "Look there: {place}. {of_force}");
                }
                (Some(place), None) => {
                    let before = if *is_of_formulas { "numbers before it are right" } else { BEFORE };
                    let _ = writeln!(text, "Look there: {place}; the {before}.");
                }
                (None, _) => {}
            }
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
    if let Some(place) = place {
        // The answers were put into the equations.
        let _ = match explanation.after {
            Some(left) => writeln!(
                text,
                "The answers leave {} of the terms of this equation, and {} with this error.",
                error(*before),
                error(left)
            ),
            None if *is_of_formulas => {
                writeln!(text, "It explains why {place}. `beamgap schema formulas` prints the formulas.")
            }
            None => writeln!(text, "It explains why {place}."),
        };
        for sentence in beyond {
            let _ = writeln!(text, "{sentence} It may be the same error.");
        }
        return text;
    }
    let left = runner_up.map_or_else(|| "none".into(), |second| error(second.left));
    let _ = writeln!(
        text,
        "With it the deviation of {} falls from {} to {after}; the next best cause leaves {left}.",
        counted(*cases, "case"),
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
