//! What is found of an equation: it is right, or an error explains the numbers, or nothing does.

use super::equations::{Equation, Zero};
use super::point::Point;
use super::rows::{Row, What, leaves_a_result, rows};
use super::search::{System, cases, is_common};
use super::terms::Earlier;
use std::sync::OnceLock;

/// The cases at which an equation is wrong, and the others.
pub(super) type Cases = (Vec<usize>, Vec<usize>);

/// An error that explains the numbers.
#[derive(Clone, Debug)]
pub(super) struct Cause {
    /// The largest residual over the size of its terms, and what the errors leave of it.
    pub(super) deviation: [f64; 2],
    /// The errors with their factors. Several readings if they yield the same numbers.
    pub(super) readings: Vec<Vec<(Row, f64)>>,
    /// The number of the equation of the sum, if it is not that of the others.
    pub(super) number: Option<&'static str>,
    /// Whether all cases have the error, or only those at which the equation is wrong.
    pub(super) everywhere: bool,
    /// The numbers that the program used of earlier equations.
    earlier: Earlier,
}

/// What was found of a sum.
#[derive(Clone, Debug)]
pub(super) enum Status {
    /// It is zero.
    Right,
    /// The numbers satisfy another equation, which is not valid there.
    WrongForm(&'static str),
    /// An error explains the numbers.
    Explained(Cause),
    /// One of these terms explains them with a factor that differs from case to case.
    Varies(Vec<String>),
    /// No error does.
    Unknown,
}

impl Status {
    /// The simplest explanation has the smallest cost.
    fn cost(&self) -> u32 {
        match self {
            Self::Right => 0,
            Self::WrongForm(_) => 1,
            Self::Explained(cause) => {
                1 + u32::from(!cause.everywhere)
                    + 3 * u32::from(cause.readings[0].len() > 1)
                    + 2 * u32::from(cause.earlier == Earlier::Exact)
                    + u32::from(!is_of_factors(&cause.readings[0]))
            }
            Self::Varies(_) => UNKNOWN - 1,
            Self::Unknown => UNKNOWN,
        }
    }
}

/// The least cost of an equation that is wrong: one error explains one sum, at all cases.
const LEAST: u32 = 1;
/// The maximum number of terms of which one has a factor that differs from case to case.
const VARYING: usize = 4;
/// The cost of a sum that is not explained.
const UNKNOWN: u32 = 100;

/// The cases at which an equation is right in none of its forms, and the others.
pub(super) fn judged(equation: &Equation, points: &[Point]) -> Cases {
    let mut wrong: Option<Vec<usize>> = None;
    let mut all: Vec<usize> = Vec::new();
    let is_valid = |form: &&Vec<Zero>| form.iter().all(|zero| zero.is_wrong_form.is_none());
    for earlier in [Earlier::Own, Earlier::Exact] {
        for form in equation.forms.iter().filter(is_valid) {
            let mut of_form: Vec<usize> = Vec::new();
            for zero in form {
                let system = System::new(equation, zero, points, earlier);
                of_form.extend(system.wrong_cases());
                if all.is_empty() {
                    all = cases(&system.points);
                }
            }
            of_form.sort_unstable();
            of_form.dedup();
            match &mut wrong {
                Some(wrong) => wrong.retain(|case| of_form.contains(case)),
                None => wrong = Some(of_form),
            }
            if wrong.as_ref().is_some_and(Vec::is_empty) {
                return (Vec::new(), all);
            }
        }
    }
    let wrong = wrong.unwrap_or_default();
    let right = all.into_iter().filter(|case| !wrong.contains(case)).collect();
    (wrong, right)
}

/// Whether an equation is wrong. One case may be wrong by chance.
pub(super) fn is_wrong(wrong: &[usize], right: &[usize]) -> bool {
    wrong.len() > 1 || (!wrong.is_empty() && right.is_empty())
}

/// The possible errors of each sum of an equation in each of its forms. They are the same at all points.
pub(super) struct Errors(Vec<Vec<OnceLock<Vec<Row>>>>);

impl Errors {
    pub(super) fn new(equation: &Equation) -> Self {
        let of_form = |form: &Vec<Zero>| form.iter().map(|_| OnceLock::new()).collect();
        Self(equation.forms.iter().map(of_form).collect())
    }
}

/// What was found of each sum of an equation, in the form that explains most.
pub(super) fn examined(
    (equation, errors): (&Equation, &Errors),
    points: &[Point],
    (wrong, right): &Cases,
    with_pairs: bool,
) -> Vec<Status> {
    if !is_wrong(wrong, right) {
        return vec![Status::Right; equation.forms[0].len()];
    }
    let examination = Examination { equation, points, wrong, right };
    let mut best: Option<(u32, Vec<Status>)> = None;
    let satisfies = |form: &&Vec<Zero>| form.iter().all(|zero| examination.is_right(zero, &[Earlier::Own]));
    let mut wrong_forms = equation.forms.iter().filter(|form| form[0].is_wrong_form.is_some());
    if let Some(words) = wrong_forms.find(satisfies).and_then(|form| form[0].is_wrong_form) {
        return vec![Status::WrongForm(words)];
    }
    for (form, errors) in equation.forms.iter().zip(&errors.0) {
        if form[0].is_wrong_form.is_some() {
            continue;
        }
        let found: Vec<Status> = form
            .iter()
            .zip(errors)
            .map(|(zero, errors)| examination.status((zero, errors), with_pairs))
            .collect();
        let cost = found.iter().map(Status::cost).sum();
        if best.as_ref().is_none_or(|(known, _)| cost < *known) {
            best = Some((cost, found));
        }
        // No form of a wrong equation costs less.
        if cost <= LEAST {
            break;
        }
    }
    best.map(|(_, found)| found).unwrap_or_default()
}

/// An equation that is wrong.
struct Examination<'a> {
    equation: &'a Equation,
    points: &'a [Point<'a>],
    wrong: &'a [usize],
    right: &'a [usize],
}

