//! The results of all answers.

mod coverage;
mod found;
mod parts;
mod searched;

use super::answers::{Answers, Program};
use super::compare::{CaseFound, Judged, Judgement};
use super::error::Place;
use super::few_digits::Precision;
use super::only::{Only, PartKey, is_force, is_of_element};
use super::vectors::Vector;
use crate::check::left_out_warning;
use crate::check::verdict::Inconclusive;
use crate::linearization::Quantity;
pub use coverage::Coverage;
pub use found::{Loss, PartFound, RegimeFound};
use parts::key;
pub use searched::SearchFound;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The number of cases with a wrong number that are kept for an explanation.
const KEPT: usize = 40;
/// The maximum number of these for each kind of pair.
const OF_A_KIND: usize = 10;

/// The result of all answers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The program, as its answers describe it.
    pub program: Program,
    /// Cases.
    #[serde(rename = "cases")]
    pub vectors: u64,
    /// Cases that were compared.
    pub compared: u64,
    /// Of these, those with a wrong number.
    pub wrong: u64,
    /// Of these, those at which the references disagree among themselves.
    pub doubted: u64,
    /// Cases with a reference that the program states to answer.
    #[serde(default)]
    pub asked: u64,
    /// Cases with a reference that the program states not to answer.
    #[serde(default)]
    pub not_asked: u64,
    /// Of the cases to answer, those without an answer.
    pub missing: u64,
    /// The first of them.
    pub first_missing: Option<String>,
    /// Answers without any number.
    pub unanswered: u64,
    /// Answers that there is no regular closest point, although there is one.
    #[serde(default)]
    pub declined: u64,
    /// The first of them: its case, and the place of the answer.
    #[serde(default)]
    pub first_declined: Option<(String, Place)>,
    /// Cases whose closest point has no reference, by reason.
    #[serde(rename = "not_compared")]
    pub degenerate: BTreeMap<String, u64>,
    /// The results by part. A part is identified by its worst number.
    #[serde(with = "parts")]
    pub parts: BTreeMap<PartKey, PartFound>,
    /// The results by regime.
    pub regimes: BTreeMap<String, RegimeFound>,
    /// The search for the closest points against the independent one.
    #[serde(default)]
    pub search: SearchFound,
    /// The first wrong case, with its first wrong number; one that rounding does not explain, if there is one.
    #[serde(skip)]
    pub first: Option<(Vector, Answers, Judged)>,
    /// Wrong cases by the first wrong part.
    #[serde(skip)]
    pub beginnings: BTreeMap<PartKey, u64>,
    /// Cases for the explanation, of as many kinds as possible.
    #[serde(skip)]
    pub kept: Vec<(Vector, Answers)>,
    /// Cases at which nothing is wrong, for the explanation.
    #[serde(skip)]
    pub right: Vec<(Vector, Answers)>,
    /// What was answered, by part.
    #[serde(skip)]
    pub coverage: Coverage,
    /// The digits of the answers.
    #[serde(skip)]
    pub precision: Precision,
}

impl Report {
    /// A report on a program that answers only some parts and cases; `is_element` if it states a penalty stiffness.
    pub fn of_program(program: &Program, only: &Only, is_element: bool) -> Self {
        let coverage = Coverage::new(only, is_element);
        Self { program: program.clone(), coverage, ..Self::default() }
    }

