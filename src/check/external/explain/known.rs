//! A case with its answers, and the same along single dofs.

use super::answered_case::AnsweredCase;
use crate::check::Answer;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::external::answers::Answers;
use crate::check::external::compare::Demands;
use crate::check::external::vectors::Vector;
use crate::closest_point::ClosestPoint;
use crate::test_beam::AnyBeam;

/// The number of entries of gradients and Hessians that are used at a case.
const ENTRIES: usize = 4;

/// A case with its answers, its beams and its closest point.
pub(super) struct Known {
    pub(super) vector: Vector,
    answers: Answers,
    beams: [Box<dyn AnyBeam>; 2],
    point: ClosestPoint,
}

impl Known {
    pub(super) fn new((vector, answers): &(Vector, Answers)) -> Option<Self> {
        let beams = vector.case.beams().ok()?;
        let point = vector.evaluated(|evaluation| evaluation.point).ok()?;
        Some(Self { vector: vector.clone(), answers: answers.clone(), beams, point })
    }

    pub(super) fn case(&self, demands: &Demands) -> Option<AnsweredCase<'_>> {
        let beams = self.beams.each_ref().map(|beam| &**beam);
        let evaluate = || EvaluationPoint::new(beams, &self.vector.case.contact, &self.point).ok();
        AnsweredCase::new((&self.vector, &self.answers), demands, evaluate)
            .filter(|case| !case.data.is_empty())
    }

    /// The same case along pairs of single dofs, so that the contractions of gradients and Hessians are their entries.
    pub(super) fn entries(&self) -> Vec<Self> {
        let is_array = |answers: &Answers| {
            let has = |answer: &Answer| answer.gradient.is_some() || answer.hessian.is_some();
            answers.residual.is_some() || answers.tangent.is_some() || answers.answers.iter().any(has)
        };
        if !is_array(&self.answers) {
            return Vec::new();
        }
        let dofs: usize = self.beams.iter().map(|beam| beam.dofs()).sum();
        let along = |k: usize| {
            // Every dof occurs, together with others of both beams.
            let (row, column) = ((7 * k + 1) % dofs, (5 * k + dofs / 2) % dofs);
            // A dof that the element does not have has no direction.
            if self.vector.directions().iter().any(|along| along[row] == 0.0 || along[column] == 0.0) {
                return None;
            }
            let mut vector = self.vector.clone();
            let [beam, bar] = &mut vector.case.test_beams;
            let split = beam.q.len();
            let unit = |at: usize, of: std::ops::Range<usize>| {
                of.map(|i| if i == at { 1.0 } else { 0.0 }).collect::<Vec<_>>()
            };
            (beam.dq, bar.dq) = (unit(row, 0..split), unit(row, split..dofs));
            (beam.linear_dq, bar.linear_dq) = (unit(column, 0..split), unit(column, split..dofs));
            let beams = vector.case.beams().ok()?;
            Some(Self { vector, answers: self.answers.clone(), beams, point: self.point })
        };
        (0..ENTRIES).filter_map(along).collect()
    }
}
