//! A linearization of the user's own against automatic differentiation.
//!
//! # The tolerance
//! A number may differ from that of automatic differentiation by the bound on the rounding of the latter, by [`CAREFUL`]
//! times the bound on the rounding of the paper's formulas at the same point, and by what solving for the closest point in
//! `f64` again may change: what a careful evaluation of the textbook formulas loses there. Their shape functions may be
//! written as sums of powers: near an end of a beam those cancel, and a point is known to half an ulp of its largest
//! control vectors only. What the contraction with the directions rounds is added.

mod found;

use super::compare::ROUTES;
use super::diagnosis::place;
use super::draw::Case;
use super::evaluation_point::EvaluationPoint;
use super::oracle::differences;
use super::shrink::shrink;
use super::verdict::{Comparison, Order};
use super::{CaseData, Regime};
use crate::closest_point::{ClosestPoint, Held, Search, closest_points};
use crate::curve::Geometry;
use crate::linearization::closed_form::{Formulation, PartialVariations};
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::RunningError;
use crate::pair::Contact;
use crate::test_beam::{Family, RunningError2};
use crate::variant::{Step, Variant};
use nalgebra::Vector3;
use rayon::prelude::*;

pub use found::{Digits, Example, Found};

/// How many times the rounding of the textbook formulas a careful evaluation may lose, in another order of its sums.
pub const CAREFUL: f64 = 8.0;

/// A pair of beams at a closest point.
#[derive(Clone, Copy, Debug)]
pub struct Situation<'a> {
    /// The families of beam and bar beam.
    pub families: [Family; 2],
    /// The fixed parameters of their curves, as [`Family::parameters`] has them.
    pub parameters: [&'a [f64]; 2],
    /// The dofs of the beam.
    pub q: &'a [f64],
    /// The dofs of the bar beam.
    pub q_bar: &'a [f64],
    /// The closest point, with all that is known of it.
    pub point: ClosestPoint,
    /// Its parameters.
    pub at: (f64, f64),
    /// Which of them an end holds.
    pub held: Held,
    /// Radii and reference parameters.
    pub contact: Contact,
    /// The direction delta, over the dofs of both beams.
    pub dq: &'a [f64],
    /// The direction Delta.
    pub linear_dq: &'a [f64],
}

/// What a linearization says of a scalar, or of a component of a vector: all of it, or some. Dofs are those of the beam, then of the bar beam.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The quantity.
    pub quantity: Quantity,
    /// Of a vector the component, x, y or z.
    pub axis: Option<char>,
    /// Its value.
    pub value: Option<f64>,
    /// Its gradient.
    pub gradient: Option<Vec<f64>>,
    /// Its Hessian, row by row.
    pub hessian: Option<Vec<f64>>,
    /// Its variations along the directions of the situation: delta, Delta and Delta-delta.
    pub variations: [Option<f64>; 3],
}

impl Answer {
    /// Nothing yet of a scalar.
    pub fn of(quantity: Quantity) -> Self {
        Self { quantity, axis: None, value: None, gradient: None, hessian: None, variations: [None; 3] }
    }
}

