//! Numbers that a program does not answer: they follow from the equations, with or without an error in one of these.
//!
//! A program may answer the Hessian of d alone. An error in its first variations of xi is then seen in this Hessian only. Each
//! possible error of an earlier equation is tried: its results are computed with it, and all that depends on them.

use super::Reading;
use super::equations::{At, Equation, RESIDUAL, Zero, equations};
use super::judgement::judged;
use super::point::Point;
use super::rows::{Row, What, rows};
use super::sample::Sample;
use super::sentences::{READINGS, of_row, result_words};
use super::terms::{Earlier, Factor, Number, Part, Reading as Numbers, Terms};
use crate::linearization::Quantity;
use crate::number::RunningError;
use rayon::prelude::*;

/// A result.
type Result = (Quantity, Part);

/// The factors less one that are tried for a term.
const FACTORS: [f64; 4] = [-2.0, -1.0, 1.0, -0.5];
/// The number of samples that are tried before all others.
const PROBES: usize = 6;

/// The results that an equation is made of in its first form, without its own.
fn used(equation: &Equation) -> Vec<Result> {
    let factors = equation.forms[0].iter().flat_map(|zero| &zero.terms).flat_map(|term| &term.factors);
    let result = |factor: &Factor| match factor {
        Factor::Number(Number::Of(quantity, part)) | Factor::SizeOf(Number::Of(quantity, part)) => {
            Some((*quantity, *part))
        }
        _ => None,
    };
    factors.filter_map(result).filter(|of| !equation.results.contains(of)).collect()
}

/// The equations whose results are not answered, and of which this one is made, in the order of evaluation.
struct Chain {
    all: Vec<Equation>,
    which: Vec<usize>,
}

impl Chain {
    fn new(equation: &Equation, samples: &[Sample]) -> Self {
        let all = equations(false);
        let is_answered =
            |(of, part): Result| samples.iter().any(|sample| sample.own[of.component()][part].is_some());
        let mut needed = used(equation);
        let mut which = Vec::new();
        for (e, earlier) in all.iter().enumerate().rev() {
            let is_needed = earlier.results.iter().any(|of| needed.contains(of) && !is_answered(*of));
            // The closest point is that of the case, and d is its distance.
            if is_needed && earlier.results.iter().all(|(_, part)| (1..RESIDUAL).contains(part)) {
                needed.extend(used(earlier));
                which.push(e);
            }
        }
        which.reverse();
        Self { all, which }
    }

    /// Computes the numbers that are not answered at a point, with errors in some equations.
    fn fill(&self, point: &mut Point, errors: &[Error]) -> Option<()> {
        for &e in &self.which {
            let equation = &self.all[e];
            if !equation.at.holds(point.sample.held) {
                continue;
            }
            let error = errors.iter().find(|error| error.place.equation == e);
            solve(equation, &equation.forms[error.map_or(0, |error| error.place.form)], error, point)?;
        }
        Some(())
    }
}

/// A sum of a form of an equation.
#[derive(Clone, Copy)]
struct Place {
    equation: usize,
    form: usize,
    sum: usize,
}

/// Terms that are added to a sum, with their factor.
struct Error {
    place: Place,
    terms: Terms,
    factor: f64,
}

