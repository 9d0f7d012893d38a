//! Faults of the terms of residual and tangent of the contact element: whether the elements of the check detect them.
//!
//! The cases of a regime are gone through in the order of the check until each fault is detected at some element, or the default
//! number of cases is reached. The terms are those of [`terms`](crate::teaching::terms), for beams with at most 12 dofs.

use crate::check::{Case, Comparison, ElementAt, EvaluationPoint, Regime, Selection, compares_routes};
use crate::closest_point::{Search, closest_points};
use crate::contact::State;
use crate::parallel;
use crate::teaching::terms::{Components, Term, Terms};
use nalgebra::DVector;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// The largest number of cases: the default of `beamgap check`.
const CASES: u64 = 10_000;
/// The number of cases that are drawn at a time.
const AT_ONCE: usize = 32;
/// The terms of R.
const FORCES: [&str; 3] = ["-F_N grad g_N", "F A", "F_bar A_bar"];
/// What is wrong with a term, and what this adds to it, in multiples of it.
const KINDS: [(&str, f64); 4] =
    [("is missing", -1.0), ("has the opposite sign", -2.0), ("is doubled", 1.0), ("is halved", -0.5)];

/// The detections of the faults in a regime.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ElementFaults {
    /// The regime.
    pub regime: Regime,
    /// The number of cases that were drawn.
    pub cases: u64,
    /// The elements at which the check rejects the right element. They are not counted for a fault.
    pub rejected: u64,
    /// The number of faults.
    pub planted: usize,
    /// The faults that no element detects, in words.
    pub missed: Vec<String>,
}

impl ElementFaults {
    /// Whether every fault is detected, and no right element is rejected.
    pub fn holds(&self) -> bool {
        self.planted > 0 && self.rejected == 0 && self.missed.is_empty()
    }
}

/// Injects all faults of the element in these regimes.
///
/// The result depends on the seed and the regimes, not on the number of threads.
pub fn element_faults(seed: u64, regimes: &[Regime]) -> Vec<ElementFaults> {
    regimes.iter().map(|&regime| of_regime(seed, regime)).collect()
}

fn of_regime(seed: u64, regime: Regime) -> ElementFaults {
    let numbers = Selection { regimes: vec![regime], family: None, cases: CASES }.numbers();
    let all: BTreeSet<Fault> = faults().collect();
    let (mut cases, mut rejected, mut open) = (0, 0, all.clone());
    for block in numbers.chunks(AT_ONCE) {
        if open.is_empty() {
            break;
        }
        let with_elements: Vec<u64> =
            block.iter().copied().filter(|&number| compares_routes(number)).collect();
        let found = parallel::map(&with_elements, |&number| detected(&Case::draw(seed, number), &open));
        for (of_case, rejects) in found {
            rejected += rejects;
            open.retain(|fault| !of_case.contains(fault));
        }
        cases += block.len() as u64;
    }
    let missed = open.into_iter().map(Fault::words).collect();
    ElementFaults { regime, cases, rejected, planted: all.len(), missed }
}

/// A term of R or of K, by its number, and what is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Fault {
    is_of_tangent: bool,
    term: usize,
    kind: usize,
}

impl Fault {
    fn words(self) -> String {
        let (array, term) =
            if self.is_of_tangent { ("K", Term::ALL[self.term].name()) } else { ("R", FORCES[self.term]) };
        format!("in {array} {term} {}", KINDS[self.kind].0)
    }
}

fn faults() -> impl Iterator<Item = Fault> {
    let terms = [(false, FORCES.len()), (true, Term::ALL.len())];
    let of = |(is_of_tangent, count): (bool, usize)| {
        (0..count).flat_map(move |term| (0..KINDS.len()).map(move |kind| Fault { is_of_tangent, term, kind }))
    };
    terms.into_iter().flat_map(of)
}

