//! The place where a gradient or a Hessian is wrong: the entry that differs most.

use super::answers::Answers;
use super::compare::Judged;
use super::conventions::{Conventions, Length, Range};
use super::shape::Shape;
use super::vectors::Vector;
use super::which_entries::{Dof, Entries, permuted};
use crate::check::evaluation_point::Dense;
use crate::check::serialized::short;
use crate::linearization::Quantity;
use crate::linearization::closed_form::Formulation;
use crate::test_beam::Family;
use crate::variant::Variant;
use serde::Serialize;

/// An entry of a gradient or a Hessian.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Location {
    /// Gradient, Hessian, residual or tangent.
    #[serde(rename = "of")]
    pub what: &'static str,
    /// The row, and the column of a matrix, from 0, in the order of the program.
    pub indices: Vec<usize>,
    /// The beams that these dofs belong to: `beam`, `bar`.
    pub block: Vec<&'static str>,
    /// The number of the program.
    pub answered: f64,
    /// The expected number.
    pub expected: f64,
    /// The difference over the largest expected entry.
    #[serde(serialize_with = "short::serialize")]
    pub scaled_error: f64,
    /// The number of entries that differ by more than a thousandth of this one's difference, or in the first five digits.
    pub differing: usize,
    /// Which entries differ, and what they are, if these have something in common.
    pub which: Option<String>,
    /// What is in another order, if the matrix has the expected rows and columns in another order.
    #[serde(skip)]
    pub order: Option<String>,
    /// Whether the matrix of differences is antisymmetric.
    pub is_antisymmetric: bool,
    /// The shape of the matrix, if it is not an ordinary symmetric one.
    pub shape: Option<Shape>,
}

/// The entry of the answers that differs most, if the wrong number is a contraction.
pub fn locate(
    vector: &Vector,
    answers: &Answers,
    wrong: &Judged,
    conventions: &Conventions,
) -> Option<Location> {
    if !wrong.is_contracted {
        return None;
    }
    let comparison = &wrong.comparison;
    let is_energy = matches!(comparison.part, "residual" | "tangent");
    let of_answer = |answer: &&crate::check::Answer| {
        answer.quantity == comparison.quantity && answer.axis == comparison.axis
    };
    let answer = answers.answers.iter().find(of_answer);
    let is_second = matches!(comparison.part, "Delta-delta" | "tangent");
    let answered = match (is_energy, is_second) {
        (true, false) => answers.residual.as_deref(),
        (true, true) => answers.tangent.as_deref(),
        (false, false) => answer?.gradient.as_deref(),
        (false, true) => answer?.hessian.as_deref(),
    }?;
    let expected = vector
        .evaluated(|evaluation| {
            if let Some(element) = vector.element_at(&evaluation).ok()?.filter(|_| is_energy) {
                let (residual, tangent, _) = element.with(|decision| evaluation.element(decision))?;
                return Some(in_order(signed_by(conventions, residual, tangent), vector, conventions));
            }
            let paper = Formulation::paper(evaluation.held);
            let dense = evaluation.in_formulation(paper).dense(&Variant::Unmodified);
            expected(vector, dense, comparison.quantity, is_energy, conventions)
        })
        .ok()??;
    let expected = if is_second { expected.1 } else { expected.0 };
    let families = vector.families();
    let beam = families[0].units().len();
    let vectors = families.map(Family::vectors);
    let component = |place: usize| {
        let [bar, place] = if place < beam { [0, place] } else { [1, place - beam] };
        let vector = vectors[bar].iter().rposition(|start| (*start..start + 3).contains(&place))?;
        Some([vector, place - vectors[bar][vector]])
    };
    let directions = vector.directions();
    // A dof that the element does not have has no direction.
    let dofs: Vec<Dof> = conventions
        .dofs(vector.families())
        .into_iter()
        .map(|(place, _)| Dof {
            is_bar: place >= beam,
            vector: component(place),
            is_there: directions.iter().any(|direction| direction[place] != 0.0),
        })
        .collect();
    entry(answered, &expected, &dofs, conventions, (is_energy, is_second))
}

