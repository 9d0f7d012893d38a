//! The cause of wrong answers: the numbers of the program in each equation.
//!
//! The equations follow each other: closest point, d and g_N, first order of xi and d, second order of both, tangents,
//! slips, contact element with a penalty. In each the numbers of the program stand for all that came before. So its residual is zero to
//! rounding if this step of the program is right, whatever was wrong before. A residual that is not zero is a sum of few terms
//! with the same factors in all cases: a term that is missing, that has the wrong sign, in which something else stands in
//! the place of a factor. Gradients and Hessians are contracted with random directions, so that each term is a number.
//!
//! Errors of the curves are in all equations. They are tried first, as changes of the vectors that the equations are
//! made of. A wrong Hessian whose one triangle was computed and mirrored is compared entry by entry.
//!
//! A list of [`formulas`], from the curves to the tangent of a contact element, is searched for one change that yields all
//! answers.

mod blocks;
mod condition;
mod curves;
mod equations;
mod formulas;
mod inputs;
mod judgement;
mod point;
mod rows;
mod sample;
mod search;
mod sentences;
mod terms;
mod words;

use super::answers::Answers;
use super::compare::Demands;
use super::vectors::Vector;
use crate::parallel;
use equations::{At, CLOSEST_POINT, Equation, equations};
pub use formulas::LIST_OF_FORMULAS;
use judgement::{Cases, Errors, Status, examined, is_wrong, judged};
use point::Point;
use sample::{Along, Sample, samples};
pub(super) use sentences::Reading;
use sentences::{of_curves, of_status};
use std::cell::{LazyCell, OnceCell};

/// What the equations say of the answers of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Traced {
    /// The errors that explain the first equation that is not satisfied: several if they yield the same numbers.
    pub(super) causes: Vec<Reading>,
    /// The largest residual of this equation over the size of its terms, and what the errors leave of it.
    pub(super) deviation: Option<[f64; 2]>,
    /// The number of cases.
    pub(super) cases: usize,
    /// The first equation that is not satisfied, as a sentence without its full stop.
    pub(super) place: String,
    /// Whether the list of formulas was searched.
    pub(super) is_of_formulas: bool,
    /// Whether some equation is not satisfied and not explained.
    pub(super) leaves_some: bool,
    /// What is wrong beyond it.
    pub(super) beyond: Vec<Reading>,
}

impl Traced {
    /// Adds what was found of the sums of an equation, with its readings.
    fn add(&mut self, found: &[Status], readings: Vec<Vec<Reading>>, is_first: bool) {
        self.leaves_some |= !is_known(found);
        for (status, readings) in found.iter().zip(readings) {
            if is_first && self.causes.is_empty() && !readings.is_empty() {
                self.causes = readings;
                if let Status::Explained(cause) = status {
                    self.deviation = Some(cause.deviation);
                }
            } else {
                self.go_beyond(&readings);
            }
        }
    }

    /// Whether the errors explain everything.
    pub(super) fn is_complete(&self) -> bool {
        !self.causes.is_empty() && !self.leaves_some
    }

    /// Whether one error explains everything.
    pub(super) fn is_one(&self) -> bool {
        self.is_complete() && self.beyond.is_empty()
    }

    /// An error of the curves that explains everything, if there is one and nothing else does.
    fn or_of_curves(self, samples: &[Sample]) -> Self {
        if self.is_one() {
            return self;
        }
        let causes: Vec<Reading> = curves::found(samples).iter().map(|words| of_curves(words)).collect();
        if causes.is_empty() {
            return self;
        }
        Self { causes, beyond: Vec::new(), leaves_some: false, is_of_formulas: false, ..self }
    }

    /// Adds what the error is a multiple of, if there is something. The samples are those of a grid.
    fn tell_product(&mut self, samples: &[Sample]) {
        if let Some(words) = formulas::product(samples) {
            self.place = format!("{}, and {words}", self.place);
        }
    }

    /// Adds the first of these readings, unless one of them is known.
    fn go_beyond(&mut self, readings: &[Reading]) {
        let mut known = self.causes.iter().chain(&self.beyond);
        if !known.any(|known| readings.iter().any(|of| of.names == known.names)) {
            self.beyond.extend(readings.first().cloned());
        }
    }
}

