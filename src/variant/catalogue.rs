//! The catalogue of faults: every term of the closed form with every kind of fault that changes a result.
//!
//! There is no list. The code names its terms when it runs, and the prime field decides whether a change of a term is a
//! fault. Equivalent mutants, which alter no result, are skipped. Two changes of one term with the same results are one
//! fault.

use super::point::{Point, Results};
use super::{Fault, Kind, UnknownFault, Variant};
use crate::number::Label;
use crate::parallel;
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// All faults, in the order in which their terms are evaluated.
pub fn catalogue() -> Vec<Fault> {
    static ALL: OnceLock<Vec<Fault>> = OnceLock::new();
    ALL.get_or_init(|| parallel::flat_map(&labels(), of_term)).clone()
}

/// The faults of the catalogue in the same order, in parts of more and more terms: the first faults are known early.
pub fn catalogue_in_parts() -> impl Iterator<Item = Vec<Fault>> {
    let (labels, mut start, mut count) = (labels(), 0, 2);
    std::iter::from_fn(move || {
        let terms = labels.get(start..labels.len().min(start + count)).filter(|terms| !terms.is_empty())?;
        (start, count) = (start + terms.len(), 2 * count);
        Some(parallel::flat_map(terms, of_term))
    })
}

/// The closed form with the faults of these names, as [`Fault`] writes them; unmodified if there are no names.
///
/// # Errors
/// If a name is not in the catalogue.
pub fn with_faults(names: &[String]) -> Result<Variant, UnknownFault> {
    if names.is_empty() {
        return Ok(Variant::Unmodified);
    }
    let labels = labels();
    let find = |name: &String| {
        let of = |label: &&Label| name.starts_with(&format!("{label} = "));
        let mut faults = labels.iter().filter(of).flat_map(of_term);
        faults.find(|fault| fault.to_string() == *name).ok_or_else(|| UnknownFault(name.clone()))
    };
    names.iter().map(find).collect::<Result<_, _>>().map(Variant::Faulty)
}

/// The faults of a term.
fn of_term(&label: &Label) -> Vec<Fault> {
    let mut known = vec![Outcome::new(Variant::Unmodified)];
    let mut faults = Vec::new();
    for kind in Kind::ALL {
        let fault = Fault { label, kind };
        let outcome = Outcome::new(Variant::Faulty(vec![fault]));
        if !known.contains(&outcome) {
            known.push(outcome);
            faults.push(fault);
        }
    }
    faults
}

/// The results of a variant at all points. It is evaluated only at those that a comparison needs.
struct Outcome {
    variant: Variant,
    results: Vec<OnceCell<Results>>,
}

impl Outcome {
    fn new(variant: Variant) -> Self {
        Self { variant, results: points().iter().map(|_| OnceCell::new()).collect() }
    }
}

impl PartialEq for Outcome {
    fn eq(&self, other: &Self) -> bool {
        points().iter().enumerate().all(|(i, point)| {
            let [one, two] = [self, other].map(|of| of.results[i].get_or_init(|| point.results(&of.variant)));
            one == two
        })
    }
}

/// Faults by name, each with a number. Faults with the same number have the same results for all beams.
pub(crate) fn classes(faults: &[Fault]) -> BTreeMap<String, usize> {
    let results = |fault: &Fault| {
        let variant = Variant::Faulty(vec![*fault]);
        points().iter().map(|point| point.results(&variant)).collect::<Vec<_>>()
    };
    let all = parallel::map(faults, results);
    let first = |i: usize| (0..i).find(|&j| all[j] == all[i]).unwrap_or(i);
    faults.iter().enumerate().map(|(i, fault)| (fault.to_string(), first(i))).collect()
}

fn points() -> &'static [Point] {
    static ALL: OnceLock<Vec<Point>> = OnceLock::new();
    ALL.get_or_init(Point::all)
}

/// The names of all terms: those of the variations, then those of the matrices alone.
pub(crate) fn labels() -> Vec<Label> {
    let [varied, expanded] = terms();
    varied.iter().chain(expanded.iter().filter(|label| !varied.contains(label))).copied().collect()
}

/// The names of the terms of the variations, and of the matrices, in the order of their first use; some are in both.
pub(crate) fn terms() -> &'static [Vec<Label>; 2] {
    static ALL: OnceLock<[Vec<Label>; 2]> = OnceLock::new();
    ALL.get_or_init(|| {
        let mut all = [Vec::new(), Vec::new()];
        for point in points() {
            for (known, labels) in all.iter_mut().zip(point.labels()) {
                for label in labels {
                    if !known.contains(label) {
                        known.push(*label);
                    }
                }
            }
        }
        all
    })
}
