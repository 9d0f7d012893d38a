//! A case with its answers, and the answers of the closed form with a fault.

use super::datum::{Datum, ratio};
use super::hypothesis::Change;
use crate::check::candidate::Sides;
use crate::check::diagnosis::place;
use crate::check::element::ElementAt;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::external::answers::Answers;
use crate::check::external::compare::{Converted, Demands, Judgement, half_unit};
use crate::check::external::conventions::Conventions;
use crate::check::external::vectors::Vector;
use crate::linearization::closed_form::Formulation;
use crate::linearization::{COMPONENTS, Varied};
use crate::test_beam::Family;
use crate::variant::{Fault, SCALAR_COMPONENTS, Variant};
use std::borrow::Cow;
use std::collections::HashMap;

/// All items, as a program answers them directly, and contracted.
pub(super) type Predicted = [Vec<Varied<f64>>; 2];

/// Predictions of single faults that are reused, by case.
pub(super) type Memo = HashMap<String, Known>;
/// The reused predictions at a case.
pub(super) type Known = HashMap<Fault, Vec<Predicted>>;

/// A case to be explained.
pub(super) struct AnsweredCase<'a> {
    memo: Option<&'a Known>,
    paper: EvaluationPoint<'a>,
    /// The case in the library's formulation and in the robust one, where these differ.
    others: Vec<EvaluationPoint<'a>>,
    pub(super) conventions: Conventions,
    families: [Family; 2],
    is_closed: bool,
    element: Option<ElementAt>,
    pub(super) data: Vec<Datum>,
}

impl<'a> AnsweredCase<'a> {
    /// All numbers of the answers to a case that can be compared; `evaluate` makes the closest point.
    pub(super) fn new(
        (vector, answers): (&Vector, &Answers),
        demands: &Demands,
        evaluate: impl Fn() -> Option<EvaluationPoint<'a>>,
    ) -> Option<Self> {
        let evaluation = evaluate()?;
        let element = vector.element_at(&evaluation).ok()?;
        let (sides, paper) = Sides::new(evaluation, &vector.case.test_beams);
        let converted = Converted::new(vector, &sides, element, &demands.conventions);
        let entries = converted.entries(answers, &demands.conventions).ok()?;
        let datum = |entry: crate::check::candidate::Entry| {
            let judged = entry.judged(demands.digits);
            let comparison = judged.comparison;
            let digits = demands.digits.map_or(0.0, half_unit);
            // Printed numbers with few digits have an error of up to half a unit of the last digit.
            let printed = digits * entry.spread / 3.0_f64.sqrt();
            let least = f64::EPSILON * comparison.other.abs();
            Datum {
                place: entry.place,
                quantity: comparison.quantity,
                order: comparison.order,
                rank: place(&comparison),
                is_contracted: entry.is_contracted,
                answer: comparison.closed,
                reference: comparison.other,
                scale: comparison.scale.max(comparison.other.abs()),
                tolerance: comparison.tolerance + digits * entry.size,
                sigma: entry.comparison.tolerance.max(least) + printed,
                is_wrong: judged.judgement == Judgement::Wrong,
            }
        };
        let clear = |entry: &crate::check::candidate::Entry| {
            entry.judged(demands.digits).judgement != Judgement::Unclear
        };
        let data = entries.into_iter().filter(clear).map(datum).collect();
        let chosen = evaluate()?.form;
        let robust = Formulation::robust(&paper.points(), paper.held);
        let inside = !paper.held.xi && !paper.held.xi_bar;
        let mut forms: Vec<Formulation> = Vec::new();
        for form in [chosen, robust] {
            if inside && form != paper.form && !forms.contains(&form) {
                forms.push(form);
            }
        }
        let in_form = |form: &Formulation| Some(evaluate()?.in_formulation(*form));
        let others = forms.iter().filter_map(in_form).collect();
        let is_closed = sides.reference[20].value.value < 0.0;
        Some(Self {
            paper,
            others,
            conventions: demands.conventions,
            families: vector.families(),
            is_closed,
            element: converted.element,
            data,
            memo: None,
        })
    }

    /// The case with known predictions.
    pub(super) fn with_memo(self, memo: Option<&'a Known>) -> Self {
        Self { memo, ..self }
    }

    /// The largest tolerance over its scale.
    pub(super) fn blur(&self) -> f64 {
        self.data.iter().map(|datum| ratio(datum.tolerance, datum.scale)).fold(0.0, f64::max)
    }

    /// The number of wrong numbers.
    pub(super) fn wrong(&self) -> usize {
        self.data.iter().filter(|datum| datum.is_wrong).count()
    }

