//! The summands of the Hessians that explain the answers: one with a fitted factor, or two.
//!
//! Second variations are linear in their summands, so the factors follow from the deviations by least squares.

use super::answered_case::AnsweredCase;
use super::datum::Datum;
use super::hypothesis::{Change, WrongSummand};
use crate::check::evaluation_point::{Increment, Summand, SummandError};
use crate::linearization::Varied;
use rayon::prelude::*;

/// The number of changes of each kind that are tried at all cases.
const TRIED: usize = 40;
/// The factors of errors that derivations by hand contain, less one.
const COMMON: [f64; 7] = [-3.0, -2.0, -1.0, -0.5, 0.5, 1.0, 2.0];
/// The distance from a common factor that few digits explain.
const NEAR: f64 = 1e-3;

/// The deviations of the answers, and those that each summand causes, over the probable rounding errors.
struct Deviations {
    found: Vec<f64>,
    caused: Vec<Vec<f64>>,
}

impl Deviations {
    fn new(cases: &[&AnsweredCase], summands: usize) -> Self {
        let found = |case: &&AnsweredCase| {
            let over = |datum: &Datum| finite((datum.answer - datum.reference) / datum.sigma);
            case.data.iter().map(over).collect::<Vec<_>>()
        };
        let unchanged: Vec<_> = cases.iter().map(|case| case.with_increment(&Increment::default())).collect();
        let caused = |index: usize| {
            let of_case = |(case, without): (&&AnsweredCase, &Vec<Varied<f64>>)| {
                let with = case.with_increment(&case.summands()[index].1);
                let over = |datum: &Datum| {
                    let [item, part] = datum.place;
                    finite((with[item].parts()[part] - without[item].parts()[part]) / datum.sigma)
                };
                case.data.iter().map(over).collect::<Vec<_>>()
            };
            cases.iter().zip(&unchanged).flat_map(of_case).collect()
        };
        Self {
            found: cases.iter().flat_map(found).collect(),
            caused: (0..summands).into_par_iter().map(caused).collect(),
        }
    }

    /// The sum of squares that remains.
    fn left(&self, wrong: &[(usize, f64)]) -> f64 {
        let at = |k: usize| {
            let explained: f64 = wrong.iter().map(|&(i, coefficient)| coefficient * self.caused[i][k]).sum();
            (self.found[k] - explained).powi(2)
        };
        (0..self.found.len()).map(at).sum()
    }

    /// The coefficient, or a common one if it fits as well.
    fn settled(&self, coefficient: f64, wrong: impl Fn(f64) -> Vec<(usize, f64)>) -> f64 {
        let is_as_good = |common: &f64| {
            let best = self.left(&wrong(coefficient));
            #[expect(clippy::cast_precision_loss, reason = "few numbers")]
            let mean = best / self.found.len() as f64;
            self.left(&wrong(*common)) <= 2.0 * best + 25.0 * mean.max(1.0)
        };
        common(coefficient).filter(is_as_good).unwrap_or(coefficient)
    }
}

fn finite(number: f64) -> f64 {
    if number.is_finite() { number } else { 0.0 }
}

fn dot(one: &[f64], two: &[f64]) -> f64 {
    one.iter().zip(two).map(|(one, two)| one * two).sum()
}

/// A group of summands with one factor, with the deviations that it causes.
struct Group {
    members: Vec<usize>,
    caused: Vec<f64>,
    /// The sum of their squares, and of their products with the deviations of the answers.
    square: f64,
    product: f64,
}

impl Group {
    fn with(&self, coefficient: f64) -> Vec<(usize, f64)> {
        self.members.iter().map(|&i| (i, coefficient)).collect()
    }
}

/// The fit of all summands to the answers.
pub(super) struct SummandFit {
    all: Vec<Summand>,
    deviations: Deviations,
    /// Each summand, and each together with that of the other beam: one line of a program can serve both.
    groups: Vec<Group>,
}

