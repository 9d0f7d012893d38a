//! The answers of the library itself, dense: for comparison by eye, and for tests of the check.

use super::answers::{ANSWERS, AnswerReader, Answers};
use super::conventions::STATE_AND_FORCES;
use super::vectors::{Vector, VectorWriter, key, quoted};
use crate::check::evaluation_point::EvaluationPoint;
use crate::linearization::closed_form::Formulation;
use crate::linearization::{COMPONENTS, Quantity};
use crate::variant::Variant;
use std::fmt::Write;

/// A program that answers cases: the closed form of this library, unmodified or with faults.
#[derive(Clone, Debug, Default)]
pub struct Evaluator {
    /// The closed form.
    pub variant: Variant,
    /// The formulas that it uses.
    pub formulas: Formulas,
    /// The stiffness of a contact element that is answered too, if given.
    pub penalty: Option<f64>,
    /// The format of numbers.
    pub writer: VectorWriter,
    /// The number of significant digits that are written, if not all.
    pub digits: Option<usize>,
}

/// The formulas that are evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Formulas {
    /// Those that lose the fewest digits at each point.
    #[default]
    Chosen,
    /// The paper's.
    Paper,
    /// The formulas with the normal and the cross products.
    Robust,
}

impl Formulas {
    pub(in crate::check) fn at(self, evaluation: EvaluationPoint<'_>) -> EvaluationPoint<'_> {
        let form = match self {
            Self::Chosen => return evaluation,
            Self::Paper => Formulation::paper(evaluation.held),
            Self::Robust => Formulation::robust(&evaluation.points(), evaluation.held),
        };
        evaluation.in_formulation(form)
    }
}

impl Evaluator {
    /// The head of the answers.
    pub fn head(&self) -> String {
        let version = env!("CARGO_PKG_VERSION");
        let penalty = self.penalty.map_or_else(String::new, |stiffness| {
            format!(",\"penalty_stiffness\":{}", self.writer.number(stiffness))
        });
        format!(
            "{{\"schema\":\"{ANSWERS}\",\"program\":\"beamgap evaluate\",\"version\":\"{version}\"{penalty}}}"
        )
    }

    /// The line that answers a case, without its end.
    pub fn line(&self, vector: &Vector) -> String {
        let id = quoted(&vector.id);
        let answers = |evaluation: EvaluationPoint<'_>| {
            let evaluation = self.formulas.at(evaluation);
            self.answers(&evaluation, self.penalty.filter(|_| vector.element.is_none()))
                + &self.element(vector, &evaluation)
        };
        match vector.evaluated(answers) {
            Ok(answers) => format!("{{\"id\":{id},\"result\":\"valid\"{answers}}}"),
            Err(outcome) => format!("{{\"id\":{id},\"result\":\"{}\"}}", outcome.name()),
        }
    }

    /// Its answer to a case, read from its line.
    pub fn answered(&self, vector: &Vector) -> Option<Answers> {
        let text = format!("{}\n{}\n", self.head(), self.line(vector));
        AnswerReader::new(text.as_bytes(), "answers").ok()?.next_answers().ok()?
    }

    fn answers(&self, evaluation: &EvaluationPoint<'_>, penalty: Option<f64>) -> String {
        let plain = evaluation.plain(&self.variant);
        let dense = evaluation.dense(&self.variant);
        let number = |x: f64| self.writer.number(self.rounded(x));
        let list = |numbers: &[f64]| {
            let rounded: Vec<_> = numbers.iter().map(|&x| self.rounded(x)).collect();
            self.writer.list(&rounded)
        };
        let mut line = String::new();
        for (i, varied) in plain.iter().enumerate().take(COMPONENTS) {
            let (quantity, axis) = (Quantity::of_component(i), Quantity::axis_of_component(i));
            let [value, delta, linear, second] = varied.parts().map(number);
            let _ = write!(
                line,
                ",\"{}\":{{\"value\":{value},\"delta\":{delta},\"Delta\":{linear},\"Delta-delta\":{second}",
                key(quantity, axis)
            );
            let same = if quantity == Quantity::GN { Quantity::D } else { quantity };
            if let Some(of) = dense.iter().find(|of| of.quantity == same && axis.is_none()) {
                let (gradient, hessian) = (list(&of.gradient), list(&of.hessian));
                let _ = write!(line, ",\"gradient\":{gradient},\"hessian\":{hessian}");
            }
            line.push('}');
        }
        if let (Some(stiffness), Some(d)) = (penalty, dense.first()) {
            // r = ε g ∇g   K = ε (∇g ∇gᵀ + g H)
            let gap = (d.value - evaluation.contact.radius - evaluation.contact.radius_bar).min(0.0);
            let is_open = gap == 0.0;
            let residual: Vec<_> = d.gradient.iter().map(|g| stiffness * gap * g).collect();
            let products = d.gradient.iter().flat_map(|g| d.gradient.iter().map(move |h| g * h));
            let entry = |(product, hessian): (f64, &f64)| {
                if is_open { 0.0 } else { stiffness * (product + gap * hessian) }
            };
            let tangent: Vec<_> = products.zip(&d.hessian).map(entry).collect();
            let _ = write!(line, ",\"residual\":{},\"tangent\":{}", list(&residual), list(&tangent));
        }
        line
    }

    /// The contact element of the case, if it has one.
    fn element(&self, vector: &Vector, evaluation: &EvaluationPoint) -> String {
        let Ok(Some(element)) = vector.element_at(evaluation) else { return String::new() };
        let found = element.with(|decision| (decision.state, evaluation.element(decision)));
        let Some((state, (residual, tangent, values))) = found else { return String::new() };
        let list = |numbers: Vec<f64>| {
            let rounded: Vec<_> = numbers.into_iter().map(|x| self.rounded(x)).collect();
            self.writer.list(&rounded)
        };
        let forces = [values.f_n, values.f, values.f_bar].into_iter().zip(&STATE_AND_FORCES[1..]);
        let forces =
            forces.map(|(force, name)| format!(",\"{name}\":{}", self.writer.number(self.rounded(force))));
        format!(
            ",\"state\":\"{}\"{},\"residual\":{},\"tangent\":{}",
            state.name(),
            forces.collect::<String>(),
            list(residual),
            list(tangent)
        )
    }

    /// The number rounded to the digits that are written.
    fn rounded(&self, number: f64) -> f64 {
        let Some(digits) = self.digits.and_then(|digits| digits.checked_sub(1)) else { return number };
        format!("{number:.digits$e}").parse().unwrap_or(number)
    }
}
