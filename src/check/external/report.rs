//! The results of all answers.

use super::answers::{Answers, Program};
use super::compare::{CaseFound, Judged, Judgement};
use super::error::Place;
use super::vectors::{Outcome, Vector};
use crate::check::verdict::Order;
use crate::linearization::Quantity;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The number of cases with a wrong number that are kept for an explanation.
const KEPT: usize = 40;
/// The maximum number of these for each kind of pair.
const OF_A_KIND: usize = 10;

/// The result for one part of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartFound {
    /// The number of compared numbers.
    pub numbers: u64,
    /// The number of these that are correct, but have fewer digits than are attainable.
    #[serde(rename = "losing_digits")]
    pub losing: u64,
    /// The number of wrong numbers.
    pub wrong: u64,
    /// The count of numbers that are not meaningful, because rounding explains more than a thousandth of their scale.
    pub unclear: u64,
    /// The number that comes closest to its tolerance, or exceeds it most.
    pub worst: Judged,
    /// Its case.
    pub case: String,
    /// The place of its answer.
    pub place: Place,
    /// The number with the largest error over its size.
    pub largest_error: Loss,
}

/// The largest error, or the largest loss of digits, in a regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Loss {
    /// The number.
    pub judged: Judged,
    /// Its case.
    pub case: String,
}

impl Loss {
    /// The error over the size of the number; infinite if it is not a number.
    pub fn error(&self) -> f64 {
        let Judged { loss, size, .. } = self.judged;
        // A number without any error has all digits.
        let error = if loss == 0.0 { 0.0 } else { loss / size };
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// The number of attainable digits that are lost.
    pub fn digits(&self) -> f64 {
        (self.judged.loss / self.judged.attainable).log10()
    }
}

/// The result in a regime.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RegimeFound {
    /// Cases that were compared.
    pub compared: u64,
    /// Of these, those with a wrong number.
    pub wrong: u64,
    /// Of these, those with a number that is correct but loses digits.
    #[serde(rename = "losing_digits")]
    pub losing: u64,
    /// The largest loss among the correct numbers.
    pub loss: Option<Loss>,
    /// The largest error over the size of the number, whether correct or wrong.
    pub worst: Option<Loss>,
}

/// The key of a part: order, quantity, and the name of the order, or residual or tangent.
pub type PartKey = (Order, Quantity, &'static str);

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
    /// Cases without an answer.
    pub missing: u64,
    /// The first of them.
    pub first_missing: Option<String>,
    /// Answers without any number.
    pub unanswered: u64,
    /// Cases whose closest point has no reference, by reason.
    #[serde(rename = "not_compared")]
    pub degenerate: BTreeMap<String, u64>,
    /// The results by part. A part is identified by its worst number.
    #[serde(with = "parts")]
    pub parts: BTreeMap<PartKey, PartFound>,
    /// The results by regime.
    pub regimes: BTreeMap<String, RegimeFound>,
    /// The first wrong case, with its first wrong number.
    #[serde(skip)]
    pub first: Option<(Vector, Answers, Judged)>,
    /// Wrong cases by the first wrong part.
    #[serde(skip)]
    pub beginnings: BTreeMap<PartKey, u64>,
    /// Cases for the explanation, of as many kinds as possible.
    #[serde(skip)]
    pub kept: Vec<(Vector, Answers)>,
}

impl Report {
    /// Adds a case that was not answered.
    pub fn add_missing(&mut self, id: &str) {
        self.vectors += 1;
        self.missing += 1;
        self.first_missing.get_or_insert_with(|| id.to_owned());
    }

    /// Adds the result of a case.
    pub fn add(&mut self, vector: Vector, answers: Answers, found: CaseFound) {
        self.vectors += 1;
        let (judged, is_doubted) = match found {
            CaseFound::Degenerate(outcome) => {
                let reason = match outcome {
                    Outcome::Degenerate(reason) => reason.reason(),
                    Outcome::NoProjection => "no closest point is known",
                    Outcome::Valid => "valid",
                };
                self.add_degenerate(reason);
                return;
            }
            CaseFound::Unanswered => {
                self.unanswered += 1;
                return;
            }
            CaseFound::Compared(judged, is_doubted) => (judged, is_doubted),
        };
        for one in &judged {
            self.add_part(one, &vector.id, &answers.place);
        }
        let is = |wanted: Judgement| move |judged: &&Judged| judged.judgement == wanted;
        if judged.iter().all(|judged| judged.judgement == Judgement::Unclear) {
            self.add_degenerate("the rounding bound exceeds 1e-3 of a scale");
            return;
        }
        self.compared += 1;
        let regime = self.regimes.entry(vector.regime.clone()).or_default();
        regime.compared += 1;
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
        let Some(&first) = judged.iter().find(is(Judgement::Wrong)) else { return };
        regime.wrong += 1;
        self.wrong += 1;
        self.doubted += u64::from(is_doubted);
        *self.beginnings.entry(key(&first)).or_default() += 1;
        self.keep(&vector, &answers);
        self.first.get_or_insert((vector, answers, first));
    }

    fn add_degenerate(&mut self, reason: &str) {
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

    /// Quantities without an answer at any case.
    pub fn never_answered(&self) -> Vec<Quantity> {
        let is_answered = |quantity: &Quantity| self.parts.keys().any(|(_, known, _)| known == quantity);
        Quantity::ALL.into_iter().filter(|quantity| !is_answered(quantity)).collect()
    }

    /// Whether something was compared, and no number is wrong.
    pub fn agrees(&self) -> bool {
        self.compared > 0 && self.wrong == 0
    }

    /// The part that is wrong first in most wrong cases. If there are several, the earliest in the order of evaluation.
    pub fn beginning(&self) -> Option<(PartKey, u64)> {
        let most = self.beginnings.values().max()?;
        self.beginnings.iter().find(|(_, count)| *count == most).map(|(key, count)| (*key, *count))
    }
}

fn key(judged: &Judged) -> PartKey {
    let comparison = &judged.comparison;
    let is_of_element = matches!(comparison.part, "residual" | "tangent");
    let name = if is_of_element { comparison.part } else { comparison.order.name() };
    (comparison.order, comparison.quantity, name)
}

/// The parts as a list, each with its quantity and order. Their keys are those of the worst numbers.
mod parts {
    use super::{PartFound, PartKey, key};
    use crate::linearization::Quantity;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use std::collections::BTreeMap;

    #[derive(Serialize)]
    struct Part<'a> {
        quantity: Quantity,
        order: &'static str,
        #[serde(flatten)]
        found: &'a PartFound,
    }

    pub(super) fn serialize<S: Serializer>(
        parts: &BTreeMap<PartKey, PartFound>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(parts.iter().map(|(&(_, quantity, order), found)| Part {
            quantity,
            order,
            found,
        }))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<BTreeMap<PartKey, PartFound>, D::Error> {
        let parts = Vec::<PartFound>::deserialize(deserializer)?;
        Ok(parts.into_iter().map(|part| (key(&part.worst), part)).collect())
    }
}