/// A linearization under check.
pub trait Candidate: Sync {
    /// All that it answers at a closest point; nothing where it has no answer.
    fn answers(&self, at: &Situation<'_>) -> Vec<Answer>;
}

impl<F: Fn(&Situation<'_>) -> Vec<Answer> + Sync> Candidate for F {
    fn answers(&self, at: &Situation<'_>) -> Vec<Answer> {
        self(at)
    }
}

/// Compares a linearization with automatic differentiation: `cases` pairs of these families in every regime.
///
/// The result depends on the arguments alone.
///
/// ```
/// use beamgap::check::{self, Answer, Family};
/// use beamgap::linearization::Quantity;
///
/// // The gap of two straight beams: x = (q_a (1 - xi) + q_b (1 + xi))/2.
/// let mine = |at: &check::Situation<'_>| {
///     let point = |q: &[f64], xi: f64| [0, 1, 2].map(|c| 0.5 * (q[c] * (1.0 - xi) + q[3 + c] * (1.0 + xi)));
///     let (x, x_bar) = (point(at.q, at.at.0), point(at.q_bar, at.at.1));
///     let d = [0, 1, 2].map(|c| x[c] - x_bar[c]);
///     let gap = d.iter().map(|d| d * d).sum::<f64>().sqrt();
///     let along = |c: usize, n: f64| n * d[c] / gap;
///     let shapes = [0.5 * (1.0 - at.at.0), 0.5 * (1.0 + at.at.0), -0.5 * (1.0 - at.at.1), -0.5 * (1.0 + at.at.1)];
///     let gradient = shapes.iter().flat_map(|&n| [0, 1, 2].map(|c| along(c, n))).collect();
///     vec![Answer { value: Some(gap), gradient: Some(gradient), ..Answer::of(Quantity::D) }]
/// };
/// let found = check::linearization(&mine, [Family::Segment; 2], 4);
/// assert!(found.agrees(), "{found}");
/// ```
pub fn linearization(candidate: &impl Candidate, families: [Family; 2], cases: u64) -> Found {
    let regimes = Regime::ALL.len() as u64;
    let drawn = |number: u64| {
        let regime = Regime::ALL[usize::try_from(number % regimes).unwrap_or(0)];
        Case::of(0x5eed, number, regime, families)
    };
    let of_case = |number| Found::of(&drawn(number), &at_closest_points(candidate, &drawn(number).data()));
    let all: Vec<Found> = (0..cases * regimes).into_par_iter().map(of_case).collect();
    let mut found = all.into_iter().fold(Found::default(), Found::and);
    if let Some(example) = &mut found.example {
        example.case = shrunk(candidate, &drawn(example.number).data());
        example.entry = first_wrong(candidate, &example.case).unwrap_or(example.entry);
    }
    found
}

/// The first wrong number of a case, if there is one.
fn first_wrong(candidate: &impl Candidate, case: &CaseData) -> Option<Comparison> {
    let all = at_closest_points(candidate, case).into_iter().flat_map(|at| at.entries);
    all.filter(Comparison::is_wrong).min_by_key(place)
}

/// A smaller case of the same families with the same first wrong number.
fn shrunk(candidate: &impl Candidate, case: &CaseData) -> CaseData {
    let families = |case: &CaseData| case.test_beams.each_ref().map(|test_beam| test_beam.family);
    shrink(case, |smaller| {
        // The candidate may know these families alone.
        let is_known = families(smaller) == families(case);
        let entry = is_known.then(|| first_wrong(candidate, smaller)).flatten()?;
        Some((entry.order, entry.quantity))
    })
}

/// What was compared at a closest point.
struct AtPoint {
    /// All numbers; none if there was no answer.
    entries: Vec<Comparison>,
    /// What is wrong with the shape of an answer.
    misshapen: Option<String>,
    /// Whether the oracles disagree among themselves.
    doubted: bool,
}

fn at_closest_points(candidate: &impl Candidate, case: &CaseData) -> Vec<AtPoint> {
    let Ok(beams) = case.beams() else { return Vec::new() };
    let [beam, bar] = beams.each_ref().map(|beam| &**beam);
    let Ok(closest) = closest_points(beam, bar, &Search::default()) else { return Vec::new() };
    let [test_beam, test_beam_bar] = &case.test_beams;
    let [dq, linear_dq] = [
        [&test_beam.dq[..], &test_beam_bar.dq].concat(),
        [&test_beam.linear_dq[..], &test_beam_bar.linear_dq].concat(),
    ];
    let at_point = |point: &ClosestPoint| {
        let evaluation = EvaluationPoint::new([beam, bar], &case.contact, point).ok()?;
        let at = Situation {
            families: [test_beam.family, test_beam_bar.family],
            parameters: [&test_beam.parameters, &test_beam_bar.parameters],
            q: &test_beam.q,
            q_bar: &test_beam_bar.q,
            point: evaluation.point,
            at: (evaluation.at.0.value, evaluation.at.1.value),
            held: evaluation.held,
            contact: case.contact,
            dq: &dq,
            linear_dq: &linear_dq,
        };
        let answers = candidate.answers(&at);
        let reference = evaluation.chord();
        let paper = evaluation.in_formulation(Formulation::paper(point.held()));
        let sides =
            Sides { reference, textbook: textbook(&paper, case), scales: paper.scales(&Variant::Unmodified) };
        let (mut entries, mut misshapen) = (Vec::new(), None);
        for answer in &answers {
            match entries_of(answer, &at, &sides) {
                Ok(of_answer) => entries.extend(of_answer),
                Err(wrong) => misshapen = misshapen.or(Some(wrong)),
            }
        }
        // The reference itself is doubted where the differences in double-double say so.
        let doubted = entries.iter().any(Comparison::is_wrong) && is_doubted(&paper, &sides.reference);
        Some(AtPoint { entries, misshapen, doubted })
    };
    closest.minima.iter().filter_map(at_point).collect()
}

/// The paper's formulas, with bounds on their rounding where shape functions are written as sums of powers.
fn textbook(evaluation: &EvaluationPoint, case: &CaseData) -> [Varied<RunningError2>; COMPONENTS] {
    let mut beams = evaluation.bounded(Step::Now);
    for ((partial, test_beam), is_sum) in beams.iter_mut().zip(&case.test_beams).zip(evaluation.have_shapes())
    {
        if !is_sum {
            continue;
        }
        let PartialVariations { geometry: Geometry { x, t, t_xi, t_xixi }, delta_u, linear_u, .. } = partial;
        let rounded = |vectors: &mut dyn Iterator<Item = &mut Vector3<RunningError2>>, of: &[f64]| {
            for vector in vectors {
                for (c, number) in vector.iter_mut().enumerate() {
                    let size: f64 = of.iter().skip(c).step_by(3).map(|dof| dof.abs()).sum();
                    number.bound = number.bound.map(|bound| bound + f64::EPSILON / 2.0 * size);
                }
            }
        };
        rounded(&mut [x, t, t_xi, t_xixi].into_iter(), &test_beam.q);
        rounded(&mut delta_u.iter_mut(), &test_beam.dq);
        rounded(&mut linear_u.iter_mut(), &test_beam.linear_dq);
    }
    Variant::Unmodified.formulas(&beams, evaluation.at, evaluation.form, evaluation.contact).components()
}

/// What an answer is compared with.
struct Sides {
    reference: [Varied<RunningError2>; COMPONENTS],
    textbook: [Varied<RunningError2>; COMPONENTS],
    scales: [Varied<crate::number::TermScale>; COMPONENTS],
}

/// Whether the differences in double-double do not agree with the reference.
fn is_doubted(evaluation: &EvaluationPoint, reference: &[Varied<RunningError2>; COMPONENTS]) -> bool {
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

/// The comparisons of one answer.
fn entries_of(answer: &Answer, at: &Situation<'_>, sides: &Sides) -> Result<Vec<Comparison>, String> {
    let dofs = at.dq.len();
    let quantity = answer.quantity;
    let is_meant =
        |&i: &usize| (Quantity::of_component(i), Quantity::axis_of_component(i)) == (quantity, answer.axis);
    let Some(i) = (0..COMPONENTS).find(is_meant) else {
        let found = answer.axis.map_or_else(|| "none".into(), |axis| format!("{axis:?}"));
        return Err(format!(
            "{}: of a vector a component, x, y or z, and of a scalar none expected, found {found}",
            quantity.name()
        ));
    };
    let shaped = |what: &str, numbers: &Option<Vec<f64>>, expected: usize| match numbers {
        Some(numbers) if numbers.len() != expected => Err(format!(
            "{what} of {}: {expected} numbers expected, found {}",
            quantity.name(),
            numbers.len()
        )),
        _ => Ok(()),
    };
    shaped("gradient", &answer.gradient, dofs)?;
    shaped("Hessian", &answer.hessian, dofs * dofs)?;
    let exact = |value: f64| RunningError { value, bound: 0.0 };
    let sum = |terms: &mut dyn Iterator<Item = RunningError>| terms.fold(exact(0.0), |sum, term| sum + term);
    let dot = |u: &[f64], v: &[f64]| sum(&mut u.iter().zip(v).map(|(&u, &v)| exact(u) * exact(v)));
    let along = |gradient: &Option<Vec<f64>>, dq| gradient.as_ref().map(|gradient| dot(gradient, dq));
    let second = answer.hessian.as_ref().map(|hessian| {
        let rows = hessian.chunks_exact(dofs.max(1)).zip(at.dq);
        sum(&mut rows.map(|(row, &dq)| exact(dq) * dot(row, at.linear_dq)))
    });
    let numbers = [
        (0, answer.value.map(exact)),
        (1, along(&answer.gradient, at.dq)),
        (2, along(&answer.gradient, at.linear_dq)),
        (3, second),
        (1, answer.variations[0].map(exact)),
        (2, answer.variations[1].map(exact)),
        (3, answer.variations[2].map(exact)),
    ];
    let orders = [Order::Value, Order::First, Order::First, Order::Second];
    let entry = |(k, number): (usize, Option<RunningError>)| {
        let number = number?;
        let (other, textbook) = (sides.reference[i].parts()[k], sides.textbook[i].parts()[k]);
        // The second bound is of those who solve for the closest point again.
        let [near, far] = textbook.bound;
        let bound = CAREFUL * near + far + number.bound;
        Some(Comparison {
            quantity,
            axis: answer.axis,
            order: orders[k],
            part: Varied::<f64>::PARTS[k],
            against: ROUTES[2],
            closed: number.value,
            other: other.value,
            scale: sides.scales[i].parts()[k].scale,
            bound,
            tolerance: bound + other.bound[0],
        })
    };
    Ok(numbers.into_iter().filter_map(entry).collect())
}
