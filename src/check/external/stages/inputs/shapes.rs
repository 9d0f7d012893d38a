//! Wrong shape functions. By how much one is wrong is an unknown of each case and beam.

use super::iteration::error_by_beam;
use super::{BEAMS, Input, OF, ORDERS, Of, add};
use crate::check::external::stages::equations::Equation;
use crate::check::external::stages::point::Point;
use crate::check::external::stages::sample::Sample;
use crate::check::external::stages::terms::{Beam, Earlier, Reading};
use crate::number::RunningError;
use crate::parallel;
use nalgebra::{DMatrix, DVector};

/// The number of cases that are tried.
const TRIED: usize = 16;
/// A derivative of a polynomial.
pub(super) fn polynomial(coefficients: &[f64; 4], order: usize, xi: f64) -> f64 {
    derivative(coefficients, order).iter().rev().fold(0.0, |sum, c| sum * xi + c)
}

/// The coefficients of a derivative of a polynomial.
pub(super) fn derivative(coefficients: &[f64; 4], order: usize) -> [f64; 4] {
    (0..order).fold(*coefficients, |[_, a, b, c], _| [a, 2.0 * b, 3.0 * c, 0.0])
}

/// A shape function whose derivative of this order is wrong.
#[derive(Clone, Copy)]
struct Shape {
    node: usize,
    order: usize,
    of: Of,
    beams: &'static [Beam],
}

impl Shape {
    fn point<'a>(&self, sample: &'a Sample, by: [f64; 2]) -> Point<'a> {
        let mut vectors = (sample.geometry, sample.moved);
        for &beam in self.beams {
            if let Some(node) = sample.nodes[beam].get(self.node) {
                add(&mut vectors, (beam, self.order), by[beam], node.vectors, self.of);
            }
        }
        Point::with(sample, &vectors.0, &vectors.1)
    }

    /// The residuals of the equations in their first form.
    fn residuals(&self, equations: &[&Equation], samples: &[&Sample], by: [f64; 2]) -> Vec<RunningError> {
        let points: Vec<Point> = samples.iter().map(|sample| self.point(sample, by)).collect();
        let of_equation = |equation: &&Equation| {
            let reading = Reading { results: &equation.results, earlier: Earlier::Own };
            let points = points.iter().filter(|point| equation.at.holds(point.sample.held));
            let values = points.flat_map(|point| {
                equation.forms[0].iter().filter_map(|zero| point.value(&zero.terms, &reading))
            });
            values.collect::<Vec<_>>()
        };
        equations.iter().flat_map(of_equation).collect()
    }

    /// By how much the derivative is wrong at a case, for each beam, if that explains these equations.
    fn solved(&self, equations: &[&Equation], samples: &[&Sample]) -> Option<[Option<f64>; 2]> {
        let residuals = |by| self.residuals(equations, samples, by);
        error_by_beam(self.beams, &residuals, &|by| residuals(by).iter().map(|of| of.value).collect())
    }

    /// By how much it is wrong at each parameter, if that explains at least half of these cases.
    fn errors(
        &self,
        equations: &[&Equation],
        samples: &[Sample],
        cases: &[usize],
    ) -> Option<Vec<(f64, f64)>> {
        let (mut tried, mut solved, mut errors) = (0, 0, Vec::new());
        for case in cases.iter().step_by((cases.len() / TRIED).max(1)).take(TRIED) {
            let here: Vec<&Sample> = samples.iter().filter(|sample| sample.case == *case).collect();
            if here[0].held != [false; 2] {
                continue;
            }
            tried += 1;
            if let Some(by) = self.solved(equations, &here) {
                solved += 1;
                errors
                    .extend(self.beams.iter().filter_map(|&beam| Some((here[0].xi[beam].value, by[beam]?))));
            } else if tried >= 3 && solved == 0 {
                return None;
            }
        }
        (solved >= 3 && 2 * solved >= tried && !errors.is_empty()).then_some(errors)
    }

    /// What is wrong, in words: a polynomial, if the error is one.
    fn words(&self, samples: &[Sample], errors: &[(f64, f64)]) -> Option<String> {
        let node = |sample: &Sample| sample.nodes[self.beams[0]].get(self.node)?.coefficients;
        let coefficients = samples.iter().find_map(node);
        let told = coefficients
            .zip(fitted(errors))
            .map(|(coefficients, fit)| error_words(&derivative(&coefficients, self.order), &fit));
        // Second and third derivatives are in few products, so that another vector may have the same.
        told.or_else(|| (self.order < 2).then(|| "it is wrong".to_owned()))
    }
}