/// The number of equations in which pairs of errors are looked for.
const WITH_PAIRS: usize = 2;

/// The first equation that the answers do not satisfy, and the error that explains it; nothing if all are satisfied.
///
/// Gradients and Hessians are put into the equations first, and then the variations along the directions.
pub(super) fn traced(cases: &[&(Vector, Answers)], demands: &Demands) -> Option<Traced> {
    traced_by(cases, demands, true)
}

/// The same without the list of formulas.
pub(super) fn traced_in_equations(cases: &[&(Vector, Answers)], demands: &Demands) -> Option<Traced> {
    traced_by(cases, demands, false)
}

fn traced_by(cases: &[&(Vector, Answers)], demands: &Demands, in_list: bool) -> Option<Traced> {
    let of = |along: Along| -> Vec<Sample> {
        let of_case = |i: usize| samples(i, &cases[i].0, &cases[i].1, demands, along);
        parallel::indices(cases.len(), of_case).into_iter().flatten().collect()
    };
    let mut all = Vec::from([Along::Random, Along::Stated].map(|along| traced_along(along, in_list, &of)));
    all.retain(Option::is_some);
    all.sort_by_key(|traced| traced.as_ref().is_some_and(|traced| traced.causes.is_empty()));
    let mut all = all.into_iter().flatten();
    let mut first = all.next()?;
    for Traced { causes, beyond, leaves_some, .. } in all {
        first.leaves_some |= leaves_some;
        first.go_beyond(&causes);
        for reading in beyond {
            first.go_beyond(&[reading]);
        }
    }
    if in_list && first.causes.is_empty() {
        first.tell_product(&of(Along::Grid));
    }
    Some(first)
}

