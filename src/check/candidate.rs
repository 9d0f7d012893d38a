//! The check of a user's linearization against automatic differentiation.
//!
//! # The tolerance
//! A number may differ from that of automatic differentiation by the bound on the rounding of the latter, by [`CAREFUL`]
//! times the bound on the rounding of the paper's formulas at the same point, and by the change from solving for the
//! closest point in `f64` again. A careful evaluation of the textbook formulas loses as much. Their shape functions may
//! be sums of powers. These cancel near an end of a beam, and a point is accurate only to half an ulp of its largest
//! control vectors. The rounding of the contraction with the directions is added.

mod entry;
mod found;
mod problem_size;
mod sides;

use super::diagnosis::place;
use super::draw::Case;
use super::evaluation_point::EvaluationPoint;
use super::shrink::shrink;
use super::verdict::Comparison;
use super::{CaseData, Regime};
use crate::closest_point::{ClosestPoint, Held, Search, closest_points};
use crate::linearization::Quantity;
use crate::pair::Contact;
use crate::parallel;
use crate::test_beam::Family;

pub(super) use entry::Entry;
pub use found::{Digits, Example, Found};
pub(super) use found::{contact_in_words, list};
pub(super) use problem_size::ProblemSize;
pub(super) use sides::{Sides, is_doubted};

/// The factor on the rounding of the textbook formulas: a choice, which allows another order of the sums.
pub const CAREFUL: f64 = 8.0;

/// A pair of beams at a closest point.
#[derive(Clone, Copy, Debug)]
pub struct Situation<'a> {
    /// The families of beam and bar beam.
    pub families: [Family; 2],
    /// The fixed parameters of their curves, in the order of [`Family::parameters`].
    pub parameters: [&'a [f64]; 2],
    /// The dofs of the beam.
    pub q: &'a [f64],
    /// The dofs of the bar beam.
    pub q_bar: &'a [f64],
    /// The closest point, with its properties.
    pub point: ClosestPoint,
    /// Its parameters.
    pub at: (f64, f64),
    /// Which of them are held at an end.
    pub held: Held,
    /// Radii and reference parameters.
    pub contact: Contact,
    /// The direction delta, over the dofs of both beams.
    pub dq: &'a [f64],
    /// The direction Delta.
    pub linear_dq: &'a [f64],
}

/// The answer of a linearization for a scalar, or for a component of a vector, in full or in part. Beam dofs are first.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The quantity.
    pub quantity: Quantity,
    /// The component of a vector: x, y or z.
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
    /// An empty answer for a scalar.
    pub fn of(quantity: Quantity) -> Self {
        Self { quantity, axis: None, value: None, gradient: None, hessian: None, variations: [None; 3] }
    }
}

/// A linearization under check.
pub trait Candidate: Sync {
    /// All its answers at a closest point; empty if it has none.
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
    let of_case =
        |&number: &u64| Found::of(&drawn(number), &at_closest_points(candidate, &drawn(number).data()));
    let all = parallel::map(&(0..cases * regimes).collect::<Vec<_>>(), of_case);
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
        // The candidate may support these families only.
        let is_known = families(smaller) == families(case);
        let entry = is_known.then(|| first_wrong(candidate, smaller)).flatten()?;
        Some((entry.order, entry.quantity))
    })
}

/// The comparison at a closest point.
struct AtPoint {
    /// All numbers; empty if there was no answer.
    entries: Vec<Comparison>,
    /// The error in the shape of an answer, if there is one.
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
        let (sides, paper) = Sides::new(evaluation, &case.test_beams);
        let (mut entries, mut misshapen) = (Vec::new(), None);
        for answer in &answers {
            match sides.entries(answer, [&dq, &linear_dq]) {
                Ok(of_answer) => entries.extend(of_answer.into_iter().map(Entry::decided)),
                Err(wrong) => misshapen = misshapen.or(Some(wrong)),
            }
        }
        // The reference itself is doubted if the differences in double-double contradict it.
        let doubted = entries.iter().any(Comparison::is_wrong) && is_doubted(&paper, &sides.reference);
        Some(AtPoint { entries, misshapen, doubted })
    };
    closest.minima.iter().filter_map(at_point).collect()
}