/// Computes the results of an equation, in which they are linear.
fn solve(equation: &Equation, form: &[Zero], error: Option<&Error>, point: &mut Point) -> Option<()> {
    let reading = Numbers { results: &equation.results, earlier: Earlier::Own };
    let count = equation.results.len();
    let set = |point: &mut Point, k: usize, value: RunningError| {
        let (quantity, part) = equation.results[k];
        point.own[quantity.component()][part] = Some(value);
    };
    let sums = |point: &Point| -> Option<Vec<RunningError>> {
        let of = |(k, zero): (usize, &Zero)| {
            let sum = point.value(&zero.terms, &reading)?;
            match error.filter(|error| error.place.sum == k) {
                Some(error) => {
                    Some(sum + RunningError::from(error.factor) * point.value(&error.terms, &reading)?)
                }
                None => Some(sum),
            }
        };
        form.iter().enumerate().map(of).collect()
    };
    (0..count).for_each(|k| set(point, k, RunningError::from(0.0)));
    let rest = sums(point)?;
    let mut slopes = Vec::new();
    for k in 0..count {
        set(point, k, RunningError::from(1.0));
        let slope: Vec<_> = sums(point)?.into_iter().zip(&rest).map(|(sum, rest)| sum - *rest).collect();
        set(point, k, RunningError::from(0.0));
        slopes.push(slope);
    }
    let solution = match (&slopes[..], &rest[..]) {
        ([slope], [rest]) => vec![-*rest / slope[0]],
        ([one, two], [r, s]) => {
            let determinant = one[0] * two[1] - one[1] * two[0];
            vec![(two[0] * *s - two[1] * *r) / determinant, (one[1] * *r - one[0] * *s) / determinant]
        }
        _ => return None,
    };
    for (k, value) in solution.into_iter().enumerate() {
        if !value.value.is_finite() {
            return None;
        }
        set(point, k, value);
    }
    Some(())
}

/// The errors of earlier equations that leave only rounding of this one, if some of their results are not answered. None
/// if there are many.
pub(super) fn found(equation: &Equation, samples: &[Sample]) -> Vec<Reading> {
    let chain = Chain::new(equation, samples);
    let used = samples.iter().filter(|sample| equation.at.holds(sample.held));
    let points: Vec<Point> = used.map(Point::new).collect();
    let step = (points.len() / PROBES).max(1);
    let search = Search {
        equation,
        chain: &chain,
        probes: points.iter().step_by(step).take(PROBES).collect(),
        points: points.iter().collect(),
    };
    let mut of_equations = chain.which.iter().rev().map(|e| (*e, search.errors_of(*e)));
    let Some((e, mut found)) = of_equations.find(|(_, found)| !found.is_empty()) else {
        return Vec::new();
    };
    // A term that exists is meant rather than one that does not.
    let is_of_factor = |(row, _): &(Row, f64)| matches!(row.what, What::Factor(_));
    if found.iter().any(is_of_factor) {
        found.retain(is_of_factor);
    }
    let mut readings: Vec<Reading> = Vec::new();
    for (row, factor) in &found {
        let reading = reading(equation, &chain.all[e], row, *factor);
        if !readings.iter().any(|known| known.names == reading.names) {
            readings.push(reading);
        }
    }
    if readings.len() > READINGS { Vec::new() } else { readings }
}

/// The search for an error that explains an equation.
struct Search<'a> {
    equation: &'a Equation,
    chain: &'a Chain,
    probes: Vec<&'a Point<'a>>,
    points: Vec<&'a Point<'a>>,
}

