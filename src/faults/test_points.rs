//! The closest points of fault injection, chosen so that no term vanishes at all of them.

use super::steps::Steps;
use crate::check::{
    Case, Closed, Comparison, EvaluationPoint, References, Regime, Selection, Verdict, judged,
};
use crate::closest_point::{ClosestPoint, Held, Search, closest_points};
use crate::linearization::closed_form::Formulation;
use crate::test_beam::Family;
use crate::variant::Variant;
use std::collections::BTreeMap;

/// The number of points inside both beams, for each combination of curves that are linear in their dofs or not.
const INSIDE: usize = 2;
/// The maximum number of drawn cases.
const DRAWN: u64 = 2000;
/// The step from one case to the next. It is coprime to the 121 pairs of families, so the steps reach all pairs.
const STRIDE: usize = 37;

/// A closest point, with all values that do not depend on the variant.
pub(super) struct Sample<'a> {
    pub(super) evaluation: EvaluationPoint<'a>,
    references: References,
    pub(super) steps: Steps,
}

impl<'a> Sample<'a> {
    /// In the paper's formulation and, inside both beams, in the three others; none if the point has no comparable
    /// derivatives.
    ///
    /// A check may detect a fault in one formulation only: symmetry detects a wrong d.t,xi of the system if (40) is used
    /// with the solution by cross products.
    pub(super) fn in_all_forms(case: &'a Case, point: &ClosestPoint) -> Vec<Self> {
        let evaluation = || EvaluationPoint::new(case.beams(), &case.contact, point).ok();
        let Some(first) = evaluation() else { return Vec::new() };
        let paper = Formulation::paper(point.held());
        let robust = Formulation::robust(&first.points(), point.held());
        let others = [
            Formulation { distance: robust.distance, ..paper },
            Formulation { system: robust.system, ..paper },
            robust,
        ];
        let others = others.into_iter().filter(|_| point.is_interior());
        let in_form =
            |(evaluation, form)| Self::new(case, point, EvaluationPoint::in_formulation(evaluation, form));
        let evaluations = others.filter_map(|form| Some((evaluation()?, form)));
        [(first, paper)].into_iter().chain(evaluations).map(in_form).collect()
    }

    /// Evaluates the references.
    fn new(case: &'a Case, point: &ClosestPoint, evaluation: EvaluationPoint<'a>) -> Self {
        let references = References::new(&evaluation);
        let steps = Steps::new(&case.test_beams, point);
        Self { evaluation, references, steps }
    }

    /// The comparisons of the gate.
    pub(super) fn compared(&self, variant: &Variant) -> Vec<Comparison> {
        Closed::new(variant, &self.evaluation).compared_with(&self.references)
    }
}

/// The cases and closest points of a regime: inside, and with one parameter held at an end, for beams of both kinds.
pub(super) fn test_points(seed: u64, regime: Regime) -> Vec<(Case, ClosestPoint)> {
    let selection = Selection { regimes: vec![regime], family: None, cases: 121 * DRAWN };
    let mut wanted = BTreeMap::new();
    for linear in [[false, false], [false, true], [true, false], [true, true]] {
        wanted.insert((false, false, linear), INSIDE);
        wanted.insert((true, false, linear), 1);
        wanted.insert((false, true, linear), 1);
    }
    let mut chosen = Vec::new();
    for number in selection.numbers().into_iter().step_by(STRIDE).take(usize::try_from(DRAWN).unwrap_or(0)) {
        if wanted.values().all(|&count| count == 0) {
            break;
        }
        let case = Case::draw(seed, number);
        let Some((key, point)) = best(&case, &wanted) else { continue };
        wanted.entry(key).and_modify(|count| *count -= 1);
        chosen.push((key, case, point));
    }
    // First the points with the most active terms.
    chosen.sort_by_key(|(key, ..)| *key);
    chosen.into_iter().map(|(_, case, point)| (case, point)).collect()
}

type Key = (bool, bool, [bool; 2]);

/// A closest point of the case that is still needed and that passes the gate.
fn best(case: &Case, wanted: &BTreeMap<Key, usize>) -> Option<(Key, ClosestPoint)> {
    let linear = case.families.map(Family::is_linear);
    let [beam, bar] = case.beams();
    let minima = closest_points(beam, bar, &Search::default()).ok()?.minima;
    minima.into_iter().find_map(|point| {
        let Held { xi, xi_bar } = point.held();
        let key = (xi, xi_bar, linear);
        let is_wanted = wanted.get(&key).is_some_and(|&count| count > 0);
        let passes =
            |sample: &Sample| matches!(judged(sample.compared(&Variant::Unmodified)), Verdict::Pass(_));
        let samples = if is_wanted { Sample::in_all_forms(case, &point) } else { Vec::new() };
        (!samples.is_empty() && samples.iter().all(passes)).then_some((key, point))
    })
}