/// The same with the numbers along some of the directions.
fn traced_along(along: Along, in_list: bool, of: &(impl Fn(Along) -> Vec<Sample> + Sync)) -> Option<Traced> {
    let samples = of(along);
    if samples.is_empty() {
        return None;
    }
    let has_arrays = along == Along::Random;
    let equations = equations(has_arrays);
    let points: Vec<Point> = samples.iter().map(Point::new).collect();
    let judged_at = |e: usize| {
        let (wrong, right) = judged(&equations[e], &points);
        is_wrong(&wrong, &right).then_some((e, (wrong, right)))
    };
    let all_wrong: Vec<(usize, Cases)> =
        parallel::indices(equations.len(), judged_at).into_iter().flatten().collect();
    // The formulas of a contact element follow from the geometry.
    if has_arrays && all_wrong.is_empty() {
        let found = formulas::found(&samples, of, &|| blocks::found(of));
        return found.map(|traced| traced.or_of_curves(&samples));
    }
    let (first, of_first) = all_wrong.first()?;
    let first = &equations[*first];
    let wrong: Vec<usize> = all_wrong.iter().map(|(e, _)| *e).collect();
    let count = of_first.0.len() + of_first.1.len();
    let place = sentences::of_place(first, &points, of_first);
    let mut traced = Traced { cases: count, place, ..Traced::default() };
    if let Some((place, cause)) = of_closest_point(&equations, &wrong, &points, of_first) {
        traced.place = place.unwrap_or(traced.place);
        traced.causes = vec![cause];
        return Some(traced);
    }
    if wrong.len() > 1 {
        traced.causes =
            inputs::found(&equations, &samples, &wrong).iter().map(|words| of_curves(words)).collect();
        if !traced.causes.is_empty() {
            return Some(traced);
        }
    }
    let errors: Vec<Errors> = equations.iter().map(Errors::new).collect();
    let of_equation = |e: usize| (&equations[e], &errors[e]);
    let entries = [Along::Lower, Along::Upper].map(|along| (along, OnceCell::new()));
    let of_one_error: LazyCell<Vec<_>, _> = LazyCell::new(|| {
        parallel::map(&all_wrong, |(e, cases)| examined(of_equation(*e), &points, cases, false))
    });
    // An error that is told by its whole effect is told before several errors, or none.
    if in_list && (wrong.len() > 1 || !is_known(&of_one_error[0])) {
        let mut causes = formulas::of_all(&samples);
        if causes.is_empty() && has_arrays {
            causes = blocks::found(of);
        }
        if causes.is_empty() && has_arrays {
            causes = of_entries(&entries.each_ref().map(|(along, cell)| &**cell.get_or_init(|| of(*along))));
        }
        traced = if causes.is_empty() {
            traced.or_of_curves(&samples)
        } else {
            Traced { causes, is_of_formulas: true, ..traced }
        };
        if !traced.causes.is_empty() {
            return Some(traced);
        }
    }
    let (mut with_pairs, mut is_pinned) = (0, false);
    for ((e, cases), mut found) in all_wrong.iter().zip(of_one_error.clone()) {
        let (equation, mut words_of_triangle) = (&equations[*e], "");
        let in_entries = || {
            let is_matrix = has_arrays && equation.results.iter().all(|(_, part)| *part == 3);
            let of_triangle = |(along, samples): &(Along, OnceCell<Vec<Sample>>)| {
                let points: Vec<Point> = samples.get_or_init(|| of(*along)).iter().map(Point::new).collect();
                let cases = judged(equation, &points);
                let mut found = examined(of_equation(*e), &points, &cases, false);
                if !is_known(&found) && found.iter().any(|of| matches!(of, Status::Explained(_))) {
                    found = examined(of_equation(*e), &points, &cases, true);
                }
                let says = |of: &Status| of_status(equation, of, &points, &cases, "");
                let says: Vec<_> = found.iter().flat_map(says).map(|reading| reading.names).collect();
                is_known(&found).then_some((found, says))
            };
            let both = if is_matrix { entries.each_ref().map(of_triangle) } else { [None, None] };
            match both {
                [Some((found, lower)), Some((_, upper))] if lower == upper => Some((found, "")),
                [Some((found, _)), _] => Some((found, "below")),
                [None, upper] => upper.map(|(found, _)| (found, "above")),
            }
        };
        if !is_known(&found) {
            if let Some(in_entries) = in_entries() {
                (found, words_of_triangle) = in_entries;
            } else if with_pairs < WITH_PAIRS {
                with_pairs += 1;
                found = examined(of_equation(*e), &points, cases, true);
            }
        }
        let readings: Vec<_> = found
            .iter()
            .map(|status| of_status(equation, status, &points, cases, words_of_triangle))
            .collect();
        is_pinned |= *e == wrong[0] && found.iter().any(|of| matches!(of, Status::Varies(_)));
        traced.add(&found, readings, *e == wrong[0]);
    }
    // What follows from a number that is not named is not told as an error of its own.
    if is_pinned {
        traced.beyond.clear();
    }
    Some(traced)
}

/// What is wrong with the closest point alone, and where if it is not the first equation: a held parameter that is moved, or
/// an iteration that has not converged.
fn of_closest_point(
    equations: &[Equation],
    wrong: &[usize],
    points: &[Point],
    (of_first, others): &Cases,
) -> Option<(Option<String>, Reading)> {
    let first = &equations[wrong[0]];
    if first.number == CLOSEST_POINT && matches!(first.at, At::Held(_)) {
        return Some((None, sentences::of_end(first)));
    }
    let is_alone = wrong.iter().all(|e| equations[*e].number == CLOSEST_POINT);
    let place = "all equations but those of the closest point are satisfied";
    is_alone.then(|| (Some(place.into()), sentences::of_closest_point(points, of_first, others)))
}

/// One change that explains the entries off the diagonal, as of a direction that is used twice, or those of one triangle.
fn of_entries([lower, upper]: &[&[Sample]; 2]) -> Vec<Reading> {
    let of_entries = |(samples, words): (&[Sample], &str)| -> Option<Vec<Reading>> {
        let mut found = formulas::of_all(samples);
        for of in &mut found {
            of.words = format!("{}, in the entries {words} the diagonal", of.words);
        }
        Some(found).filter(|found| !found.is_empty())
    };
    let all = [*lower, *upper].concat();
    [(&all[..], "off"), (*lower, "below"), (*upper, "above")]
        .into_iter()
        .find_map(of_entries)
        .unwrap_or_default()
}

fn is_known(found: &[Status]) -> bool {
    !found.iter().any(|status| matches!(status, Status::Unknown | Status::Varies(_)))
}

#[cfg(test)]
mod tests;
