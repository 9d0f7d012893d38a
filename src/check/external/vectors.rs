//! Cases for programs in any language, of the schema `beamgap-vectors/1`: JSON Lines, one head and then a case a line.
//!
//! A case is two beams with their dofs, two directions of variation, radii and reference parameters, and its closest
//! point. It has two kinds of input. *Curves* (family, parameters, dofs) test the closest point too and allow gradients
//! and Hessians. *Jets* (x, t, t_xi, t_xixi of both beams at the closest point, and their variations along both
//! directions) serve programs with interpolations of their own. The expected numbers are written beside them, with the
//! largest difference that rounding explains. The check of answers computes these numbers again and does not read them.

mod draw;
mod element;
mod entries;
mod read;
mod steps;
mod write;

pub use draw::Drawing;
pub use read::VectorReader;
pub(super) use read::{find, id, schema};
pub use steps::StepDofs;
pub use write::{Expected, VectorWriter};
pub(super) use write::{key, quoted};

use super::error::Place;
use crate::check::element::ElementAt;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::verdict::Inconclusive;
use crate::check::{CaseData, ElementData};
use crate::closest_point::{ClosestPoint, Held, Search, closest_points};
use crate::contact::State;
use crate::test_beam::{AnyBeam, Family};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The schema.
pub const VECTORS: &str = "beamgap-vectors/1";

/// A case with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector {
    /// Its name. The answers to it have the same name.
    pub id: String,
    /// The regime that it was drawn in, or any other word.
    pub regime: String,
    /// The beams.
    pub case: CaseData,
    /// The contact element, if the case has one.
    pub element: Option<ElementData>,
    /// Earlier converged steps, from the first contact on: those that lead to the history of the element, if they are known.
    pub steps: Vec<StepDofs>,
    /// The parameters of its closest point, as written. They select one of several closest points.
    pub point: Option<(f64, f64)>,
    /// Where it was read, if it was read.
    pub place: Option<Place>,
}

/// The state of the closest point of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has derivatives.
    Valid,
    /// It has no derivatives that could be compared.
    Degenerate(Inconclusive),
    /// There is none.
    NoProjection,
    /// The given point is not one.
    OtherPoint,
    /// A beam has no length.
    NoLength,
}

impl Outcome {
    /// The name of the state.
    pub fn name(self) -> &'static str {
        match self {
            Self::Valid => "valid",
            Self::Degenerate(_) | Self::NoLength => "degenerate",
            Self::NoProjection | Self::OtherPoint => "no-projection",
        }
    }

    /// The reason why there is nothing to compare with.
    pub fn reason(self) -> &'static str {
        match self {
            Self::Valid => "valid",
            Self::Degenerate(reason) => reason.reason(),
            Self::NoProjection => "no closest point is known",
            Self::OtherPoint => "the given point is not a closest point of the beams",
            Self::NoLength => "a beam has no length",
        }
    }
}

impl Vector {
    /// The state of the contact element, if the case has one.
    pub fn state(&self) -> Option<State> {
        let of = |evaluation: EvaluationPoint<'_>| Some(self.element_at(&evaluation).ok()??.state());
        self.element.and_then(|_| self.evaluated(of).ok()?)
    }

    /// Whether xi and xi_bar become held in the step of the contact element: they were free at the last converged one.
    pub fn become_held(&self) -> [bool; 2] {
        let slips = self.element.and_then(|element| element.history.slips);
        let held = slips.and_then(|_| self.evaluated(|at| at.held).ok());
        let now = held.zip(slips.map(|slips| slips.held));
        now.map_or([false; 2], |(now, before)| [now.xi && !before.xi, now.xi_bar && !before.xi_bar])
    }

