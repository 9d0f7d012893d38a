//! The references in the conventions of a program, and the comparison of each number of its answers.

use crate::check::Answer;
use crate::check::candidate::{Entry, ProblemSize, Sides};
use crate::check::element::ElementAt;
use crate::check::external::answers::Answers;
use crate::check::external::conventions::{Conventions, ENERGY, STATE_AND_FORCES};
use crate::check::external::vectors::Vector;
use crate::linearization::Quantity;

/// The references at a case in the conventions of a program, and its directions.
pub(in crate::check::external) struct Converted {
    pub(in crate::check::external) sides: Sides,
    pub(in crate::check::external) directions: [Vec<f64>; 2],
    /// The contact element of the case.
    pub(in crate::check::external) element: Option<ElementAt>,
    /// The references of a contact element in the other state, if rounding leaves the state open: at a gap of zero, and at
    /// the cone.
    in_other_state: Option<Box<Sides>>,
}

impl Converted {
    /// The references, and the contact element at the closest point if the case has one.
    pub(in crate::check::external) fn new(
        vector: &Vector,
        sides: &Sides,
        element: Option<ElementAt>,
        conventions: &Conventions,
    ) -> Self {
        // g_N, the 21st component.
        let is_closed = sides.reference[20].value.value < 0.0;
        let families = vector.families();
        let gap = &sides.textbook[20].value;
        let is_zero = conventions.penalty.is_some() && gap.value.abs() <= 2.0 * gap.bound[1];
        let stiffness = match &element {
            Some(element) => element.stiffness(),
            None => conventions.penalty.map_or(1.0, |penalty| penalty.stiffness),
        };
        let of = |is_closed: bool, element: Option<&ElementAt>| {
            let [paper, best] = sides.forms;
            Sides {
                reference: conventions.of(&sides.reference, is_closed, element, best),
                textbook: conventions.of(&sides.textbook, is_closed, element, paper),
                best: conventions.of(&sides.best, is_closed, element, best),
                best_scales: conventions.of(&sides.best_scales, is_closed, element, best),
                scales: conventions.of(&sides.scales, is_closed, element, paper),
                problem: ProblemSize { stiffness, ..sides.problem },
                forms: sides.forms,
            }
        };
        let other = match &element {
            Some(element) => element.other_state(&sides.best).map(|other| of(is_closed, Some(&other))),
            None => is_zero.then(|| of(!is_closed, None)),
        };
        Self {
            sides: of(is_closed, element.as_ref()),
            directions: vector.directions().map(|dq| conventions.direction(families, &dq)),
            element,
            in_other_state: other.map(Box::new),
        }
    }

    /// All numbers of the answers, compared.
    pub(in crate::check::external) fn entries(
        &self,
        answers: &Answers,
        conventions: &Conventions,
    ) -> Result<Vec<Entry>, String> {
        let directions = self.directions.each_ref().map(Vec::as_slice);
        let mut entries = Vec::new();
        for answer in &answers.answers {
            match &answer.hessian {
                Some(hessian) if conventions.column_major => {
                    let hessian = Some(transposed(hessian, directions[0].len()));
                    entries.extend(self.sides.entries(&Answer { hessian, ..answer.clone() }, directions)?);
                }
                _ => entries.extend(self.sides.entries(answer, directions)?),
            }
        }
        if answers.has_element() {
            if conventions.penalty.is_none() && self.element.is_none() {
                return Err(
                    "residual, tangent: penalty_stiffness expected in the head of the answers, or a contact \
                            element in the case"
                        .into(),
                );
            }
            let tangent = answers.tangent.as_ref().map(|tangent| {
                let size = directions[0].len();
                if conventions.column_major { transposed(tangent, size) } else { tangent.clone() }
            });
            let of = |sides: &Sides| {
                let arrays = [answers.residual.as_deref(), tangent.as_deref()];
                let parts = ["residual", "residual", "tangent"];
                let mut entries = sides.of_arrays((ENERGY, Quantity::GN), parts, arrays, directions)?;
                let numbers = answers.state_and_forces.into_iter().zip(STATE_AND_FORCES);
                for (k, (number, part)) in numbers.enumerate() {
                    let entry = |number| sides.of_value((ENERGY + 1 + k, Quantity::GN), part, number);
                    entries.extend(number.map(entry));
                }
                Ok::<_, String>(entries)
            };
            let mut of_element = of(&self.sides)?;
            // The element has two tangents there.
            if let Some(others) = &self.in_other_state {
                let nearer = |(one, other): (Entry, Entry)| {
                    let error = |entry: &Entry| entry.comparison.over_tolerance();
                    if error(&other) < error(&one) { other } else { one }
                };
                of_element = of_element.into_iter().zip(of(others)?).map(nearer).collect();
            }
            entries.extend(of_element);
        }
        Ok(entries)
    }
}

fn transposed(matrix: &[f64], size: usize) -> Vec<f64> {
    if matrix.len() != size * size {
        return matrix.to_vec();
    }
    (0..size * size).map(|i| matrix[(i % size) * size + i / size]).collect()
}