    /// Adds the result of a case. There are no answers if the program gave none.
    pub fn add(&mut self, vector: Vector, answers: Option<Answers>, found: CaseFound) {
        self.vectors += 1;
        self.asked += u64::from(!matches!(found, CaseFound::Degenerate(_) | CaseFound::NotAsked));
        let line = vector.place.as_ref().map_or(0, |place| place.line);
        let (judged, is_doubted, answers) = match (found, answers) {
            (CaseFound::Degenerate(outcome), _) => {
                self.add_degenerate(&vector.regime, outcome.reason());
                return;
            }
            (CaseFound::Compared(judged, is_doubted), Some(answers)) => (judged, is_doubted, answers),
            (CaseFound::Declined, Some(answers)) => {
                self.declined += 1;
                self.first_declined.get_or_insert((vector.id, answers.place));
                return;
            }
            (CaseFound::NotAsked, _) => {
                self.not_asked += 1;
                return;
            }
            (_, Some(_)) => {
                self.unanswered += 1;
                return;
            }
            (_, None) => {
                self.missing += 1;
                self.first_missing.get_or_insert(vector.id);
                self.coverage.add_missing(line);
                return;
            }
        };
        self.coverage.add(&vector, line, &answers);
        self.precision.add(&vector.regime, &answers, &judged);
        for one in &judged {
            self.add_part(one, &vector.id, &answers.place);
        }
        let is = |wanted: Judgement| move |judged: &&Judged| judged.judgement == wanted;
        if judged.iter().all(|judged| judged.judgement == Judgement::Unclear) {
            self.add_degenerate(&vector.regime, Inconclusive::NotMeaningful.reason());
            return;
        }
        self.compared += 1;
        let regime = self.regimes.entry(vector.regime.clone()).or_default();
        regime.compared += 1;
        regime.not_compared += u64::from(judged.iter().any(|judged| is(Judgement::Unclear)(&judged)));
        regime.losing += u64::from(judged.iter().any(|judged| is(Judgement::Loses)(&judged)));
        for one in judged.iter().filter(|judged| judged.judgement != Judgement::Unclear) {
            let worst = Loss { judged: *one, case: vector.id.clone() };
            if regime.worst.as_ref().is_none_or(|known| known.error() < worst.error()) {
                regime.worst = Some(worst);
            }
        }
        for one in judged.iter().filter(is(Judgement::Loses)) {
            let loss = Loss { judged: *one, case: vector.id.clone() };
            if regime.loss.as_ref().is_none_or(|known| known.digits() < loss.digits()) {
                regime.loss = Some(loss);
            }
        }
        // What rounding does not explain is told first.
        let wrong = || judged.iter().filter(is(Judgement::Wrong));
        let Some(&first) = wrong().find(|judged| !judged.is_rounding).or_else(|| wrong().next()) else {
            if self.right.len() < KEPT {
                self.right.push((vector, answers));
            }
            return;
        };
        regime.wrong += 1;
        self.wrong += 1;
        self.doubted += u64::from(is_doubted);
        *self.beginnings.entry(key(&first)).or_default() += 1;
        self.keep(&vector, &answers);
        if self.first.as_ref().is_none_or(|(.., known)| known.is_rounding && !first.is_rounding) {
            self.first = Some((vector, answers, first));
        }
    }

    fn add_degenerate(&mut self, regime: &str, reason: &str) {
        self.regimes.entry(regime.to_owned()).or_default().not_compared += 1;
        self.regimes.entry(regime.to_owned()).or_default().without_reference += 1;
        *self.degenerate.entry(reason.to_owned()).or_default() += 1;
    }

    fn add_part(&mut self, one: &Judged, case: &str, place: &Place) {
        let new = || PartFound {
            numbers: 0,
            losing: 0,
            wrong: 0,
            unclear: 0,
            worst: *one,
            case: case.to_owned(),
            place: place.clone(),
            largest_error: Loss { judged: *one, case: case.to_owned() },
        };
        let part = self.parts.entry(key(one)).or_insert_with(new);
        match one.judgement {
            Judgement::Unclear => part.unclear += 1,
            Judgement::Agrees => part.numbers += 1,
            Judgement::Loses => (part.numbers, part.losing) = (part.numbers + 1, part.losing + 1),
            Judgement::Wrong => (part.numbers, part.wrong) = (part.numbers + 1, part.wrong + 1),
        }
        let is_unclear = one.judgement == Judgement::Unclear;
        let is_worse = one.comparison.over_tolerance() > part.worst.comparison.over_tolerance();
        let was_unclear = part.worst.judgement == Judgement::Unclear;
        if !is_unclear && (is_worse || was_unclear) {
            (part.worst, part.case, part.place) = (*one, case.to_owned(), place.clone());
        }
        let loss = Loss { judged: *one, case: case.to_owned() };
        let was_unclear = part.largest_error.judged.judgement == Judgement::Unclear;
        if !is_unclear && (was_unclear || loss.error() > part.largest_error.error()) {
            part.largest_error = loss;
        }
    }