impl Search<'_> {
    /// Whether the numbers that follow with these errors satisfy the equation.
    fn is_explained(&self, errors: &[Error], points: &[&Point]) -> bool {
        let mut filled = Vec::new();
        for point in points {
            filled.push((*point).clone());
            let is_filled = filled.last_mut().is_some_and(|point| self.chain.fill(point, errors).is_some());
            // Most errors are excluded by the first point.
            if !is_filled || (filled.len() == 1 && !judged(self.equation, &filled).0.is_empty()) {
                return false;
            }
        }
        judged(self.equation, &filled).0.is_empty()
    }

    /// The errors of an equation that explain the other one, with their factors.
    fn errors_of(&self, e: usize) -> Vec<(Row, f64)> {
        let earlier = &self.chain.all[e];
        // The first variations along the second direction have the errors of those along the first.
        if earlier.results[0].1 == 2 || !matches!(earlier.at, At::All | At::Free) {
            return Vec::new();
        }
        let mut found = Vec::new();
        for (form, sums) in earlier.forms.iter().enumerate() {
            if sums.iter().any(|zero| zero.is_wrong_form.is_some()) {
                continue;
            }
            for sum in 0..sums.len() {
                let tables = self.tables(e, form, sum);
                let Some((_, first)) = tables.first() else { continue };
                let tried: Vec<(usize, f64)> = (0..first.len())
                    .flat_map(|k| {
                        let is_term = matches!(first[k].what, What::Factor(_));
                        let factors: &[f64] = if is_term { &FACTORS } else { &[1.0] };
                        factors.iter().map(move |factor| (k, *factor))
                    })
                    .collect();
                let holds = |(k, factor): &(usize, f64)| {
                    let of = |(place, table): &(Place, Vec<Row>)| Error {
                        place: *place,
                        terms: table[*k].terms.clone(),
                        factor: *factor,
                    };
                    let errors: Vec<Error> = tables.iter().map(of).collect();
                    self.is_explained(&errors, &self.probes) && self.is_explained(&errors, &self.points)
                };
                let here: Vec<_> = tried.into_par_iter().filter(holds).collect();
                found.extend(here.into_iter().map(|(k, factor)| (first[k].clone(), factor)));
            }
        }
        found
    }

    /// The possible errors of a sum of an equation, and the same ones of the equations that are valid where one parameter is
    /// held and of those along the second direction.
    fn tables(&self, e: usize, form: usize, sum: usize) -> Vec<(Place, Vec<Row>)> {
        let Chain { all, which } = self.chain;
        let rows_of = |Place { equation, form, sum }: Place| {
            rows(&all[equation].forms[form][sum], &all[equation].results)
        };
        let place = |equation| Place { equation, form, sum };
        let mut tables = vec![(place(e), rows_of(place(e)))];
        let number = all[e].number;
        let along_second = |t: usize| {
            let results: Vec<_> = all[t].results.iter().map(|(of, _)| (*of, 2)).collect();
            let is_twin = |other: &usize| all[*other].results == results && all[*other].at == all[t].at;
            (all[t].results[0].1 == 1).then(|| which.iter().copied().find(is_twin)).flatten()
        };
        let alone = which.iter().copied().find(|t| {
            let has_part = all[*t].results[0].1 == all[e].results[0].1;
            has_part && all[*t].number == number && all[*t].at == At::Alone(sum) && form == 0
        });
        let mut others: Vec<(usize, Place)> = Vec::new();
        others.extend(along_second(e).map(|t| (0, place(t))));
        if let Some(alone) = alone {
            let here = Place { equation: alone, form: 0, sum: 0 };
            let rows = rows_of(here);
            // An error that this equation does not have changes nothing in it.
            let same = |row: &Row| rows.iter().find(|of| of.what == row.what).map(|of| of.terms.clone());
            let table =
                tables[0].1.iter().map(|row| Row { terms: same(row).unwrap_or_default(), ..row.clone() });
            tables.push((here, table.collect()));
            others.extend(along_second(alone).map(|t| (1, Place { equation: t, form: 0, sum: 0 })));
        }
        for (of, place) in others {
            let [own, twin] = [tables[of].0, place].map(rows_of);
            if own.len() != twin.len() {
                return Vec::new();
            }
            let same =
                |row: &Row| own.iter().position(|of| of.what == row.what).map(|k| twin[k].terms.clone());
            let table =
                tables[0].1.iter().map(|row| Row { terms: same(row).unwrap_or_default(), ..row.clone() });
            tables.push((place, table.collect()));
        }
        tables
    }
}

/// An error of an equation that is seen in another one.
fn reading(seen: &Equation, earlier: &Equation, row: &Row, factor: f64) -> Reading {
    Reading {
        names: vec![of_row("", row, factor)],
        words: format!(
            "in {} {}, as {} shows",
            result_words(earlier),
            of_row(&format!(" {}", earlier.number), row, factor),
            result_words(seen)
        ),
        coefficient: matches!(row.what, What::Factor(_)).then_some(factor),
    }
}