/// The coefficients of errors at these parameters, if they are a polynomial.
pub(super) fn fitted(errors: &[(f64, f64)]) -> Option<[f64; 4]> {
    let count = (errors.len() / 2).clamp(1, 4);
    let powers =
        DMatrix::from_fn(errors.len(), count, |i, j| (0..j).fold(1.0, |power, _| power * errors[i].0));
    let values = DVector::from_fn(errors.len(), |i, _| errors[i].1);
    if errors.is_empty() || !values.iter().chain(&powers).all(|number| number.is_finite()) {
        return None;
    }
    let fit = powers.clone().svd(true, true).solve(&values, 1e-12).ok()?;
    let is_polynomial = (&powers * &fit - &values).amax() <= 1e-6 * values.amax();
    is_polynomial.then(|| std::array::from_fn(|i| fit.get(i).copied().unwrap_or(0.0)))
}

/// What is wrong with a polynomial by an error: a factor of the whole, or of a term.
pub(super) fn error_words(right: &[f64; 4], error: &[f64; 4]) -> String {
    // Answers with few digits leave a little of each term.
    let least = error.iter().fold(1e-7_f64, |least, of| least.max(1e-5 * of.abs()));
    let whole = (0..4).find(|i| right[*i] != 0.0).map(|i| error[i] / right[i]);
    if let Some(by) = whole.filter(|by| (0..4).all(|i| (error[i] - by * right[i]).abs() < least)) {
        return format!("it {}", factor_words(by));
    }
    let wrong: Vec<usize> = (0..4).filter(|i| error[*i].abs() > least).collect();
    match wrong[..] {
        [i] if right[i] != 0.0 => format!("its {} {}", TERMS[i], factor_words(error[i] / right[i])),
        _ => {
            let term = |i: &usize| format!("{:+.4} in its {}", error[*i], TERMS[*i]);
            format!("it is wrong by {}", wrong.iter().map(term).collect::<Vec<_>>().join(" and "))
        }
    }
}

/// The factors of wrong terms.
pub(super) const WRONG_FACTORS: [f64; 8] = [-1.0, 0.0, 2.0, 0.5, 3.0, 1.0 / 3.0, 1.5, 2.0 / 3.0];

/// Terms of shape functions that are wrong in all derivatives.
pub(super) fn inputs(samples: &[Sample]) -> Vec<Input> {
    let mut all = Vec::new();
    for (beams, of_beams) in BEAMS {
        let nodes = samples.iter().map(|sample| &sample.nodes[beams[0]]).max_by_key(|nodes| nodes.len());
        for (k, node) in nodes.into_iter().flatten().enumerate() {
            for (power, coefficient) in node.coefficients.iter().flatten().enumerate() {
                for by in WRONG_FACTORS.map(|factor| factor - 1.0).into_iter().filter(|_| *coefficient != 0.0)
                {
                    let mut wrong = [0.0; 4];
                    wrong[power] = by * coefficient;
                    let words = format!(
                        "shape function {} of {of_beams}, with its derivatives: its {} {}",
                        k + 1,
                        TERMS[power],
                        factor_words(by)
                    );
                    all.push(Input::new(words, move |sample, vectors| {
                        for &beam in beams {
                            let Some(node) = sample.nodes[beam].get(k) else { continue };
                            for order in 0..4 {
                                let error = polynomial(&wrong, order, sample.xi[beam].value);
                                add(vectors, (beam, order), error, node.vectors, Of::Both);
                            }
                        }
                    }));
                }
            }
        }
    }
    all
}