    /// The kind of terms that occur: those of curves that are not linear in their dofs, and those of free parameters.
    pub(super) fn kind(&self) -> [bool; 4] {
        let linear = self.families.map(Family::is_linear);
        [linear[0], linear[1], self.paper.held.xi, self.paper.held.xi_bar]
    }

    /// Whether some number is a gradient or a Hessian.
    fn has_contracted(&self) -> bool {
        self.data.iter().any(|datum| datum.is_contracted)
    }

    /// The case with gradients and Hessians alone, because the directions are not part of the case.
    pub(super) fn of_arrays(mut self) -> Self {
        self.data.retain(|datum| datum.is_contracted);
        self
    }

    /// The answers of the closed form with this change, by each method that the program may use for its numbers: by the
    /// paper's formulas or by those that keep more digits, with gradients and Hessians by their own formulas
    /// or from the variations.
    pub(super) fn predicted(&self, change: &Change) -> Cow<'_, [Predicted]> {
        let known = match change {
            Change::Variant(Variant::Faulty(faults)) if faults.len() == 1 => {
                self.memo.and_then(|memo| memo.get(&faults[0]))
            }
            _ => None,
        };
        known.map_or_else(|| Cow::Owned(self.computed(change)), |known| Cow::Borrowed(known.as_slice()))
    }

    /// The same, computed again.
    pub(super) fn computed(&self, change: &Change) -> Vec<Predicted> {
        let evaluations = [&self.paper].into_iter().chain(&self.others);
        evaluations.flat_map(|evaluation| self.computed_by(evaluation, change)).collect()
    }

    /// The number of formulations that differ at this case.
    pub(super) fn formulations(&self) -> usize {
        1 + self.others.len()
    }

    /// The answers of the closed form with this change in one of these formulations, or in the last one.
    pub(super) fn computed_in(&self, formulation: usize, change: &Change) -> Vec<Predicted> {
        let last = formulation.min(self.others.len());
        self.computed_by(last.checked_sub(1).map_or(&self.paper, |i| &self.others[i]), change)
    }

    /// The gradient of the gap along both directions.
    pub(super) fn gap_gradients(&self) -> [f64; 2] {
        let gap = self.paper.plain(&Variant::Unmodified)[20];
        [gap.delta, gap.linear]
    }

    fn computed_by(&self, evaluation: &EvaluationPoint<'_>, change: &Change) -> Vec<Predicted> {
        let mut all = Vec::with_capacity(4);
        let (varied, rows) = match change {
            Change::Structure(structure) => evaluation.simplified(*structure),
            other => {
                let variant =
                    if let Change::Variant(variant) = other { variant } else { &Variant::Unmodified };
                let of_matrices = || evaluation.matrices(variant).map(|row| row.map(|number| number.value));
                let rows = if self.has_contracted() { of_matrices() } else { Default::default() };
                (evaluation.plain(variant), rows)
            }
        };
        let converted = |varied: [Varied<f64>; COMPONENTS]| {
            let mut all =
                self.conventions.of(&varied, self.is_closed, self.element.as_ref(), evaluation.form);
            change.of_items(&mut all, &varied, &self.conventions);
            all
        };
        let direct = converted(varied);
        if self.has_contracted() {
            let mut contracted = varied;
            for (i, [delta, linear, second]) in SCALAR_COMPONENTS.into_iter().zip(rows) {
                contracted[i] = Varied { value: contracted[i].value, delta, linear, second };
            }
            contracted[20] = Varied { value: contracted[20].value, ..contracted[15] };
            all.push([direct.clone(), converted(contracted)]);
        }
        all.push([direct.clone(), direct.clone()]);
        if self.has_contracted()
            && let Change::Variant(variant) = change
        {
            // A Hessian from a wrong variation is not symmetric. It may be the transpose, or the mean of both.
            let exchanged = evaluation.exchanged(variant);
            let with = |weight: f64| {
                std::array::from_fn(|i| {
                    let second = (1.0 - weight) * varied[i].second + weight * exchanged[i].second;
                    Varied { second, ..varied[i] }
                })
            };
            let is_symmetric = |(one, two): (&Varied<f64>, &Varied<f64>)| {
                (one.second - two.second).abs() <= 1e-12 * one.second.abs()
            };
            if !varied.iter().zip(&exchanged).all(is_symmetric) {
                all.extend([1.0, 0.5].map(|weight| [direct.clone(), converted(with(weight))]));
            }
        }
        all
    }

    /// The number of a prediction in the place of this datum.
    pub(super) fn number([direct, contracted]: &Predicted, datum: &Datum) -> f64 {
        let [item, part] = datum.place;
        let of = if datum.is_contracted { contracted } else { direct };
        of[item].parts()[part]
    }
}