/// Those of the faults that the elements of a case detect, and the number of right elements that are rejected.
fn detected(case: &Case, among: &BTreeSet<Fault>) -> (BTreeSet<Fault>, u64) {
    let [beam, bar] = case.beams();
    let minima = closest_points(beam, bar, &Search::default()).map(|found| found.minima).unwrap_or_default();
    let (mut found, mut rejected) = (BTreeSet::new(), 0);
    for point in &minima {
        let Ok(evaluation) = EvaluationPoint::new([beam, bar], &case.contact, point) else { continue };
        evaluation.each_element(&evaluation.chord(), &mut |evaluation, element, comparisons| {
            if comparisons.iter().any(Comparison::is_wrong) {
                rejected += 1;
            } else if let Some(terms) = contributions(evaluation, element) {
                found.extend(among.iter().filter(|fault| is_detected(**fault, &terms, &comparisons)));
            }
        });
    }
    (found, rejected)
}

/// What each term of R adds to R along δ and Δ, and each term of K to K between them in both orders.
struct Contributions {
    forces: Vec<[f64; 2]>,
    matrices: Vec<[f64; 2]>,
}

/// The contributions of the terms, if a force acts and the beams have few dofs.
fn contributions(evaluation: &EvaluationPoint, element: &ElementAt) -> Option<Contributions> {
    if element.state() == State::Open {
        return None;
    }
    let [(jet, vectors), (jet_bar, vectors_bar)] = evaluation.jets_of_few()?;
    let at = (evaluation.at.0.value, evaluation.at.1.value);
    let terms = element.with(|decision| Terms::new(decision, (&jet, &jet_bar), at, Components::Covariant))?;
    let along = [1, 2].map(|k| {
        let (beam, bar) = (vectors[k].iter(), vectors_bar[k].iter());
        DVector::from_iterator(vectors[k].len() + vectors_bar[k].len(), beam.chain(bar).copied())
    });
    let [delta, linear] = &along;
    let of_matrix = |term: Term| {
        terms.term(term).map_or([0.0; 2], |k| [delta.dot(&(k * linear)), linear.dot(&(k * delta))])
    };
    let forces = terms.forces.iter().map(|force| along.each_ref().map(|along| force.dot(along)));
    Some(Contributions { forces: forces.collect(), matrices: Term::ALL.map(of_matrix).to_vec() })
}

/// Whether a number with the fault exceeds its tolerance.
fn is_detected(fault: Fault, terms: &Contributions, comparisons: &[Comparison]) -> bool {
    let (all, first) = if fault.is_of_tangent { (&terms.matrices, 2) } else { (&terms.forces, 0) };
    let Some(term) = all.get(fault.term) else { return false };
    let (_, factor) = KINDS[fault.kind];
    comparisons.chunks(4).any(|of_door| {
        of_door[first..].iter().zip(term).any(|(comparison, share)| comparison.is_wrong_with(factor * share))
    })
}

#[cfg(test)]
mod tests {
    use super::{FORCES, Fault, KINDS, element_faults, faults};
    use crate::check::Regime;
    use crate::teaching::terms::Term;

    #[test]
    fn every_fault_of_the_element_is_detected() {
        for of in element_faults(0x5eed, &[Regime::Generic, Regime::NearEnd]) {
            assert!(of.holds(), "{of:?}");
            assert_eq!(of.planted, KINDS.len() * (FORCES.len() + Term::ALL.len()));
            // No single case has all terms.
            assert!(of.cases > 1, "{of:?}");
        }
    }

    #[test]
    fn a_fault_that_is_missed_is_told() {
        let first = faults().next().unwrap();
        assert_eq!(first.words(), "in R -F_N grad g_N is missing");
        let last = Fault { is_of_tangent: true, term: Term::ALL.len() - 1, kind: 3 };
        assert_eq!(
            (faults().last(), &*last.words()),
            (Some(last), "in K F (u Hess t + grad t g') is halved")
        );
        let mut of = element_faults(1, &[Regime::Generic]).remove(0);
        of.missed.push(first.words());
        assert!(!of.holds());
    }
}
