//! What was found of an equation, in sentences.

use super::condition::condition;
use super::equations::{At, Equation, RESIDUAL, TANGENT};
use super::judgement::{Cases, Status};
use super::point::Point;
use super::rows::{Row, What};
use super::search::is_common;

/// One or two errors that explain the numbers.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::check::external) struct Reading {
    /// The name of each error.
    pub(in crate::check::external) names: Vec<String>,
    /// What is wrong, as a sentence without its full stop.
    pub(in crate::check::external) words: String,
    /// The factor of a term less one.
    pub(in crate::check::external) coefficient: Option<f64>,
    /// Whether it tells where something is wrong, and not what.
    pub(in crate::check::external) is_place: bool,
}

impl Reading {
    pub(super) fn new(names: Vec<String>, words: String) -> Self {
        Self { names, words, coefficient: None, is_place: false }
    }
}

/// The results of an equation, such as the first order of xi and xi_bar.
pub(super) fn result_words(equation: &Equation) -> String {
    let (_, part) = equation.results[0];
    let order = match part {
        0 => "the value",
        1 | 2 => "the first order",
        RESIDUAL..TANGENT => return "the residual".into(),
        TANGENT => return "the tangent".into(),
        _ => "the second order",
    };
    let names: Vec<_> = equation.results.iter().map(|(quantity, _)| quantity.name()).collect();
    format!("{order} of {}", names.join(" and "))
}

/// The number of the equation, if it has one.
pub(super) fn number(equation: &Equation) -> String {
    if equation.number.is_empty() { String::new() } else { format!(" {}", equation.number) }
}

/// The readings of what was found of a sum of an equation; `triangle` is the part of the Hessian that was computed.
pub(super) fn of_status(
    equation: &Equation,
    status: &Status,
    points: &[Point],
    (wrong, right): &Cases,
    triangle: &str,
) -> Vec<Reading> {
    let subject = result_words(equation);
    let triangle =
        if triangle.is_empty() { String::new() } else { format!(", in the entries {triangle} the diagonal") };
    match status {
        Status::Right | Status::Unknown => Vec::new(),
        Status::WrongForm(words) => {
            let name = format!("{subject}: {words}");
            let words = format!("in {name}{}", scope(points, wrong, right));
            vec![Reading::new(vec![name], words)]
        }
        Status::Varies(terms) => {
            // Other terms with the same variations have the same effect, so none is called wrong.
            let what = format!(
                "the residual is the term {} times a factor that differs from case to case",
                terms.join(" or ")
            );
            let of = if equation.number.is_empty() {
                String::new()
            } else {
                format!(", eq. {},", equation.number)
            };
            let words = format!("in {subject}{of} {what}{triangle}");
            vec![Reading { is_place: true, ..Reading::new(vec![what], words) }]
        }
        Status::Explained(cause) => {
            let scope = if cause.everywhere { String::new() } else { scope(points, wrong, right) };
            let reading = |errors: &Vec<(Row, f64)>| {
                let each = |number: &str| {
                    errors.iter().map(|(row, by)| of_row(number, row, *by)).collect::<Vec<_>>()
                };
                let coefficient = match &errors[..] {
                    [(Row { what: What::Factor(_), .. }, by)] => Some(*by),
                    _ => None,
                };
                let words = format!(
                    "in {subject} {}{triangle}{scope}",
                    each(&cause.number.map_or_else(|| number(equation), |of| format!(" {of}"))).join(" and ")
                );
                Reading { coefficient, ..Reading::new(each(""), words) }
            };
            cause.readings.iter().take(READINGS).map(reading).collect()
        }
    }
}

/// The number of readings that are told.
const READINGS: usize = 4;

/// An error of an equation with this number, which is left out if it is empty.
fn of_row(number: &str, row: &Row, by: f64) -> String {
    let of_equation = if number.is_empty() { String::new() } else { format!(", eq.{number},") };
    match &row.what {
        What::Replaced { of, words } if of.is_empty() => {
            format!("{words}{}", of_equation.trim_end_matches(','))
        }
        What::Replaced { of, words } => format!("{}{of_equation} is wrong: {words}", with_article(of)),
        What::Factor(of) => {
            let verb = match by {
                -1.0 => "is missing".to_owned(),
                -2.0 => "has the wrong sign".into(),
                1.0 => "counts twice".into(),
                -0.5 => "is halved".into(),
                _ if is_common(by) => format!("is multiplied by {}", 1.0 + by),
                _ => format!("is multiplied by {:.4}", 1.0 + by),
            };
            format!("{}{of_equation} {verb}", with_article(of))
        }
    }
}

fn with_article(term: &str) -> String {
    if term.starts_with("the ") || term.starts_with("both ") {
        term.into()
    } else {
        format!("the term {term}")
    }
}

/// At how many cases, and what they have in common.
pub(super) fn scope(points: &[Point], wrong: &[usize], right: &[usize]) -> String {
    if right.is_empty() {
        return String::new();
    }
    let which = condition(points, wrong, right).unwrap_or_default();
    format!(", at {} of {} cases{which}", wrong.len(), wrong.len() + right.len())
}

/// The closest point alone is wrong.
pub(super) fn of_closest_point(points: &[Point], wrong: &[usize], right: &[usize]) -> Reading {
    let name = "the closest point is not converged".to_owned();
    let words = format!(
        "xi and xi_bar are not those of the closest point{}: d.t and d.t_bar are not zero there. Look at the iteration: \
         its start, its steps, its matrix",
        scope(points, wrong, right)
    );
    Reading::new(vec![name], words)
}

/// A parameter that is held at an end is somewhere else.
pub(super) fn of_end(equation: &Equation) -> Reading {
    let name = equation.results[0].0.name();
    let words = format!(
        "{name} is held at an end of its beam, and the answer is another parameter: look at what the iteration does with a \
         held parameter"
    );
    Reading::new(vec![words.clone()], words)
}

/// Where an equation is wrong.
pub(super) fn of_place(equation: &Equation, points: &[Point], (wrong, right): &Cases) -> String {
    let (result, number) = (result_words(equation), number(equation));
    let (count, all) = (wrong.len(), wrong.len() + right.len());
    let names = ["xi", "xi_bar"];
    let which = match equation.at {
        _ if !right.is_empty() => condition(points, wrong, right).unwrap_or_default(),
        At::Held(beam) => format!(", where {} is held", names[beam]),
        At::Alone(beam) => format!(", where {} is held", names[1 - beam]),
        _ => String::new(),
    };
    format!("{result} does not satisfy its equation{number} at {count} of {all} cases{which}")
}

/// An error of the curves.
pub(super) fn of_curves(words: &str) -> Reading {
    Reading::new(vec![words.to_owned()], format!("the curves are wrong: {words}"))
}