/// Gradient and Hessian in the conventions of a program; a Hessian row by row.
fn expected(
    vector: &Vector,
    dense: Vec<Dense>,
    quantity: Quantity,
    is_energy: bool,
    conventions: &Conventions,
) -> Option<(Vec<f64>, Vec<f64>)> {
    let same = if quantity == Quantity::GN { Quantity::D } else { quantity };
    let Dense { value, gradient, hessian, .. } = dense.into_iter().find(|dense| dense.quantity == same)?;
    let products = || gradient.iter().flat_map(|g| gradient.iter().map(move |h| g * h));
    // The Hessian of f (v - c)²/2 is f ((v - c) H + ∇v ∇vᵀ).
    let square = |f: f64, value: f64| {
        let of_gradient: Vec<_> = gradient.iter().map(|g| f * value * g).collect();
        let of_hessian: Vec<_> =
            products().zip(&hessian).map(|(product, h)| f * (product + value * h)).collect();
        (of_gradient, of_hessian)
    };
    let times = |f: f64| {
        let of = |numbers: &[f64]| numbers.iter().map(|number| f * number).collect::<Vec<_>>();
        (of(&gradient), of(&hessian))
    };
    let is_unit = conventions.parameter == Range::Unit;
    let (gradient, hessian) = match quantity {
        Quantity::GN if is_energy => {
            let penalty = conventions.penalty?;
            let gap = value - vector.case.contact.radius - vector.case.contact.radius_bar;
            let stiffness = if gap < 0.0 || penalty.always { penalty.stiffness } else { 0.0 };
            let (residual, tangent) = square(stiffness, gap);
            signed_by(conventions, residual, tangent)
        }
        Quantity::D if conventions.length == Length::Square => square(2.0, value),
        Quantity::D if conventions.length == Length::HalfSquared => square(1.0, value),
        Quantity::Xi | Quantity::XiBar if is_unit => times(0.5),
        Quantity::T | Quantity::TBar if is_unit => times(2.0),
        _ => times(1.0),
    };
    Some(in_order((gradient, hessian), vector, conventions))
}

/// A residual and a tangent with the signs of a program.
fn signed_by(conventions: &Conventions, residual: Vec<f64>, tangent: Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let signed = |numbers: Vec<f64>, is_negative: bool| {
        let sign = if is_negative { -1.0 } else { 1.0 };
        numbers.into_iter().map(|number| sign * number).collect()
    };
    (signed(residual, conventions.residual_is_negative), signed(tangent, conventions.tangent_is_negative))
}

/// A gradient and a Hessian over the dofs of a program.
fn in_order(
    (gradient, hessian): (Vec<f64>, Vec<f64>),
    vector: &Vector,
    conventions: &Conventions,
) -> (Vec<f64>, Vec<f64>) {
    let dofs = conventions.dofs(vector.families());
    let size = dofs.len();
    let own = dofs.iter().map(|&(place, factor)| gradient[place] * factor).collect();
    let rows = dofs.iter().flat_map(|&(i, f)| {
        let hessian = &hessian;
        dofs.iter().map(move |&(j, g)| hessian[i * size + j] * f * g)
    });
    (own, rows.collect())
}

fn entry(
    answered: &[f64],
    expected: &[f64],
    dofs: &[Dof],
    conventions: &Conventions,
    (is_energy, is_second): (bool, bool),
) -> Option<Location> {
    let size = dofs.len();
    if answered.len() != expected.len() {
        return None;
    }
    let at = |k: usize| if conventions.column_major && is_second { (k % size) * size + k / size } else { k };
    let difference = |k: usize| {
        if !(dofs[k % size].is_there && dofs[if is_second { k / size } else { k }].is_there) {
            return 0.0;
        }
        let difference = (answered[at(k)] - expected[k]).abs();
        if difference.is_nan() { f64::INFINITY } else { difference }
    };
    let worst = (0..expected.len()).max_by(|&i, &j| difference(i).total_cmp(&difference(j)))?;
    let largest = expected.iter().fold(0.0_f64, |largest, number| largest.max(number.abs()));
    let limit = 1e-3 * difference(worst);
    let signed = |k: usize| answered[at(k)] - expected[k];
    let antisymmetric = |k: usize| {
        let mirror = (k % size) * size + k / size;
        (signed(k) + signed(mirror)).abs() <= 1e-6 * difference(worst)
    };
    let indices = if is_second { vec![worst / size, worst % size] } else { vec![worst] };
    let block = indices.iter().map(|&i| if dofs[i].is_bar { "bar" } else { "beam" });
    let rows: Vec<f64> = (0..answered.len()).map(|k| answered[at(k)]).collect();
    let differs = |k: usize| difference(k) > limit.min((1e-5 * expected[k].abs()).max(1e-9 * largest));
    let is_wrong: Vec<bool> = (0..expected.len()).map(differs).collect();
    let shape = if is_second { Shape::of(&rows, expected, size) } else { None };
    let first = conventions.first_index;
    let entries = Entries { answered: &rows, expected, is_wrong: &is_wrong, dofs, first };
    let is_told = shape.is_some_and(|shape| shape != Shape::Unsymmetric);
    Some(Location {
        what: match (is_energy, is_second) {
            (false, false) => "gradient",
            (false, true) => "Hessian",
            (true, false) => "residual",
            (true, true) => "tangent",
        },
        block: block.collect(),
        answered: answered[at(worst)],
        expected: expected[worst],
        scaled_error: difference(worst) / largest,
        differing: is_wrong.iter().filter(|is_wrong| **is_wrong).count(),
        which: if is_told { None } else { entries.words() },
        order: if is_second { permuted(&entries).map(|(order, _)| order) } else { None },
        is_antisymmetric: is_second && (0..expected.len()).all(antisymmetric),
        shape,
        indices,
    })
}
