//! The references for the answers at a closest point, and the comparison of each number.

use super::{Answer, CAREFUL, Entry, ProblemSize};
use crate::check::compare::ROUTES;
use crate::check::element::ContactSituations;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::oracle::differences;
use crate::check::verdict::{Comparison, Order};
use crate::curve::Geometry;
use crate::linearization::closed_form::{Formulation, PartialVariations};
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::{RunningError, TermScale};
use crate::test_beam::{RunningError2, TestBeam};
use crate::variant::{Step, Variant};
use nalgebra::Vector3;

/// The references for answers. The items are the components of the quantities, and numbers computed from them.
#[derive(Clone, Debug)]
pub(in crate::check) struct Sides {
    /// Automatic differentiation.
    pub(in crate::check) reference: Vec<Varied<RunningError2>>,
    /// The paper's formulas.
    pub(in crate::check) textbook: Vec<Varied<RunningError2>>,
    /// The formulas that lose the fewest digits.
    pub(in crate::check) best: Vec<Varied<RunningError2>>,
    /// The size of the terms of the paper's formulas.
    pub(in crate::check) scales: Vec<Varied<TermScale>>,
    /// The size of the terms of the formulas that lose the fewest digits.
    pub(in crate::check) best_scales: Vec<Varied<TermScale>>,
    /// The size of the problem, for numbers that are exactly zero.
    pub(in crate::check) problem: ProblemSize,
    /// The paper's formulas, and those that lose the fewest digits.
    pub(in crate::check) forms: [Formulation; 2],
}