impl SummandFit {
    /// The fit at these cases.
    pub(super) fn new(cases: &[&AnsweredCase]) -> Self {
        let first = cases.first().map_or(&[][..], |case| case.summands());
        let all: Vec<_> = first.iter().map(|(summand, _)| *summand).collect();
        let deviations = Deviations::new(cases, all.len());
        let members = |i: usize| {
            let both = all[i].mirror.filter(|mirror| i < *mirror).map(|mirror| vec![i, mirror]);
            [Some(vec![i]), both].into_iter().flatten()
        };
        let group = |members: Vec<usize>| {
            let at = |k: usize| members.iter().map(|&i| deviations.caused[i][k]).sum();
            let caused: Vec<f64> = (0..deviations.found.len()).map(at).collect();
            let (square, product) = (dot(&caused, &caused), dot(&caused, &deviations.found));
            (square > 0.0).then_some(Group { members, caused, square, product })
        };
        let groups = (0..all.len()).flat_map(members).collect::<Vec<_>>().into_par_iter();
        let groups = groups.filter_map(group).collect();
        Self { all, deviations, groups }
    }

    /// The best changes of one summand, and of one with its transpose.
    pub(super) fn of_one(&self) -> Vec<Change> {
        let single = |group: &Group| {
            let coefficient = match self.all[group.members[0]].error {
                SummandError::Factor => self
                    .deviations
                    .settled(group.product / group.square, |coefficient| group.with(coefficient)),
                SummandError::Power(_) | SummandError::System(_) => 1.0,
            };
            let wrong = group.with(coefficient);
            (coefficient != 0.0).then(|| (self.deviations.left(&wrong), wrong))
        };
        let singles = best(self.groups.par_iter().filter_map(single).collect(), TRIED);
        let doubles =
            self.doubles(|one, two| one.transposed.is_some_and(|of| self.all[of].label == two.label));
        singles.into_iter().chain(doubles).map(|wrong| self.change(wrong)).collect()
    }

    /// The best changes of two summands of a sum.
    pub(super) fn of_two(&self) -> Vec<Change> {
        let sum_of = |of: &Summand| of.label.name.split_once(": ").map(|(sum, _)| sum);
        self.doubles(|one, two| sum_of(one) == sum_of(two))
            .into_iter()
            .map(|wrong| self.change(wrong))
            .collect()
    }

    /// The best changes of two summands with factors that errors have. Two free factors would fit too much.
    fn doubles(&self, is_asked: impl Fn(&Summand, &Summand) -> bool + Sync) -> Vec<Vec<(usize, f64)>> {
        let is_pair = |&(one, two): &(&Group, &Group)| {
            let [first, second] = [one, two].map(|group| &self.all[group.members[0]]);
            let are_factors = [first, second].iter().all(|of| of.error == SummandError::Factor);
            are_factors && one.members.len() == two.members.len() && is_asked(first, second)
        };
        let double = |(one, two): (&Group, &Group)| {
            let mixed = dot(&one.caused, &two.caused);
            let det = one.square * two.square - mixed * mixed;
            if det <= 1e-9 * one.square * two.square {
                return None;
            }
            let first = common((one.product * two.square - two.product * mixed) / det)?;
            let second = common((two.product * one.square - one.product * mixed) / det)?;
            let wrong = [one.with(first), two.with(second)].concat();
            Some((self.deviations.left(&wrong), wrong))
        };
        let with_second = |(k, one): (usize, _)| self.groups[k + 1..].iter().map(move |two| (one, two));
        let pairs: Vec<_> = self.groups.iter().enumerate().flat_map(with_second).filter(is_pair).collect();
        best(pairs.into_par_iter().filter_map(double).collect(), TRIED)
    }

    fn change(&self, wrong: Vec<(usize, f64)>) -> Change {
        let of = |(index, coefficient): (usize, f64)| WrongSummand {
            index,
            summand: self.all[index],
            coefficient,
        };
        Change::Summands(wrong.into_iter().map(of).collect())
    }
}

/// The common factor, less one, near this one.
fn common(coefficient: f64) -> Option<f64> {
    COMMON.into_iter().find(|common| (coefficient - common).abs() <= NEAR)
}

/// The changes that leave the smallest sums of squares.
fn best(mut all: Vec<(f64, Vec<(usize, f64)>)>, count: usize) -> Vec<Vec<(usize, f64)>> {
    all.sort_by(|one, two| one.0.total_cmp(&two.0));
    all.into_iter().take(count).map(|(_, wrong)| wrong).collect()
}

#[cfg(test)]
mod tests;