    /// The nearest closest point, or the one next to the given parameters.
    fn closest_point(&self) -> Result<ClosestPoint, Outcome> {
        let beams = self.case.beams().map_err(|_| Outcome::NoProjection)?;
        let is_point = |beam: &dyn AnyBeam| {
            [-1.0, -0.5, 0.0, 0.5, 1.0].iter().all(|&xi| beam.geometry(xi).t.iter().all(|t| *t == 0.0))
        };
        if beams.iter().any(|beam| is_point(&**beam)) {
            return Err(Outcome::NoLength);
        }
        let found = closest_points(&*beams[0], &*beams[1], &Search::default())
            .map_err(|_| Outcome::Degenerate(Inconclusive::SearchFailed))?;
        let (minima, is_open) = (found.minima, !found.unresolved.is_empty());
        let away = |point: &ClosestPoint| match self.point {
            Some((xi, xi_bar)) => (point.xi - xi).abs().max((point.xi_bar - xi_bar).abs()),
            None => point.distance,
        };
        let nearest = minima.into_iter().min_by(|one, two| away(one).total_cmp(&away(two)));
        let nearest = nearest.filter(|point| self.point.is_none() || away(point) <= NEAR);
        nearest.ok_or(match (is_open, self.point) {
            (true, _) => Outcome::Degenerate(Inconclusive::Unresolved),
            (false, Some(_)) => Outcome::OtherPoint,
            (false, None) => Outcome::NoProjection,
        })
    }

    /// The result of `f` at the closest point, or the reason why there is none.
    pub(in crate::check) fn evaluated<R>(
        &self,
        f: impl FnOnce(EvaluationPoint<'_>) -> R,
    ) -> Result<R, Outcome> {
        let beams = self.case.beams().map_err(|_| Outcome::NoProjection)?;
        let point = self.closest_point()?;
        let evaluation =
            EvaluationPoint::new(beams.each_ref().map(|beam| &**beam), &self.case.contact, &point);
        evaluation.map(f).map_err(Outcome::Degenerate)
    }

    /// Its contact element at its closest point.
    ///
    /// # Errors
    /// The reason why the element is not defined there, in words.
    pub(super) fn element_at(&self, evaluation: &EvaluationPoint<'_>) -> Result<Option<ElementAt>, String> {
        let at = |element: &ElementData| element.at(evaluation).map_err(|error| format!("element: {error}"));
        self.element.as_ref().map(at).transpose()
    }

    /// The state of its closest point.
    pub fn outcome(&self) -> Outcome {
        self.evaluated(|_| Outcome::Valid).unwrap_or_else(|outcome| outcome)
    }

    /// Both directions, over the dofs of both beams.
    pub fn directions(&self) -> [Vec<f64>; 2] {
        let [beam, bar] = &self.case.test_beams;
        [[&beam.dq[..], &bar.dq].concat(), [&beam.linear_dq[..], &bar.linear_dq].concat()]
    }

    /// The same case along directions that are in no file: each entry is multiplied by a random number of 0.5 to 1.5 and a
    /// random sign. The numbers depend on the dofs alone.
    pub(super) fn along_others(&self) -> Self {
        let mut other = self.clone();
        let dofs = self.case.test_beams.iter().flat_map(|beam| &beam.q);
        let seed = dofs.fold(0_u64, |seed, dof| seed.rotate_left(7) ^ dof.to_bits());
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        for beam in &mut other.case.test_beams {
            for entry in beam.dq.iter_mut().chain(&mut beam.linear_dq) {
                let sign = if rng.random() { 1.0 } else { -1.0 };
                *entry *= sign * rng.random_range(0.5..1.5);
            }
        }
        other
    }

    /// The families of beam and bar beam.
    pub fn families(&self) -> [Family; 2] {
        self.case.test_beams.each_ref().map(|beam| beam.family)
    }
}

/// The parameters that are held at an end, in a word.
pub(super) fn held_name(held: Held) -> &'static str {
    match (held.xi, held.xi_bar) {
        (false, false) => "none",
        (true, false) => "xi",
        (false, true) => "xi_bar",
        (true, true) => "both",
    }
}

/// The maximum distance of the parameters of a closest point from the written ones.
const NEAR: f64 = 1e-5;