impl Sides {
    /// The references at a closest point, and the point in the paper's formulation.
    pub(in crate::check) fn new<'a>(
        evaluation: EvaluationPoint<'a>,
        test_beams: &[TestBeam; 2],
    ) -> (Self, EvaluationPoint<'a>) {
        let EvaluationPoint { at, form, contact, .. } = evaluation;
        let best = Variant::Unmodified.formulas(&evaluation.bounded(Step::Now), at, form, contact);
        let best_scales = evaluation.sized(&Variant::Unmodified).to_vec();
        let reference = evaluation.chord().to_vec();
        let paper = Formulation::paper(evaluation.held);
        let paper = evaluation.in_formulation(paper);
        let sides = Self {
            reference,
            textbook: textbook(&paper, test_beams).to_vec(),
            best: best.components().to_vec(),
            scales: paper.sized(&Variant::Unmodified).to_vec(),
            best_scales,
            problem: ProblemSize::new(test_beams),
            forms: [paper.form, form],
        };
        (sides, paper)
    }

    /// The comparisons of one answer; `directions` are those of its dofs.
    pub(in crate::check) fn entries(
        &self,
        answer: &Answer,
        directions: [&[f64]; 2],
    ) -> Result<Vec<Entry>, String> {
        let quantity = answer.quantity;
        let is_meant = |&i: &usize| {
            (Quantity::of_component(i), Quantity::axis_of_component(i)) == (quantity, answer.axis)
        };
        let Some(item) = (0..COMPONENTS).find(is_meant) else {
            let found = answer.axis.map_or_else(|| "none".into(), |axis| format!("{axis:?}"));
            return Err(format!(
                "{}: a component x, y or z expected for a vector and none for a scalar, found {found}",
                quantity.name()
            ));
        };
        let [value, delta, linear, second] = Varied::<f64>::PARTS;
        let direct = [answer.value, answer.variations[0], answer.variations[1], answer.variations[2]];
        let mut entries = self.of_arrays(
            (item, quantity),
            [delta, linear, second],
            [answer.gradient.as_deref(), answer.hessian.as_deref()],
            directions,
        )?;
        for (k, (number, part)) in direct.into_iter().zip([value, delta, linear, second]).enumerate() {
            entries.extend(number.map(|number| self.of_number(([item, k], quantity, part), number)));
        }
        Ok(entries)
    }

    /// The comparison of the value of an item.
    pub(in crate::check) fn of_value(
        &self,
        (item, quantity): (usize, Quantity),
        part: &'static str,
        number: f64,
    ) -> Entry {
        self.of_number(([item, 0], quantity, part), number)
    }

    fn of_number(&self, of: ([usize; 2], Quantity, &'static str), number: f64) -> Entry {
        self.entry(of, exact(number), [number.abs(), number.abs(), 1.0])
    }

    /// The comparisons of a gradient and a Hessian of an item, contracted with the directions.
    pub(in crate::check) fn of_arrays(
        &self,
        (item, quantity): (usize, Quantity),
        [delta, linear, second]: [&'static str; 3],
        [gradient, hessian]: [Option<&[f64]>; 2],
        [dq, linear_dq]: [&[f64]; 2],
    ) -> Result<Vec<Entry>, String> {
        let dofs = dq.len();
        for (what, numbers, expected) in [("gradient", gradient, dofs), ("Hessian", hessian, dofs * dofs)] {
            let found = numbers.map_or(expected, <[f64]>::len);
            if found != expected {
                let name = quantity.name();
                let is_triangle = what == "Hessian" && found == dofs * (dofs + 1) / 2;
                let hint = if is_triangle {
                    ": a triangle alone; state it by the entry \"triangle\" of the head"
                } else {
                    ""
                };
                let of = match ([delta, second], what) {
                    (["residual", _], "gradient") => "residual".to_owned(),
                    ([_, "tangent"], "Hessian") => "tangent".to_owned(),
                    _ => format!("{what} of {name}"),
                };
                return Err(format!("{of}: {expected} numbers expected, found {found}{hint}"));
            }
        }
        let mut entries = Vec::new();
        let sum = |of: &[f64]| of.iter().map(|entry| entry.abs()).sum::<f64>();
        let (delta_sum, linear_sum) = (sum(dq), sum(linear_dq));
        let sensitivities = [0.0, delta_sum, linear_sum, delta_sum * linear_sum];
        let mut add = |k: usize, part, (number, [size, squares]): (RunningError, [f64; 2])| {
            let sizes = [size, squares.sqrt(), sensitivities[k]];
            let entry = self.entry(([item, k], quantity, part), number, sizes);
            entries.push(Entry { is_contracted: true, ..entry });
        };
        if let Some(gradient) = gradient {
            add(1, delta, dot(gradient, dq));
            add(2, linear, dot(gradient, linear_dq));
        }
        if let Some(hessian) = hessian {
            add(3, second, bilinear(dq, hessian, linear_dq));
        }
        Ok(entries)
    }

    fn entry(
        &self,
        ([item, k], quantity, part): ([usize; 2], Quantity, &'static str),
        number: RunningError,
        [size, spread, sensitivity]: [f64; 3],
    ) -> Entry {
        let of = |side: &[Varied<RunningError2>]| side[item].parts()[k];
        let (other, textbook, best) = (of(&self.reference), of(&self.textbook), of(&self.best));
        // The second bound is for methods that solve for the closest point again.
        let [near, far] = textbook.bound;
        let [best_near, best_far] = best.bound;
        let [mut scale, mut best_scale] =
            [&self.scales, &self.best_scales].map(|scales| scales[item].parts()[k].scale);
        // Where the exact number is zero, only the rounding of the problem's size is.
        let mut of_zero = 0.0;
        if scale == 0.0 && other.value == 0.0 && other.bound[0] == 0.0 {
            scale = self.problem.of([item, k]);
            best_scale = scale;
            of_zero = CAREFUL * f64::EPSILON * scale;
        }
        let bound = CAREFUL * near + far + of_zero + number.bound;
        let attainable = CAREFUL * best_near + best_far + of_zero + number.bound;
        let loss = (number.value - best.value).abs();
        let comparison = Comparison {
            quantity,
            axis: (item < COMPONENTS).then(|| Quantity::axis_of_component(item)).flatten(),
            order: [Order::Value, Order::First, Order::First, Order::Second][k],
            part,
            against: ROUTES[2],
            closed: number.value,
            other: other.value,
            scale,
            bound,
            tolerance: bound + other.bound[0],
            situations: ContactSituations::NONE,
        };
        Entry {
            comparison,
            place: [item, k],
            is_contracted: false,
            loss,
            attainable,
            best_scale,
            size,
            spread,
            sensitivity,
            own_bound: number.bound,
            reference_bound: other.bound[0],
        }
    }
}

/// A scalar product with a bound on its rounding, and the sums of the absolute values and of the squares of its terms.
fn dot(u: &[f64], v: &[f64]) -> (RunningError, [f64; 2]) {
    u.iter().zip(v).fold((exact(0.0), [0.0; 2]), |(sum, [size, squares]), (&u, &v)| {
        let product = exact(u) * exact(v);
        (sum + product, [size + product.value.abs(), squares + product.value * product.value])
    })
}

/// dqᵀ H Dq, with the same bound and sums.
fn bilinear(dq: &[f64], hessian: &[f64], linear_dq: &[f64]) -> (RunningError, [f64; 2]) {
    let rows = hessian.chunks_exact(dq.len().max(1)).zip(dq);
    rows.fold((exact(0.0), [0.0; 2]), |(sum, [all, all_squares]), (row, &dq)| {
        let (along, [size, squares]) = dot(row, linear_dq);
        (sum + exact(dq) * along, [all + dq.abs() * size, all_squares + dq * dq * squares])
    })
}

fn exact(value: f64) -> RunningError {
    RunningError { value, bound: 0.0 }
}

/// The paper's formulas, with bounds on their rounding where shape functions are written as sums of powers.
fn textbook(evaluation: &EvaluationPoint, test_beams: &[TestBeam; 2]) -> [Varied<RunningError2>; COMPONENTS] {
    // Half an ulp of the sum of the absolute values, by coordinate.
    let rounding = |of: &[f64]| {
        let size = |c: usize| of.iter().skip(c).step_by(3).map(|dof| dof.abs()).sum::<f64>();
        Vector3::from_fn(|c, _| f64::EPSILON / 2.0 * size(c))
    };
    let sums = evaluation.have_shapes();
    let of_dofs = |read: fn(&TestBeam) -> &[f64]| {
        [0, 1].map(|i| if sums[i] { rounding(read(&test_beams[i])) } else { Vector3::zeros() })
    };
    let positions = of_dofs(|beam| &beam.q);
    let [delta, linear] = [of_dofs(|beam| &beam.dq), of_dofs(|beam| &beam.linear_dq)];
    // A program that solves for the closest point with such positions finds other parameters.
    let at = evaluation.parameters_with(positions.map(|rounding| CAREFUL * rounding));
    let mut beams = evaluation.bounded_at(at);
    for (i, partial) in beams.iter_mut().enumerate() {
        let PartialVariations { geometry: Geometry { x, t, t_xi, t_xixi }, delta_u, linear_u, .. } = partial;
        let rounded = |vectors: &mut dyn Iterator<Item = &mut Vector3<RunningError2>>, by: &Vector3<f64>| {
            for vector in vectors {
                for (number, by) in vector.iter_mut().zip(by) {
                    number.bound = number.bound.map(|bound| bound + by);
                }
            }
        };
        rounded(&mut [x, t, t_xi, t_xixi].into_iter(), &positions[i]);
        rounded(&mut delta_u.iter_mut(), &delta[i]);
        rounded(&mut linear_u.iter_mut(), &linear[i]);
    }
    Variant::Unmodified.formulas(&beams, at, evaluation.form, evaluation.contact).components()
}

/// Whether the differences in double-double disagree with the reference.
pub(in crate::check) fn is_doubted(
    evaluation: &EvaluationPoint,
    reference: &[Varied<RunningError2>],
) -> bool {
    let Some(differences) = differences(evaluation) else { return false };
    let pairs = differences
        .into_iter()
        .flat_map(Varied::parts)
        .zip(reference.iter().flat_map(|varied| varied.parts()));
    pairs.into_iter().any(|(told, own)| {
        let difference = (told.value.value() - own.value).abs();
        difference > told.error + own.bound[0] + f64::EPSILON * own.value.abs()
    })
}