/// The terms of a cubic.
pub(super) const TERMS: [&str; 4] = ["constant", "term of xi", "term of xi^2", "term of xi^3"];

/// A factor less one, in words.
pub(super) fn factor_words(by: f64) -> String {
    let known = super::FACTORS.into_iter().find(|(known, _)| (by - known).abs() < 1e-6);
    known.map_or_else(|| format!("is multiplied by {:.4}", 1.0 + by), |(_, words)| words.to_owned())
}

/// The shape functions whose errors leave only rounding in these equations, in words.
pub(super) fn found(
    equations: &[Equation],
    samples: &[Sample],
    wrong: &[usize],
    cases: &[usize],
) -> Vec<String> {
    // Of equations with several forms the implicit ones are valid in any program.
    let is_used =
        |equation: &&Equation| equation.forms.len() == 1 || matches!(equation.number, "(50)" | "(55)");
    let which: Vec<&Equation> = wrong.iter().map(|e| &equations[*e]).filter(is_used).collect();
    let count = |beam: Beam| samples.iter().map(|sample| sample.nodes[beam].len()).max().unwrap_or(0);
    for (of, scope) in OF {
        let shapes = BEAMS.into_iter().filter(|_| !which.is_empty()).flat_map(|(beams, of_beams)| {
            let each = (0..count(beams[0])).flat_map(|node| (0..4).map(move |order| (node, order)));
            each.map(move |(node, order)| (Shape { node, order, of, beams }, of_beams))
        });
        let words = |(shape, of_beams): &(Shape, &str)| {
            let errors = shape.errors(&which, samples, cases)?;
            let (order, number, words) =
                (ORDERS[shape.order], shape.node + 1, shape.words(samples, &errors)?);
            Some(format!("{order}shape function {number} of {of_beams}{scope}: {words}"))
        };
        let found = parallel::filter_map(&shapes.collect::<Vec<_>>(), words);
        if !found.is_empty() {
            return found;
        }
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::{Equation, Of, Sample, Shape};
    use crate::check::external::stages::equations::equations;
    use crate::check::external::stages::sample::{Along, samples};
    use crate::check::external::stages::tests::right_answers;
    use nalgebra::Vector3;

    /// By how much a shape function is wrong is not known where its control vector is zero.
    #[test]
    fn a_shape_function_without_effect_has_no_error() {
        let (cases, demands) = right_answers(None);
        let of =
            |(i, (vector, answers)): (usize, &(_, _))| samples(i, vector, answers, &demands, Along::Random);
        let all: Vec<Vec<Sample>> = cases.iter().enumerate().map(of).collect();
        let is_tried = |of: &&Vec<Sample>| {
            of.first()
                .is_some_and(|sample| sample.held == [false; 2] && sample.nodes.iter().all(|of| of.len() > 1))
        };
        let mut here = all.iter().find(is_tried).unwrap().clone();
        for sample in &mut here {
            sample.nodes[0][1].vectors = [Vector3::zeros(); 3];
        }
        let equations = equations(true);
        let first: Vec<&Equation> = equations.iter().filter(|equation| equation.number == "(50)").collect();
        let shape = Shape { node: 1, order: 2, of: Of::Both, beams: &[0, 1] };
        let [beam, bar] = shape.solved(&first, &here.iter().collect::<Vec<_>>()).unwrap();
        assert!(beam.is_none() && bar.is_some_and(|by| by.abs() < 1e-6), "{beam:?} {bar:?}");
        // If it has no effect in any case, it explains nothing.
        let in_case = |case: usize| here.iter().cloned().map(move |sample| Sample { case, ..sample });
        let cases: Vec<Sample> = (0..3).flat_map(in_case).collect();
        let of_beam = Shape { beams: &[0], ..shape };
        assert_eq!(of_beam.errors(&first, &cases, &[0, 1, 2]), None);
    }
}