impl Examination<'_> {
    /// Whether a sum is zero at the cases at which the equation is wrong.
    fn is_right(&self, zero: &Zero, of: &[Earlier]) -> bool {
        of.iter().any(|earlier| {
            let mut system = System::new(self.equation, zero, self.points, *earlier);
            system.retain(|case| self.wrong.contains(&case));
            system.wrong_cases().is_empty() && !system.points.is_empty()
        })
    }

    fn status(&self, (zero, table): (&Zero, &OnceLock<Vec<Row>>), with_pairs: bool) -> Status {
        if self.is_right(zero, &[Earlier::Own, Earlier::Exact]) {
            return Status::Right;
        }
        for earlier in [Earlier::Own, Earlier::Exact] {
            for everywhere in [true, false] {
                if let Some(cause) = self.cause((zero, table), earlier, everywhere, false) {
                    return Status::Explained(cause);
                }
            }
        }
        // Pairs of errors are looked for with the numbers of the program, and among single terms alone.
        if !with_pairs {
            return Status::Unknown;
        }
        let cause = || self.cause((zero, table), Earlier::Own, self.right.is_empty(), true);
        let found = zero.is_elementary.then(cause).flatten().map(Status::Explained);
        found.unwrap_or_else(|| self.varying((zero, table)))
    }

    /// The fewest terms that have another factor in each case. A value does not vary with the directions, so it is a multiple
    /// of any term.
    fn varying(&self, (zero, table): (&Zero, &OnceLock<Vec<Row>>)) -> Status {
        if self.equation.results.iter().any(|(_, part)| *part == 0) {
            return Status::Unknown;
        }
        let mut system = System::new(self.equation, zero, self.points, Earlier::Own);
        system.retain(|case| self.wrong.contains(&case));
        let table = table.get_or_init(|| rows(zero, self.equation));
        let found = system.varying(table).into_iter().map(|k| &table[k]);
        let factors: Vec<_> = found
            .filter_map(|row| match &row.what {
                What::Factor(name) => Some((row.terms.len(), name)),
                What::Replaced { .. } => None,
            })
            .collect();
        let fewest = factors.iter().map(|(terms, _)| *terms).min();
        let names: Vec<_> = factors
            .into_iter()
            .filter(|(terms, _)| Some(*terms) == fewest)
            .map(|(_, name)| name.clone())
            .collect();
        if (1..=VARYING).contains(&names.len()) { Status::Varies(names) } else { Status::Unknown }
    }

    /// The errors that explain the residuals of a sum, at all cases or where the equation is wrong.
    fn cause(
        &self,
        (zero, table): (&Zero, &OnceLock<Vec<Row>>),
        earlier: Earlier,
        everywhere: bool,
        in_pairs: bool,
    ) -> Option<Cause> {
        let mut system = System::new(self.equation, zero, self.points, earlier);
        if !everywhere {
            if self.right.is_empty() {
                return None;
            }
            system.retain(|case| self.wrong.contains(&case));
        }
        let results = &self.equation.results;
        let table = table.get_or_init(|| rows(zero, self.equation));
        let found = if in_pairs { system.pairs(table) } else { system.singles(table) };
        let says_something = |errors: &Vec<(&Row, f64)>| {
            errors.iter().all(|error| is_plausible(*error)) && leaves_a_result(zero, results, errors)
        };
        let of_rows = |of: Vec<(usize, f64)>| of.into_iter().map(|(k, by)| (&table[k], by)).collect();
        let readings: Vec<Vec<(&Row, f64)>> = found.into_iter().map(of_rows).filter(says_something).collect();
        let owned = |of: Vec<(&Row, f64)>| of.into_iter().map(|(row, by)| (row.clone(), by)).collect();
        let mut readings: Vec<Vec<(Row, f64)>> = readings.into_iter().map(owned).collect();
        // A term that exists is meant rather than one that does not.
        if readings.iter().any(|of| is_of_factors(of)) {
            readings.retain(|of| is_of_factors(of));
        }
        let deviation = system.deviations(readings.first()?);
        Some(Cause { deviation, readings, number: zero.number, everywhere, earlier })
    }
}

/// Whether terms have other factors, and nothing else is wrong.
fn is_of_factors(errors: &[(Row, f64)]) -> bool {
    errors.iter().all(|(row, _)| matches!(row.what, What::Factor(_)))
}

/// What stands in the place of a term has the factor 1.
fn is_plausible((row, by): (&Row, f64)) -> bool {
    match row.what {
        What::Replaced { .. } => (by - 1.0).abs() < f64::EPSILON,
        What::Factor(_) => is_common(by),
    }
}