    fn keep(&mut self, vector: &Vector, answers: &Answers) {
        let kind = |vector: &Vector| {
            let is_end = |xi: f64| xi.abs() >= 1.0 - 1e-12;
            let held = vector.point.map(|(xi, xi_bar)| [is_end(xi), is_end(xi_bar)]);
            (vector.families().map(crate::test_beam::Family::is_linear), held)
        };
        let own = kind(vector);
        let of_kind = self.kept.iter().filter(|(other, _)| kind(other) == own).count();
        if self.kept.len() < KEPT && of_kind < OF_A_KIND {
            self.kept.push((vector.clone(), answers.clone()));
        }
    }

    /// Quantities without an answer at any case; none if a contact element alone is asked for.
    pub fn never_answered(&self) -> Vec<Quantity> {
        if self.coverage.is_of_element() {
            return Vec::new();
        }
        let is_answered = |quantity: &Quantity| {
            self.parts.keys().any(|(_, known, name)| known == quantity && !is_of_element(name))
        };
        Quantity::ALL.into_iter().filter(|quantity| !is_answered(quantity)).collect()
    }

    /// Whether something was compared, and nothing is wrong.
    pub fn agrees(&self) -> bool {
        self.compared > 0 && self.wrong == 0 && self.declined == 0
    }

    /// Cases that the program did not answer by a number, although there is a reference.
    pub fn open(&self) -> u64 {
        self.missing + self.unanswered
    }

    /// Whether all that was asked is answered.
    pub fn is_complete(&self) -> bool {
        self.open() == 0 && self.coverage.open_parts().is_empty()
    }

    /// The warning if too many cases of some regimes could not be compared.
    pub fn warning(&self) -> Option<String> {
        let of_regime = |(name, of): (&String, &RegimeFound)| {
            (name.clone(), of.not_compared, of.compared + of.without_reference)
        };
        let counts: Vec<_> = self.regimes.iter().map(of_regime).collect();
        left_out_warning(counts.iter().map(|(name, left, all)| (name.as_str(), *left, *all)), "cases")
    }

    /// The names of state and forces that are wrong, if residual or tangent are compared, and nothing else is wrong.
    pub fn wrong_forces(&self) -> Option<Vec<&'static str>> {
        let wrong: Vec<_> =
            self.parts.iter().filter(|(_, of)| of.wrong > 0).map(|((_, _, name), _)| *name).collect();
        let is_right = self.parts.keys().any(|(_, _, name)| is_of_element(name) && !is_force(name));
        (is_right && !wrong.is_empty() && wrong.iter().all(|name| is_force(name))).then_some(wrong)
    }

    /// The names of wrong forces, if forces are answered.
    pub fn forces(&self) -> Option<Vec<&'static str>> {
        let forces: Vec<_> = self.parts.iter().filter(|((.., name), _)| is_force(name)).collect();
        let wrong = forces.iter().filter(|(_, of)| of.wrong > 0).map(|((.., name), _)| *name).collect();
        (!forces.is_empty()).then_some(wrong)
    }

    /// The part that is wrong first in most wrong cases. If there are several, the earliest in the order of evaluation.
    pub fn beginning(&self) -> Option<(PartKey, u64)> {
        let most = self.beginnings.values().max()?;
        self.beginnings.iter().find(|(_, count)| *count == most).map(|(key, count)| (*key, *count))
    }
}
